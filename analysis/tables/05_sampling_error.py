# SPDX-License-Identifier: GPL-3.0-or-later
# @name      table-5
# @question  The sampling error of RSID by the thesis' formula, and the errors measured (Table 5 of the thesis).
# @data      sampling_error sampling_error_proven sampling_error_sphere
"""Table 5: the sampling error of the RSID table. It has the thesis' formula (Eq. 7-8), the distance along the surface that this
stands for, and, where it was measured, the error of the radius with its proven bound.
"""

import math

import pandas as pd

import common

SCHEME = "rsid"  # Table 5 of the thesis is about this one


def main(options) -> common.Table:
    ours = common.load(options.results, "sampling_error")
    ours = ours[ours.scheme == SCHEME].set_index("precision_deg")
    proven = common.load(options.results, "sampling_error_proven")
    proven = proven[proven.scheme == SCHEME].set_index("precision_deg")
    sphere = common.load(options.results, "sampling_error_sphere").set_index("precision_deg")
    thesis = common.thesis("table-5").pivot(index="row", columns="column", values="value")
    lines = pd.DataFrame(
        [
            {
                "precision_deg": precision,
                "thesis_error_mm": thesis.max_error[f"{precision:g}deg"],
                "formula_error_mm": row.formula_max_mm,
                "thesis_relative_percent": thesis.relative_error[f"{precision:g}deg"],
                "formula_relative_percent": row.formula_relative,
                "tangential_max_mm": sphere.tangential_max_mm.get(precision, math.nan),
                "radial_max_mm": row.measured_max_mm,
                "radial_rms_mm": row.measured_rms_mm,
                "radial_bound_mm": proven.bound_mm.get(precision, math.nan),
            }
            for precision, row in ours.iterrows()
            if f"{precision:g}deg" in thesis.index
        ]
    )
    return lines, latex(lines)


def latex(lines: pd.DataFrame) -> str:
    """The formula, thesis and here; then what is measured, along the surface in mm, of the radius in um."""
    rows = [
        f"{line.precision_deg:g}\\textdegree & {line.thesis_error_mm} & {line.formula_error_mm:.4f} & "
        f"{line.thesis_relative_percent} & {line.formula_relative_percent:.4f} & "
        f"{common.digits(line.tangential_max_mm, 4)} & "
        f"{common.digits(1000 * line.radial_rms_mm)} & {common.digits(1000 * line.radial_max_mm)} & "
        f"{common.digits_up(1000 * line.radial_bound_mm)} \\\\"
        for line in lines.itertuples()
    ]
    return common.tabular(
        "@{}lrrrrrrrr@{}",
        [
            " & \\multicolumn{2}{c}{Eq.~7, mm} & \\multicolumn{2}{c}{Eq.~8, \\%} & along the & "
            "\\multicolumn{3}{c}{radius, \\textmu m} \\\\",
            "\\cmidrule(lr){2-3}\\cmidrule(lr){4-5}\\cmidrule(l){7-9}",
            "Precision & thesis & here & thesis & here & surface, mm & rms & largest & proven \\\\",
        ],
        rows,
    )


common.run(main)
