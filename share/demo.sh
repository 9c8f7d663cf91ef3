#!/usr/bin/env bash
# The one demo command: installs packages, builds, converts maps and says where the pictures are.
#   share/demo.sh            real scans that Debian ships, and a generated building
#   share/demo.sh MY.bt      your own map (.bt, .ot, .simplemap, .rawlog) [and flags of mapconv convert]
# Results go to ./mapconv-demo (or to $MRPT_MAPCONV_DEMO).
set -euo pipefail
case "${1:-}" in -h | --help)
  sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}"
  exit 0
  ;;
esac
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${MRPT_MAPCONV_BUILD:-$root/build}
out=${MRPT_MAPCONV_DEMO:-$PWD/mapconv-demo}
data=/usr/share/mrpt/datasets

"$root/share/setup.sh"
# keep the tests in if an earlier run has built them
tests=$(sed -n 's/^MRPT_MAPCONV_TESTS:BOOL=//p' "$build/CMakeCache.txt" 2>/dev/null || true)
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DMRPT_MAPCONV_TESTS="${tests:-OFF}" >/dev/null
cmake --build "$build" --parallel "$(nproc)" --target mapconv
mapconv=$build/bin/mapconv

made=()
convert() { # NAME INPUT FLAGS…
  local name=$1
  shift
  echo
  echo "== $name"
  "$mapconv" convert "$@" -o "$out/$name"
  made+=("$out/$name")
}

if [ $# -gt 0 ]; then
  convert "own/$(basename -- "$1")" "$@"
else
  mkdir -p "$out"
  "$mapconv" sample-map building -o "$out/building.bt"
  convert building "$out/building.bt" --max-step 0.1
  # one scan leaves gaps between its beams: coarse voxels and a low robot
  convert velodyne "$data/test_velodyne_VLP16.rawlog" --resolution 0.4 --min-clearance 0.4
  convert rgbd "$data/tests_rgbd.rawlog" --resolution 0.05 --min-clearance 0.3
fi
echo
echo "Pictures:"
find "${made[@]}" -name '*.png' | sort
echo "In 3D:"
for dir in "${made[@]}"; do printf 'SceneViewer3D %q\n' "$dir/map.3Dscene"; done
echo "The program: $mapconv (try: $mapconv --help)"
