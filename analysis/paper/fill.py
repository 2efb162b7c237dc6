# SPDX-License-Identifier: GPL-3.0-or-later
# @data      fill
# @depends   tables/fill-growth.csv
"""Numbers of the paper about experiment 13_fill: fill:start_us, :triangle_ns, :entry_ns and :largest_residual
(percent) of the growth of one thread that stores 16 bits in memory that is used again, fill:double how many times
longer the rasteriser of all schemes takes, and fill:fresh what fresh memory costs, both at the finest of the tables;
fill:worst_triangles and :worst_cells where the ratio to Embree is least, and fill:few the least for 12,000 or fewer.
"""

from pathlib import Path

import common
from common import fill


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    table = fill.load(results)
    fit = fill.growth(table).set_index(fill.WAY).loc[("cube_at_once", "uint16", "used again", 1)]
    found = {f"fill:{name}": common.digits(fit[name], 2) for name in ("start_us", "triangle_ns", "entry_ns")}
    found["fill:largest_residual"] = common.digits(100 * fit.largest_residual, 2)
    finest = table[
        (table.cells == table.cells.max()) & (table.triangles == fill.TRIANGLES) & (table.threads == 1)
    ]
    times = finest.set_index(["method", "storage", "memory"]).median_ms
    own = times["cube_at_once", "uint16", "used again"]
    found["fill:double"] = common.digits(times["cube_in_double", "double", "used again"] / own, 2)
    found["fill:fresh"] = common.digits(times["cube_at_once", "uint16", "fresh"] / own, 2)
    found["fill:cells"] = str(table.cells.max())
    aimed = fill.aimed(table)
    worst = aimed.loc[aimed.times_embree.idxmin()]
    found |= {"fill:worst_triangles": f"{worst.triangles:,}", "fill:worst_cells": str(worst.cells)}
    found["fill:few"] = common.digits(aimed[aimed.triangles <= fill.TRIANGLES].times_embree.min(), 2)
    return found
