#!/usr/bin/env bash
# scripts/make-charts.sh [NAME...]: runs the studies of assets/studies (or the named ones) and puts their charts where
# docs/charts.md shows them, docs/images/charts/NAME*.svg, with the numbers in docs/images/charts/NAME.csv. About eight minutes
# on two cores. A run that was cut off goes on where it was; FRESH=1 begins anew.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
cd "$root"
program=${PUSHFORWARD:-build/release/pushforward}  # another build may be used: PUSHFORWARD=build/developer/pushforward
[ -n "${PUSHFORWARD:-}" ] || build release pushforward
work=${WORK:-$root/build/studies}
mkdir -p "$work" docs/images/charts
if [ $# -eq 0 ]; then
  for study in assets/studies/*.json; do set -- "$@" "$(basename "$study" .json)"; done
fi
for name in "$@"; do
  "$program" study "assets/studies/$name.json" --out "$work/$name" --jobs "$(nproc)" ${FRESH:+--fresh}
  rm -f "docs/images/charts/$name"*
  cp "$work/$name/results.csv" "docs/images/charts/$name.csv"
  if [ -e "$work/$name/adaptive.csv" ]; then cp "$work/$name/adaptive.csv" "docs/images/charts/$name-front.csv"; fi
  for chart in "$work/$name"/chart*.svg; do
    cp "$chart" "docs/images/charts/$name$(basename "$chart" | sed 's/^chart//')"
  done
done
scripts/adaptive-table.sh > docs/adaptive.md
