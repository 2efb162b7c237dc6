# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws time against size on two logarithmic axes, ours and the thesis', with the slope of growth of each method.
"""

import math

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common


def slope(x: pd.Series, y: pd.Series) -> float:
    """Exponent b of the power law y = a x^b that fits best in logarithms; NaN for fewer than two points."""
    known = np.isfinite(y) & (y > 0)
    return float(np.polyfit(np.log(x[known]), np.log(y[known]), 1)[0]) if known.sum() > 1 else math.nan


def draw_method(axes: plt.Axes, lines: pd.DataFrame, key: str, look: dict) -> None:
    """Draws the median with the spread of its quartiles; hollow where extrapolated."""
    axes.errorbar(lines[key], lines.measured_ms, yerr=lines.iqr_ms / 2, fmt="none", ecolor=look["color"], capsize=3)
    axes.plot(lines[key], lines.measured_ms, color=look["color"], linestyle=look["linestyle"])
    for hollow, group in lines.groupby("extrapolated"):
        common.marks(
            axes,
            group[key],
            group.measured_ms,
            marker=look["marker"],
            color=look["color"],
            markerfacecolor="white" if hollow else look["color"],
            markeredgewidth=1.4,
        )


def draw_thesis(axes: plt.Axes, lines: pd.DataFrame, key: str, look: dict) -> None:
    """Draws the thesis' times of the same method: grey, the same marker, thin."""
    lines = lines[np.isfinite(lines.thesis_ms)]
    axes.plot(
        lines[key],
        lines.thesis_ms,
        color=common.THESIS_GREY,
        linestyle=look["linestyle"],
        linewidth=0.9,
        marker=look["marker"],
        markersize=4.5,
        markerfacecolor=common.THESIS_GREY,
        markeredgewidth=0,
        zorder=1,
    )


def draw(lines: pd.DataFrame, key: str, ticks: dict[float, str], x_title: str, title: str) -> plt.Figure:
    """Draws times over lines[key], which grows to the right, as a whole figure. Its legend gives each method's exponent, from
    measured times, and the thesis'.
    """
    figure, axes = plt.subplots(figsize=(0.46 * common.WIDTH, 3.4))
    looks = common.look(list(lines.method))
    legend = []
    for method, look in looks.items():
        group = lines[lines.method == method]
        draw_thesis(axes, group, key, look)
        draw_method(axes, group, key, look)
        measured = group[~group.extrapolated]
        exponents = []
        if len(measured) > 1:
            exponents.append(f"power {slope(measured[key], measured.measured_ms):.2f}")
        if np.isfinite(group.thesis_ms).any():
            exponents.append(f"thesis {slope(group[key], group.thesis_ms):.2f}")
        text = ": ".join([common.label(method), ", ".join(exponents)]) if exponents else common.label(method)
        text = text.replace(" -", " −")
        legend.append(common.key(text, **look))
    legend.append(
        common.key(
            "grey: the thesis' times, on its own machine",
            color=common.THESIS_GREY,
            marker="o",
            markersize=4.5,
            linewidth=0.9,
        )
    )
    if lines.extrapolated.any():
        legend.append(
            common.key(
                "hollow: extrapolated from a smaller run",
                color="black",
                marker="o",
                markerfacecolor="white",
                linestyle="none",
            )
        )
    axes.set(xscale="log", yscale="log", xlabel=x_title, ylabel="time, ms", title=title)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:,g}")
    axes.set_xticks(list(ticks), list(ticks.values()))
    axes.minorticks_off()
    title = f"time grows with this power of the {key}"
    axes.legend(handles=legend, loc="upper left", bbox_to_anchor=(-0.15, -0.2), title=title, alignment="left")
    return figure
