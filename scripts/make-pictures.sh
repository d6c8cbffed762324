#!/usr/bin/env bash
# scripts/make-pictures.sh: makes the pictures of README.md, docs/images/*.png, with the program itself. Each is one
# state of a shipped scene: NAME TIME.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
cd "$root"
program=${PUSHFORWARD:-build/release/pushforward}  # another build may be used: PUSHFORWARD=build/developer/pushforward
[ -n "${PUSHFORWARD:-}" ] || build release pushforward
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p docs/images
while read -r scene time; do
  say "$scene at $time s"
  "$program" run "$scene" --until "$time" --set "/time/frame=$time" --images=1280x720 --out "$work" --quiet
  last=$(printf '%s\n' "$work"/images/*.png | tail -n 1)
  cp "$last" "docs/images/$scene.png"
done <<'SCENES'
welcome 1.0
drooping-cantilever 1.0
stretched-strip 1.0
twisted-bar 0.3
torus-on-ball 0.6
SCENES
