# SPDX-License-Identifier: GPL-3.0-or-later
# @data      all_gaps
"""Numbers of the paper about all gaps of a pose, by the cube of 291 cells in 16 bits: fast:set the instruction set, fast:ns and
:um of the vertices of the socket against the ball, fast:ball and fast:socket how many times as fast as Embree's best rays
it is against either surface, fast:floor how many times as long as the memory-bound baseline it takes."""

from pathlib import Path

import common
from common import fast

SETTING = "n=291"


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    table = fast.load(results)
    rows = fast.plain_rows(table)
    rows = rows[(rows.setting == SETTING) & (rows.storage == "uint16")]
    cube, floor = (
        rows[rows.method == method].set_index("direction") for method in ("cube_gnomonic_mesh_exact", "floor")
    )
    ball, socket = cube.loc["socket->ball"], cube.loc["ball->socket"]
    values = {
        "ns": ball.ns_vertex,
        "um": ball.error_um,
        "ball": ball.times_embree,
        "socket": socket.times_embree,
        "floor": ball.ns_vertex / floor.ns_vertex["socket->ball"],
    }
    return {"fast:set": fast.set_name(table)} | {f"fast:{key}": common.digits(value, 2) for key, value in values.items()}
