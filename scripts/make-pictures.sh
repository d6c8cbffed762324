#!/usr/bin/env bash
# scripts/make-pictures.sh: makes the pictures of README.md, docs/images/*.png, with the program itself. Each is one
# state of a shipped scene: NAME TIME.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
cd "$root"
build release pushforward
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p docs/images
while read -r scene time; do
  say "$scene at $time s"
  build/release/pushforward run "$scene" --until "$time" --set "/time/frame=$time" --images=1280x720 --out "$work" --quiet
  last=$(printf '%s\n' "$work"/images/*.png | tail -n 1)
  cp "$last" "docs/images/$scene.png"
done <<'SCENES'
welcome 1.0
drooping-cantilever 1.0
stretched-strip 1.0
twisted-bar 0.5
torus-on-ball 1.0
SCENES
