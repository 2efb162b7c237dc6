# SPDX-License-Identifier: GPL-3.0-or-later
# @name      motion-volume
# @question  All rotations of a joint at once: how soon is the free share proven, and how does internal rotation fall with flexion?
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
    """A thin line a joint, one for each other way."""
    for joint, rows in own.groupby("joint", sort=False):
        axes.plot(rows.time_s, rows.proven, color=common.COLOURS[0], marker="o", markersize=4, linewidth=1)
    axes.plot([], [], color=common.COLOURS[0], marker="o", label=f"all cells, proven ({own.joint.nunique()} joints)")
    looks = common.look(["", *beside.line])
    for line, rows in beside.groupby("line", sort=False):
        axes.plot(rows.needed_s, rows.proven, label=line, markerfacecolor="white", **looks[line])
    axes.set(xscale="log", yscale="log", xlabel="time, s (hollow: extrapolated)", ylabel="upper minus lower bound")
    widths = sorted({*own.width, *([0.5, 1] if own.proven.max() > 0.3 else [])})
    axes.set_yticks(widths, [f"{width:g}" for width in widths])
    axes.minorticks_off()
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.19), ncol=2, columnspacing=1.0, handlelength=1.6)
    axes.set_title("Free share of all rotations, proven to within …")


def rotations(axes: plt.Axes, table: pd.DataFrame) -> None:
    """Limits by closed forms as marks, what the cells know as bars."""
    generated = table[table.joint.isin(motion_limits.GENERATED)]
    looks = common.look(list(generated.joint))
    for k, (joint, rows) in enumerate(generated.groupby("joint", sort=False)):
        x = rows.flexion_deg + 0.5 * (k - 3)
        high = rows.cells_high_deg.fillna(90)
        axes.vlines(x, rows.cells_low_deg, high, color=looks[joint]["color"], linewidth=3, alpha=0.25)
        axes.plot(x, rows.low_deg, **looks[joint] | {"linewidth": 1, "markersize": 4}, label=motion_limits.label(joint))
    low = generated.set_index(["joint", "flexion_deg"]).low_deg
    start, end = low["normal", 70], low["normal", 90]
    axes.plot([70, 90], [start, start - 2 * volume.SLOPE], color="black", linewidth=2.5, alpha=0.4, label="published slope")
    said = f"For 10° of flexion normal loses\n{(start - end) / 2:.1f}° (published {volume.SLOPE:g}). At 90° cam\n"
    said += f"has {end - low['cam', 90]:.0f}° less (published {volume.CAM_LOSS})."
    axes.text(1, 1, said, transform=axes.transAxes, ha="right", va="top", fontsize=common.SMALL)
    axes.set(xlabel="flexion, degrees", ylabel="internal rotation, degrees", xticks=[70, 80, 90], ylim=(0, 125))
    axes.legend(loc="upper center", bbox_to_anchor=(0.45, -0.19), ncol=2, columnspacing=1.0, handlelength=1.6)
    axes.set_title("Internal rotation left in flexion (bars: proven bounds)")


common.run(main)
