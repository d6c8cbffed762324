#!/usr/bin/env bash
# scripts/method-tables.sh [orders|energy|long|cost|transfers]...: runs the studies behind the tables of docs/integrators.md and
# docs/transfers.md (all of them by default) and writes the tables anew. A few minutes on two cores.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
cd "$root"
program=${PUSHFORWARD:-build/release/pushforward}  # another build may be used: PUSHFORWARD=build/developer/pushforward
[ -n "${PUSHFORWARD:-}" ] || build release pushforward
work=${WORK:-$root/build/studies}
mkdir -p "$work"

# study FILE NAME: runs it and leaves results.csv in $work/NAME.
study() { "$program" study "$1" --out "$work/$2" --jobs "$(nproc)" ${FRESH:+--fresh} > /dev/null; }

# replace PAGE MARK: what stands in PAGE between "<!-- MARK" and "<!-- end -->" becomes standard input.
replace() {
  local table
  table=$(cat)
  MARK="<!-- $2" TABLE=$table awk '
    skip && index($0, "<!-- end -->") { skip = 0 }
    !skip { print }
    index($0, ENVIRON["MARK"]) == 1 { print ENVIRON["TABLE"]; skip = 1 }' "docs/$1" > "$work/page.md"
  cp "$work/page.md" "docs/$1"
}

# rows FILE COLUMN...: the columns of a results.csv by name, tab between them, quotes and the commas in them seen to.
rows() {
  local file=$1
  shift
  awk -v wanted="$*" '
    function cells(line, out,    n, i, c, quoted, text) {
      n = 1; text = ""; quoted = 0
      for (i = 1; i <= length(line); ++i) {
        c = substr(line, i, 1)
        if (c == "\"") quoted = !quoted
        else if (c == "," && !quoted) { out[n++] = text; text = "" }
        else text = text c
      }
      out[n] = text
      return n
    }
    NR == 1 { n = cells($0, head); for (k = 1; k <= n; ++k) at[head[k]] = k; m = split(wanted, want, " "); next }
    { cells($0, cell); for (k = 1; k <= m; ++k) printf "%s%s", cell[at[want[k]]], k < m ? "\t" : "\n" }' "$file"
}

# The template of the orders' study, for a mass and a basis; symplectic Euler, whose consistent limit is short, with its own steps.
# Averaged linear functions: on a bar whose free faces lie within cells, or else nodes that no domain reached come into play as it moves.
orders() {
  local bases="linear quadratic cubic gimp quadratic_gimp"
  for mass in lumped consistent; do
    for basis in $bases; do
      size='1, 0.75'
      if [ $basis = gimp ]; then size='1.125, 0.875'; fi
      sed -e "s/\"max\": \[1, 0.75\]/\"max\": [$size]/" -e "s/\"basis\": \"quadratic\"/\"basis\": \"$basis\"/" -e "s/\"mass\": \"consistent\"/\"mass\": \"$mass\"/" \
        assets/tables/integrator-orders.json > "$work/orders-$mass-$basis.json"
      sed -e 's/"\/integrator\/type": \[.*\]/"\/integrator\/type": ["symplectic_euler"]/' \
        -e 's/"\/time\/step": \[.*\]/"\/time\/step": [0.0008, 0.0004, 0.0002, 0.0001]/' \
        "$work/orders-$mass-$basis.json" > "$work/explicit-$mass-$basis.json"
      for kind in orders explicit; do study "$work/$kind-$mass-$basis.json" "$kind-$mass-$basis"; done
    done
  done
  for kind in orders explicit; do
    for mass in lumped consistent; do
      for basis in $bases; do
        # Symplectic Euler's places are of second order where it starts from rest: of it, the velocity's error.
        error=error_l2
        if [ $kind = explicit ]; then error=error_velocity_l2; fi
        rows "$work/$kind-$mass-$basis/results.csv" /integrator/type /time/step $error | sed "s/^/$mass\t$basis\t/"
      done
    done
  done | awk -F'\t' -v bases="$bases" '
    !($3 in seen) { seen[$3] = 1; name[++names] = $3 }
    { key = $3 SUBSEP $1 SUBSEP $2; if (key in last) order[key] = order[key] sprintf(" %.2f", log(last[key] / $5) / log(2)); last[key] = $5 }
    END {
      n_bases = split(bases, basis, " ")
      head = "| integrator |"; rule = "|---|"
      for (b = 1; b <= n_bases; ++b) { head = head " " basis[b] ", lumped | " basis[b] ", consistent |"; rule = rule "---|---|" }
      print head "\n" rule
      for (n = 1; n <= names; ++n) {
        line = "| " name[n]
        for (b = 1; b <= n_bases; ++b) line = line " |" order[name[n] SUBSEP "lumped" SUBSEP basis[b]] " |" order[name[n] SUBSEP "consistent" SUBSEP basis[b]]
        print line " |"
      }
    }' | replace integrators.md orders
}

