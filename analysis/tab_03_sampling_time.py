# SPDX-License-Identifier: GPL-3.0-or-later
"""Table 3, time to fill a table: thesis beside ours, times and ratios. From data/sampling_time.csv."""

import common
import timing


def main() -> None:
    """Writes tables/table-3.csv and .tex."""
    options = common.arguments(__doc__)
    lines = timing.compare(options.results, timing.TABLE_3)
    common.write_table(options.out, "table-3", lines, timing.latex(lines, timing.TABLE_3))


common.run(main)
