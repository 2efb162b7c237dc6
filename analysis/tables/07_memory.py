# SPDX-License-Identifier: GPL-3.0-or-later
# @name      table-7
# @question  Entries and memory of the USID table at four precisions, beside RSID's (Table 7 of the thesis).
# @data      lut_memory fill_memory
"""Table 7: entries and memory of the USID table and of the RSID table for comparison, in the thesis and here."""

import common
from common import memory


def main(options) -> common.Table:
    lines = memory.compare(options.results, "table-7")
    grid = memory.compare(options.results, "table-2")
    lines = lines.merge(
        grid[["precision_deg", "thesis_mib", "measured_mib", "filled_mib"]], on="precision_deg", suffixes=("", "_rsid")
    )
    for kind in ("measured", "filled"):
        lines[f"saved_{kind}_percent"] = 100 * (1 - lines[f"{kind}_mib"] / lines[f"{kind}_mib_rsid"])
    rows = [
        [
            f"{line.precision_deg:g}\\textdegree",
            *memory.cells(line),
            line.thesis_mib_rsid,
            f"{line.measured_mib_rsid:,.3f}",
            f"{line.filled_mib_rsid:,.3f}",
            f"{line.saved_measured_percent:.1f}",
            f"{line.saved_filled_percent:.1f}",
        ]
        for line in lines.itertuples()
    ]
    groups = [("entries", 2), ("memory, MiB", 2), ("with rim", 1), ("at peak", 1)]
    groups += [("RSID, MiB", 2), ("with rim", 1), ("saved, \\%", 1), ("with rim", 1)]
    return lines, common.tabular(*common.groups("Precision", groups), rows)


common.run(main)
