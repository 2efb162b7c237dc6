# SPDX-License-Identifier: GPL-3.0-or-later
# @name      euclidean-distances
# @question  How far do radial gaps exceed Euclidean distances, and what bounds on these do they prove?
# @data      euclidean
"""Radial gaps beside Euclidean distances by where a ray ends, and the proven ends of the distance."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common

ZONES = {
    "facing": "facing it\n(below 20°)",
    "oblique": "oblique\n(20° to 45°)",
    "steep": "steep\n(above 45°)",
    "rim": "nearer to a\nrim or fold",
}
WIDTH = 0.7  # of a zone, for the joints side by side
TICKS = [1.0, 1.2, 1.5, 2.0, 3.0, 5.0, 10.0]


def main(options) -> common.Figure:
    joints = by_joint(common.load(options.results, "euclidean"))
    names = list(dict.fromkeys(joints.joint))
    looks = common.look(names)
    figure, (above, below) = plt.subplots(2, 1, figsize=(6.8, 6.4), sharex=True)
    for k, name in enumerate(names):
        rows = joints[joints.joint == name]
        offset = WIDTH * ((k + 0.5) / len(names) - 0.5)
        x = np.array([list(ZONES).index(zone) for zone in rows.zone]) + offset
        colour, marker = looks[name]["color"], looks[name]["marker"]
        above.vlines(x, rows.gap_median, rows.gap_max, color=colour, linewidth=1.2)
        above.plot(x, rows.gap_median, linestyle="none", marker=marker, color=colour, label=name)
        below.vlines(x, rows.lower_median, rows.upper_median, color=colour, linewidth=1.2)
        below.plot(x, rows.lower_median, linestyle="none", marker=marker, color=colour)
        below.plot(x, rows.upper_median, linestyle="none", marker="_", color=colour, markersize=9)
    finish(above, below, joints)
    figure.tight_layout()
    return figure


def by_joint(table: pd.DataFrame) -> pd.DataFrame:
    """One row a joint and zone: medians weighted by vertices over poses and surfaces, largest of all."""
    rows = []
    for (joint, zone), group in table.groupby(["joint", "zone"], sort=False):
        medians = {
            name: np.average(group[name], weights=group.vertices)
            for name in ("gap_median", "lower_median", "upper_median")
        }
        rows.append({"joint": joint, "zone": zone, "gap_max": group.gap_max.max(), **medians})
    return pd.DataFrame(rows)


def finish(above: plt.Axes, below: plt.Axes, joints: pd.DataFrame) -> None:
    """Scales, titles and legend."""
    top = 1.15 * joints.gap_max.max()
    ticks = [tick for tick in TICKS if tick <= top]
    above.set_yscale("log")
    above.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
    above.minorticks_off()
    above.set(
        ylim=(0.95, top),
        ylabel="radial gap over exact distance",
        title="How far a radial gap is above the distance: median (mark) to largest (line)",
    )
    below.axhline(1.0, color="black", linestyle="--", linewidth=1.0)
    below.set(
        ylim=(0, 1.25),
        ylabel="proven bound / exact distance",
        title="Bounds on the distance from gaps: lower (mark) and upper (dash), medians",
        xlabel="how the vertex sees the other surface: angle between ray and normal, or rim",
    )
    below.set_xticks(range(len(ZONES)), list(ZONES.values()))
    below.set_xlim(-0.5, len(ZONES) - 0.5)
    for axes in (above, below):
        axes.grid(visible=False, axis="x")
    above.legend(loc="upper left", ncol=1)


common.run(main)
