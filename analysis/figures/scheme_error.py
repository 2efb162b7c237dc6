# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scheme-error
# @question  How much memory does each scheme take to interpolate as well as the others?
# @data      schemes scheme_errors
"""Entries that every scheme needs for an interpolation error, next to the thesis' grid."""

import matplotlib.pyplot as plt

import common
from common import scheme_plot

MEASURES = {
    "entries_p9999": "error that 1 in 10,000 directions exceeds",
    "entries_rms": "root mean square error",
    "entries_rms_poles": "root mean square error within 1° of the poles",
}


def main(options) -> common.Figure:
    labels = common.scheme_labels(options.results)
    table = common.load(options.results, "scheme_errors").sort_values("entries_p9999", kind="stable")
    figure, axes = plt.subplots(figsize=(6.8, 0.9 + 0.3 * len(table)))
    places = scheme_plot.rows(axes, [labels[scheme] for scheme in table.scheme])
    reference = table[table.scheme == scheme_plot.REFERENCE].iloc[0]
    shares = {name: table[name] / reference[name] for name in MEASURES}
    span = (0.5, 1.08 * max(scheme_plot.reach(share) for share in shares.values()))
    for place, *ends in zip(places, *(share.clip(*span) for share in shares.values())):
        axes.plot([min(ends), max(ends)], [place, place], color=common.THESIS_GREY, linewidth=1.2, zorder=1)
    scheme_plot.dots(axes, shares, span, MEASURES, apart=0)
    axes.axvline(1, color="black", linewidth=1, linestyle=":")
    axes.set(
        xlim=span,
        xlabel=f"entries for the same error, {labels[scheme_plot.REFERENCE]} = 1",
        title="Memory that each scheme takes for an equal error",
    )
    axes.legend(loc="upper left", bbox_to_anchor=(-0.02, -0.6 / len(table) - 0.08))
    return figure


common.run(main)
