# SPDX-License-Identifier: GPL-3.0-or-later
# @name      needs-by-question
# @question  Time, memory and what is looked at, of each question asked alone, of everything, and of other libraries.
"""What each question needs, compared with everything at once and with other libraries for the same question."""

import common
from common import scene_needs

COLUMNS = ["joint", "faces", "vertices", "question", "way", "cpu_ms", "cpu_iqr_ms", "times_needed", "of_all", "peak_MB", "touched_MB",
           "faces_looked_at", "vertices_looked_at", "differs", "extrapolated"]  # fmt: skip


def main(options) -> common.Table:
    table = scene_needs.load(options.results)
    lines = []
    for row in table[table.joint == table.joint.iloc[0]].itertuples():
        cells = [row.cpu_ms, row.times_needed, row.peak_MB, row.touched_MB, row.faces_looked_at, row.vertices_looked_at]
        lines.append([common.tex(row.question), common.tex(row.label + ("*" if row.extrapolated else "")), *map(cell, cells)])
    head = [
        r" & & time, & times this & peak, & touched, & \multicolumn{2}{c}{looked at} \\",
        r"question & by & ms & alone & MB & MB & faces & vertices \\",
    ]
    return table[COLUMNS], common.tabular("@{}llrrrrrr@{}", head, common.ruled(lines))


def cell(value: float) -> str:
    """The cell of a number; a dash where nothing was counted."""
    return common.digits(value) or "---"


common.run(main)
