# SPDX-License-Identifier: GPL-3.0-or-later
# @name      motion-volume
# @question  How soon is the share of all rotations that is free of contact bounded, and how does internal rotation fall with flexion?
# @data      motion_volume motion_volume_methods motion_volume_rotations
"""How near the proven ends of the free share are after which time, beside a grid of poses (extrapolated) and random poses;
and internal rotation by flexion, beside the published slope.
"""

import matplotlib.pyplot as plt
import pandas as pd

import common
from common import motion_limits, volume


def main(options) -> common.Figure:
    figure, axes = plt.subplots(1, 2, figsize=(common.WIDTH, 4.6), width_ratios=(1.15, 1))
    times(axes[0], volume.load(options.results), volume.beside(options.results))
    rotations(axes[1], common.load(options.results, "motion_volume_rotations"))
    figure.tight_layout()
    return figure


def times(axes: plt.Axes, own: pd.DataFrame, beside: pd.DataFrame) -> None:
    """Of the joint that others were asked of: a line a way."""
    joint = beside.joint.iloc[0]
    own, beside = own[own.joint == joint], beside[beside.joint == joint]
    looks = common.look(["ours", *beside.line])
    axes.plot(own.time_s, own.proven, label="all cells, proven", **looks["ours"])
    for line, rows in beside.groupby("line", sort=False):
        grid = "" if rows.method.iloc[0] == volume.OURS else "grid of poses, "
        axes.plot(rows.needed_s, rows.proven, label=grid + line, **looks[line] | {"markerfacecolor": "white"})
    axes.set(xscale="log", yscale="log", xlabel="time, s (hollow: extrapolated)", ylabel="upper minus lower bound of the share")
    widths = sorted({*own.width, *([0.5, 1] if own.proven.max() > 0.3 else [])})
    axes.set_yticks(widths, [f"{width:g}" for width in widths])
    axes.minorticks_off()
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.19), ncol=2, columnspacing=1.0, handlelength=1.6)
    axes.set_title(f"Time to bound the free share of rotations ({motion_limits.label(joint)} hip)")


def rotations(axes: plt.Axes, table: pd.DataFrame) -> None:
    """Limits by closed forms as marks, what the cells know as bars."""
    generated = table[table.joint.isin(motion_limits.GENERATED)]
    looks = common.look(list(generated.joint))
    for k, (joint, rows) in enumerate(generated.groupby("joint", sort=False)):
        x = rows.flexion_deg + 0.5 * (k - 3)
        high = rows.cells_high_deg.fillna(90)
        middle, half = (high + rows.cells_low_deg) / 2, (high - rows.cells_low_deg) / 2
        axes.errorbar(x, middle, half, fmt="none", ecolor=looks[joint]["color"], elinewidth=0.8, capsize=2)
        axes.plot(x, rows.low_deg, **looks[joint] | {"linewidth": 1, "markersize": 4}, label=motion_limits.label(joint))
    low = generated.set_index(["joint", "flexion_deg"]).low_deg
    start, end = low["normal", 70], low["normal", 90]
    axes.plot([70, 90], [start, start - 2 * volume.SLOPE], color=common.THESIS_GREY, linewidth=3.5, zorder=1, label="published slope")
    said = f"For 10° of flexion normal loses\n{(start - end) / 2:.1f}° (published {volume.SLOPE:g}). At 90° cam\n"
    said += f"has {end - low['cam', 90]:.0f}° less (published {volume.CAM_LOSS})."
    axes.text(1, 1, said, transform=axes.transAxes, ha="right", va="top", fontsize=common.SMALL)
    axes.set(xlabel="flexion, degrees (bars: proven bounds)", ylabel="internal rotation, degrees", xticks=[70, 80, 90], ylim=(0, 125))
    axes.legend(loc="upper center", bbox_to_anchor=(0.45, -0.19), ncol=2, columnspacing=1.0, handlelength=1.6)
    axes.set_title("Internal rotation left in flexion")


common.run(main)
