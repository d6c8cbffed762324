#!/usr/bin/env bash
# scripts/before-after.sh OLD NEW [SCENE...]: speed against accuracy of two builds of the program, in turn on the same scenes:
# docs/images/charts/before-after-SCENE.csv (CPU seconds on one thread, the least of RUNS = 3; rms distance of the particles at the
# end to a run of NEW with eight times finer steps and tolerance; iterations) and the chart of it beside.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
old=$1 new=$2
shift 2
[ $# -gt 0 ] || set -- welcome drooping-cantilever twisted-bar
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
declare -A until=([welcome]=1.2 [drooping-cantilever]=.6 [twisted-bar]=.4)
TIMEFORMAT=%U

# PROGRAM SCENE DT FOLDER [OPTION...]: simulates there and prints CPU seconds.
simulate() {
  local program=$1 scene=$2 dt=$3 folder=$4
  shift 4
  rm -rf "$folder"
  { time "$program" run "assets/scenes/$scene.json" --threads 1 --quiet --until "${until[$scene]}" --out "$folder" --export=csv \
      --set "/time/step=$dt" --set "/time/frame=${until[$scene]}" "$@" 2> "$folder.err" >&2; } 2>&1
}
column() { awk -F, -v name="$2" 'NR == 1 { for (k = 1; k <= NF; ++k) if ($k == name) c = k; next } { s += $c } END { print s }' "$1/stats.csv"; }

for scene; do
  table=docs/images/charts/before-after-$scene.csv
  echo program,dt,cpu_s,error,newton_iterations,linear_iterations > "$table"
  simulate "$new" "$scene" 0.0003125 "$work/reference" --set /solver/newton_tolerance=1e-6 > /dev/null
  # compare tells the rms of two frames; in the first, at t = 0, nothing differs: hence the root of two.
  for dt in 0.02 0.01 0.005 0.0025; do
    least_old=1e9 least_new=1e9
    for ((run = 0; run < ${RUNS:-3}; ++run)); do
      least_old=$(echo "$least_old $(simulate "$old" "$scene" "$dt" "$work/old")" | awk '{ print $1 < $2 ? $1 : $2 }')
      least_new=$(echo "$least_new $(simulate "$new" "$scene" "$dt" "$work/new")" | awk '{ print $1 < $2 ? $1 : $2 }')
    done
    for build in old new; do
      least=least_$build
      error=$({ "$new" compare "$work/$build" "$work/reference" --tolerance 1e9 || true; } | awk '$1 == "export" && $2 == "position" { print $5 * sqrt(2) }')
      label=$([ $build = old ] && echo before || echo after)
      echo "$label,$dt,${!least},$error,$(column "$work/$build" newton_iterations),$(column "$work/$build" linear_iterations)" | tee -a "$table"
    done
  done
  name=$(sed -n 's/.*"name": "\([^"]*\)".*/\1/p' "assets/scenes/$scene.json" | head -1)
  "$new" chart "$table" --x cpu_s --y error --lines program --log-x --log-y --pareto --out "${table%.csv}.svg" \
    --title "$name: speed against accuracy, before and after" --x-title "CPU time of ${until[$scene]} s [s]" \
    --y-title "Distance to a fine run, rms [m]"
done
