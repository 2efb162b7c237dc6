# SPDX-License-Identifier: GPL-3.0-or-later
# @name      stability-summary
# @question  Which stiff cases (condition number above 1000) and extreme ones (parameter within 1e-6 of a place where the answer jumps or is not defined) break a method, and is a mutation of the method noticed?
# @data      stability stability_detail stability_families
"""Stiff and extreme cases, a row per family: how far our methods and others are off, and how often they fail."""

import pandas as pd

import common
from common import stability


def main(options) -> common.Table:
    cases = stability.load(options.results)
    families = stability.families(options.results)
    lines = pd.DataFrame([line(cases[cases.family == name], name, row) for name, row in families.iterrows()])
    return lines, latex(lines)


def line(cases: pd.DataFrame, name: str, family: pd.Series) -> dict:
    """The worst error and the counts of one family."""
    ours = cases[cases.kind == "ours"]
    others = cases[~cases.kind.isin(["ours", "mutated"])]
    bounds = stability.bounds(ours)
    in_double = ours[ours.scalar == "double"]
    return {
        "family": name,
        "parameter": family.parameter,
        "unit": family.unit,
        "magnitudes": len(stability.magnitudes(cases)),
        "stiffness": cases.stiffness.max(),
        "worst_condition": stability.condition(cases, name),
        "worst_of_ours": in_double.error_over_condition_u.max(),
        "seen": family.seen,
        "worst_of_ours_in_float": ours[ours.scalar == "float"].error_over_condition_u.max(),
        "threshold": family.threshold,
        "failures_of_ours": int(ours.failures.sum()),
        **{f"bounds_{what}": int((bounds == what).sum()) for what in ("held", "broken", "infinite", "unanswered")},
        "withheld": int(ours.withheld.sum()),
        "unbounded": int(ours.unbounded.sum()),
        "refused": int(ours.refused.sum()),
        "failures_of_others": int(others.failures.sum()),
        "mutation": family.mutation,
        "mutation_cases": family.mutation_cases,
        "mutation_noticed": family.mutation_noticed,
    }


def latex(lines: pd.DataFrame) -> str:
    """A row per family."""
    rows = []
    for row in lines.itertuples():
        cells = [
            row.family.replace("_", " "),
            f"{stability.power(row.worst_condition)}, {stability.kind(row.worst_condition)}",
            stability.power(row.worst_of_ours) if row.worst_of_ours == row.worst_of_ours else "---",
            stability.power(row.threshold),
            str(row.failures_of_ours),
            f"{row.withheld + row.unbounded + row.refused:,}",
            f"{row.bounds_held}, {row.bounds_infinite + row.bounds_unanswered}",
            f"{row.failures_of_others:,}",
            common.tex(row.mutation),
            f"{row.mutation_noticed} of {row.mutation_cases}",
        ]
        rows.append(cells)
    return common.tabular(
        "@{}lrrrrrrrlr@{}",
        [
            " & & \\multicolumn{5}{c}{Ours} & Others & \\multicolumn{2}{c}{Mutation of the method} \\\\",
            "\\cmidrule(lr){3-7}\\cmidrule(lr){8-8}\\cmidrule(l){9-10}",
            "Family & Condition & Worst & Allowed & Fail & Say nothing & Bounds held, open & Fail & What is wrong & Noticed \\\\",
        ],
        rows,
    )


common.run(main)
