# SPDX-License-Identifier: GPL-3.0-or-later
# @name      slices-error
# @question  What each stage from slices to tables adds to the error of a gap.
# @data      slices_to_surface
"""What each stage from slices to tables adds to the error of a gap."""

import matplotlib.pyplot as plt

import common

STAGES = {
    "slices": "slices and pixels",
    "noise": "noise",
    "decimation": "decimation",
    "centre": "fitted centre",
    "table": "table",
}
TICKS = [0.5, 0.7, 1.25, 2, 3, 5]


def main(options) -> common.Figure:
    table = common.load(options.results, "slices_to_surface")
    looks = common.look(list(STAGES))
    figure, axes = plt.subplots(figsize=(0.66 * common.WIDTH, 2.6))
    for stage, label in STAGES.items():
        mine = table[table.stage == stage]
        axes.plot(mine.slice_mm, 1e3 * mine.added_rms_mm, label=label, **looks[stage])
    final = table[table.stage == "table"]
    axes.plot(final.slice_mm, 1e3 * final.rms_mm, label="all together", color="black", linewidth=2.0, zorder=1)
    axes.axvline(1.25, color=common.THESIS_GREY, linestyle=":", linewidth=1.2)
    axes.set(xscale="log", yscale="log", xlabel="distance of the slices, mm")
    axes.set_xticks(TICKS, [f"{tick:g}" for tick in TICKS])
    axes.xaxis.set_minor_locator(plt.NullLocator())
    axes.set(ylabel="rms error of a gap, µm", title="What each stage adds (dotted: the thesis' slices)")
    axes.set_ylim(top=5 * axes.get_ylim()[1])
    axes.legend(ncol=2, loc="upper left")
    figure.tight_layout()
    return figure


common.run(main)
