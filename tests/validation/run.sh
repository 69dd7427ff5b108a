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

# prepare MODEL SITE 'FILES': puts tests/validation/MODEL.yaml beside copies of the files of its site.
prepare() {
  for file in $3; do
    if [ ! -e "$data/$2/$file" ]; then
      echo "$1: SKIPPED, $data/$2/$file is absent"
      return 1
    fi
  done
  rm -rf "${out:?}/$1"
  mkdir -p "$out/$1"
  for file in $3; do cp "$data/$2/$file" "$out/$1/"; done
  cp "$here/$1.yaml" "$out/$1/"
  # The triangles between the points of this grid are above some starts: without heights, blocks are lowered onto them.
  if [ "$2" = tschamut2014 ]; then cut -d, -f1-4,6- "$data/$2/release_points.csv" > "$out/$1/starts.csv"; fi
  echo "== $1"
}

# fit MODEL SITE 'FILES' --vary ...
fit() {
  prepare "$1" "$2" "$3" || return 0
  model=$1
  shift 3
  "$program" calibrate "$out/$model/$model.yaml" "$@" -o "$out/$model/fit" --force || [ $? -eq 1 ]
}

authume="terrain.obj blocks_p1.csv"
tschamut="terrain.asc release_points.csv observed_deposition.csv"

if prepare authume_laws authume "$authume"; then
  "$program" run "$out/authume_laws/authume_laws.yaml" -o "$out/authume_laws/run" --force
fi
fit authume authume "$authume" \
  --vary materials.rock.friction.mu=0.1:0.9 --vary "materials.rock.roughness.angle.normal.sd=2 deg:25 deg" --trials 20
fit tschamut2014 tschamut2014 "$tschamut" --hold 4 \
  --vary materials.soil.friction.mu=0.2:0.6 --vary "materials.soil.roughness.angle.normal.sd=2 deg:20 deg" --trials 20
fit authume_sphere authume "$authume" \
  --vary materials.rock.rolling.share.normal.mean=0.3:0.6 --trials 20
fit tschamut2014_sphere tschamut2014 "$tschamut" --hold 4 \
  --vary materials.soil.rolling.share.normal.mean=0.3:0.6 --trials 5
