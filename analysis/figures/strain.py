# SPDX-License-Identifier: GPL-3.0-or-later
# @name      strain-by-gap
# @question  What does a gap say about the strain of the cartilage, and where is it wrong?
# @data      strain_layer strain_incidence strain_hip
"""Strain by gap beside elastic layers, at oblique rays, and in a hip."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import strain

HIP = "patient_a"
HOURS = [9, 10, 11, 12, 1, 2, 3, 4, 5, 6, 7, 8]
WAYS = {
    "by gap, cartilage 4 mm everywhere": ("uniform", "strain"),
    "by distance, cartilage 4 mm everywhere": ("uniform", "strain_by_distance"),
    "by gap, cartilage thickness by place": ("by_place", "strain"),
}


def main(options) -> common.Figure:
    figure, ((area, shear), (rays, hip)) = plt.subplots(2, 2, figsize=(common.WIDTH, 6.6))
    layers = strain.layers(options.results)
    draw_layers(area, layers, "area")
    area.set(ylabel="overlap area / contact area", title="a) area that the gap calls strained", ylim=(0.4, 2.15))
    for limit, name in ((2.0, "Hertz"), (1.0, "springs"), (0.5, "thin, ν = 0.5")):
        area.axhline(limit, color=common.THESIS_GREY, linestyle=":", linewidth=1.0, zorder=1)
        area.annotate(
            name,
            (1.0, limit),
            (-2, 2),
            xycoords=("axes fraction", "data"),
            textcoords="offset points",
            ha="right",
            va="bottom",
            fontsize=common.SMALL,
            color="#555555",
        )
    area.legend(loc="upper left", bbox_to_anchor=(0.0, 0.95), title="Poisson ratio ν", alignment="left")
    draw_layers(shear, layers, "bone_shear")
    shear.set(ylabel="largest shear over strain by gap", title="b) shear where cartilage meets bone", yscale="log")
    shear.axhline(1.0, color=common.THESIS_GREY, linestyle=":", linewidth=1.0, zorder=1)
    draw_rays(rays, common.load(options.results, "strain_incidence"))
    draw_hip(hip, common.load(options.results, "strain_hip"))
    figure.tight_layout()
    return figure


def draw_layers(axes: plt.Axes, layers: pd.DataFrame, column: str) -> None:
    """One line a Poisson ratio."""
    ratios = list(layers.poisson.unique())
    looks = common.look([f"{ratio:g}" for ratio in ratios])
    for ratio in ratios:
        mine = layers[layers.poisson == ratio]
        axes.plot(mine.thickness, mine[column], label=f"ν = {ratio:g}", **looks[f"{ratio:g}"], markersize=4)
    axes.set(xscale="log", xlabel="layer thickness / contact radius")
    axes.set_xticks([0.05, 0.2, 1, 5], ["0.05", "0.2", "1", "5"])
    axes.xaxis.set_minor_locator(plt.NullLocator())


def draw_rays(axes: plt.Axes, table: pd.DataFrame) -> None:
    """True strain, by radial gaps, and by the cosine, against the angle."""
    angle = np.linspace(0, 70, 200)
    looks = common.look([f"{gap:g}" for gap in table.gap_mm.unique()])
    for gap, mine in table.groupby("gap_mm"):
        of_gap = looks[f"{gap:g}"]
        cartilage = mine.cartilage_mm.iloc[0]
        axes.axhline(mine.strain.iloc[0], color=of_gap["color"], linestyle=":", linewidth=1.2)
        falling = 1 - gap / (cartilage * np.cos(np.radians(angle)))
        axes.plot(angle, np.maximum(falling, 0), color=of_gap["color"], linewidth=1.2)
        common.marks(
            axes,
            mine.angle_deg,
            mine.by_gap,
            marker=of_gap["marker"],
            color=of_gap["color"],
            label=f"by gap: {gap:g} mm, cartilage h = {cartilage:g} mm",
            clip_on=False,
        )
    axes.set(xlabel="angle ψ between ray and normal, degrees", ylabel="strain", ylim=(0, 1.35), xlim=(0, 70))
    axes.set_yticks(np.linspace(0, 1, 6))
    axes.set_title("c) oblique rays (line: 1 − gap / (h cos ψ))")
    axes.plot([], [], color="black", linestyle=":", linewidth=1.2, label="true strain")
    axes.legend(loc="upper right")


def draw_hip(axes: plt.Axes, table: pd.DataFrame) -> None:
    """Mean strain of the strained area of each hour."""
    table = table[table.hip == HIP]
    looks = common.look(list(WAYS))
    x = np.arange(len(HOURS))
    for name, (cartilage, column) in WAYS.items():
        mine = table[table.cartilage == cartilage].set_index("hour")[column].reindex(HOURS)
        hollow = {"markerfacecolor": "none", "markersize": 9} if column != "strain" else {}
        axes.plot(x, mine, label=name, **looks[name] | hollow)
    axes.set_xticks(x, [str(hour) for hour in HOURS])
    pose = table.pose.iloc[0].replace("=", " ")
    axes.set(xlabel="hour on the socket's dial", ylabel="mean strain of the strained area", ylim=(0, None))
    axes.set_title(f"d) socket of a stand-in for patient A, {pose}°")
    axes.set_ylim(top=1.5 * axes.get_ylim()[1])
    axes.legend(loc="upper right")


common.run(main)
