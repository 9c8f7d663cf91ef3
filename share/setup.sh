#!/usr/bin/env bash
# Installs from Debian what mrpt_mapconv needs to be built, run and tested. Quick when all is there.
set -euo pipefail

packages=(
  g++ cmake make git
  libmrpt-dev mrpt-apps mrpt-common
  libeigen3-dev liboctomap-dev libgdal-dev libtbb-dev libembree-dev libcli11-dev zlib1g-dev liblzf-dev
  libgtest-dev libbenchmark-dev
  gnuplot-nox xvfb imagemagick
)

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed ||
    missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root() { if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi; }
echo "Installing from Debian: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
as_root apt-get -o DPkg::Lock::Timeout=300 update -qq
as_root env DEBIAN_FRONTEND=noninteractive \
  apt-get -o DPkg::Lock::Timeout=300 install -y -qq --no-install-recommends "${missing[@]}"
