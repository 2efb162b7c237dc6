# SPDX-License-Identifier: GPL-3.0-or-later
# @data      all_gaps
# @depends   tables/fast-targets.csv
"""Numbers of the paper about all gaps of a pose: fast:KEY of each target's ratio, fast:KEY:met, fast:met and fast:missed
how many were, fast:set the instruction set, fast:METHOD:SETTING:STORAGE:ns, :um and :kib of the vertices of the
socket against the ball, fast:threads how much two threads gain,
fast:growth the exponent with which the time of a pose grows with the triangles, cube in 16 bits (1 is linear)."""

from pathlib import Path

import pandas as pd

import common
from common import fast, log_plot


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    table = fast.load(results)
    targets = common.as_text(results / "tables" / "fast-targets.csv")
    found = {f"fast:{row.key}": row.measured for row in targets.itertuples()}
    found |= {f"fast:{row.key}:met": row.met for row in targets.itertuples()}
    found |= {"fast:met": str((targets.met == "yes").sum()), "fast:missed": str((targets.met == "no").sum())}
    rows = fast.plain_rows(table)
    for row in rows[rows.direction == "socket->ball"].itertuples():
        name = f"fast:{row.method}:{row.setting}:{row.storage}"
        found[f"{name}:ns"] = common.digits(row.ns_vertex, 2)
        found[f"{name}:um"] = common.digits(row.error_um, 2)
        found[f"{name}:kib"] = common.digits(row.bytes / 1024)
    return found | {"fast:set": fast.set_name(table), "fast:threads": gain(table, rows), "fast:growth": growth(table)}


def gain(table: pd.DataFrame, rows: pd.DataFrame) -> str:
    """Vertices a second of two threads over those of one, cube in 16 bits."""
    one = rows[(rows.method == "cube_gnomonic_mesh_exact") & (rows.setting == "n=291") & (rows.storage == "uint16")]
    keys = ["method", "setting", "storage", "direction", "triangles"]
    pair = one.merge(table[table.threads == 2], on=keys)
    return common.digits((pair.ns_vertex_x / pair.ns_vertex_y).median(), 2)


def growth(table: pd.DataFrame) -> str:
    """Of the vertices of the socket, one thread; --- where one size alone was run."""
    own = table[
        (table.method == "cube_gnomonic_mesh_exact")
        & (table.setting == "n=291")
        & (table.storage == "uint16")
    ]
    own = own[(own.instruction_set == fast.best_set(table)) & (own.threads == 1) & (own.direction == "socket->ball")]
    exponent = log_plot.slope(own.triangles, own.ns_vertex * own.triangles)
    return common.digits(exponent, 2) or "---"
