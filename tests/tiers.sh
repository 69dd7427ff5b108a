#!/bin/sh
# tiers.sh test | heavy [JOBS]: builds and runs the tests tier by tier, and ends with the minutes of each.
set -e
kind=$1
jobs=${2:-2}
# One test more than processors: many wait for the disk or for another process.
tests=$((jobs + 1))

# Under sanitizers in `make test`: all that reads texts and files, what the parts of the engine do one by one, and each
# shipped scenario once, which visits all of them together. The rest, which computes much, in `make test-heavy`.
sanitized="unit scenarios fuzz cli golden"
others="analytic conformance solver"

report=""
trap 'printf "%s" "$report"' EXIT

# tier NAME COMMAND...: runs a command, and notes its time.
tier() {
  name=$1
  shift
  start=$(date +%s)
  code=0
  "$@" || code=$?
  seconds=$(($(date +%s) - start))
  report="$report$(printf '%3d:%02d min  %s' $((seconds / 60)) $((seconds % 60)) "$name")
"
  return $code
}

build() { make --no-print-directory "build-$1" TARGETS="$2"; }
programs() { for folder in $1; do printf 'flyrock_%s_tests ' "$folder"; done; }
# run PRESET LABELS FOLDERS
run() {
  ctest --test-dir "build/$1" -L "$2" -R "^($(echo $3 | tr ' ' '|')):" -j $tests --output-on-failure
}

if [ "$kind" = test ]; then
  tier "build with sanitizers" build dev "$(programs "$sanitized")"
  tier "fast tests with sanitizers ($sanitized)" run dev fast "$sanitized"
  tier "build of the release" build release
  tier "fast and full tests of the release" run release 'fast|full' "$sanitized $others format"
else
  tier "build with sanitizers" build dev
  tier "fast tests with sanitizers ($others)" run dev fast "$others"
  tier "build of the release" build release
  tests=1
  tier "heavy tests of the release" run release heavy "$sanitized $others"
fi
