#!/usr/bin/env bash
# scripts/check-tidy.sh [FILE...]: clang-tidy with .clang-tidy over the given sources, or all of them. Needs a
# configured build (./run.sh, or any preset) for the compile commands.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if (($#)); then files=("$@"); else mapfile -t files < <(git ls-files 'core/*.cpp' 'render/*.cpp' 'app/*.cpp'); fi
for build in release developer debug; do
  [ -f "build/$build/compile_commands.json" ] && break
done
# gcc's own options in the compile commands are none of clang's business.
printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -n 1 clang-tidy -p "build/$build" --quiet \
  --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-ignored-optimization-argument --warnings-as-errors='*'
