# SPDX-License-Identifier: GPL-3.0-or-later
# @name      fast-times
# @question  Time, error and bytes of every way to find all gaps of a pose.
# @data      all_gaps
"""Time, error and bytes of every way to find all gaps of a pose."""

import pandas as pd

import common
from common import fast


SIZES = ["0.5deg", "n=180", "n=291"]  # of tables, in the paper


def main(options) -> common.Table:
    warm = fast.load(options.results)
    table = pd.concat([fast.load(options.results, state, scenes="") for state in ("warm", "cold")])
    cases = ["scene", "method", "setting", "storage", "triangles", "direction", "instruction_set", "threads", "state"]
    rows = table[cases].copy()
    rows["KiB"] = table.bytes / 1024
    for name in ("build_ms", "error_um", "ns_vertex", "iqr_ns", "times_embree"):
        rows[name] = table[name]
    return rows, latex(fast.plain_rows(warm))


def latex(table: pd.DataFrame) -> str:
    """One line per method and setting, with both directions side by side; tables at one size."""
    sized = table.setting.str.endswith("deg") | table.setting.str.startswith("n=")
    table = table[~sized | table.setting.isin(SIZES)]
    head = [
        r" & & & \multicolumn{3}{c}{socket to ball} & \multicolumn{3}{c}{ball to socket} \\",
        r"\cmidrule(lr){4-6}\cmidrule(l){7-9}",
        r"method & setting & KiB & µm & ns & $\times$ & µm & ns & $\times$ \\",
    ]
    lines = []
    for (line, setting), rows in table.groupby(["line", "setting"], sort=False):
        cells = [common.tex(line), common.tex(setting.replace("deg", "°")).replace("°", r"\degrees{}")]
        cells.append(common.digits(rows.bytes.iloc[0] / 1024))
        for direction in fast.DIRECTIONS:
            row = rows[rows.direction == direction].iloc[0]
            cells.append("$<$0.001" if row.error_um < 0.001 else common.digits(row.error_um, 2) or "---")
            cells += [common.digits(value, 2) for value in (row.ns_vertex, row.times_embree)]
        lines.append(cells)
    return common.tabular("@{}llrrrrrrr@{}", head, lines)


common.run(main)
