#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
#
# check.sh LIMN NAME FOLDER: draws a picture into the folder, by the pipeline and by the reference
# renderer; fails if either differs from the golden image.
set -euo pipefail
source Testing/Image/pictures.sh
golden=Data/Golden/$2.png
if [ ! -f "$golden" ]; then
  echo "$golden is not there; ./dev golden draws it" >&2
  exit 1
fi
draw "$1" "$2" "$3/$2.png"
LIMN_RENDERER=reference draw "$1" "$2" "$3/$2.reference.png"
"$1" compare "$golden" "$3/$2.png"
"$1" compare "$3/$2.reference.png" "$3/$2.png"
