# SPDX-License-Identifier: GPL-3.0-or-later
# @name      fill-times
# @question  Time to fill the tables of a joint, beside Embree's tree and coherent rays.
# @data      fill
"""Time to fill the tables of a joint, and how many times faster than Embree that is."""

import pandas as pd

import common
from common import fill


def main(options) -> common.Table:
    table = fill.load(options.results)
    rows = table[["method", "storage", "memory", "threads", "triangles", "cells", "entries"]].copy()
    rows["ms"] = table.median_ms.map(common.digits)
    rows["iqr_ms"] = table.iqr_ms.map(lambda value: common.digits(value, 2))
    rows["times_embree"] = table.times_embree.map(lambda value: common.digits(value, 2))
    return rows, latex(table)


def latex(table: pd.DataFrame) -> str:
    """One line a way and number of triangles, in memory that is used again; time and ratio at every precision."""
    shown = table[table.memory == "used again"]
    cells = sorted(shown.cells.unique())
    precisions = " & ".join(rf"\multicolumn{{2}}{{c}}{{{90 / n:.2g}\degrees{{}}}}" for n in cells)
    rules = "".join(rf"\cmidrule(l){{{3 + 2 * k}-{4 + 2 * k}}}" for k in range(len(cells)))
    head = [rf" & & {precisions} \\", rules, "filling & triangles" + r" & ms & $\times$" * len(cells) + r" \\"]
    lines = []
    for line, own in shown.groupby("line", sort=False):
        for triangles, rows in own.groupby("triangles"):
            values = rows.sort_values("cells")[["median_ms", "times_embree"]].to_numpy().ravel()
            lines.append([common.tex(line), f"{triangles:,}", *(common.digits(value, 2) for value in values)])
    return common.tabular("@{}lr" + "rr" * len(cells) + "@{}", head, common.ruled(lines))


common.run(main)
