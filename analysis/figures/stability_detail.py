# SPDX-License-Identifier: GPL-3.0-or-later
# @name      stability-detail
# @question  How far off is a look-up of a steep surface, and which contacts along a face does each method miss?
# @data      stability stability_detail stability_families schemes
"""Two families: error and bound against tan psi, and contacts that are missed, by the degree of a step and by scheme."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.patches import Rectangle

import common
from common import stability

LOOKS = {0.1: ("0.1°", common.COLOURS[0], "o"), 1.0: ("1°", common.drawing.METHODS["icosahedral"][0], "s")}
RADIUS_UM = 20e3  # of the point that is aimed at, stress/shapes.hpp


def main(options) -> common.Figure:
    """A panel for each family."""
    cases = stability.load(options.results)
    figure, axes = plt.subplots(1, 2, figsize=(common.WIDTH, 3.9), width_ratios=[1, 1], layout="constrained")
    near_tangent(axes[0], cases[(cases.family == "near_tangent") & (cases.kind == "ours")])
    labels = common.scheme_labels(options.results)
    missed(axes[1], cases[(cases.family == "stiff_motion") & (cases.scalar == "double")], labels)
    return figure


def near_tangent(axes: plt.Axes, cases: pd.DataFrame) -> None:
    """The worst scheme of each precision, and the exact answer."""
    ends = []
    for precision, (said, colour, marker) in LOOKS.items():
        tables = cases[(cases.precision_deg == precision) & ~cases.method.str.endswith("_mesh_exact") & cases.error_um.notna()]
        tables = tables[np.isfinite(tables.bound_um)].assign(slope=tables.condition - 1)
        worst = tables.groupby("magnitude")[["slope", "error_um", "bound_um"]].max().sort_values("slope")
        look = {"color": colour, "marker": marker, "markersize": 5}
        axes.plot(worst.slope, worst.bound_um, linestyle="--", markerfacecolor="white", label=f"bound, tables of {said}", **look)
        ends.append(f"{worst.slope.max():.0f} ({said})")
        axes.plot(worst.slope, worst.error_um, label=f"error, tables of {said}", **look)
    exact = cases[cases.method == "cone_rays"].assign(slope=cases.condition - 1).sort_values("slope")
    axes.plot(exact.slope, exact.relative_error * RADIUS_UM, color="black", marker="*", label="error, exact rays")
    axes.set(xscale="log", yscale="log", xlabel="tan ψ, ψ the angle between ray and normal", ylabel="error or bound, µm at 20 mm")
    title = f"Rays that almost run along the surface; tables have\na finite bound up to tan ψ = {' and '.join(ends)}"
    axes.set_title(title, fontsize=common.SMALL + 1)
    axes.legend(loc="lower right", fontsize=common.SMALL)


def missed(axes: plt.Axes, cases: pd.DataFrame, labels: dict[str, str]) -> None:
    """A row a method, a column an angle."""
    rows = methods(cases, labels)
    angles = list(rows[0][1].index)
    for at, (name, lost, asked) in enumerate(rows):
        for column, angle in enumerate(angles):
            share = lost[angle] / asked[angle]
            colour = stability.HOLDS if not share else stability.FAILS if "steps" in name else stability.OPEN
            axes.add_patch(Rectangle((column + 0.03, at + 0.06), 0.94, 0.88, linewidth=0, facecolor=colour))
            if share:
                said = "all" if share == 1 else f"{100 * share:.0f} %"
                axes.text(column + 0.5, at + 0.53, said, ha="center", va="center", fontsize=common.SMALL, color="white" if colour == stability.FAILS else "black")
    axes.set(xlim=(0, len(angles)), ylim=(len(rows), 0))
    axes.set_yticks(np.arange(len(rows)) + 0.5, [name for name, *_ in rows])
    axes.set_xticks(np.arange(len(angles)) + 0.5, [f"{angle:g}" if angle >= 0.01 else f"$10^{{{np.log10(angle):.0f}}}$" for angle in angles])
    axes.tick_params(length=0, labelsize=common.SMALL)
    axes.grid(False)
    for side in axes.spines.values():
        side.set_visible(False)
    axes.set_xlabel("half of the angle over which it lasts, degrees", fontsize=common.SMALL)
    axes.set_title("Contacts along a face: missed (red, white\ndigits), left open (yellow), found (blue)", fontsize=common.SMALL + 1)


def methods(cases: pd.DataFrame, labels: dict[str, str]) -> list[tuple[str, pd.Series, pd.Series]]:
    """First contact, steps, and schemes at both precisions, those together that miss alike: what is missed and asked by angle."""
    ours = cases[cases.kind == "ours"]
    rows = [("first contact in closed form", *by_angle(ours[ours.method == "first_contact"]))]
    for step in LOOKS:
        rows.append((f"exact test, steps of {step:g}°", *by_angle(cases[(cases.kind == "steps") & (cases.precision_deg == step)])))
    for precision in LOOKS:
        alike: dict[tuple, list] = {}
        for scheme, of_scheme in ours[ours.precision_deg == precision].groupby("method"):
            lost, asked = by_angle(of_scheme)
            alike.setdefault(tuple(lost / asked), []).append((scheme, lost, asked))
        for group in sorted(alike.values(), key=len, reverse=True):
            name = f"{len(group)} schemes" if len(group) > 2 else ", ".join(labels.get(scheme, scheme) for scheme, *_ in group)
            rows.append((f"{name}, {precision:g}°", group[0][1], group[0][2]))
    return rows


def by_angle(cases: pd.DataFrame) -> tuple[pd.Series, pd.Series]:
    """Contacts that are missed or withheld, and all, from the longest on."""
    counts = cases.assign(lost=cases.missed_hits + cases.withheld).groupby("magnitude")[["lost", "questions"]].sum()
    counts = counts.sort_index(ascending=False)
    return counts.lost, counts.questions


common.run(main)
