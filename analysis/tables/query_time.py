# SPDX-License-Identifier: GPL-3.0-or-later
# @name      table-9-queries
# @question  Time per query, ns: the time in Table 9 divided by the vertices of both models.
# @data      detection_time
"""Nanoseconds per query: times of Table 9 divided by the vertices that a scan looks up, which are those of both models.

The thesis does not count its vertices. It gets those of our models with as many triangles; by Euler's formula a closed surface
has half as many vertices as triangles.
"""

import pandas as pd

import common
from common import timing


def main(options) -> common.Table:
    data = common.load(options.results, timing.TABLE_9.data)
    scans = set(data[data.gives_distance].method)
    lines = timing.compare(options.results, timing.TABLE_9)
    lines = lines[lines.method.isin(scans)].copy()
    lines["thesis_ns"] = 1e6 * lines.thesis_ms / lines.queries
    lines["measured_ns"] = 1e6 * lines.measured_ms / lines.queries
    lines = lines[["triangles", "joint", "queries", "method", "thesis_ns", "measured_ns", "extrapolated", "inconclusive"]]
    return lines, latex(lines)


def latex(lines: pd.DataFrame) -> str:
    """A row for each number of triangles, with thesis and here for each method."""
    methods = list(lines.method.unique())
    spans = [f"\\multicolumn{{2}}{{c}}{{{common.label(method)}}}" for method in methods]
    rules = [f"\\cmidrule(lr){{{3 + 2 * i}-{4 + 2 * i}}}" for i in range(len(methods))]
    rows = []
    for (triangles, joint, queries), group in lines.groupby(["triangles", "joint", "queries"], sort=False):
        times = group.set_index("method").loc[methods, ["thesis_ns", "measured_ns"]].to_numpy().ravel()
        cells = [common.digits(value) or "---" for value in times]
        rows.append([timing.row_title(timing.TABLE_9, triangles, joint), f"{queries:,.0f}", *cells])
    titles = ["Triangles a model", "queries", *["thesis & here"] * len(methods)]
    return common.tabular(f"@{{}}ll{'rr' * len(methods)}@{{}}", [["", "", *spans], "".join(rules), titles], rows)


common.run(main)
