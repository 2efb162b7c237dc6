# SPDX-License-Identifier: GPL-3.0-or-later
# @name      fast-counts
# @question  Instructions and cache misses of a gap, and its time as a multiple of the memory-bound baseline.
# @data      counts all_gaps
"""Instructions and cache misses of a vertex or a pose, beside the time over that of the memory-bound baseline."""

import pandas as pd

import common
from common import counts, fast


def main(options) -> common.Table:
    table = counts.load(options.results)
    rows = table[["method", "setting", "storage", "direction", "instruction_set", "unit"]].copy()
    for name in ("instructions", "over_floor", "time_over_floor", "l1_misses", "l2_misses"):
        rows[name] = table[name].map(lambda value: common.digits(value, 3))
    return rows, latex(counts.first_set(table))


def latex(table: pd.DataFrame) -> str:
    """One line a way and direction."""
    head = (
        r"of a vertex (a pose: touch) & & instructions & $\times$ baseline & "
        r"time $\times$ baseline & misses, 32 KiB & 1 MiB \\"
    )
    lines = []
    for row in table.itertuples():
        name = row.name + (", corners" if row.storage == "corners" else "")
        cells = [name, fast.DIRECTIONS.get(row.direction, "")]
        cells += [common.digits(row.instructions, 3)]
        cells += [common.digits(value, 2) or "---" for value in (row.over_floor, row.time_over_floor)]
        cells += [f"{value:,.2f}" for value in (row.l1_misses, row.l2_misses)]
        lines.append([common.tex(cell) for cell in cells])
    return common.tabular("@{}llrrrrr@{}", [head], lines)


common.run(main)
