#!/usr/bin/env bash
# Unpacks what the core needs of Debian's arm64 packages into FOLDER, without touching the
# machine's own packages: fetch_packages.sh FOLDER
set -euo pipefail
folder=$(realpath -m "$1")
[ -e "$folder/complete" ] && exit
mkdir -p "$folder"/{lists/partial,cache/archives/partial,packages}
options=(-qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::status=/dev/null
  -o Dir::State::Lists="$folder/lists" -o Dir::Cache="$folder/cache" -o APT::Sandbox::User=)
apt-get "${options[@]}" update
cd "$folder/packages"
apt-get "${options[@]}" download libhwy1 libhwy-dev libtbb12 libtbbmalloc2 libtbbbind-2-5 libtbb-dev libgtest-dev
for package in *.deb; do
  dpkg -x "$package" "$folder/root"
done
touch "$folder/complete"
