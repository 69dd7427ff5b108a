#!/bin/sh
# Installs those of Debian's packages that are missing, and first says how many they are and how large. The Makefile has their list.
#   SUDO=sudo packages.sh NAME...
set -eu
missing=
for name; do
  # A program may also come from elsewhere.
  command -v "$name" > /dev/null ||
    dpkg-query -W -f '${Status}' "$name" 2> /dev/null | grep -q 'ok installed' || missing="$missing $name"
done
[ -n "$missing" ] || exit 0

apt_get() { $SUDO env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q --no-install-recommends "$@"; }
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt_get update > "$log" 2>&1 || cat "$log"  # an index that is older may do
# With --assume-no, apt plans, says what it would do, and ends with an error.
apt_get install --assume-no $missing > "$log" 2>&1 || true
plan() { sed -n "s/$1/\\1/p" "$log"; }
count=$(plan '.* \([0-9]*\) newly installed.*')
fetched=$(plan 'Need to get \(.*\) of archives.*')
size=$(plan 'After this operation, \(.*\) of additional.*')
[ -z "$count" ] || echo "Installing $count packages of Debian, $fetched to fetch and $size on disk, for$missing"
apt_get install -y $missing > "$log" 2>&1 || { cat "$log"; exit 1; }
