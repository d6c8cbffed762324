#!/usr/bin/env bash
# scripts/make-pictures.sh: makes the pictures of README.md, docs/images/*.png, and those of the scene gallery,
# assets/scenes/*.png, with the program itself. Each is one state of a shipped scene: NAME TIME.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
cd "$root"
program=${PUSHFORWARD:-build/release/pushforward}  # another build may be used: PUSHFORWARD=build/developer/pushforward
[ -n "${PUSHFORWARD:-}" ] || build release pushforward
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# picture FILE SCENE TIME OPTIONS...: the last state of a run.
picture() {
  say "$2 at $3 s -> $1"
  "$program" run "$2" --until "$3" --set "/time/frame=$3" --out "$work" --quiet "${@:4}"
  cp "$(printf '%s\n' "$work"/images/*.png | tail -n 1)" "$1"
}

mkdir -p docs/images
while read -r scene time; do
  picture "docs/images/$scene.png" "$scene" "$time" --images=1280x720
done <<'SCENES'
welcome 1.0
drooping-cantilever 1.0
stretched-strip 1.0
twisted-bar 0.3
torus-on-ball 0.6
SCENES

# Small: the gallery shows them about 110 points wide, on a fine screen in twice or thrice as many pixels.
while read -r scene time; do
  picture "assets/scenes/$scene.png" "$scene" "$time" --images=352x218 --plain
done <<'SCENES'
welcome 1.0
colliding-discs 1.75
drooping-cantilever 1.0
spinning-disc 0.1
stretched-strip 1.2
twisted-bar 0.3
torus-on-ball 0.6
vibrating-bar 0.13
SCENES
