# SPDX-License-Identifier: GPL-3.0-or-later
# @name      fill-growth
# @question  How the time to fill a table grows with triangles and entries.
# @data      fill
"""How the time to fill the tables of a joint grows with its triangles and their entries."""

import common
from common import fill


def main(options) -> common.Table:
    fits = fill.growth(fill.load(options.results))
    rows = fits[[*fill.WAY, "points"]].copy()
    for name in ("start_us", "triangle_ns", "entry_ns", "largest_residual"):
        rows[name] = fits[name].map(lambda value: common.plain(value, 3))
    head = [r"filling, memory & start, \textmu s & a triangle, ns & an entry, ns & largest residual \\"]
    lines = []
    for fit in fits.itertuples():
        numbers = [common.digits(value, 2) for value in (fit.start_us, fit.triangle_ns, fit.entry_ns)]
        share = f"{100 * fit.largest_residual:.0f}" + r"\,\%"
        lines.append([common.tex(f"{fit.line}, {fit.memory}"), *numbers, share])
    return rows, common.tabular("@{}lrrrr@{}", head, lines)


common.run(main)
