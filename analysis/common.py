# SPDX-License-Identifier: GPL-3.0-or-later
"""What every table and figure shares: arguments, loading with its refusal, thesis values, style, saving.

Every script is called as SCRIPT --results DIR [--out DIR]: it reads DIR/data/NAME.csv and writes under the
folder --out (by default the working folder) laid out as the results folder. The same input gives the same
bytes.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import math
import os
import re
import sys
from pathlib import Path
from typing import NoReturn

os.environ.setdefault("SOURCE_DATE_EPOCH", "0")  # figures carry no date

import matplotlib  # noqa: E402

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import pandas as pd  # noqa: E402

HERE = Path(__file__).resolve().parent

# Okabe and Ito (2008): distinct for every common colour vision. Each colour has a marker and a dash of its
# own, for
# readers in grey.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#F0E442"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "*"]
DASHES = ["-", "--", "-.", ":"]
THESIS_GREY = "#8c8c8c"

# How methods and schemes are called in a legend; one that is not here goes by its own name.
LABELS = {
    "pairwise": "pairwise",
    "rsid": "RSID",
    "rsid_thesis": "RSID, raster of the thesis",
    "usid": "USID",
    "usid_thesis": "USID, resampled (thesis)",
    "usid_pairwise": "USID, pairwise",
    "fcl_obb": "OBB tree (FCL)",
    "rapid": "OBB tree (RAPID)",
    "embree_ray1": "Embree, a ray at a time",
    "embree_ray8": "Embree, 8 rays at a time",
    "embree_ray16": "Embree, 16 rays at a time",
    "embree_closest": "Embree, closest point",
    "cgal_first_hit": "CGAL, first hit",
    "cgal_closest": "CGAL, closest point",
    "fcl_collide": "FCL, collide",
    "fcl_distance": "FCL, distance",
    "distance_grid": "Cartesian distance grid",
    "hu_voxels": "Voxels (Hu)",
    "maciel_triangles": "Triangles (Maciel)",
    "cartesian_field": "Cartesian distance field",
}


class Refused(Exception):
    """A result that cannot be trusted, or is not there; the message says which file and what to do."""


def arguments(description: str | None, *more: str) -> argparse.Namespace:
    """--results, --out and further required options of the same kind."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--results", type=Path, required=True, help="the results folder")
    parser.add_argument(
        "--out", type=Path, default=Path("."), help="where to write, laid out as the results folder"
    )
    for name in more:
        parser.add_argument(name, required=True)
    return parser.parse_args()


def run(main) -> NoReturn:
    """Calls main(); a refusal is one clear line and exit code 1."""
    try:
        main()
    except Refused as refusal:
        sys.exit(f"{Path(sys.argv[0]).name}: {refusal}")
    sys.exit(0)


# Reading


def sidecar(csv: Path) -> dict:
    """The record beside a CSV; refused unless it carries the SHA-256 of these bytes."""
    path = csv.with_suffix(".json")
    remedy = f"remove {csv.name} and run experiments/reproduce again"
    if not csv.is_file():
        raise Refused(f"{csv} is not there: run experiments/reproduce")
    if not path.is_file():
        raise Refused(f"{csv} has no sidecar {path.name}: {remedy}")
    try:
        record = json.loads(path.read_text())
        expected = record["csv_sha256"]
    except (ValueError, KeyError, TypeError):
        raise Refused(f"{path} is no sidecar with a csv_sha256: {remedy}") from None
    if hashlib.sha256(csv.read_bytes()).hexdigest() != expected:
        raise Refused(f"{csv} does not have the bytes that {path.name} vouches for: {remedy}")
    return record


def load(results: Path, name: str) -> pd.DataFrame:
    """data/NAME.csv with its sidecar in attrs; yes and no become booleans."""
    csv = results / "data" / f"{name}.csv"
    record = sidecar(csv)
    table = pd.read_csv(csv, float_precision="round_trip")
    for column in table.columns:
        if table[column].isin(["yes", "no"]).all() and len(table):
            table[column] = table[column] == "yes"
    table.attrs.update(record)
    return table


def thesis(artefact: str | None = None) -> pd.DataFrame:
    """The values that the thesis prints, as text: digits count. Columns artefact,row,column,value ..."""
    values = pd.read_csv(HERE / "thesis_values.csv", dtype=str, keep_default_na=False)
    return values if artefact is None else values[values.artefact == artefact]


def _counterparts(artefact: str) -> pd.DataFrame:
    table = pd.read_csv(HERE / "counterparts.csv", keep_default_na=False)
    return table[table.artefact == artefact]


def counterparts(artefact: str) -> dict[str, str]:
    """The method of ours that stands for each column of a timing table of the thesis."""
    table = _counterparts(artefact)
    return {column: method for column, method in zip(table.thesis_column, table.method) if column}


