# SPDX-License-Identifier: GPL-3.0-or-later
# @name      motion-limits
# @question  How far does each joint turn before its bones touch?
# @data      motion_limit_details
"""The limit of every motion of every joint beside the range that a clinician finds in a normal hip."""

import matplotlib.pyplot as plt
import pandas as pd

import common
from common import motion_limits

SPREAD = 0.86  # of a motion's row, for the joints one below the other


def main(options) -> common.Figure:
    limits = motion_limits.contacts(options.results)
    generated = limits[limits.joint.isin(motion_limits.GENERATED)]
    real = limits[~limits.joint.isin(motion_limits.GENERATED)]
    parts = [("First contact: generated hips", generated)] + ([("First contact: real joints", real)] if len(real) else [])
    figure, panels = plt.subplots(1, len(parts), figsize=(common.WIDTH, 6.4), sharey=True, squeeze=False)
    for axes, (title, part) in zip(panels[0], parts):
        draw(axes, part)
        axes.set_title(title)
        axes.set_xlabel("angle of first contact, degrees\n(bars: for any centre within half a millimetre)")
    panels[0][0].set_yticks(range(len(motion_limits.MOTIONS)), list(motion_limits.MOTIONS.values()))
    figure.tight_layout()
    return figure


def draw(axes: plt.Axes, limits: pd.DataFrame) -> None:
    """One panel: a mark a joint, from end to end of where it is for any centre within half a millimetre."""
    for k, motion in enumerate(motion_limits.MOTIONS):
        if k % 2 == 0:
            axes.axhspan(k - 0.5, k + 0.5, color="#f4f4f4", linewidth=0, zorder=0)
        if motion in motion_limits.CLINICAL:
            low, high = motion_limits.CLINICAL[motion]
            label = "clinical range, normal hip" if k == 0 else None
            axes.barh(k, high - low, left=low, height=0.9, color="#d4d4d4", edgecolor=common.THESIS_GREY, linewidth=0.8, zorder=1, label=label)
    joints = list(dict.fromkeys(limits.joint))
    looks = common.look(joints)
    for j, joint in enumerate(joints):
        rows = limits[limits.joint == joint]
        y = [list(motion_limits.MOTIONS).index(m) + SPREAD * ((j + 0.5) / len(joints) - 0.5) for m in rows.motion]
        axes.errorbar(
            rows.limit_low_deg,
            y,
            xerr=reach(rows),
            linestyle="none",
            marker=looks[joint]["marker"],
            color=looks[joint]["color"],
            markersize=4,
            linewidth=1.0,
            label=motion_limits.label(joint),
            zorder=3,
        )
    axes.set(xlim=(-5, 190), ylim=(len(motion_limits.MOTIONS) - 0.5, -0.5))
    axes.axvline(180, color="black", linestyle=":", linewidth=1, label="no contact")
    axes.set_xticks(range(0, 181, 30))
    axes.grid(visible=False, axis="y")
    axes.legend(loc="upper center", bbox_to_anchor=(0.4, -0.13), ncol=4 // len(axes.figure.axes), columnspacing=1.0, handlelength=1.4)


def reach(limits: pd.DataFrame) -> list[pd.Series]:
    """What is to the left and to the right of each mark; nothing where the start is blocked, 180 where no end is known."""
    low = limits.centre_low_deg.where(limits.state != "blocked", limits.limit_low_deg)
    high = limits.centre_high_deg.where(limits.state != "blocked", limits.limit_low_deg).fillna(180)
    return [limits.limit_low_deg - low, (high - limits.limit_low_deg).clip(lower=0)]


common.run(main)
