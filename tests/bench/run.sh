#!/bin/sh
# make bench: rocks per second to rest on one core and the share of time by phase, median of five runs each; ballistic
# flights alone, and lumped masses beside a plain loop, with rows and envelopes, and with the restitution in Lua; the
# time of contacts, gap and time of impact for each pair of shapes; then the time of the Ninh Dan run with its
# restitution in Lua over that with the same law native, and with one thread over that with two, in pairs of runs.
set -eu
flyrock=$1/flyrock
here=$(cd "$(dirname "$0")" && pwd)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

awk 'BEGIN {
  print "ncols 1000\nnrows 1000\nxllcenter 0\nyllcenter 0\ncellsize 1"
  for (r = 999; r >= 0; --r)
    for (c = 0; c < 1000; ++c) printf "%.3f%s", 400 * exp(-c / 300) + 0.3 * sin(c / 3) * sin(r / 4), c < 999 ? " " : "\n"
}' > "$out/raster1000.asc"
cp "$here/points_raster.yaml" "$out"
for scenario in "$here/../../scenarios/ninh_dan/benches_2d.yaml" "$here/../../scenarios/ninh_dan/rockfall_2d.yaml" "$here/s3.yaml" "$here/shots.yaml" "$here/points.yaml" "$out/points_raster.yaml"; do
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

"$1/flyrock_shots"
"$1/flyrock_points" "$here/points.yaml"
"$1/flyrock_pairs"

# Rocks to rest with steps chosen by error and fixed ones, in turn; between them the peer, where it is installed, with
# the same scene and the same rest: Box2D in 2D, Bullet in 3D.
compile() { g++ -O3 "$@" 2> /dev/null; }
compile "$here/box2d_s3.cpp" -lbox2d -o "$out/box2d_s3" || true
compile -DBT_USE_DOUBLE_PRECISION -I/usr/include/bullet "$here/bullet_s12.cpp" -lBulletDynamics-float64 \
  -lBulletCollision-float64 -lLinearMath-float64 -o "$out/bullet_s12" || true
peer() {
  case $1 in
    s3) [ ! -x "$out/box2d_s3" ] || "$out/box2d_s3" "$here/scenes/profile.txt" 60 0.001 ;;
    s1) [ ! -x "$out/bullet_s12" ] || "$out/bullet_s12" sphere "$here/scenes/terrain.obj" 40 0.001 ;;
    s2) [ ! -x "$out/bullet_s12" ] || "$out/bullet_s12" "$here/scenes/rock20.obj" "$here/scenes/terrain.obj" 20 0.001 ;;
  esac
}
for scenario in "$here/../../scenarios/ninh_dan/benches_2d.yaml" "$here/s3.yaml" "$here/s1.yaml" "$here/s2.yaml"; do
  name=$(basename "$scenario" .yaml)
  for round in 1 2 3; do
    for step in auto "5 ms" "1 ms"; do
      of=$out/$name-$(echo "$step" | tr -d ' ')
      sed "/^solver:/d; s|file: scenes|file: $here/scenes|; \$ a solver: { time_step: $step }" "$scenario" > "$of.yaml"
      "$flyrock" run "$of.yaml" -o "$of" -j 1 --force --quiet > /dev/null 2>&1 || true
      sed -n 's/^rocks\/s *//p' "$of/run.log" >> "$of.rates"
    done
    peer "$name" >> "$out/$name.peer"
  done
  for step in auto 5ms 1ms; do
    of=$out/$name-$step
    runout=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "runout_m") c = i } NR > 1 && $c != "" { print $c }' "$of/rocks.csv" |
      sort -n | awk '{ v[NR] = $1; s += $1; q += $1 * $1 } END { m = s / NR; printf "%.1f +- %.1f m, p95 %.1f m", m, 1.96 * sqrt((q / NR - m * m) / NR), v[int(0.95 * NR + 0.5)] }')
    printf '%-12s %-5s %8s rocks/s, runout %s\n' $name $step $(sort -n "$of.rates" | sed -n 2p) "$runout"
  done
  sort "$out/$name.peer" | sed -n 2p
done

# Memory does not grow with the number of rocks; 1000000 gives the same (about a minute). All threads, as an engineer runs it.
for trials in 10000 100000; do
  "$flyrock" run "$here/many.yaml" --trials $trials -o "$out/many" --force --quiet
  printf 'many         %8s rocks  (%s)\n' $trials "$(sed -nE '/^(store|tables|memory)/s/  */ /gp' "$out/many/run.log" | paste -s -d ',' -)"
done
# A pair is two runs, one after the other and each first in turn: what else the machine does meets both.
ninh_dan=$here/../../scenarios/ninh_dan/benches_2d.yaml
law() { sed "s/restitution: { type: [a-z_]*/restitution: { type: $1/" "$ninh_dan"; }
law newton > "$out/native.yaml"
{ law newton_in_lua; echo "plugins: [newton_in_lua.lua]"; } > "$out/lua.yaml"
cp "$here/newton_in_lua.lua" "$out"
seconds() {
  "$flyrock" run "$out/$1.yaml" -o "$out/$1" -j $2 --force --quiet > "$out/messages" 2>&1 ||
    [ $? = 1 ] || { cat "$out/messages" >&2; exit 1; }  # 1: an expectation failed
  sed -n 's/^seconds  *//p' "$out/$1/run.log"
}
for pair in 1 2 3 4 5 6 7 8 9; do
  if [ $((pair % 2)) = 0 ]; then native=$(seconds native 1); lua=$(seconds lua 1); else lua=$(seconds lua 1); native=$(seconds native 1); fi
  awk "BEGIN { print $lua / $native }" >> "$out/ratios"
done
cmp "$out/native/rocks.csv" "$out/lua/rocks.csv"
printf 'restitution in Lua: %s times the native run (median of 9 pairs, %s to %s); one call: %s\n' \
  $(sort -n "$out/ratios" | sed -n '5p;1p;9p' | awk '{ v[NR] = $1 } END { print v[2], v[1], v[3] }') \
  "$("$1/flyrock_law_call" "$here/newton_in_lua.lua")"
for pair in 1 2 3 4 5 6 7 8 9; do
  if [ $((pair % 2)) = 0 ]; then one=$(seconds native 1); two=$(seconds native 2); else two=$(seconds native 2); one=$(seconds native 1); fi
  awk "BEGIN { print $one / $two }" >> "$out/speedups"
done
printf 'two threads: %s times as fast as one (median of 9 pairs, %s to %s)\n' \
  $(sort -n "$out/speedups" | sed -n '5p;1p;9p' | awk '{ v[NR] = $1 } END { print v[2], v[1], v[3] }')
