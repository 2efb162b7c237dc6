# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-53
# @question  How unevenly rays at equal angles cut the conchoid, by their origin (Figure 53).
# @data      conchoid_curve conchoid_spacing conchoid_origins
"""Figure 53: rays at equal angles cut the conchoid unevenly, from the centre of the object and from the conchoid's origin;
how unevenly, from these and other centres.
"""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import conchoid_plot as conchoid

PANELS = [
    ("cap_extent_middle", "a) from the middle of the cap's extent"),
    ("conchoid_origin", "b) from the conchoid's origin"),
]
SHADES = plt.cm.viridis


def draw_segments(axes: plt.Axes, curve: pd.DataFrame, segments: pd.DataFrame) -> None:
    """Rays, and the segments between them by their length against that at the apex."""
    origin = np.array([0, -segments.height_mm.iloc[0]])
    ends = [*segments.phi_from_deg, segments.phi_to_deg.iloc[-1]]
    for phi in ends:
        axes.plot(*np.array([origin, conchoid.point(curve, phi)]).T, color="#777777", linewidth=0.8)
    relative = segments.length_mm / segments.length_mm.iloc[0]
    for row, excess in zip(segments.itertuples(), relative - 1):
        phi = np.linspace(row.phi_from_deg, row.phi_to_deg, 30)
        x, up = conchoid.at(curve, phi, "x_mm"), conchoid.at(curve, phi, "up_mm")
        axes.plot(x, up, color=SHADES(0.5 + excess), linewidth=5, solid_capstyle="butt")
        middle = np.array([x[15], up[15]])
        outward = (middle - origin) / np.linalg.norm(middle - origin)
        axes.annotate(f"{excess:+.0%}", middle + 3.4 * outward, ha="center", va="center", fontsize=9)
    axes.plot(*origin, "o", color="black", markersize=5)


def main(options) -> common.Figure:
    curve = conchoid.load(options.results)
    spacing = common.load(options.results, "conchoid_spacing")
    spacing = spacing[spacing.rays == spacing.rays.min()]
    origins = common.load(options.results, "conchoid_origins")
    figure, panels = plt.subplots(1, 3, figsize=(13.6, 5.6), gridspec_kw={"width_ratios": [1, 1, 1]})
    for axes, (name, title) in zip(panels, PANELS):
        conchoid.draw_axis(axes, -43, 3)
        draw_segments(axes, curve, spacing[spacing.origin == name])
        conchoid.plane(axes)
        axes.set(title=title, xlim=(-3, 33), ylim=(-45, 4))
    draw_origins(panels[2], origins)
    figure.suptitle(
        "Length of each segment against the one at the apex (bottom), rays at equal angles", x=0.01, ha="left"
    )
    figure.tight_layout()
    return figure


def draw_origins(axes: plt.Axes, origins: pd.DataFrame) -> None:
    """Of every origin: middle and rim against apex, in the limit of many rays."""
    origins = origins.sort_values("height_mm")
    rows = np.arange(len(origins))
    for column, look in zip(("middle", "rim"), common.look(["middle", "rim"]).values()):
        excess = 100 * (origins[f"{column}_mm_per_deg"] / origins.apex_mm_per_deg - 1)
        common.marks(
            axes,
            excess,
            rows,
            marker=look["marker"],
            color=look["color"],
            label="middle" if column == "middle" else "rim, φ = 90°",
        )
    axes.axvline(0, color="#555555", linewidth=0.8)
    axes.set_yticks(
        rows, [f"{name.replace('_', ' ')}, {h:.1f} mm" for name, h in zip(origins.origin, origins.height_mm)]
    )
    axes.set(title="c) many rays, by origin", xlabel="segment longer than at the apex, %")
    axes.legend(loc="lower right")


common.run(main)
