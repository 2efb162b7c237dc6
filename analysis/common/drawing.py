# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours, style and saving of every figure: the same figure gives the same bytes."""

import os
import re
from pathlib import Path

os.environ.setdefault("SOURCE_DATE_EPOCH", "0")  # figures carry no date

import matplotlib  # noqa: E402

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patheffects import withStroke  # noqa: E402
from matplotlib.text import Annotation  # noqa: E402

# After Okabe and Ito (2008), distinct for every common colour vision, and darker where they are too pale on white: each has a
# contrast of 3 : 1 at least. Each colour has a marker and a dash of its own, for readers in grey.
COLOURS = ["#0072B2", "#D55E00", "#008F68", "#B5528A", "#A87000", "#2E8BC0", "#000000", "#7A7A00"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "*"]
DASHES = ["-", "--", "-.", ":"]
# Of a method, the same in every figure: colour, marker, dash. The longest beginning of its name counts, small letters.
METHODS = {
    "thesis, rsid": ("#A6611A", ">", "--"),
    "rsid_thesis": ("#A6611A", ">", "--"),
    "thesis, usid": ("#6B3E0C", "<", ":"),
    "usid_thesis": ("#6B3E0C", "<", ":"),
    "pairwise": ("#404040", "v", "-."),
    "conchoid": ("#B5528A", "v", "-."),
    "icosahedral": ("#6A3D9A", "P", "-"),
    "rsid": ("#008F68", "s", "-"),
    "usid": ("#00573F", "D", "-"),
    "usid_arc": ("#4B7A1E", "d", ":"),
    "cube": ("#0072B2", "o", "-"),
    "exact cells": ("#000000", "*", "-"),
    "cube_cells_exact": ("#000000", "*", "-"),
    "impinge": ("#0072B2", "o", "-"),
    "ours": ("#0072B2", "o", "-"),
    "ours, with ranges": ("#2E8BC0", "s", "--"),
    "bracket": ("#0072B2", "*", "-"),
    "radial overlap": ("#0072B2", "h", "-"),
    "touch of vertices": ("#2E8BC0", "h", "--"),
    "smallest gap, culled": ("#2E8BC0", "o", "--"),
    "random poses": ("#6B6B6B", "s", ":"),
    "all gaps": ("#00376B", "^", "-"),
    "embree": ("#D55E00", "^", "-"),
    "cgal": ("#B2182B", "X", "-"),
    "fcl": ("#882255", "p", "--"),
    "rapid": ("#882255", "p", "--"),
    "ode": ("#5E6B00", "<", "-."),
    "bullet": ("#A87000", ">", ":"),
    "vtk": ("#44777F", "d", "--"),
}
THESIS_GREY, INK = "#8c8c8c", "#202020"
HALO = [withStroke(linewidth=2.5, foreground="white")]  # of words and lines on a picture

# Inches of a figure that is as wide as the paper's text, and points of the smallest text in it: 6.5 in print. A narrower
# figure of the paper is drawn as much narrower.
WIDTH, SMALL = 9.2, 9

# What a file would say of the day and of matplotlib.
UNSAID = {"svg": ["Date", "Creator"], "png": ["Software"], "pdf": ["CreationDate", "Creator", "Producer"]}


def style() -> None:
    """Sets fonts, sizes and lines for every figure; a file gets no date and no random name."""
    plt.rcParams.update(
        {
            "figure.figsize": (6.4, 4.4),
            "figure.dpi": 100,
            "savefig.dpi": 200,
            "font.size": 10,
            "axes.titlesize": 11,
            "axes.titlelocation": "left",
            "axes.spines.top": False,
            "axes.spines.right": False,
            "axes.grid": True,
            "grid.color": "#dddddd",
            "grid.linewidth": 0.6,
            "axes.axisbelow": True,
            "lines.linewidth": 1.5,
            "lines.markersize": 6,
            "legend.frameon": False,
            "legend.fontsize": 9,
            "svg.hashsalt": "impinge",
            "svg.fonttype": "path",
            "pdf.fonttype": 42,
        }
    )


def look(names: list[str]) -> dict[str, dict]:
    """Colour, marker and dash of each name: of a method from METHODS, of others by first appearance. Markers are hollow in the
    second round, and for a method's second form.
    """
    looks = {}
    others = 0
    for name in dict.fromkeys(names):
        begins = [method for method in METHODS if name.lower().startswith(method)]
        if begins:
            colour, marker, dash = METHODS[max(begins, key=len)]
            again = any((own["color"], own["marker"]) == (colour, marker) for own in looks.values())
        else:
            again = others // len(COLOURS)
            colour, marker = COLOURS[others % len(COLOURS)], MARKERS[others % len(MARKERS)]
            dash = DASHES[(others + again) % len(DASHES)]
            others += 1
        looks[name] = {"color": colour, "marker": marker, "linestyle": dash}
        if again:
            looks[name]["markerfacecolor"] = "white"
    return looks


def key(label: str, **look) -> Line2D:
    """What a legend shows for a line or marker, wherever that is drawn."""
    return Line2D([], [], label=label, **look)


def marks(axes: plt.Axes, x, y, **look) -> None:
    """Markers without a line."""
    axes.plot(x, y, linestyle="none", **look)


def note(axes: plt.Axes, text: str, at, offset: tuple[float, float], **look) -> Annotation:
    """Writes words beside a point, `offset` in points of the page."""
    return axes.annotate(text, at, offset, textcoords="offset points", **{"fontsize": SMALL, **look})


def number_clip_paths(svg: Path) -> None:
    """Numbers the clip paths of an SVG in order. matplotlib names those that are not rectangles after addresses in memory,
    which differ from run to run.
    """
    text = svg.read_text(encoding="utf-8")
    for number, name in enumerate(re.findall(r'<clipPath id="([^"]+)"', text)):
        text = text.replace(f'"{name}"', f'"clip{number}"').replace(f"#{name})", f"#clip{number})")
    svg.write_text(text, encoding="utf-8", newline="\n")


def save_figure(figure: Figure, out: Path, name: str, kinds: list[str] = list(UNSAID)) -> None:
    """Writes figures/NAME.KIND as svg, png or pdf; the same figure gives the same bytes."""
    folder = out / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    figure.draw_without_rendering()
    tight = figure.get_tightbbox().padded(plt.rcParams["savefig.pad_inches"])  # once for all kinds: a sixth of a script
    for kind in kinds:
        figure.savefig(folder / f"{name}.{kind}", metadata=dict.fromkeys(UNSAID[kind]), bbox_inches=tight)
        if kind == "svg":
            number_clip_paths(folder / f"{name}.svg")
    plt.close(figure)
