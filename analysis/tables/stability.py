# SPDX-License-Identifier: GPL-3.0-or-later
# @name      stability-summary
# @question  Which ill-conditioned and extreme cases break a method?
# @data      stability stability_detail stability_families
"""Stiff and extreme cases, a row a family: how far ours and the others are off, and how often they fail."""

import pandas as pd

import common
from common import stability


def main(options) -> common.Table:
    cases = stability.load(options.results)
    families = stability.families(options.results)
    lines = pd.DataFrame([line(cases[cases.family == name], name, row) for name, row in families.iterrows()])
    return lines, latex(lines)


def line(cases: pd.DataFrame, name: str, family: pd.Series) -> dict:
    """Worst and counts of one family."""
    ours = cases[cases.kind == "ours"]
    others = cases[cases.kind != "ours"]
    bounds = stability.bounds(ours)
    in_double = ours[ours.scalar == "double"]
    return {
        "family": name,
        "parameter": family.parameter,
        "unit": family.unit,
        "magnitudes": len(stability.magnitudes(cases)),
        "stiffness": cases.stiffness.max(),
        "worst_condition": cases.condition.max(),
        "worst_of_ours": in_double.error_over_condition_u.max(),
        "worst_of_ours_in_float": ours[ours.scalar == "float"].error_over_condition_u.max(),
        "threshold": family.threshold,
        "failures_of_ours": int(ours.failures.sum()),
        **{f"bounds_{what}": int((bounds == what).sum()) for what in ("held", "broken", "infinite", "unanswered")},
        "withheld": int(ours.withheld.sum()),
        "refused": int(ours.refused.sum()),
        "worst_of_others": others.error_over_condition_u.max(),
        "failures_of_others": int(others.failures.sum()),
    }


def power(value: float) -> str:
    """A cell of a wide range."""
    if not value == value:
        return "---"
    if value < 1e4:
        return common.digits(value)
    mantissa, exponent = f"{value:.0e}".split("e")
    return f"${mantissa}\\cdot10^{{{int(exponent)}}}$"


def latex(lines: pd.DataFrame) -> str:
    """A row a family."""
    rows = []
    for row in lines.itertuples():
        cells = [
            row.family.replace("_", " "),
            str(row.magnitudes),
            power(row.worst_condition),
            power(row.worst_of_ours),
            power(row.threshold),
            str(row.failures_of_ours),
            str(row.refused),
            f"{row.withheld:,}",
            f"{row.bounds_held}, {row.bounds_infinite}, {row.bounds_unanswered}",
            power(row.worst_of_others),
            f"{row.failures_of_others:,}",
        ]
        rows.append(cells)
    return common.tabular(
        "@{}lrrrrrrrrrr@{}",
        [
            " & & & \\multicolumn{6}{c}{Ours} & \\multicolumn{2}{c}{Others} \\\\",
            "\\cmidrule(lr){4-9}\\cmidrule(l){10-11}",
            "Family & Steps & Condition & Worst & Allowed & Fail & Refused & Withheld & Bounds held, infinite, unanswered & Worst & Fail \\\\",
        ],
        rows,
    )


common.run(main)
