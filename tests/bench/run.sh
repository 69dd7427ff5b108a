#!/bin/sh
# make bench: rocks per second to rest on one core and the share of time by phase, median of five runs each.
set -eu
flyrock=$1
here=$(cd "$(dirname "$0")" && pwd)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

for scenario in "$here/../../scenarios/ninh_dan/benches_2d.yaml" "$here/../../scenarios/ninh_dan/rockfall_2d.yaml" "$here/s3.yaml"; do
  name=$(basename "$scenario" .yaml)
  for run in 1 2 3 4 5; do
    "$flyrock" run "$scenario" -o "$out/$name" -j 1 --force --quiet > /dev/null 2>&1 || true
    sed -n 's/^rocks\/s *//p' "$out/$name/run.log" >> "$out/$name.rates"
  done
  rate=$(sort -n "$out/$name.rates" | sed -n 3p)
  phases=$(sed -n '/ %$/s/  */ /gp' "$out/$name/run.log" | paste -s -d ',' -)
  count() { sed -n "s/.*\"$1\": *\([0-9]*\).*/\1/p" "$out/$name/summary.json" | head -1; }
  printf '%-12s %8s rocks/s  (%s)  %s steps, %s flights\n' "$name" "$rate" "$phases" "$(count steps)" "$(count flights)"
done

# Memory does not grow with the number of rocks; 1000000 gives the same (about a minute). All threads, as an engineer runs it.
for trials in 10000 100000; do
  "$flyrock" run "$here/many.yaml" --trials $trials -o "$out/many" --force --quiet
  printf 'many         %8s rocks  (%s)\n' $trials "$(sed -nE '/^(store|tables|memory)/s/  */ /gp' "$out/many/run.log" | paste -s -d ',' -)"
done
