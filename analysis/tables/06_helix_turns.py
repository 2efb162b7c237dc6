# SPDX-License-Identifier: GPL-3.0-or-later
# @name      table-6
# @question  Turns of the helix that matches each precision, and its points at the equator (Table 6 of the thesis).
# @data      lut_memory
"""Table 6: turns of the helix and its points at the equator, in the thesis and here."""

import pandas as pd

import common

HELIX = "usid"  # Table 6 of the thesis matches this one
GRID = "rsid"  # to this one


def main(options) -> common.Table:
    ours = common.load(options.results, "lut_memory")
    helix = ours[ours.scheme == HELIX].set_index("precision_deg")
    grid = ours[ours.scheme == GRID].set_index("precision_deg")
    thesis = common.thesis("table-6").pivot(index="row", columns="column", values="value")
    lines = pd.DataFrame(
        [
            {
                "precision_deg": precision,
                "grid_equator_points": grid.equator_points[precision],
                "thesis_helix_turns": int(thesis.helix_turns[f"{precision:g}deg"]),
                "measured_helix_turns": int(row.helix_turns),
                "thesis_equator_points": int(thesis.equator_points[f"{precision:g}deg"]),
                "equator_points_by_formula": row.equator_points,
                "counted_least": int(row.equator_least),
                "counted_most": int(row.equator_most),
            }
            for precision, row in helix.iterrows()
            if f"{precision:g}deg" in thesis.index
        ]
    )
    return lines, latex(lines)


def latex(lines: pd.DataFrame) -> str:
    """Turns and points, thesis and here. A turn holds one point more or less, depending on where it begins."""
    rows = [
        f"{line.precision_deg:g}\\textdegree & {line.grid_equator_points:,} & {line.thesis_helix_turns:,} & "
        f"{line.measured_helix_turns:,} & {line.thesis_equator_points:,} & "
        f"{line.counted_least:,} to {line.counted_most:,} \\\\"
        for line in lines.itertuples()
    ]
    return common.tabular(
        "@{}lrrrrr@{}",
        [
            " & grid & \\multicolumn{2}{c}{turns $k$ of the helix} & "
            "\\multicolumn{2}{c}{its points at the equator} \\\\",
            "\\cmidrule(lr){3-4}\\cmidrule(lr){5-6}",
            "Precision & points & thesis & here & thesis & counted \\\\",
        ],
        rows,
    )


common.run(main)
