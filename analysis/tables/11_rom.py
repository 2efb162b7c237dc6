# SPDX-License-Identifier: GPL-3.0-or-later
# @name      table-11
# @question  The recorded range of motion of two patients, and how close the bones of their stand-ins come (Table 11).
# @data      motion_frames motion_limit_details
"""Table 11: the recorded range of motion, how close the bones of our stand-ins are at its ends, and where they touch."""

import pandas as pd

import common
from common import motion_limits, replay

PATIENTS = {"patient_a": "A", "patient_b": "B"}


def main(options) -> common.Table:
    thesis = common.thesis("table-11").pivot(index="row", columns="column", values="value")
    ends = replay.ends(options.results)
    limits = motion_limits.contacts(options.results).set_index(["joint", "motion"])
    lines = []
    for motion in common.thesis("table-11").row.unique():
        line = {"motion": motion}
        for patient in PATIENTS:
            end = ends.loc[(patient, motion)]
            line |= {
                f"{patient}_deg": thesis[patient][motion],
                f"{patient}_stand_in_smallest_gap_mm": common.plain(end.smallest_gap_mm, 3),
                f"{patient}_stand_in_clock": replay.clock(end.clock_hours),
                f"{patient}_stand_in_limit_state": limits.state[patient, motion],
                f"{patient}_stand_in_limit_low_deg": limits.limit_low_deg[patient, motion],
                f"{patient}_stand_in_limit_high_deg": limits.limit_high_deg[patient, motion],
            }
        lines.append(line)
    table = pd.DataFrame(lines)
    return table, latex(table, limits)


def latex(table: pd.DataFrame, limits: pd.DataFrame) -> str:
    """Degrees as printed, with gap, clock position and limit of the stand-in."""
    rows = []
    for row in table.to_dict("records"):
        cells = [replay.MOTIONS[row["motion"]]]
        for patient in PATIENTS:
            gap = float(row[f"{patient}_stand_in_smallest_gap_mm"])
            cells += [row[f"{patient}_deg"], f"{gap:.2f}", row[f"{patient}_stand_in_clock"]]
            cells.append(motion_limits.text(limits.loc[(patient, row["motion"])]))
        rows.append(cells)
    return common.tabular(
        r"@{}lrrrrrrrr@{}",
        [
            r" & \multicolumn{4}{c}{patient A (right hip)} & \multicolumn{4}{c}{patient B (left hip)} \\",
            r"\cmidrule(lr){2-5}\cmidrule(lr){6-9}",
            r"motion & recorded & gap, mm & at & limit & recorded & gap, mm & at & limit \\",
        ],
        rows,
    )


common.run(main)
