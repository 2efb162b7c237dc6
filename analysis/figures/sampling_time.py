# SPDX-License-Identifier: GPL-3.0-or-later
# @name      sampling-time
# @question  How the time to fill the tables grows with precision
# @data      sampling_time
"""Time to fill a table against its precision, ours and Tables 3 and 8 of the thesis."""

import common
from common import log_plot, timing


def main(options) -> common.Figure:
    lines = timing.compare(options.results, timing.TABLE_8)
    lines["points"] = 1 / lines.precision_deg
    ticks = {1 / p: f"{p:g}°" for p in lines.precision_deg.unique()}
    return log_plot.draw(
        lines,
        "points",
        ticks,
        "precision, finer to the right\n(exponents are of 1/precision)",
        "Filling a table, 3,000 triangles a model",
    )


common.run(main)
