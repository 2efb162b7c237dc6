# SPDX-License-Identifier: GPL-3.0-or-later
# @name      pareto
# @question  The settings that no other beats in error and cost.
# @data      error_against_time error_against_time_spread
"""The points of the plots of error against cost, and which of them are on a Pareto front: the file that a test computes
again.
"""

import common
from common import pareto


def main(options) -> common.Table:
    """The methods that stand on a front, with how often they do."""
    points = pareto.fronts(pareto.load(options.results))
    return points, latex(points)


def latex(points) -> str:
    """One line a method that is on any front: number of its settings there, for each cost, over all scenes."""
    counts = (
        points[points.on_front]
        .groupby(["method", "cost"])
        .size()
        .unstack(fill_value=0)
        .reindex(columns=list(pareto.COSTS), fill_value=0)
    )
    counts["all"] = counts.sum(axis=1)
    counts = counts.sort_values(["all", "method"], ascending=[False, True])
    titles = {"query_ns": "query", "build_ms": "fill", "bytes": "memory"}
    rows = [
        [common.tex(common.label(method)), *(str(row[cost]) for cost in pareto.COSTS)]
        for method, row in counts.iterrows()
    ]
    head = ["Method", *(titles[cost] for cost in pareto.COSTS)]
    return common.tabular(f"@{{}}l{'r' * len(pareto.COSTS)}@{{}}", [head], rows)


common.run(main)
