# SPDX-License-Identifier: GPL-3.0-or-later
# @name      stability-overview
# @question  Which methods hold in stiff cases (condition number above 1000) and extreme ones (parameter within 1e-6 of a place where the answer jumps), which fail, and which say nothing?
# @data      stability stability_detail stability_families
"""Stiff and extreme cases: a row a family, a column a method; whether it holds, fails or says nothing, with numbers."""

import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.patches import Patch, Rectangle

import common
from common import stability

NAMES = {
    "behind_bone": "bone behind bone",
    "beside_opening": "contact beside an opening",
    "grazing_turn": "turn that only just grazes",
    "huge_step": "tables of huge steps",
    "off_centre_origin": "centre near the surface",
    "parallel_edges": "edges nearly parallel",
    "ray_through_edge_or_vertex": "ray through edge or vertex",
    "stiff_motion": "contact along a face",
    "tiny_step": "tables of tiny steps",
    "translation": "far from the origin",
    "conchoid": "cusp of the conchoid",
    "fold": "folded surface",
    "near_tangent": "ray along the surface",
    "rim_edge": "ray beside a rim",
    "seam": "seam of the azimuths",
    "pole": "pole of the grid",
    "sliver": "sliver triangles",
}
BLOCKS = ["One radius, look-up or formula", "One turn, up to its first contact"]
GROUPS = {"ours": stability.COLUMNS[:4], "pose after pose": stability.COLUMNS[4:7], "others": stability.COLUMNS[7:]}


def main(options) -> common.Figure:
    """The families in two blocks."""
    cases = stability.load(options.results)
    found = stability.overview(cases)
    columns = [who for who in stability.COLUMNS if who in found.index.get_level_values("who")]
    families = list(found.index.get_level_values("family").unique())
    turns = [name for name in families if (name, stability.STEPS[1.0]) in found.index]
    rows = ["", *(name for name in families if name not in turns), "", *turns]
    figure, axes = plt.subplots(figsize=(common.WIDTH, 0.27 * len(rows) + 2.2))
    axes.set(xlim=(0, len(columns) + 2.6), ylim=(len(rows) + 0.7, 0))
    for at, family in enumerate(rows):
        for column, who in enumerate(columns):
            if (family, who) in found.index:
                draw_cell(axes, column, at, found.loc[(family, who)])
        if family:
            condition = stability.condition(cases, family)
            axes.text(len(columns) + 0.15, at + 0.52, f"{stability.kind(condition)}, {stability.power(condition)}", va="center", fontsize=common.SMALL)
    for title, at in zip(BLOCKS, [at for at, name in enumerate(rows) if not name]):
        axes.text(0.03, at + 0.6, title, va="center", fontsize=common.SMALL, fontweight="bold")
    for name, group in GROUPS.items():
        places = [columns.index(who) for who in group if who in columns]
        first, last = min(places), max(places) + 1
        axes.plot([first + 0.06, last - 0.06], [len(rows) + 0.12] * 2, color=common.drawing.INK, linewidth=0.8, clip_on=False)
        axes.text((first + last) / 2, len(rows) + 0.6, name, ha="center", va="center", fontsize=common.SMALL)
    axes.text(len(columns) + 0.15, 0.6, "condition no.", va="center", fontsize=common.SMALL)
    axes.set_yticks([at + 0.5 for at, name in enumerate(rows) if name], [NAMES.get(name, name.replace("_", " ")) for name in rows if name])
    axes.set_xticks([column + 0.5 for column in range(len(columns))])
    axes.set_xticklabels(columns, rotation=40, ha="left", rotation_mode="anchor")
    axes.tick_params(length=0, labelsize=common.SMALL, top=True, labeltop=True, bottom=False, labelbottom=False)
    axes.set_title("Stiff and extreme cases: which method holds, leaves open or fails?", x=-0.25, fontsize=12)
    axes.grid(False)
    for side in axes.spines.values():
        side.set_visible(False)
    axes.legend(handles=legend(), loc="upper left", bbox_to_anchor=(-0.2, -0.01), ncols=2, handlelength=1.2, columnspacing=1.2)
    return figure


def draw_cell(axes: plt.Axes, column: int, row: float, counts: pd.Series) -> None:
    """Its colour, and what share fails or says nothing, or how many hold."""
    colour = stability.FAILS if counts.wrong else stability.OPEN if counts.silent else stability.HOLDS
    axes.add_patch(Rectangle((column + 0.03, row + 0.05), 0.94, 0.9, facecolor=colour, linewidth=0))
    said = percent(counts.wrong or counts.silent, counts.asked) if counts.wrong or counts.silent else short(counts.asked)
    axes.text(column + 0.5, row + 0.52, said, ha="center", va="center", fontsize=common.SMALL, color="white" if counts.wrong else common.drawing.INK)


def percent(part: int, of: int) -> str:
    """Of all, of so many in a hundred, or of less than one."""
    return "all" if part == of else f"{100 * part / of:.0f} %" if 100 * part >= of else "< 1 %"


def short(count: int) -> str:
    """At most four characters: 950, 1.7k, 17k."""
    return str(count) if count < 1000 else f"{count / 1000:.1f}k" if count < 9950 else f"{count / 1000:.0f}k"


def legend() -> list:
    """The three colours."""
    return [
        Patch(color=stability.HOLDS, label="holds: all answers right; their number"),
        Patch(color=stability.OPEN, label="left open: no answer wrong, this share has none"),
        Patch(color=stability.FAILS, label="fails: this share is wrong"),
        Patch(facecolor="white", edgecolor=common.drawing.INK, linewidth=0.5, label="empty: not asked"),
    ]


common.run(main)
