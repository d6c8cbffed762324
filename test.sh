#!/usr/bin/env bash
# ./test.sh [--yes] [ARGS]: the same set-up as run.sh, then every test but the long ones. ARGS go to ctest:
# ./test.sh -R grid       tests whose name matches
# ./test.sh -L long       the long ones
source "$(dirname "${BASH_SOURCE[0]}")/scripts/setup.sh"
take_yes "$@"
install_missing build test
# In CI warnings are errors.
preset=release
[ -z "${CI:-}" ] || preset=developer
build "$preset"
selection=(-LE long)
for argument in ${arguments[@]+"${arguments[@]}"}; do
  case $argument in -L* | --label*) selection=() ;; esac
done
cd "$root/build/$preset"
CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc 2>/dev/null || echo 2)} \
  exec ctest --output-on-failure "${selection[@]}" ${arguments[@]+"${arguments[@]}"}
