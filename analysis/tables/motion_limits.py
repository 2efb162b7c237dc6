# SPDX-License-Identifier: GPL-3.0-or-later
# @name      motion-limits-by-joint
# @question  The limit of every motion of every joint, and where the bones touch.
# @data      motion_limit_details
"""How far each joint turns until its surfaces touch, about the centre of the head and about the socket's. It has the clock
position of the contact, the interval that holds for every centre within half a millimetre, and where the gap first falls to
half a millimetre.
"""

import pandas as pd

import common
from common import motion_limits


def main(options) -> common.Table:
    head = motion_limits.contacts(options.results)
    socket = motion_limits.contacts(options.results, "socket").set_index(["joint", "motion"])
    rows = []
    for row in head.itertuples():
        key = (row.joint, row.motion)
        other = socket.loc[key] if key in socket.index else None
        rows.append(
            {
                "joint": motion_limits.label(row.joint),
                "motion": motion_limits.MOTIONS[row.motion],
                **ends(row, "limit"),
                "clock": "" if pd.isna(row.clock) else row.clock,
                "any_centre_low_deg": row.centre_low_deg,
                "any_centre_high_deg": row.centre_high_deg,
                "half_mm_gap_deg": row.half_mm_gap_deg,
                "hangs_on_less": row.hangs_on_less,
                **({} if other is None else ends(other, "about_socket_centre")),
                "shown": motion_limits.text(row),
            }
        )
    table = pd.DataFrame(rows)
    return table.drop(columns="shown"), latex(table)


def ends(row, name: str) -> dict:
    """A limit in numbers: the angles between which it lies, and what it is; open above where nothing is known."""
    return {f"{name}_state": row.state, f"{name}_low_deg": row.limit_low_deg, f"{name}_high_deg": row.limit_high_deg}


def latex(table: pd.DataFrame) -> str:
    """A line per motion and a column per generated hip: limit and clock position."""
    joints = [motion_limits.label(name) for name in motion_limits.GENERATED]
    names = [name.removeprefix("stand-in for ") for name in joints]
    lines = []
    for motion in motion_limits.MOTIONS.values():
        cells = []
        for joint in joints:
            found = table[(table.joint == joint) & (table.motion == motion)]
            cells.append(" ".join(found.iloc[0][["shown", "clock"]]).strip() if len(found) else "")
        lines.append(motion.replace("°", r"\textdegree{}") + " & " + " & ".join(cells) + r" \\")
    return common.tabular("l" + "r" * len(joints), ["motion & " + " & ".join(names) + r" \\"], lines)


common.run(main)
