# SPDX-License-Identifier: GPL-3.0-or-later
"""A timing table of the thesis, Table 3, 4, 8 or 9: thesis beside ours, times and ratios. From
data/sampling_time.csv or data/detection_time.csv.
"""

import common
from common import timing


def main() -> None:
    """Writes tables/NAME.csv and .tex."""
    options = common.arguments(__doc__, "--name")
    table = next(table for table in timing.TABLES if table.artefact == options.name)
    lines = timing.compare(options.results, table)
    lines = lines[lines.method.isin(common.methods_of(table.artefact))]
    common.write_table(options.out, table.artefact, lines, timing.latex(lines, table))


common.run(main)