energy() {
  study assets/tables/integrator-energy.json integrator-energy
  rows "$work/integrator-energy/results.csv" integrator /grid/basis transfer energy_change status | awk -F'\t' '
    !($1 in seen) { seen[$1] = 1; name[++names] = $1 }
    !($3 in had) { had[$3] = 1; transfer[++transfers] = $3 }
    { left[$1, $2, $3] = $5 == "ok" ? sprintf("%.4f", 1 + $4) : $5 }
    END {
      printf "| integrator | basis |"; for (t = 1; t <= transfers; ++t) printf " %s |", transfer[t]; print ""
      printf "|---|---|"; for (t = 1; t <= transfers; ++t) printf "---|"; print ""
      split("linear quadratic cubic", basis, " ")
      for (n = 1; n <= names; ++n) for (b = 1; b <= 3; ++b) {
        printf "| %s | %s |", name[n], basis[b]
        for (t = 1; t <= transfers; ++t) printf " %s |", left[name[n], basis[b], transfer[t]]
        print ""
      }
    }' | replace integrators.md energy
}

long() {
  study assets/tables/integrator-long.json integrator-long
  rows "$work/integrator-long/results.csv" integrator energy_change energy_gained | awk -F'\t' '
    BEGIN { print "| integrator | E/E0 after 100 periods | most above E0 on the way |\n|---|---|---|" }
    { printf "| %s | %.6f | %.1e |\n", $1, 1 + $2, $3 }' | replace integrators.md long
}

cost() {
  study assets/tables/integrator-cost.json integrator-cost
  rows "$work/integrator-cost/results.csv" /integrator/type wall_min_s work newton_iterations linear_iterations steps | awk -F'\t' '
    BEGIN { print "| integrator | wall time | counted work | Newton iterations a step | CG iterations a step |\n|---|---|---|---|---|" }
    NR == 1 { wall = $2 / $6; work = $3 / $6 }
    { printf "| %s | %.2f | %.2f | %.1f | %.0f |\n", $1, $2 / $6 / wall, $3 / $6 / work, $4 / $6, $5 / $6 }' | replace integrators.md cost
}

transfers() {
  for name in energy noise spin; do study "assets/tables/transfer-$name.json" "transfer-$name"; done
  {
    rows "$work/transfer-spin/results.csv" transfer /grid/basis /time/end angular_drift | sed 's/^/spin\t/'
    rows "$work/transfer-noise/results.csv" transfer /grid/basis steps energy_change | sed 's/^/noise\t/'
    rows "$work/transfer-energy/results.csv" transfer /grid/basis steps energy_change | sed 's/^/energy\t/'
  } | awk -F'\t' '
    !($2 in seen) { seen[$2] = 1; name[++names] = $2 }
    $1 == "spin" { L[$2, $3, ($4 < 0.1) ? "early" : "late"] = 1 - $5; next }
    { left[$1, $2, $3] = 1 + $5 }
    END {
      print "| transfer | basis | L lost a transfer | noise left after 100 | E/E0 after 1000 |\n|---|---|---|---|---|"
      split("linear quadratic cubic", basis, " ")
      for (n = 1; n <= names; ++n) for (b = 1; b <= 3; ++b) {
        lost = 1 - (L[name[n], basis[b], "late"] / L[name[n], basis[b], "early"]) ^ 0.01
        printf "| %s | %s | %.1e | %.1e | %.4f |\n", name[n], basis[b], lost, left["noise", name[n], basis[b]], left["energy", name[n], basis[b]]
      }
    }' | replace transfers.md transfers
}

if [ $# -eq 0 ]; then set -- orders energy long cost transfers; fi
for table in "$@"; do "$table"; done
