# SPDX-License-Identifier: GPL-3.0-or-later
# @name      thesis-figures
# @question  Which figures of the thesis are made, and which are other people's pictures and are not?
# @depends   analysis/common/borrowed_figures.csv analysis/figures/*.py
"""Every figure of the thesis: what reproduces it, or from whose picture the thesis took it (its own reference)."""

import pandas as pd

import common
from common import heads

FIGURES = 63


def main(options) -> common.Table:
    borrowed = pd.read_csv(heads.ANALYSIS / "common" / "borrowed_figures.csv", keep_default_na=False).set_index("figure")
    scripts = sorted((heads.ANALYSIS / "figures").glob("*.py"))
    made = {job["name"]: job for script in scripts for job in heads.head(script)[1]}
    rows = []
    for number in range(1, FIGURES + 1):
        name, theirs = f"figure-{number}", borrowed.loc[number] if number in borrowed.index else None
        whole = theirs is not None and theirs.part == ""
        if whole == (name in made):
            raise common.Refused(f"Figure {number} is {'made, though it is not' if whole else 'neither made nor'} in borrowed_figures.csv")
        rows.append(
            {
                "figure": number,
                "made": not whole,
                "name": "" if whole else name,
                "shows": theirs.shows if whole else made[name]["question"],
                "not_made": "" if theirs is None else theirs.part or "all",
                "source": "" if theirs is None else theirs.source,
            }
        )
    table = pd.DataFrame(rows)
    return table, latex(table)


def latex(table: pd.DataFrame) -> str:
    """The figures that are not reproduced, or only in part."""
    left = table[table.not_made != ""]
    lines = [[str(row.figure), row.not_made, common.tex(row.shows), common.tex(row.source)] for row in left.itertuples()]
    return common.tabular("@{}rlll@{}", [["figure", "not made", "shows", "whose"]], lines)


common.run(main)
