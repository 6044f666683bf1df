#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Draws the gallery: draw.sh BUILD_DIR OUT_DIR
# Each picture stands in OUT_DIR/index.html beside the command or the program that made it. Fails if
# any picture does. The pictures in OpenGL windows are drawn on a virtual X server of their own.
set -euo pipefail

if [ $# -ne 2 ]; then
  echo "usage: $0 BUILD_DIR OUT_DIR" >&2
  exit 2
fi
mkdir -p "$2"
programs=$(cd "$1" && pwd)/bin
out=$(cd "$2" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../../.."
meshes=Data/Meshes
page=$(mktemp)
trap 'rm -f "$page"' EXIT

escaped() { sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g'; }

section() { # TITLE TEXT: a heading of the page
  printf '</section>\n<h2>%s</h2>\n<p>%s</p>\n<section>\n' "$1" "$2" >> "$page"
}

show() { # NAME CAPTION LANGUAGE; reads the command or code from stdin
  if [ ! -s "$out/$1.png" ]; then
    echo "draw.sh: $1.png was not drawn" >&2
    exit 1
  fi
  {
    printf '<figure id="%s">\n<a href="%s.png"><img src="%s.png" alt="%s" loading="lazy"></a>\n' \
      "$1" "$1" "$1" "$2"
    printf '<figcaption><b>%s</b>\n' "$2"
    if [ "$3" = code ]; then printf '<details><summary>the program</summary>'; fi
    printf '<pre>'
    escaped
    printf '</pre>'
    if [ "$3" = code ]; then printf '</details>'; fi
    printf '</figcaption>\n</figure>\n'
  } >> "$page"
  echo "  $1.png"
}

command_line() { # ARGUMENT...: one a line, as one would type it
  printf 'limn render'
  printf ' \\\n    %s' "$@"
}

draw() { # NAME CAPTION ARGUMENT...: a picture by `limn render`, with DISPLAY unset
  local name=$1 caption=$2
  shift 2
  rm -f "$out/$name.png"
  env -u DISPLAY "$programs/limn" render "$@" --output="$out/$name.png"
  command_line "$@" "--output=$name.png" | show "$name" "$caption" command
}

draw_in_gl_window() { # the same in an OpenGL window
  local name=$1 caption=$2
  shift 2
  rm -f "$out/$name.png"
  xvfb-run -a "$programs/limn" render "$@" --window=gl --output="$out/$name.png"
  command_line "$@" --window=gl "--output=$name.png" | show "$name" "$caption" command
}

program() { # NAME CAPTION COMMAND...: a picture by a program of this folder, which NAME names
  local name=$1 caption=$2
  shift 2
  run_program "$name" "$caption" "$@" "$programs/$name"
}

run_program() { # NAME CAPTION COMMAND...: likewise, with the program in the command
  local name=$1 caption=$2
  shift 2
  rm -f "$out/$name.png"
  "$@" "$out/$name.png"
  sed -e '1,/^$/d' "$here/$name.cxx" | show "$name" "$caption" code
}

report() { # a line of text under the pictures, from a command that must succeed
  printf '</section>\n<pre class="report">%s\n%s</pre>\n<section>\n' "$1" "$2" >> "$page"
}

echo "drawing into $out"
teapot="$meshes/teapot.obj"
lamp=--light=directional:1,-1,-1:1,1,1
dim=--ambient-light=0.15,0.15,0.15

section "Shading" "How often light is evaluated: once per face, per vertex, or per pixel."
draw teapot "The default" "$teapot"
draw teapot_flat "Flat" "$teapot" --shading=flat "$lamp" "$dim"
draw teapot_gouraud "Gouraud" "$teapot" --shading=gouraud "$lamp" "$dim"
draw teapot_phong "Phong" "$teapot" --shading=phong "$lamp" "$dim"

section "Technical illustration" "Tones instead of darkness, and lines where a surface turns away."
draw teapot_gooch "Gooch: warm faces the light" "$teapot" --tone=gooch "$lamp"
draw teapot_gooch_chapter "Gooch as the chapter prints it: cool faces the light" \
  "$teapot" --tone=gooch-chapter "$lamp"
draw teapot_outline "Outline where |n.v| is small" \
  "$teapot" --reflection=none --specular=0,0,0 --color=1,1,1 --outline=normal --samples=8
draw teapot_outline_even "Outline of two pixels, whatever the surface" \
  "$teapot" --reflection=none --specular=0,0,0 --color=1,1,1 --outline=normal --outline-width=2 --samples=8
draw teapot_toon "Toon: light in three steps" "$teapot" --tone=toon --color=0.85,0.35,0.2 --ambient=0.85,0.35,0.2 \
  --specular=0.35,0.35,0.35 --specular-power=60 --light=directional:0.7,-1,-0.8:0.7,0.7,0.7 \
  --ambient-light=0.4,0.4,0.46 --outline=normal --outline-width=2
draw knot_toon_gooch "Gooch in five steps, lit from above and the right of the camera" "$meshes/knot.obj" --tone=gooch \
  --toon-steps=5 --tone-light=upper-right --color=0.6,0.6,0.6 --specular=0.4,0.4,0.4
draw teapot_metal "Milled metal" "$teapot" --tone=metal --tone-light=upper-right --outline=normal --outline-width=2
draw knot_toon_ramp "X-Toon: far parts lose their contrast" "$meshes/knot.obj" \
  --toon-ramp=Data/Textures/toon_ramp.png --light=directional:0.7,-1,-0.8:1,1,1 --toon-ramp-range=11,15
draw teapot_matcap "A picture of a lit sphere" "$teapot" --matcap=Data/Textures/lit_sphere.png
draw knot_hatching "Hatching, as dense as it is dark" "$meshes/knot.obj" --tone=hatching "$lamp" "$dim" \
  --outline=normal --outline-width=1.5 --samples=8
draw rock_lambert "A rock by Lambert's cosine: half of it is black" "$meshes/rock.ply" --reflection=lambert --color=1,1,1 \
  --light=directional:-1,-1,-0.6:1,1,1
draw rock_exaggerated "Exaggerated shading by the same light: dents, ridges and grain on both sides" "$meshes/rock.ply" \
  --tone=exaggerated --light=directional:-1,-1,-0.6:1,1,1 --samples=8
draw teapot_hull "Outline by inverted hull, equally wide" \
  "$teapot" --reflection=none --specular=0,0,0 --color=1,1,1 --outline=hull --outline-width=3 --samples=8
draw knot_gooch_hull "Gooch with such an outline" "$meshes/knot.obj" --tone=gooch --outline=hull \
  --outline-width=3 --samples=8 "$lamp"
draw knot_gooch_outline "Gooch with the other" "$meshes/knot.obj" --tone=gooch --outline=normal "$lamp"

draw knot_shadow_lines "Lines where the light ends: terminators and borders of cast shadows" "$meshes/knot.obj" --color=1,1,1 \
  --light=directional:-1,-0.5,-0.5:0.6,0.6,0.6 --ambient-light=0.45,0.45,0.45 --lines=contour,terminator,shadow \
  --stroke-width=1.4 --samples=8
draw intersection_lines "Lines where parts run into each other" "$meshes/torus.off" "$meshes/sphere.ply" --feature-angle=40 \
  --color=0.95,0.93,0.88 --light=directional:1,-1.2,-0.6:0.7,0.7,0.7 --ambient-light=0.4,0.4,0.4 \
  --lines=contour,intersections,terminator,shadow --stroke-width=1.4 --samples=8

section "Styles" "By one word: vtkLimnStyle in a program, --style on the command line. First, as VTK draws surfaces."
draw style_plain "plain" "$teapot" --style=plain --samples=8
draw style_technical "technical" "$meshes/gear.stl" --style=technical --samples=8
draw style_gooch "gooch" "$meshes/knot.obj" --style=gooch --samples=8
draw style_toon "toon" "$teapot" --style=toon --samples=8 --color=0.85,0.35,0.2
draw style_blueprint "blueprint" "$meshes/gear.stl" --style=blueprint --samples=8
draw style_pencil "pencil" "$teapot" --style=pencil --samples=8
draw style_ink "ink" "$teapot" --style=ink --samples=8
draw style_anatomy "anatomy" "$meshes/knot.obj" --style=anatomy --samples=8 --color=0.85,0.55,0.45
draw style_metal "metal" "$teapot" --style=metal --samples=8
draw style_xray "xray" "$teapot" --style=xray --samples=8
draw style_print "print" "$meshes/gear.stl" --style=print --samples=8

section "Light" "Point lights fall off with the square of the distance; spots have a cone."
draw lights_point "Three coloured point lights" "$meshes/sphere.ply" --color=0.9,0.9,0.9 \
  --light=point:-2,1.5,1.5:4,0.6,0.6 --light=point:2,1.5,1.5:0.6,4,0.6 \
  --light=point:0,-2,1.5:0.6,0.6,4 --background-color=0.1,0.1,0.12
draw lights_spot "A spot on a sheet" "$meshes/sheet.off" \
  --light=spot:0,3,0:0,-1,0:20:4:9,8,6 --ambient-light=0.2,0.2,0.25
draw gear_flat "Polygons of a gear, one colour each" "$meshes/gear.stl" --shading=flat "$lamp" "$dim"
draw reflection_lambert "Lambert: no highlight" "$meshes/torus.off" --reflection=lambert "$lamp" "$dim"
draw reflection_blinn_phong "Blinn-Phong" "$meshes/torus.off" --reflection=blinn-phong \
  --specular=0.7,0.7,0.7 --specular-power=40 "$lamp" "$dim"
draw reflection_phong "Phong's reflected ray" "$meshes/torus.off" --reflection=phong \
  --specular=0.7,0.7,0.7 --specular-power=40 "$lamp" "$dim"

section "Shaders" "Programs for the colour of visible points and for the place of vertices."
run_program height_contours "A surface shader: contours of height" \
  env -u DISPLAY "$programs/height_contours" "$teapot"
run_program rippled_mesh "A vertex shader: a wave that runs up" \
  env -u DISPLAY "$programs/rippled_mesh" "$teapot"

section "Colour by data" "An array of the mesh through a map."
draw waves "viridis" "$meshes/waves.vtp" --coloring-array=height
draw waves_cool_warm "cool-warm" "$meshes/waves.vtp" --coloring-array=height --colormap=cool-warm

section "Samples" "More samples per pixel make smoother edges."
draw samples_1 "1 sample" "$meshes/gear.stl" --samples=1 --resolution=320,192 "$lamp" "$dim"
draw samples_8 "8 samples" "$meshes/gear.stl" --samples=8 --resolution=320,192 "$lamp" "$dim"

section "Windows" "The same picture in an OpenGL window and in Limn's own, which needs neither \
OpenGL nor a display; and a program in which Limn and OpenGL share a window."
draw window_cpu "Limn's own window" "$teapot" --tone=gooch "$lamp" --samples=1
draw_in_gl_window window_gl "An OpenGL window" "$teapot" --tone=gooch "$lamp" --samples=1
difference=$("$programs/limn" compare "$out/window_cpu.png" "$out/window_gl.png") || [ $? -eq 3 ]
report "limn compare window_cpu.png window_gl.png" "$difference"
program intersecting_actors "Limn's sphere through OpenGL's cone" xvfb-run -a
program without_opengl "The same scene without OpenGL" env -u DISPLAY

{
  cat <<'HEAD'
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Limn: gallery</title>
<style>
body { margin: 0 auto; max-width: 72rem; padding: 1rem 1.5rem 4rem; color: #222; background: #fff;
  font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 2.2rem; margin-bottom: 0; }
h2 { margin: 3rem 0 0; border-bottom: 1px solid #ccc; }
section { display: grid; grid-template-columns: repeat(auto-fill, minmax(30rem, 1fr)); gap: 2rem; }
figure { margin: 0; min-width: 0; }
img { width: 100%; border: 1px solid #ddd; border-radius: 4px; }
#samples_1 img, #samples_8 img { image-rendering: pixelated; }
pre { overflow-x: auto; padding: .7rem .9rem; background: #f4f5f7; border-radius: 4px;
  font: 13px/1.45 ui-monospace, monospace; }
summary { cursor: pointer; }
@media (max-width: 34rem) { section { grid-template-columns: 1fr; } }
</style>
</head>
<body>
<h1>Limn</h1>
<p>Every picture here was drawn on the CPU, by the command or the program that stands below it.</p>
<section>
HEAD
  cat "$page"
  printf '</section>\n</body>\n</html>\n'
} > "$out/index.html.part"
mv "$out/index.html.part" "$out/index.html"
echo "gallery: $out/index.html"
