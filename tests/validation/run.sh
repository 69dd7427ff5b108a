#!/bin/sh
# Fits models to what was measured at real sites, and prints how well they then agree. Data of others are never part of flyrock:
# DATA is a folder with one folder a site (docs/validation.md says which files). A site whose files are absent is SKIPPED.
#   tests/validation/run.sh PROGRAM DATA
set -eu
program=$1
data=$2
here=$(cd "$(dirname "$0")" && pwd)
out=out/validation
mkdir -p $out

# fit SITE 'FILES' --vary ...: calibrates tests/validation/SITE.yaml beside copies of the files of its site.
fit() {
  site=$1
  files=$2
  shift 2
  for file in $files; do
    if [ ! -e "$data/$site/$file" ]; then
      echo "$site: SKIPPED, $data/$site/$file is absent"
      return 0
    fi
  done
  rm -rf "$out/$site"
  mkdir -p "$out/$site"
  for file in $files; do cp "$data/$site/$file" "$out/$site/"; done
  cp "$here/$site.yaml" "$out/$site/"
  # The triangles between the points of this grid are above some starts: without heights, blocks are lowered onto them.
  if [ "$site" = tschamut2014 ]; then cut -d, -f1-4,6- "$data/$site/release_points.csv" > "$out/$site/starts.csv"; fi
  echo "== $site"
  "$program" calibrate "$out/$site/$site.yaml" "$@" -o "$out/$site/fit" --force || [ $? -eq 1 ]
}

fit authume "terrain.obj blocks_p1.csv" \
  --vary materials.rock.friction.mu=0.1:0.9 --vary "materials.rock.roughness.angle.normal.sd=2 deg:25 deg" --trials 20
fit tschamut2014 "terrain.asc release_points.csv observed_deposition.csv" --hold 4 \
  --vary materials.soil.friction.mu=0.2:0.6 --vary "materials.soil.roughness.angle.normal.sd=2 deg:20 deg" --trials 20
