# SPDX-License-Identifier: GPL-3.0-or-later
# @name      table-10
# @question  Four rays adjusted to the conchoid (Table 10 of the thesis).
# @data      conchoid_angles
"""Table 10: four rays on the conchoid, original and adjusted, in the thesis and here."""

import pandas as pd

import common

RAYS = 4  # of Table 10


def main(options) -> common.Table:
    ours = common.load(options.results, "conchoid_angles")
    ours = ours[ours.rays == RAYS].set_index("i")
    thesis = common.thesis("table-10").pivot(index="row", columns="column", values="value")
    lines = pd.DataFrame(
        [
            {
                "i": i,
                "original_deg": row.original_deg,
                "thesis_adjusted_deg": thesis.adjusted_angle[f"i={i}"],
                "eq16_adjusted_deg": row.thesis_deg,
                "exact_adjusted_deg": row.exact_deg,
                "thesis_adjustment_deg": thesis.adjustment[f"i={i}"],
                "eq16_adjustment_deg": row.thesis_deg - row.original_deg,
                "exact_adjustment_deg": row.exact_deg - row.original_deg,
            }
            for i, row in ours.iterrows()
        ]
    )
    return lines, latex(lines)


def latex(lines: pd.DataFrame) -> str:
    """Degrees as printed, by Eq. 16 as printed, and exact."""
    rows = [
        f"{line.i} & {line.original_deg:.0f} & {line.thesis_adjusted_deg} & {line.eq16_adjusted_deg:.2f} & "
        f"{line.exact_adjusted_deg:.2f} & ${line.thesis_adjustment_deg}$ & ${line.eq16_adjustment_deg:.2f}$ & "
        f"${line.exact_adjustment_deg:.2f}$ \\\\"
        for line in lines.itertuples()
    ]
    return common.tabular(
        "@{}lrrrrrrr@{}",
        [
            " & & \\multicolumn{3}{c}{adjusted $\\varphi$, \\textdegree} & "
            "\\multicolumn{3}{c}{adjustment, \\textdegree} \\\\",
            "\\cmidrule(lr){3-5}\\cmidrule(lr){6-8}",
            "$i$ & $\\varphi$, \\textdegree & thesis & Eq.~16 & exact & thesis & Eq.~16 & exact \\\\",
        ],
        rows,
    )


common.run(main)
