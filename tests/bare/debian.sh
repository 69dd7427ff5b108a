#!/bin/sh
# make test-bare: the first commands of the README where only Debian's base is installed. Needs root, debootstrap and a network.
#   debian.sh FOLDER < SOURCES.tar     makes the roots FOLDER/sources and FOLDER/user
# In `sources`: `make demo` where npm reaches nothing, then `make deb`. In `user`, which has no compiler: the packages, a run whose
# rows have the bytes of those in `sources`, and a raster that GDAL reads.
set -eu
folder=$(realpath -m "$1")
sources=$folder/sources user=$folder/user
if [ -z "${IN_NAMESPACE:-}" ]; then
  # What is mounted here goes with the process.
  unshare --mount true || { echo "SKIPPED: mounts of its own are not allowed here"; exit 0; }
  IN_NAMESPACE=1 exec unshare --mount "$0" "$@"
fi
fail() { echo "test-bare: $*" >&2; exit 1; }
has() { grep -qF "$1" "$2" || fail "no \`$1\` in $2"; }
in_root() {
  root=$1; shift
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C DEBIAN_FRONTEND=noninteractive "$@"
}
seconds() { date +%s; }

release=bookworm
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' "Codename: $release" 'Component: main' | head -n 1)
rm -rf "$folder"
mkdir -p "$folder/flyrock"
tar -xC "$folder/flyrock"
debootstrap --variant=minbase $release "$sources" $mirror > "$folder/debootstrap.log" || { cat "$folder/debootstrap.log"; exit 1; }
cp -a "$sources" "$user"
for root in "$sources" "$user"; do
  mount -t proc proc "$root/proc"
  in_root "$root" apt-get update -qq
done

in_root "$sources" apt-get install -y -qq --no-install-recommends make > /dev/null 2>&1
mv "$folder/flyrock" "$sources/flyrock"
start=$(seconds)
in_root "$sources" npm_config_registry=http://127.0.0.1:9 make -C /flyrock demo > "$folder/demo.log" 2>&1 || { tail -n 40 "$folder/demo.log"; fail "make demo"; }
times > "$folder/times"
echo "make demo: $(($(seconds) - start)) s, $(sed -n '2s/m.*//p' "$folder/times") minutes of processor time"
grep -E '^(Installing|Compiling|npm|report)' "$folder/demo.log"
has 'npm cannot fetch Plotly' "$folder/demo.log"
has 'Plots are missing' "$sources/flyrock/out/benches_2d/report.html"

start=$(seconds)
in_root "$sources" make -C /flyrock deb > "$folder/deb.log" 2>&1 || { tail -n 40 "$folder/deb.log"; fail "make deb"; }
echo "make deb: $(($(seconds) - start)) s"
grep -E '^(Installing|Compiling|npm|out/)' "$folder/deb.log"

cp "$sources"/flyrock/out/deb/flyrock_*.deb "$sources"/flyrock/out/deb/flyrock-gdal_*.deb "$user/tmp"
in_root "$user" sh -c 'apt-get install -y -qq --no-install-recommends /tmp/*.deb' > "$folder/install.log" 2>&1 || { cat "$folder/install.log"; fail "the packages"; }
in_root "$user" sh -c '! command -v cc && ! command -v c++ && ! command -v make' || fail "a compiler in $user"
in_root "$user" flyrock --version
quarry=ninh_dan/benches_2d.yaml
in_root "$user" flyrock run /usr/share/flyrock/scenarios/$quarry --trials 50 --quiet -o /tmp/out
in_root "$sources" /flyrock/build/bench/bin/flyrock run /flyrock/scenarios/$quarry --trials 50 --quiet -o /tmp/out
cmp "$user/tmp/out/rocks.csv" "$sources/tmp/out/rocks.csv"

# A grid in text, under an ending that only GDAL knows.
in_root "$user" sh -c 'cd /tmp && cp -r /usr/share/flyrock/plugins/terrain/raster r && cd r && mv slope.asc slope.agr &&
  sed -i s/slope.asc/slope.agr/ example.yaml && flyrock run example.yaml --trials 2 --quiet -o out && test -s out/rocks.csv'
echo "the packages run in a root without compilers"
umount "$sources/proc" "$user/proc"
rm -rf "$folder"
