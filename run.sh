#!/usr/bin/env bash
# ./run.sh [--yes] [ARGS]: installs what is missing, builds what is left to build, then runs `pushforward ARGS`.
# Without ARGS: the app on the welcome scene. stdout and the exit status are pushforward's own.
source "$(dirname "${BASH_SOURCE[0]}")/scripts/setup.sh"
take_yes "$@"
install_missing build
build release pushforward
exec "$root/build/release/pushforward" ${arguments[@]+"${arguments[@]}"}
