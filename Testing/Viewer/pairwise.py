#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws scenes in which every two choices of different kinds meet, by the pipeline and by the reference renderer.

pairwise.py LIMN FOLDER, in the root of the source. The pictures have to be the same files, and none may be empty.
"""

import itertools
import os
import pathlib
import subprocess
import sys

# Kind: choices, each a list of options of limn render.
CHOICES = {
    "mesh": [["Data/Meshes/globe.obj"], ["Data/Meshes/board.obj", "--camera-position=0.4,-1.2,1.5"]],
    "light": [
        ["--light=headlight"],
        ["--light=directional:1,-1,-1:1,1,1", "--ambient-light=0.2,0.2,0.2"],
        ["--light=point:2,3,4:20,18,16"],
        ["--light=spot:0,4,4:0,-1,-1:30:4:30,28,26:12"],
        ["--light=rectangle:0,2,4:3,0,0:0,-2,-1:power=90,90,90:7"],
        ["--light=sphere:2,3,4:1.5:18,16,20:5"],
        ["--light=directional:1,0,-1:0.9,0.2,0.2", "--light=point:-3,2,3:3,9,3", "--light=headlight"],
    ],
    "reflection": [
        ["--reflection=none"],
        ["--reflection=lambert", "--rim=0.4,0.2,0.3"],
        ["--reflection=phong", "--specular-power=1"],
        ["--reflection=blinn-phong", "--specular-power=17.5"],
        ["--reflection=blinn-phong", "--fresnel", "--refractive-index=1.4,1.6,2"],
        ["--reflection=irradiance"],
        ["--reflection=oren-nayar", "--roughness=0.8"],
        ["--reflection=metallic", "--metallic=0.7", "--roughness=0.4"],
        ["--model=4"],
        # In place of a reflection: most options of those exclude a tone.
        ["--tone=gooch"],
        ["--tone=gooch-chapter"],
        ["--tone=gooch", "--tone-over-data=undertone"],
        ["--tone=gooch", "--tone-over-data=legend-safe", "--legend-safe-range=20"],
        ["--tone=gooch-rtr4", "--toon-steps=4"],
        ["--tone=metal", "--tone-light=upper-right"],
        ["--tone=toon", "--reflection=oren-nayar"],
        ["--tone=toon", "--toon-steps=5"],
        ["--toon-ramp=Data/Textures/toon_ramp.png"],
        ["--matcap=Data/Textures/lit_sphere.png"],
        ["--tone=hatching", "--hatch-spacing=5"],
        ["--tone=hatching", "--hatch-on=texture", "--hatch-darkest=1"],
        ["--tone=exaggerated", "--exaggeration-contrast=7"],
        ["--tone=exaggerated", "--tone-light=upper-right", "--toon-steps=4"],
    ],
    "texture": [
        [],
        ["--texture=Data/Textures/uv_grid.png", "--texture-filter=nearest", "--texture-wrap=mirror"],
        ["--texture=Data/Textures/planet.png", "--texture-filter=bilinear", "--texture-mode=add"],
        ["--texture=Data/Textures/uv_grid.png", "--anisotropy=8", "--texture-wrap=border"],
        ["--texture=Data/Textures/planet.png", "--texture-role=shaded", "--texture-wrap=clamp"],
        ["--bump=Data/Textures/brick_heights.png", "--bump-scale=0.05"],
        ["--normal-map=Data/Textures/brick_normals.png", "--lightmap=Data/Textures/brick_heights.png"],
        ["--texture=Data/Textures/leaded_window.png"],
        ["--procedural=marble", "--texture-mode=decal"],
        ["--procedural=wood", "--procedural-scale=4"],
    ],
    "frequency": [
        ["--shading=flat"],
        ["--shading=flat", "--flat-point=first-vertex"],
        ["--shading=gouraud", "--normals=angle"],
        ["--shading=phong"],
        ["--shading=phong", "--normals=uniform", "--feature-angle=5"],
    ],
    "camera": [[], ["--camera-orthographic"]],
    "outline": [
        [],
        ["--outline=normal", "--outline-opacity=0.5"],
        ["--outline=normal", "--outline-width=3"],
    ],
    "opacity": [[], ["--opacity=0.6"]],
    "lines": [
        [],
        ["--lines=contour,border", "--stroke-width=3", "--hidden-lines=dashed"],
        ["--lines=hatch,contour", "--hatch-width=0.9"],
        ["--lines=silhouette,crease,ridge,suggestive", "--outer-width=2", "--stroke-opacity=0.5", "--stroke-taper=9"],
        ["--lines=intersections,valley", "--ridge-threshold=0.05"],
    ],
    "samples": [["--samples=" + n] for n in ("1", "2", "4", "8", "16")],
}


def pairs_of(row):
    """Every two choices of a row, which says for each kind the number of its choice."""
    return {((a, row[a]), (b, row[b])) for a, b in itertools.combinations(row, 2)}


def covering_rows():
    """Few rows in which all pairs meet: each begins with a pair that is left, and takes the best of each kind."""
    kinds = list(CHOICES)
    left = set()
    for a, b in itertools.combinations(kinds, 2):
        left |= {((a, i), (b, j)) for i in range(len(CHOICES[a])) for j in range(len(CHOICES[b]))}
    while left:
        row = dict(min(left))
        for kind in kinds:
            if kind in row:
                continue

            def gain(choice):
                return sum(tuple(sorted(((kind, choice), one), key=lambda x: kinds.index(x[0]))) in left
                           for one in row.items())

            row[kind] = max(range(len(CHOICES[kind])), key=gain)
        row = {kind: row[kind] for kind in kinds}
        left -= pairs_of(row)
        yield row


def draw(limn, arguments, path, renderer):
    environment = dict(os.environ, LIMN_RENDERER=renderer, LIMN_THREADS="2")
    environment.pop("DISPLAY", None)
    done = subprocess.run([limn, "render", "--resolution=72,54", *arguments, f"--output={path}"],
                          env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        return None, done.stderr.strip()
    return path.read_bytes(), ""


def main():
    limn, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    empty, _ = draw(limn, ["Data/Meshes/cube.obj", "--camera-position=0,0,9", "--camera-focal-point=0,0,99"],
                    folder / "empty.png", "")
    count = wrong = 0
    for row in covering_rows():
        arguments = [option for kind, choice in row.items() for option in CHOICES[kind][choice]]
        fast, why = draw(limn, arguments, folder / "pipeline.png", "")
        slow, _ = draw(limn, arguments, folder / "reference.png", "reference")
        count += 1
        if fast is None or fast != slow or fast == empty:
            wrong += 1
            print(why or ("empty" if fast == empty else "not as the reference"), "limn render", *arguments)
    print(f"{count} scenes, {wrong} wrong")
    return 1 if wrong or count < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
