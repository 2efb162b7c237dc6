# SPDX-License-Identifier: GPL-3.0-or-later
# @data      motion_frames motion_zones
# @options   --joint JOINT --name NAME
# @name      table-12
# @for       JOINT in patient_a
# @question  Where a stand-in for patient A is impinged at the ends of the recorded motions (Table 12).
# @name      table-13
# @for       JOINT in patient_b
# @question  Where a stand-in for patient B is impinged at the ends of the recorded motions (Table 13).
"""Tables 12 and 13 in numbers: where and how strongly the stand-in for a patient is impinged at the end of each recorded
motion.
"""

import pandas as pd

import common
from common import replay

ORANGE, YELLOW = 4.0, 6.0  # mm: the further thresholds of Tables 12 and 13


def main(options) -> common.Table:
    ends = replay.ends(options.results).loc[options.joint]
    zones = replay.end_zones(options.results, options.joint)
    lines = []
    for motion in replay.MOTIONS:
        end = ends.loc[motion]
        mine = zones[zones.motion == motion]
        areas = mine.groupby("within_mm").area_mm2.sum()
        red = mine[mine.within_mm == replay.RED]
        lines.append(
            {
                "motion": motion,
                "angle_deg": end.angle_deg,
                "smallest_gap_mm": common.plain(end.smallest_gap_mm, 3),
                "smallest_at": replay.clock(end.clock_hours),
                "red_zones": replay.zones(red),
                "red_mm2": common.plain(areas.get(replay.RED, 0.0), 4),
                "within_4_mm_mm2": common.plain(areas.get(ORANGE, 0.0), 4),
                "within_6_mm_mm2": common.plain(areas.get(YELLOW, 0.0), 4),
            }
        )
    table = pd.DataFrame(lines)
    return table, latex(table)


def latex(table: pd.DataFrame) -> str:
    """A row per motion."""
    rows = [
        f"{replay.MOTIONS[row.motion]} & {row.angle_deg:.1f} & {float(row.smallest_gap_mm):.2f} & "
        f"{row.smallest_at} & "
        f"{row.red_zones.replace('-', '--')} & {float(row.red_mm2):.0f} & {float(row.within_4_mm_mm2):,.0f} \\\\"
        for row in table.itertuples()
    ]
    return common.tabular(
        r"@{}lrrllrr@{}",
        [
            r" & & \multicolumn{2}{c}{smallest gap} & \multicolumn{2}{c}{red: within 2\,mm} & within 4\,mm \\",
            r"\cmidrule(lr){3-4}\cmidrule(lr){5-6}",
            r"motion & \textdegree & mm & at & clock & mm$^2$ & mm$^2$ \\",
        ],
        rows,
    )


common.run(main, "--joint", "--name")
