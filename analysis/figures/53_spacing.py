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
NAMES = {
    "conchoid_origin": "origin of the conchoid",
    "cap_extent_middle": "middle of the cap's extent",
    "cap_curve_centroid": "centroid of the cap's curve",
    "cap_surface_centroid": "centroid of the cap's surface",
    "cap_best_sphere": "best sphere of the cap",
    "whole_axis_middle": "middle of the whole axis",
    "whole_extent_middle": "middle of the whole extent",
    "whole_curve_centroid": "centroid of the whole curve",
    "whole_surface_centroid": "centroid of the whole surface",
}


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
        axes.plot(x, up, color=conchoid.CURVE if row.Index % 2 else conchoid.SECOND, linewidth=5, solid_capstyle="butt")
        middle = np.array([x[15], up[15]])
        outward = (middle - origin) / np.linalg.norm(middle - origin)
        beside = outward[0] > 0.5
        at = middle + (1.4 if beside else 3.4) * outward
        axes.annotate(f"{100 * excess:+.0f} %".replace("-", "−"), at, ha="left" if beside else "center", va="center", fontsize=9)
    axes.plot(*origin, "o", color="black", markersize=5)


def main(options) -> common.Figure:
    curve = conchoid.load(options.results)
    spacing = common.load(options.results, "conchoid_spacing")
    spacing = spacing[spacing.rays == spacing.rays.min()]
    origins = common.load(options.results, "conchoid_origins")
    figure, panels = plt.subplots(1, 3, figsize=(12.4, 4.8), width_ratios=[0.73, 0.73, 0.9], layout="constrained")
    for axes, (name, title) in zip(panels, PANELS):
        conchoid.draw_axis(axes, -43, 3)
        draw_segments(axes, curve, spacing[spacing.origin == name])
        conchoid.plane(axes)
        axes.set(title=title, xlim=(-3, 33), ylim=(-45, 4))
    draw_origins(panels[2], origins)
    figure.suptitle(
        "How much longer each segment is than the one at the apex (bottom): rays at equal angles", x=0.01, ha="left", fontsize=12
    )
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
            label="half way to the rim" if column == "middle" else "at the rim, φ = 90°",
        )
    axes.axvline(0, color="#555555", linewidth=0.8)
    axes.set_yticks(
        rows, [f"{NAMES[name]}, {h:.1f} mm" for name, h in zip(origins.origin, origins.height_mm)]
    )
    axes.set(title="c) many rays, by their origin\n(mm from the conchoid's towards the apex)", xlabel="segment longer than at the apex, %")
    axes.legend(loc="lower right")


common.run(main)
