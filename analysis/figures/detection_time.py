# SPDX-License-Identifier: GPL-3.0-or-later
# @name      detection-time
# @question  With which power of the number of triangles does the time to test one pose grow?
# @data      detection_time
"""Time to test one pose of the generated pair against the number of triangles, ours and Tables 4 and 9 of the thesis."""

import common
from common import log_plot, timing


def main(options) -> common.Figure:
    lines = timing.compare(options.results, timing.TABLE_9)
    lines = lines[(lines.joint == timing.GENERATED) & lines.method.isin(common.methods_of("table-9"))]
    ticks = {n: f"{n:,.0f}" for n in lines.triangles.unique()}
    return log_plot.draw(lines, "triangles", ticks, "triangles a model", "Time to test one pose")


common.run(main)
