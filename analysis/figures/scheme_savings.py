# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scheme-savings
# @question  How much does each scheme save against RSID, in four meanings? (Section 4.4)
# @data      schemes scheme_savings
"""Entries saved against the thesis' grid at 1 degree, in four meanings of "as good"."""

import matplotlib.pyplot as plt

import common
from common import scheme_plot

PRECISION = 1.0  # degrees
MEANINGS = {
    "equator_spacing": "equal spacing on the equator (the thesis' meaning)",
    "covering_radius": "equally wide gaps",
    "interpolation_p9999": "equal interpolation error, all but 1 in 10,000 directions",
    "interpolation_rms": "equal interpolation error, root mean square",
}


def main(options) -> common.Figure:
    labels = common.scheme_labels(options.results)
    table = common.load(options.results, "scheme_savings")
    table = table[(table.precision_deg == PRECISION) & (table.scheme != scheme_plot.REFERENCE)]
    saved = table.pivot(index="scheme", columns="meaning", values="saved_percent")
    saved = saved.sort_values("covering_radius", ascending=False, kind="stable")
    figure, axes = plt.subplots(figsize=(6.8, 1.0 + 0.42 * len(saved)))
    scheme_plot.rows(axes, [labels[scheme] for scheme in saved.index])
    span = (max(-60.0, float(saved.min().min()) - 5), float(saved.max().max()) + 5)
    scheme_plot.dots(axes, {meaning: saved[meaning] for meaning in MEANINGS}, span, MEANINGS, apart=0.17)
    axes.axvline(0, color="black", linewidth=1)
    thesis = common.thesis("section-4.4").iloc[0]
    axes.axvline(
        float(thesis.value),
        color=common.THESIS_GREY,
        linestyle="--",
        linewidth=1.2,
        label=f"the thesis' claim for its helix: {thesis.value} %",
    )
    axes.set(
        xlim=span,
        xlabel=f"entries saved against {labels[scheme_plot.REFERENCE]} at {PRECISION:g}°, %",
        title="What each scheme saves depends on what is kept equal",
    )
    axes.legend(loc="upper left", bbox_to_anchor=(-0.02, -0.6 / len(saved) - 0.08))
    return figure


common.run(main)
