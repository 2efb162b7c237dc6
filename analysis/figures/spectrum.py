# SPDX-License-Identifier: GPL-3.0-or-later
# @name      power-spectrum
# @question  Power of the radius of the generated head by degree of spherical harmonics.
# @data      spectrum band_limit slice_band_limit
# @options   --spectrum spectrum --limits band_limit --name NAME
# @name      power-spectrum-real-joints
# @question  Power of the radius of real heads by degree of spherical harmonics.
# @data      spectrum_bones band_limit_bones slice_band_limit
# @options   --spectrum spectrum_bones --limits band_limit_bones --name NAME
# @when      JOINTS
"""Power of a head's radius by degree of spherical harmonics, and what a band limit leaves out."""

import re

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common

SHARE = 0.9999  # of the power of degrees 1 and up: the band limit that is marked


def main(options) -> common.Figure:
    spectrum = common.load(options.results, options.spectrum)
    limits = common.load(options.results, options.limits)
    slices = common.load(options.results, "slice_band_limit")
    figure, (left, right) = plt.subplots(1, 2, figsize=(common.WIDTH, 3.1))
    looks = common.look(list(spectrum.surface.unique()))
    for (surface, filling), lines in spectrum.groupby(["surface", "filling"], sort=False):
        if filling == "membrane":
            continue
        draw(left, right, lines[lines.degree > 0], looks[surface])
    mark_limits(left, spectrum, limits, looks)
    mark_slices(left, right, slices)
    finish(figure, left, right, list(looks.items()))
    return figure


def draw(left: plt.Axes, right: plt.Axes, lines: pd.DataFrame, look: dict) -> None:
    """Power by degree; and the root mean square of degrees L and up over L, short of the end of the grid."""
    style = {"color": look["color"], "linestyle": look["linestyle"], "linewidth": 1.2}
    left.plot(lines.degree, lines.power, **style)
    rest = np.sqrt(np.cumsum(lines.power.to_numpy()[::-1])[::-1] / (4 * np.pi))
    inside = lines.degree < 0.8 * lines.degree.max()
    right.plot(lines.degree[inside], rest[inside], **style)


def mark_limits(axes: plt.Axes, spectrum: pd.DataFrame, limits: pd.DataFrame, looks: dict) -> None:
    """A marker where the band limit of each surface lies on its curve."""
    chosen = limits[(limits.asked == "power_share") & (limits.value == SHARE) & (limits.filling != "membrane")]
    for line in chosen.itertuples():
        on = spectrum[(spectrum.surface == line.surface) & (spectrum.filling == line.filling)]
        power = on[on.degree == min(line.band_limit, on.degree.max())].power.iloc[0]
        look = looks[line.surface]
        axes.plot(line.band_limit, power, look["marker"], color=look["color"], markersize=9, markeredgecolor="black")


def mark_slices(left: plt.Axes, right: plt.Axes, slices: pd.DataFrame) -> None:
    """The band limits that the distances of CT samples allow."""
    for line in slices[slices.distance.isin(["slices, middle", "pixel"])].itertuples():
        name = {"slices, middle": "CT slices", "pixel": "CT pixels"}[line.distance]
        for axes in (left, right):
            axes.axvline(line.band_limit, color="#555555", linewidth=0.9, linestyle=(0, (1, 2)))
        right.text(
            line.band_limit * 1.04,
            0.98,
            f"{name}, L = {line.band_limit}",
            rotation=90,
            ha="left",
            va="top",
            path_effects=common.drawing.HALO,
            fontsize=common.SMALL,
            transform=right.get_xaxis_transform(),
        )


def named(surface: str) -> str:
    """As a reader writes it: "head of 12,000 faces"."""
    return re.sub(r"\d{4,}", lambda digits: f"{int(digits[0]):,}", surface.replace("_", " "))


def finish(figure: plt.Figure, left: plt.Axes, right: plt.Axes, looks: list) -> None:
    """Axes, titles and one legend for both."""
    for axes in (left, right):
        axes.set(xscale="log", yscale="log")
        axes.set_xticks([1, 2, 5, 10, 20, 50, 100, 200], ["1", "2", "5", "10", "20", "50", "100", "200"])
        axes.minorticks_off()
    left.set(xlabel="degree of the spherical harmonics", ylabel="power, mm²", title=f"Power by degree (marks: {100 * SHARE:g} % lie below)")
    right.set(xlabel="band limit L", ylabel="root mean square left out, mm", title="What a band limit L leaves out")
    handles = [common.key(named(surface), markeredgecolor="black", **look) for surface, look in looks]
    right.set_ylim(top=100 * right.get_ylim()[1])  # room for what mark_slices() writes
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(0.05, 0.0), ncols=3)
    figure.tight_layout()


common.run(main, "--spectrum", "--limits", "--name")
