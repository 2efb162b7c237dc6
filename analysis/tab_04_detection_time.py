# SPDX-License-Identifier: GPL-3.0-or-later
"""Table 4, time to test one pose: thesis beside ours, times and ratios. From data/detection_time.csv."""

import common
import timing


def main() -> None:
    """Writes tables/table-4.csv and .tex."""
    options = common.arguments(__doc__)
    lines = timing.compare(options.results, timing.TABLE_4)
    common.write_table(options.out, "table-4", lines, timing.latex(lines, timing.TABLE_4))


common.run(main)
