# SPDX-License-Identifier: GPL-3.0-or-later
# @data      counts fast
"""Numbers of the paper about experiment 13_counts, cube in 16 bits with the best instruction set that was counted:
counts:set, counts:cube, counts:floor and, of a table of corners, counts:corners instructions of a vertex of the
socket, counts:over and counts:time the ratio of instructions and of times, counts:cube_misses and counts:floor_misses
of 32 KiB, counts:rim and counts:rim_misses of the vertices of the ball, counts:rays of the fewest of Embree's,
counts:touch and counts:boxes of a pose, culled and by FCL.
"""

from pathlib import Path

import common
from common import counts


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    table = counts.first_set(counts.load(results))
    by_method = {
        direction: rows.set_index("method")
        for direction, rows in table[(table.unit == "vertex") & (table.storage != "corners")].groupby(
            "direction"
        )
    }
    socket, ball = by_method["socket->ball"], by_method["ball->socket"]
    corners = table[(table.storage == "corners") & (table.direction == "socket->ball")].iloc[0]
    cube, floor = socket.loc["cube_gnomonic_mesh_exact"], socket.loc["floor"]
    rim = ball.loc["cube_gnomonic_mesh_exact"]
    poses = table[table.unit == "pose"].set_index("method").instructions
    numbers = {
        "cube": cube.instructions,
        "corners": corners.instructions,
        "floor": floor.instructions,
        "over": cube.over_floor,
        "time": cube.time_over_floor,
        "cube_misses": cube.l1_misses,
        "floor_misses": floor.l1_misses,
        "rim": rim.instructions,
        "rim_misses": rim.l1_misses,
        "rays": socket[socket.index.str.startswith("embree_ray")].instructions.min(),
        "touch": poses["culled"],
        "boxes": poses["fcl_collide"],
    }
    found = {f"counts:{name}": common.digits(number, 2) or "---" for name, number in numbers.items()}
    return found | {"counts:set": cube.instruction_set}
