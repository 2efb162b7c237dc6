# SPDX-License-Identifier: GPL-3.0-or-later
# @name      claims-measured
# @question  Claims that the thesis makes without showing them, measured (Chapter 6, Section 6.2).
# @data      claims
"""Claims that the thesis makes and never shows, measured."""

import pandas as pd

import common


def main(options) -> common.Table:
    table = common.load(options.results, "claims")
    order = {name: k for k, name in enumerate(table.claim.unique())}
    table = table.sort_values("claim", key=lambda names: names.map(order), kind="stable")
    rows = table[["claim", "setting", "quantity"]].copy()
    rows["value"] = [readable(row) for row in table.itertuples()]
    rows["unit"] = table.unit.map({"B": "kB", "us": "µs"}).fillna(table.unit).replace("1", "")
    return rows, latex(rows)


def readable(row) -> str:
    """Three digits; bytes in kB; identical is a word."""
    if row.quantity == "identical":
        return "yes"
    if pd.isna(row.value):
        return ""
    if row.unit == "1":
        return f"{int(row.value):,}"
    return common.digits(row.value / 1e3 if row.unit == "B" else row.value)


def latex(rows: pd.DataFrame) -> str:
    """One line a claim and setting: what was measured there, one after the other."""
    lines = []
    for (claim, setting), group in rows.groupby(["claim", "setting"], sort=False):
        measured = "; ".join(
            f"{row.quantity} {row.value}" + (f" {row.unit}" if row.unit else "") for row in group.itertuples()
        )
        lines.append([common.tex(text) for text in (claim, setting, measured)])
    layout = r"@{}p{0.23\textwidth}p{0.22\textwidth}p{0.5\textwidth}@{}"
    return common.tabular(layout, [r"claim & setting & measured \\"], common.ruled(lines))


common.run(main)
