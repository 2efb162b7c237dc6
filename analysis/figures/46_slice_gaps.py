# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-46
# @question  The angles of the slices and the gaps between them (Figure 46 of the thesis).
# @data      slices
"""Figure 46: a) the arccosine that gives a slice its angle, b) the gap between the angles of neighbouring slices."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common


def main(options) -> common.Figure:
    slices = common.load(options.results, "slices")
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.2, 3.9))
    draw_curve(left, slices, slices.attrs["parameters"]["head_diameter_mm"] / 2)
    draw_gaps(right, slices.dropna(subset="gap_deg"))
    figure.tight_layout(w_pad=2)
    return figure


def draw_curve(axes: plt.Axes, slices: pd.DataFrame, radius: float) -> None:
    """phi over height / radius, with the slices on it."""
    share = np.linspace(-1, 1, 401)
    axes.plot(share, np.degrees(np.arccos(share)), color="black", linewidth=1.2, label="φ = arccos x")
    x = slices.height_mm / radius
    axes.plot(x, slices.phi_deg, "o", color=common.COLOURS[0], markersize=4.5, label="slices, upper half")
    axes.vlines(x, 0, slices.phi_deg, color=common.COLOURS[0], linewidth=0.5)
    axes.hlines(slices.phi_deg, -1, x, color=common.COLOURS[0], linewidth=0.5)
    axes.set(xlim=(-1, 1), ylim=(0, 180), yticks=range(0, 181, 30))
    axes.set(xlabel="x = i ΔT / r", ylabel="φ, degrees", title="a) even steps in height, uneven ones in angle")
    axes.legend(loc="upper right")


def draw_gaps(axes: plt.Axes, slices: pd.DataFrame) -> None:
    """A bar a gap, with its value."""
    smallest = slices.gap_deg.min()
    axes.bar(slices.slice, slices.gap_deg, color=common.COLOURS[0], width=0.7)
    for index, gap in zip(slices.slice, slices.gap_deg):
        axes.text(index, gap + 0.12, f"{gap:.2f}", ha="center", va="bottom", fontsize=8, rotation=90)
    axes.axhline(smallest, color=common.COLOURS[1], linestyle="--", linewidth=1.2)
    text = f"smallest gap {smallest:.2f}°,\nnext to the middle plane"
    axes.text(1, smallest + 2.9, text, fontsize=9, color=common.COLOURS[1])
    axes.set(xlim=(0.2, slices.slice.max() + 0.8), ylim=(0, slices.gap_deg.max() * 1.18))
    axes.set_xticks(slices.slice)
    axes.tick_params(axis="x", labelsize=8)
    axes.grid(axis="x", visible=False)
    axes.set(xlabel="slice i, counted from the middle plane", ylabel="gap to the slice below, degrees")
    axes.set_title("b) gaps Δφ between slices")


common.run(main)
