# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what `limn_benchmark --json FILE` wrote as README's table: table.py FILE"""

import json
import pathlib
import sys

HEADS = ("scene", "size", "Limn", "limit", "culled", "in OpenGL", "VTK", "VTK / Limn", "first, Limn",
         "first, VTK", "MB, Limn", "MB, VTK", "differ")


def cells(scene):
    way = {one["way"]: one for one in scene["ways"]}
    limn, composited, peer = way["limn"], way["limn-in-gl"], way["vtk-gl"]
    return (scene["scene"], f"{scene['width']} x {scene['height']}", f"{limn['median ms']:.1f}",
            *(f"{scene['limit'][one]['ms']:.1f}" if "limit" in scene else ""
              for one in ("full", "oracle")),
            f"{composited['median ms']:.1f}", f"{peer['median ms']:.1f}", f"{limn['ratio']:.1f}",
            f"{limn['first ms']:.0f}", f"{peer['first ms']:.0f}", f"{limn['peak MB']:.0f}",
            f"{peer['peak MB']:.0f}", f"{peer['differing pixels']}")


def main():
    report = json.loads(pathlib.Path(sys.argv[1]).read_text())
    for row in (HEADS, ("---",) * len(HEADS), *map(cells, report["scenes"])):
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main()
