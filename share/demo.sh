#!/usr/bin/env bash
# The one demo command: installs packages, builds, makes maps and says where the pictures are.
#   share/demo.sh            a simulated building, mapped, planned in and lifted to 3D; a simulated
#                            office, mapped from 3D scans; simulated stairs, measured; real scans
#   share/demo.sh MY.bt      your own map (.bt, .ot, .simplemap, .rawlog) [and flags of mapconv convert]
# Results go to ./mapconv-demo (or to $MRPT_MAPCONV_DEMO).
set -euo pipefail
case "${1:-}" in -h | --help)
  sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}"
  exit 0
  ;;
esac
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${MRPT_MAPCONV_BUILD:-$root/build}
out=$(realpath -m "${MRPT_MAPCONV_DEMO:-mapconv-demo}")
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

simulated_building() {
  local dir=$out/building
  echo
  echo "== building: a simulated robot with a 2D scanner and a lidar"
  "$mapconv" simulate "$root/config/worlds/building.ini" -o "$dir/run"
  made+=("$dir/run")

  echo
  echo "== building: its log in MRPT's own icp-slam, with our map (half a minute)"
  mkdir -p "$dir/icp-slam"
  (cd "$dir/icp-slam" &&
    "$mapconv" run -- icp-slam "$root/config/freeSpaceGrid/icp-slam.ini" "$dir/run/scans.rawlog" </dev/null >icp-slam.log 2>&1) ||
    { tail -n 5 "$dir/icp-slam/icp-slam.log" >&2; exit 1; }
  made+=("$dir/icp-slam")

  convert building/map "$dir/run/scans.simplemap" --min-clearance 0.8 --max-step 0.15 --max-slope 0.5

  echo
  echo "== building: paths"
  local west=-2.5,1.5 east=5,-1.5
  "$mapconv" plan "$dir/map" --robot ground --from "$west" --to "$east" --robot-radius 0.25 -o "$dir/paths/ground.csv"
  "$mapconv" plan "$dir/map" --robot aerial --from "$west" --to "$east" --robot-radius 0.3 -o "$dir/paths/aerial.csv"
  "$mapconv" lift "$dir/map" "$dir/paths/ground.csv" --robot aerial --safety-radius 0.2 --height-offset 1.2 \
    -o "$dir/paths/ground_flown.csv"
  made+=("$dir/paths")
}

simulate() { # WORLD DIR: keeps the simplemap of its logs, which suffices here: the office has 0.7 GB of rawlogs
  "$mapconv" simulate "$root/config/worlds/$1.ini" -o "$2"
  rm -f "$2"/{scans,frames}.rawlog
  made+=("$2")
}

scanned_office() {
  local dir=$out/office
  echo
  echo "== office: a simulated robot with a 128-beam lidar among furniture, glass and people (a minute)"
  simulate office "$dir/run"

  echo
  echo "== office: a 2D map of whole shapes, with reflections cut and without"
  "$mapconv" insert "$dir/run/scans.simplemap" -c "$root/config/scanShapeGrid/insert.ini" -o "$dir/map"
  "$mapconv" insert "$dir/run/scans.simplemap" -c "$root/config/scanShapeGrid/insert.ini" --no-reflection-filter -o "$dir/uncut"
  made+=("$dir/map" "$dir/uncut")
}

measured_stairs() {
  local dir=$out/stairs
  echo
  echo "== stairs: a simulated legged robot with a depth camera and a lidar (some seconds)"
  simulate stairs "$dir/run"

  echo
  echo "== stairs: planes and leaves; each step on the robot's way beside the true one"
  "$mapconv" terrain "$dir/run/scans.simplemap" -o "$dir/map" --resolution 0.02 --truth "$root/config/worlds/stairs.ini"
  made+=("$dir/map")
}

flown_forest() {
  local dir=$out/forest
  echo
  echo "== forest: a simulated lidar above trees on terraces (some seconds)"
  simulate ground_steps "$dir/run"

  echo
  echo "== forest: the ground below the trees, and the height above it"
  "$mapconv" ground "$dir/run/scans.simplemap" -o "$dir/map" --points "$dir/classified.las"
  made+=("$dir/map")
}

if [ $# -gt 0 ]; then
  convert "own/$(basename -- "$1")" "$@"
else
  mkdir -p "$out"
  simulated_building
  scanned_office
  measured_stairs
  flown_forest
  # one scan leaves gaps between its beams: coarse voxels and a low robot; and it saw hardly any
  # ground, so that the lowest free voxel has to do for it
  convert velodyne "$data/test_velodyne_VLP16.rawlog" --resolution 0.4 --min-clearance 0.4 --floor-from lowestFree
  convert rgbd "$data/tests_rgbd.rawlog" --resolution 0.05 --min-clearance 0.3 --floor-from lowestFree
fi
show() { # the pictures that say most, side by side; on a desktop in a window
  local pictures=() picture
  for picture in "$out/building"/{run/truth_ground,icp-slam/LOG_ICP-SLAM/*_ground,map/floor,paths/ground,paths/aerial}.png \
    "$out/office"/{run/truth_ground,map/map,uncut/map}.png "$out/stairs/map"/{leaves,height,traversability}.png \
    "$out/forest/map"/{ground,aboveGround}.png; do
    [ -f "$picture" ] && pictures+=("$picture")
  done
  [ ${#pictures[@]} -gt 0 ] || return 0
  montage "${pictures[@]}" -tile 3x -geometry 800x700+8+8 "$out/overview.png" || return 0
  echo "Overview: $out/overview.png"
  if [ -t 1 ] && [ -n "${DISPLAY:-}" ] && command -v xdg-open >/dev/null; then
    xdg-open "$out/overview.png" >/dev/null 2>&1 &
  fi
}

echo
echo "Pictures:"
find "${made[@]}" -name '*.png' | sort
echo "In 3D:"
find "${made[@]}" -name '*.3Dscene' | sort | while read -r scene; do printf 'SceneViewer3D %q\n' "$scene"; done
[ $# -gt 0 ] || show
echo "The program: $mapconv (try: $mapconv --help)"
