#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
#
# golden.sh LIMN: draws all golden images, replaces those that differ, and says by how much.
set -euo pipefail
source Testing/Image/pictures.sh
mkdir -p Data/Golden
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
for name in $(names); do
  draw "$1" "$name" "$fresh/$name.png"
  golden=Data/Golden/$name.png
  if [ ! -f "$golden" ]; then
    echo "$name: new"
  elif difference=$("$1" compare "$golden" "$fresh/$name.png"); then
    continue
  else
    echo "$name: $difference"
  fi
  mv "$fresh/$name.png" "$golden"
done
for file in Data/Golden/*.png; do
  name=$(basename "$file" .png)
  names | grep -qx "$name" || echo "$file: no line of $pictures draws it"
done
