# SPDX-License-Identifier: GPL-3.0-or-later
# @name      resection-by-cam
# @question  How much of a cam has to go for 30° of internal rotation at 90° of flexion?
# @data      resection_by_cam
"""What has to go of cams of several heights, between proven ends, and how far the hip turns before and after. Nothing in
it may guide a treatment.
"""

import pandas as pd

import common


def main(options) -> common.Table:
    rows = []
    for row in common.load(options.results, "resection_by_cam").itertuples():
        refused = isinstance(row.refused, str)
        rows.append(
            {
                "cam_mm": f"{row.cam_height_mm:g}",
                "volume_mm3": "" if refused else ends(row.volume_low_mm3, row.volume_high_mm3, 1),
                "area_mm2": "" if refused else ends(row.area_low_mm2, row.area_high_mm2, 0),
                "depth_mm": "" if refused else ends(row.depth_low_mm, row.depth_high_mm, 2),
                "before_deg": "" if refused else common.rounded_down(row.before_deg, 1),
                "after_deg": "" if refused else common.rounded_down(row.after_deg, 1),
                "refused": row.refused if refused else "",
            }
        )
    table = pd.DataFrame(rows)
    return table, latex(table)


def ends(low: float, high: float, places: int) -> str:
    """Rounded outward; below no length, area or volume."""
    return f"{common.rounded_down(max(low, 0), places)} to {common.rounded_up(high, places)}"


def latex(table: pd.DataFrame) -> str:
    """A line a height; of a refusal its first words."""
    head = [r"cam, mm & volume, mm$^3$ & area, mm$^2$ & depth, mm & before & after & \\"]
    lines = [[common.tex(str(cell).split(";")[0]) for cell in row] for row in table.itertuples(index=False)]
    return common.tabular("rrrrrrl", head, lines)


common.run(main)
