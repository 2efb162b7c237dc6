# SPDX-License-Identifier: GPL-3.0-or-later
# @name      table-2
# @question  Entries and memory of the RSID table at four precisions (Table 2 of the thesis).
# @data      lut_memory fill_memory
"""Table 2: entries and memory of the RSID table, in the thesis and here."""

import common
from common import memory


def main(options) -> common.Table:
    lines = memory.compare(options.results, "table-2")
    rows = [[f"{line.precision_deg:g}\\textdegree", *memory.cells(line)] for line in lines.itertuples()]
    groups = [("entries", 2), ("memory, MiB", 2), ("with rim", 1), ("at peak", 1)]
    return lines, common.tabular(*common.groups("Precision", groups), rows)


common.run(main)
