# SPDX-License-Identifier: GPL-3.0-or-later
# @name      slices-error-table
# @question  The error of a gap after each stage from slices to tables.
# @data      slices_to_surface
"""The error of a gap after each stage from slices to tables."""

import pandas as pd

import common


def main(options) -> common.Table:
    table = common.load(options.results, "slices_to_surface")
    rows = pd.DataFrame({"slice_mm": table.slice_mm, "stage": table.stage})
    rows["ball_triangles"] = table.ball_faces
    rows["socket_triangles"] = table.socket_faces
    for name in ("added_rms", "rms", "mean", "largest"):
        rows[f"{name}_um"] = (1e3 * table[f"{name}_mm"]).map(lambda value: common.digits(value, 2))
    rows["missed"] = table.missed
    return rows, latex(rows)


def latex(rows: pd.DataFrame) -> str:
    """One line a stage."""
    head = [
        r"slices & stage & triangles & adds & \multicolumn{3}{c}{off in all (µm)} \\",
        r"(mm) & & of the ball & (µm) & rms & mean & largest \\",
    ]
    lines = []
    for row in rows.itertuples():
        cells = [f"{row.slice_mm:g}", row.stage, f"{row.ball_triangles:,}", row.added_rms_um]
        lines.append([*cells, row.rms_um, row.mean_um, row.largest_um])
    return common.tabular("@{}rlrrrrr@{}", head, common.ruled(lines))


common.run(main)
