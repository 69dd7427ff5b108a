#!/bin/sh
# format.sh CLANG_FORMAT FOLDER: fails where a source is not as .clang-format lays it out, and names it.
case "$("$1" --version 2> /dev/null)" in
  *"version 14."*) ;;
  *) echo "SKIPPED: clang-format 14 is not here (make deps-format)"; exit 0 ;;
esac
cd "$2" || exit 1
find engine lua plugins tests docs -name '*.cpp' -o -name '*.h' | sort | xargs "$1" --dry-run --Werror
