# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws what `limn_benchmark --scaling FILE` wrote: plots.py FILE FOLDER"""

import json
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
# Text stays text, and equal figures give equal files.
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "limn", "font.size": 9})

import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator, NullLocator

LABELS = {"limn": "Limn", "vtk-gl": "VTK on llvmpipe"}


def draw_times(axes, chart):
    for line in chart["lines"]:
        x, y = zip(*line["points"])
        axes.plot(x, y, marker="o", markersize=4, label=LABELS[line["label"]])
    axes.set_xscale("log", base=2 if chart["name"] == "samples" else 10)
    axes.set_yscale("log")
    axes.set_ylabel("milliseconds a frame")
    axes.yaxis.set_major_locator(LogLocator())


def draw_speedup(axes, chart):
    most = max(x for line in chart["lines"] for x, _ in line["points"])
    axes.plot([1, most], [1, most], color="0.7", linestyle="--", label="as many times as threads")
    for line in chart["lines"]:
        x, y = zip(*line["points"])
        axes.plot(x, [y[0] / value for value in y], marker="o", markersize=4, label=line["label"])
    axes.set_xticks(range(1, most + 1))
    axes.set_ylabel("speed, one thread = 1")


def draw(chart, path):
    figure, axes = plt.subplots(figsize=(5, 3.2))
    (draw_speedup if chart["name"] == "threads" else draw_times)(axes, chart)
    if chart["name"] == "samples":
        axes.set_xticks([1, 2, 4, 8], labels=["1", "2", "4", "8"])
        axes.xaxis.set_minor_locator(NullLocator())
    axes.set_xlabel(chart["x"])
    axes.grid(True, color="0.9")
    axes.legend(frameon=False)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def main():
    report = json.loads(pathlib.Path(sys.argv[1]).read_text())
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for chart in report["charts"]:
        draw(chart, folder / f"{chart['name']}.svg")


if __name__ == "__main__":
    main()
