#!/bin/sh
# make archive: flyrock with all that it needs, the C library included, for x86-64 Linux older than the system that built it.
#   archive.sh BUILD FOLDER    writes FOLDER/flyrock-VERSION-linux-x86_64.tar.gz
# bin/flyrock is a script that calls libexec/flyrock: the loader of the C library under another name, which takes every library
# from lib/system. The program itself is lib/flyrock/program. libexec is as deep as bin, so that flyrock finds its share and
# lib by its own place, as where it is installed.
set -eu
build=$(cd "$1" && pwd)
mkdir -p "$2"
folder=$(cd "$2" && pwd)
version=$("$build/bin/flyrock" --version | sed -n '1s/.* //p')
name=flyrock-$version-linux-$(uname -m)
tree=$folder/$name
rm -rf "$tree"
DESTDIR='' cmake --install "$build" --prefix "$tree" --component flyrock --strip > "$folder/log.txt" 2>&1 || { cat "$folder/log.txt"; exit 1; }
rm "$folder/log.txt"

mkdir -p "$tree/libexec" "$tree/lib/system" "$tree/share/doc/flyrock/licences"
mv "$tree/bin/flyrock" "$tree/lib/flyrock/program"
ldd "$tree/lib/flyrock/program" "$tree"/lib/flyrock/*.so | sed -n 's/.*=> \(\/[^ ]*\).*/\1/p' | sort -u > "$folder/libraries"
loader=$(ldd "$tree/lib/flyrock/program" | sed -n 's/^[[:space:]]*\(\/[^ ]*ld-linux[^ ]*\).*/\1/p')
cp -L "$loader" "$tree/libexec/flyrock"
while read -r library; do
  cp -L "$library" "$tree/lib/system/"
  # The licence of each library goes with it. Debian's libraries are in /usr/lib, also where /lib is a link to it.
  package=$(dpkg-query -S "$(readlink -f "$library")" 2> /dev/null || dpkg-query -S "$library" 2> /dev/null || true)
  package=${package%%:*}
  if [ -n "$package" ] && [ -e "/usr/share/doc/$package/copyright" ]; then
    cp -L "/usr/share/doc/$package/copyright" "$tree/share/doc/flyrock/licences/$package"
  else
    echo "no licence found for $library" >&2
  fi
done < "$folder/libraries"
rm "$folder/libraries"

cat > "$tree/bin/flyrock" <<'END'
#!/bin/sh
# Starts flyrock with the libraries of this folder, whatever the system has. Links to this file may be anywhere.
self=$0
while [ -h "$self" ]; do
  target=$(readlink "$self")
  case $target in /*) self=$target ;; *) self=${self%/*}/$target ;; esac
done
case $self in */*) here=${self%/*}/.. ;; *) here=.. ;; esac
exec "$here/libexec/flyrock" --argv0 flyrock --inhibit-cache --library-path "$here/lib/system" "$here/lib/flyrock/program" "$@"
END
chmod 755 "$tree/bin/flyrock"

# The same files give the same archive.
tar --sort=name --mtime=@"${SOURCE_DATE_EPOCH:-0}" --owner=0 --group=0 --numeric-owner -C "$folder" -cf - "$name" |
  gzip -9n > "$tree.tar.gz"
rm -rf "$tree"
echo "$tree.tar.gz"