def methods_of(artefact: str) -> list[str]:
    """The methods of ours that a timing table of the thesis shows: the counterparts of its columns, and those
    that stand beside them.
    """
    return list(_counterparts(artefact).method)


def number(text: str) -> float:
    """A row's name or a value as a number: 0.5deg, 12k, 300, 0.497; NaN for N/A."""
    text = text.removesuffix("deg")
    if text == "N/A":
        return math.nan
    return float(text[:-1]) * 1000 if text.endswith("k") else float(text)


def label(name: str) -> str:
    """What a reader calls a method or scheme."""
    return LABELS.get(name, name.replace("_", " "))


def scheme_labels(results: Path) -> dict[str, str]:
    """What a reader calls each scheme, from data/schemes.csv and in its order: schemes name themselves."""
    table = load(results, "schemes")
    return dict(zip(table.scheme, table.label))


# Writing


def digits(value: float, significant: int = 3) -> str:
    """Rounded for reading: three significant digits, thousands kept apart by a comma."""
    if not math.isfinite(value):
        return ""
    if value == 0:
        return "0"
    places = max(significant - 1 - math.floor(math.log10(abs(value))), 0)
    return f"{round(value, significant - 1 - math.floor(math.log10(abs(value)))):,.{places}f}"


def plain(value: float, significant: int = 4) -> str:
    """Rounded for a CSV: significant digits without exponent or separators."""
    return (
        np.format_float_positional(value, precision=significant, fractional=False, trim="-")
        if math.isfinite(value)
        else ""
    )


def tex(text: str) -> str:
    """Text with LaTeX's own characters made harmless."""
    special = {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"}
    return "".join(special.get(c, f"\\{c}" if c in "&%$#_{}" else c) for c in text)


def write(path: Path, text: str) -> None:
    """Writes a file whose folder may be missing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8", newline="\n")


def tabular(layout: str, head: list[str], rows: list[str]) -> str:
    """A LaTeX table in the style of the paper; lines of head and rows end in two backslashes, or are rules, which may
    begin each group of rows.
    """
    rule = "\\midrule"
    return "\n".join(
        [
            f"\\begin{{tabular}}{{{layout}}}",
            "\\toprule",
            *head,
            *([] if rows[:1] == [rule] else [rule]),
            *rows,
            "\\bottomrule",
            "\\end{tabular}",
            "",
        ]
    )


def write_table(out: Path, name: str, table: pd.DataFrame, latex: str) -> None:
    """tables/NAME.csv for machines and tables/NAME.tex for the paper."""
    flags = table.select_dtypes(bool).columns
    table = table.assign(**{flag: table[flag].map({True: "yes", False: "no"}) for flag in flags})
    write(out / "tables" / f"{name}.csv", table.to_csv(index=False, lineterminator="\n"))
    write(out / "tables" / f"{name}.tex", latex)


# Drawing


def style() -> None:
    """Fonts, sizes and lines of every figure; no date and no random name in a file."""
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
    """Colour, marker and dash of each name, by first appearance."""
    return {
        name: {
            "color": COLOURS[i % len(COLOURS)],
            "marker": MARKERS[i % len(MARKERS)],
            "linestyle": DASHES[i % len(DASHES)],
        }
        for i, name in enumerate(dict.fromkeys(names))
    }


def scheme_looks(schemes: list[str]) -> dict[str, dict]:
    """look(), with hollow markers from the second round of colours on."""
    looks = look(schemes)
    for i, of_one in enumerate(looks.values()):
        of_one |= {"linewidth": 1.1, "markersize": 5}
        if i >= len(COLOURS):
            of_one |= {"markerfacecolor": "white", "linestyle": DASHES[(i + 1) % len(DASHES)]}
    return looks


def number_clip_paths(svg: Path) -> None:
    """Numbers the clip paths of an SVG in their order: matplotlib names those that are no rectangles after
    addresses in memory, which differ from run to run.
    """
    text = svg.read_text(encoding="utf-8")
    for number, name in enumerate(re.findall(r'<clipPath id="([^"]+)"', text)):
        text = text.replace(f'"{name}"', f'"clip{number}"').replace(f"#{name})", f"#clip{number})")
    svg.write_text(text, encoding="utf-8", newline="\n")


def save_figure(figure: plt.Figure, out: Path, name: str) -> None:
    """figures/NAME.svg, .png and .pdf, the same bytes for the same figure."""
    folder = out / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / f"{name}.svg", metadata={"Date": None, "Creator": None}, bbox_inches="tight")
    number_clip_paths(folder / f"{name}.svg")
    figure.savefig(folder / f"{name}.png", metadata={"Software": None}, bbox_inches="tight")
    figure.savefig(
        folder / f"{name}.pdf",
        metadata={"CreationDate": None, "Creator": None, "Producer": None},
        bbox_inches="tight",
    )
    plt.close(figure)
