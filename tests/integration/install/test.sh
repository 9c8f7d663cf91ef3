#!/usr/bin/env bash
# Installs the build into an empty prefix, builds a small consumer and the first example against it
# with find_package, runs them and the installed program.  Usage: test.sh BUILD_FOLDER
set -euo pipefail
build=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/prefix" >/dev/null
find "$work"/prefix/lib* -name libmrpt_mapconv.so | grep -q .
test -f "$work/prefix/share/mrpt_mapconv/config/freeSpaceGrid/observations2map.ini"
test -f "$work/prefix/include/mrpt_mapconv/maps/CFreeSpaceGridMap2D.h"

cmake -S "$here" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$work/prefix" >"$work/log" 2>&1 ||
  { cat "$work/log"; exit 1; }
cmake --build "$work/consumer" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
"$work/consumer/consumer"
(cd "$work" && ./consumer/01_convert)

# the installed program must find the installed library, not the one in the build folder
env -u LD_LIBRARY_PATH ldd "$work/prefix/bin/mapconv" | grep "libmrpt_mapconv" | grep -q "$work/prefix"
"$work/prefix/bin/mapconv" --version
"$work/prefix/bin/mapconv" run -- true
