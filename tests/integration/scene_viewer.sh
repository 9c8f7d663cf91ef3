#!/usr/bin/env bash
# Opens a map.3Dscene of ours in the stock SceneViewer3D, without the plugin, and looks at the window:
# it must come up and show more than its empty background.
# Usage: scene_viewer.sh MAPCONV [PICTURE.png]
set -euo pipefail
mapconv=$1
work=$(mktemp -d)
picture=${2:-$work/window.png}
cleanup() { kill "${viewer:-}" "${server:-}" 2>/dev/null || true; rm -rf "$work"; }
trap cleanup EXIT

"$mapconv" sample-map building -o "$work/building.bt"
"$mapconv" convert "$work/building.bt" -o "$work/maps" >/dev/null 2>&1

exec 3<>"$work/number" || true
Xvfb -displayfd 3 -screen 0 1280x900x24 >/dev/null 2>&1 3>"$work/number" &
server=$!
for _ in $(seq 50); do [ -s "$work/number" ] && break; sleep 0.2; done
export DISPLAY=:$(cat "$work/number") LIBGL_ALWAYS_SOFTWARE=1 HOME=$work

env -u LD_PRELOAD SceneViewer3D "$work/maps/map.3Dscene" >"$work/log" 2>&1 </dev/null &
viewer=$!
colours=0
for _ in $(seq 40); do
  sleep 1
  kill -0 "$viewer" 2>/dev/null || { echo "SceneViewer3D ended:"; cat "$work/log"; exit 1; }
  import -window root "$picture" 2>/dev/null || continue
  colours=$(identify -format %k "$picture")
  [ "$colours" -gt 200 ] && break
done
if grep -qiE "exception|unknown class|not registered" "$work/log"; then cat "$work/log"; exit 1; fi
[ "$colours" -gt 200 ] || { echo "only $colours colours on the screen"; exit 1; }
echo "SceneViewer3D shows $colours colours"
