#!/usr/bin/env bash
# Reads any bytes as files of points, each format for SECONDS, with clang's libFuzzer and sanitizers
# (Debian's clang-14 and libclang-rt-14-dev). What breaks a reader is left in build-fuzz/.
#
#   tests/fuzz/run.sh SECONDS [FORMAT...]     FORMAT: las ply pcd csv bin
set -euo pipefail
seconds=${1:?how many seconds each format gets}
shift
formats=("$@")
[ ${#formats[@]} -gt 0 ] || formats=(las ply pcd csv bin)
root=$(cd "$(dirname "$0")/../.." && pwd)
out=$root/build-fuzz
cxx=${CXX:-clang++-14}
mkdir -p "$out/objects"
cd "$root"

mrpt=()
for folder in /usr/include/mrpt/*/include; do mrpt+=(-isystem "$folder"); done
libraries=(-lmrpt-config -lmrpt-math -lmrpt-core -lmrpt-system -lgdal -lz -llzf)
flags=(-std=c++17 -g -O1 -fno-omit-frame-pointer -fsanitize=address,undefined,float-cast-overflow
       -fno-sanitize-recover=undefined -isystem /usr/include/eigen3 -isystem /usr/include/gdal
       -Imrpt_mapconv/include
       "${mrpt[@]}")

objects=()
newest=$(find mrpt_mapconv -name '*.h' -printf '%T@ %p\n' | sort -n | tail -1 | cut -d' ' -f2)
for source in mrpt_mapconv/src/{cloud,files,params}/*.cpp mrpt_mapconv/src/grid/CoordinateSystem.cpp; do
  case $source in */files/Object*) continue ;; esac # of MRPT's objects, which no cloud needs
  object=$out/objects/$(basename "$source").o
  { [ "$object" -nt "$source" ] && [ "$object" -nt "$newest" ]; } || "$cxx" "${flags[@]}" -fsanitize=fuzzer-no-link -c "$source" -o "$object"
  objects+=("$object")
done
"$cxx" "${flags[@]}" tests/fuzz/make_seeds.cpp "${objects[@]}" "${libraries[@]}" -o "$out/make_seeds"
"$out/make_seeds" "$out/seeds"

for format in "${formats[@]}"; do
  "$cxx" "${flags[@]}" -fsanitize=fuzzer "-DMAPCONV_FUZZ_NAME=\"a.$format\"" tests/fuzz/fuzz_cloud.cpp \
    "${objects[@]}" "${libraries[@]}" -o "$out/fuzz_$format"
  mkdir -p "$out/corpus/$format"
  # no header may have memory taken that the file does not fill
  "$out/fuzz_$format" "$out/corpus/$format" "$out/seeds/$format" -max_total_time="$seconds" \
    -max_len=4096 -malloc_limit_mb=64 -rss_limit_mb=1024 -timeout=10 -print_final_stats=1 \
    -artifact_prefix="$out/broke_${format}_"
done
