#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
#
# textures.sh LIMN GENERATOR FOLDER: makes the textures of Data/Textures in the folder; fails if one
# has other pixels, or one is missing on either side. (Other versions of zlib write other bytes.)
set -euo pipefail
fresh=$3/textures
rm -rf "$fresh"
mkdir -p "$fresh"
"$2" "$fresh"
diff <(cd Data/Textures && ls -- *.png) <(cd "$fresh" && ls -- *.png)
for file in "$fresh"/*.png; do
  "$1" compare "Data/Textures/$(basename "$file")" "$file"
done
