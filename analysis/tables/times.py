# SPDX-License-Identifier: GPL-3.0-or-later
# @name      table-4-precision
# @question  Time to test one pose, by precision of the tables, ms.
# @data      detection_time_precision
# @options   --data detection_time_precision --name NAME
# @name      table-4-real-joints
# @question  Time to test one pose of each real joint, ms.
# @data      detection_time_bones
# @options   --data detection_time_bones --name NAME
# @when      JOINTS
"""Times of a CSV that has no table in the thesis: a row a case, a column a method, median in ms."""

import pandas as pd

import common

MEASURES = [
    "median_ms",
    "iqr_ms",
    "rounds",
    "extrapolated",
    "inconclusive",
    "repeats",
    "gives_distance",
]  # every other column names the case


def main(options) -> common.Table:
    times = common.load(options.results, options.data)
    case = [column for column in times.columns if column not in [*MEASURES, "method"]]
    table = times.pivot_table(index=case, columns="method", values="median_ms", sort=False).reset_index()
    table = table.rename(columns={method: f"{method}_ms" for method in times.method.unique()})
    return table, latex(table)


def latex(table: pd.DataFrame) -> str:
    """All columns: times rounded for reading, the rest as it is."""
    heads = [common.tex(column.replace("_", " ")) for column in table.columns]
    rows = [[cell(name, value) for name, value in zip(table.columns, row)] for row in table.itertuples(index=False)]
    return common.tabular(f"@{{}}{'l' * len(heads)}@{{}}", [heads], rows)


def cell(column: str, value: object) -> str:
    """One value for LaTeX."""
    if isinstance(value, str):
        return common.tex(value)
    return (
        common.digits(float(value))
        if column.endswith("_ms")
        else f"{value:,g}"
        if value < 1
        else f"{value:,.0f}"
    )


common.run(main, "--data", "--name")
