#!/bin/sh
# make archive: flyrock with all that it needs, the C library included, for x86-64 Linux older than the system that built it.
#   archive.sh BUILD FOLDER         writes FOLDER/flyrock-VERSION-linux-x86_64.tar.gz
#   archive.sh BUILD FOLDER gdal    writes FOLDER/flyrock-gdal-VERSION-linux-x86_64.tar.gz, which reads the formats of GDAL too
# bin/flyrock is a script that calls libexec/flyrock: the loader of the C library under another name, which takes every library
# from lib/system. The program itself is lib/flyrock/program. libexec is as deep as bin, so that flyrock finds its share and
# lib by its own place, as where it is installed.
set -eu
build=$(cd "$1" && pwd)
with=${3:-}
mkdir -p "$2"
folder=$(cd "$2" && pwd)
version=$("$build/bin/flyrock" --version | sed -n '1s/flyrock \([^ ]*\).*/\1/p')
name=flyrock${with:+-$with}-$version-linux-$(uname -m)
tree=$folder/$name
rm -rf "$tree"
for component in flyrock $with; do
  DESTDIR='' cmake --install "$build" --prefix "$tree" --component "$component" --strip > "$folder/log.txt" 2>&1 || { cat "$folder/log.txt"; exit 1; }
done
rm "$folder/log.txt"
if [ -n "$with" ] && [ ! -e "$tree/lib/flyrock/flyrock_$with.so" ]; then
  echo "$build was built without flyrock_$with.so: \`make packages-deb\` installs what it needs, then build again" >&2
  exit 1
fi

mkdir -p "$tree/libexec" "$tree/lib/system" "$tree/share/doc/flyrock/licences"
mv "$tree/bin/flyrock" "$tree/lib/flyrock/program"
ldd "$tree/lib/flyrock/program" "$tree"/lib/flyrock/*.so | sed -n 's/.*=> \(\/[^ ]*\).*/\1/p' | sort -u > "$folder/libraries"
loader=$(ldd "$tree/lib/flyrock/program" | sed -n 's/^[[:space:]]*\(\/[^ ]*ld-linux[^ ]*\).*/\1/p')
cp -L "$loader" "$tree/libexec/flyrock"
# The licence of a package that something comes from, and where its sources are: Debian keeps those of every version.
licences=$tree/share/doc/flyrock/licences
note_package() {
  if [ -n "$1" ] && [ -e "/usr/share/doc/$1/copyright" ]; then
    cp -L "/usr/share/doc/$1/copyright" "$licences/$1"
    dpkg-query -W -f '${Package} ${Version}, of the sources ${source:Package} ${source:Version}\n' "$1" |
      head -n 1 >> "$folder/packages"
  else
    echo "no licence found for $2" >&2
  fi
}
while read -r library; do
  cp -L "$library" "$tree/lib/system/"
  # Debian's libraries are in /usr/lib, also where /lib is a link to it.
  package=$(dpkg-query -S "$(readlink -f "$library")" 2> /dev/null || dpkg-query -S "$library" 2> /dev/null || true)
  note_package "${package%%:*}" "$library"
done < "$folder/libraries"

# What GDAL and PROJ look up in the system: definitions, systems of coordinates, and the character sets of the C library.
variables=
if [ "$with" = gdal ]; then
  mkdir -p "$tree/share/gdal" "$tree/share/proj"
  cp -LR /usr/share/gdal/. "$tree/share/gdal"
  cp -LR /usr/share/proj/. "$tree/share/proj"
  cp -LR "$(dirname "$(readlink -f "$(grep '/libc\.so\.6$' "$folder/libraries")")")/gconv" "$tree/lib/system/gconv"
  note_package gdal-data /usr/share/gdal
  note_package proj-data /usr/share/proj
  variables='export GDAL_DATA="$here/share/gdal" PROJ_DATA="$here/share/proj" PROJ_LIB="$here/share/proj"
export GDAL_DRIVER_PATH=disable GCONV_PATH="$here/lib/system/gconv"
'
fi
sort -u "$folder/packages" > "$licences/packages.txt"
rm "$folder/libraries" "$folder/packages"

{
  cat <<'END'
#!/bin/sh
# Starts flyrock with the libraries of this folder, whatever the system has. Links to this file may be anywhere.
self=$0
while [ -h "$self" ]; do
  target=$(readlink "$self")
  case $target in /*) self=$target ;; *) self=${self%/*}/$target ;; esac
done
case $self in */*) here=${self%/*}/.. ;; *) here=.. ;; esac
END
  printf '%s' "$variables"
  cat <<'END'
exec "$here/libexec/flyrock" --argv0 flyrock --inhibit-cache --library-path "$here/lib/system" "$here/lib/flyrock/program" "$@"
END
} > "$tree/bin/flyrock"
chmod 755 "$tree/bin/flyrock"

# The same files give the same archive.
tar --sort=name --mtime=@"${SOURCE_DATE_EPOCH:-0}" --owner=0 --group=0 --numeric-owner -C "$folder" -cf - "$name" |
  gzip -9n > "$tree.tar.gz"
rm -rf "$tree"
echo "$tree.tar.gz"
