#!/usr/bin/env bash
# The one test command: installs packages, builds in Release, runs all tests.
# Usage: tests/run.sh [ctest arguments, e.g. -R Conversion]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${MRPT_MAPCONV_BUILD:-$root/build}

"$root/share/setup.sh"
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DMRPT_MAPCONV_TESTS=ON -DMRPT_MAPCONV_WERROR=ON
cmake --build "$build" --parallel "$(nproc)"
cd "$build"
exec ctest --output-on-failure --parallel "$(nproc)" "$@"
