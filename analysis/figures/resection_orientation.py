# SPDX-License-Identifier: GPL-3.0-or-later
# @name      resection-orientation
# @question  How fast do the bounds of a cam cut and of the socket's orientations converge, and how does a cut grow with the cam?
# @data      change_error resection_by_cam
"""How near the proven ends of a resection and of an orientation map are after which time, and the volume of the least cut
by the height of the cam. Nothing in it may guide a treatment.
"""

import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.ticker import LogLocator

import common


def main(options) -> common.Figure:
    error = common.load(options.results, "change_error")
    figure, axes = plt.subplots(1, 3, figsize=(common.WIDTH, 2.8))
    cams(axes[0], common.load(options.results, "resection_by_cam"))
    cut = error[error.question == "resection"]
    narrowing(axes[1], cut.time_s, 100 * (cut.high - cut.low) / cut.high, "upper minus lower bound, %")
    axes[1].set_title("Uncertainty of the cut's volume")
    turned = error[error.question == "orientation"]
    narrowing(axes[2], turned.time_s, 100 * (turned.high - turned.low), "of all orientations, %")
    for row in turned.itertuples():
        common.note(axes[2], f"{row.setting:.2g}°", (row.time_s, 100 * (row.high - row.low)), (5, 3))
    axes[2].set_title("Orientations, undecided")
    figure.tight_layout()
    return figure


def cams(axes: plt.Axes, table: pd.DataFrame) -> None:
    """Proven ends by height; a cross where there is no cut."""
    made = table[table.refused.isna()]
    axes.fill_between(made.cam_height_mm, made.volume_low_mm3, made.volume_high_mm3, color=common.COLOURS[0], alpha=0.3)
    axes.plot(made.cam_height_mm, made.volume_high_mm3, color=common.COLOURS[0], marker="o", markersize=4)
    none = table[table.refused.notna()]
    common.marks(axes, none.cam_height_mm, 0 * none.cam_height_mm, marker="x", color=common.COLOURS[1], label="refused")
    if len(none):
        axes.legend()
    axes.set(xlabel="height of the cam, mm", ylabel="least cut, mm³", ylim=(-10, None), title="Cut for 30° at 90° flexion")


def narrowing(axes: plt.Axes, time: pd.Series, width: pd.Series, label: str) -> None:
    """Width against time."""
    axes.plot(time, width, color=common.COLOURS[0], marker="o", markersize=4)
    axes.set(yscale="log", xlabel="time, s", ylabel=label, xlim=(0, 1.2 * time.max()), ylim=(None, 1.5 * width.max()))
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.minorticks_off()


common.run(main)
