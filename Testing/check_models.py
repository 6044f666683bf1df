#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that each row of Rendering/MODELS.md has what it names.

check_models.py LIMN, in the root of the source. A row has a formula, its source, a setter and an option that are
there, a golden image that is drawn and a test that is there. Every choice that vtkLimnProperty offers has a row.
"""

import pathlib
import re
import subprocess
import sys

HEADER = ["model", "formula", "seed", "class, flag", "picture", "test"]


def read(pattern):
    return "\n".join(path.read_text() for path in sorted(pathlib.Path().glob(pattern)))


def rows(text):
    """Cells of each row of the tables with our header, by line number."""
    isOurs = False
    for number, line in enumerate(text.splitlines(), 1):
        if not line.startswith("|"):
            isOurs = False
            continue
        # A bar within a formula is written \|.
        cells = [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if cells == HEADER:
            isOurs = True
        elif isOurs and not all(set(cell) <= set("-: ") for cell in cells):
            yield number, cells


class Checker:
    def __init__(self, limn):
        self.help = subprocess.run([limn, "help", "render"], check=True, capture_output=True, text=True).stdout
        self.headers = read("Plugin/Vtk/*.h") + read("Rendering/**/*.h")
        self.tests = read("Testing/**/*.cpp") + read("Testing/**/*.cxx") + read("Testing/**/*.py")
        self.testLists = read("Testing/**/CMakeLists.txt")
        self.pictures = re.findall(r"^([a-z0-9_]+)[:!] ", pathlib.Path("Testing/Image/pictures.txt").read_text(), re.M)

    def options(self, cell):
        for option in re.findall(r"--[a-z][a-z-]*", cell):
            if not re.search(re.escape(option) + r"\b(?!-)", self.help):
                yield f"limn render has no {option}"
        for option, value in re.findall(r"(--[a-z][a-z-]*)=([a-z][a-z0-9-]*)\b", cell):
            if value not in self.help:
                yield f"the help of limn render does not name {option}={value}"

    def setters(self, cell):
        names = re.findall(r"\b[A-Za-z0-9]+::([A-Za-z0-9_]+)|\b(Set[A-Za-z0-9]+)\b", cell)
        if not names and "no setter" not in cell:
            yield "no setter of a class, nor the words \"no setter\""
        for name in {a or b for a, b in names}:
            if not self.declares(self.headers, name) and not self.isOfVtk(cell, name):
                yield f"no header of Limn or of the VTK class named declares {name}"

    @staticmethod
    def declares(text, name):
        """By itself, or as vtkSetMacro(Name, ...) and vtkBooleanMacro(Name, ...) do."""
        bare = re.sub(r"^Set|^(?!Set)(?=.*(On|Off)$)|(On|Off)$", "", name)
        return re.search(rf"\b{name}\b|Macro\({bare},", text) is not None

    @classmethod
    def isOfVtk(cls, cell, name):
        folder = next(iter(sorted(pathlib.Path("/usr/include").glob("vtk-*"))), None)
        for owner in re.findall(r"\b(vtk(?!Limn)[A-Za-z0-9]+)", cell):
            header = folder / f"{owner}.h" if folder else None
            if header and header.exists() and cls.declares(header.read_text(errors="replace"), name):
                return True
        return False

    def row(self, cells):
        if len(cells) != len(HEADER):
            yield f"{len(cells)} cells instead of {len(HEADER)}"
            return
        for title, cell in zip(HEADER, cells):
            if not cell or cell in "-?":
                yield f"{title} is empty"
        _, _, seed, flag, picture, test = cells
        if not re.search(r"\b00[0-3]\b|\b(19|20)\d\d\b|VTK|seed|Direct3D", seed):
            yield "no seed (000 to 003) or paper with its year"
        if "`" not in flag and "no option" not in flag and not re.search(r"--[a-z]", flag):
            yield "no flag"
        if "--" not in flag and "no option" not in flag:
            yield "no option of limn, nor the words \"no option\""
        yield from self.options(flag)
        yield from self.setters(flag)
        image = re.fullmatch(r"!\[[^\]]*\]\(\.\./Data/Golden/([a-z0-9_]+)\.png\)", picture)
        if not image:
            yield "the picture is not ![name](../Data/Golden/name.png)"
        else:
            if image[1] not in self.pictures:
                yield f"Testing/Image/pictures.txt does not draw {image[1]}"
            if not pathlib.Path(f"Data/Golden/{image[1]}.png").exists():
                yield f"Data/Golden/{image[1]}.png is not there"
        names = re.findall(r"\b([A-Za-z0-9_]+)\.([A-Za-z0-9_]+)\b", test)
        if not names:
            yield "the test is not Suite.Test"
        for suite, name in names:
            if not re.search(rf"TEST(_[FP])?\({suite},\s*{name}\)", self.tests) and name not in self.testLists:
                yield f"no test {suite}.{name}"

    def choices(self, text):
        header = pathlib.Path("Plugin/Vtk/vtkLimnProperty.h").read_text()
        for setter in re.findall(r"void (Set[A-Za-z]+To[A-Za-z0-9]+)\(\)", header):
            # "None" is the absence of a model.
            if setter not in text and not setter.endswith(("ToNone", "ToAsVTK", "ToObject")):
                yield f"no row names vtkLimnProperty::{setter}"


def main():
    text = pathlib.Path("Rendering/MODELS.md").read_text()
    checker = Checker(sys.argv[1])
    count = 0
    findings = []
    for number, cells in rows(text):
        count += 1
        findings += [f"Rendering/MODELS.md:{number}: {cells[0]}: {finding}" for finding in checker.row(cells)]
    findings += [f"Rendering/MODELS.md: {finding}" for finding in checker.choices(text)]
    if count == 0:
        findings.append("Rendering/MODELS.md: no row")
    print("\n".join(findings + [f"{count} rows, {len(findings)} findings"]))
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
