# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by check.sh and golden.sh, in the root of the source.
pictures=Testing/Image/pictures.txt

names() { sed -n 's/^\([a-z0-9_]*\)[:!] .*/\1/p' "$pictures"; }

# draw LIMN NAME FILE: what pictures.txt says of a name, small, without a display
draw() {
  local line arguments
  line=$(grep "^$2[:!] " "$pictures")
  eval "arguments=(${line#*[:!] })"
  case $line in
    "$2! "*) env -u DISPLAY "$(dirname "$1")/${arguments[0]}" "${arguments[@]:1}" "$3" 240 180 ;;
    *) env -u DISPLAY "$1" render --resolution=240,180 "${arguments[@]}" --output="$3" ;;
  esac
}
