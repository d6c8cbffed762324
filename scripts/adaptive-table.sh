#!/usr/bin/env bash
# scripts/adaptive-table.sh: adaptive runs against the front of the fixed settings as a table of Markdown, from what
# scripts/make-charts.sh left in docs/images/charts/adaptive-*-front.csv. "Within" counts ratios up to 1.1, and runs that are
# more exact than every fixed one.
cd "$(dirname "${BASH_SOURCE[0]}")/../docs/images/charts"
echo '<!-- made by scripts/adaptive-table.sh -->'
echo '| case | tolerance [1/s] | error [m] | work | front at this error | ratio |'
echo '|---|---|---|---|---|---|'
awk -F, '
  FNR == 1 { for (k = 1; k <= NF; ++k) at[$k] = k; next }
  {
    name = FILENAME; sub(/^adaptive-/, "", name); sub(/-front[.]csv$/, "", name)
    front = $at["front_cost"]; ratio = $at["ratio"]
    ++all
    if (front == "" || ratio <= 1.1) ++within
    printf "| %s | %g | %.2e | %.3e | %s | %s |\n", name, $at["/time/tolerance"], $at["error_l2"], $at["cost"],
      front == "" ? "none as exact" : sprintf("%.3e", front), front == "" ? "" : sprintf("%.2f", ratio)
  }
  END { printf "\nWithin 10 %% of the front, or below it: %d of %d.\n", within, all }' adaptive-*-front.csv
