# SPDX-License-Identifier: GPL-3.0-or-later
# @name      phantom-validation
# @question  Joints with closed forms: limits and gaps measured beside the formulas.
# @data      phantoms
"""Limits and gaps of joints with closed forms: what the formula says, what was measured, and what the difference keeps: a
limit a target that was chosen, a gap a bound that is proven.
"""

import pandas as pd

import common


def main(options) -> common.Table:
    phantoms = common.load(options.results, "phantoms")
    return phantoms, latex(phantoms)


def latex(phantoms: pd.DataFrame) -> str:
    """A line a quantity."""
    head = [r"phantom & quantity & closed form & measured & error & target & bound \\"]
    lines = []
    for row in phantoms.itertuples():
        cells = [common.tex(row.phantom), common.tex(row.quantity)]
        cells += [f"{row.closed_form:.5f}", f"{row.measured:.5f}", f"{row.error:.5f}"]
        cells += ["" if pd.isna(value) else common.rounded_up(value, 5) for value in (row.target, row.bound)]
        lines.append(cells)
    return common.tabular("llrrrrr", head, lines)


common.run(main)
