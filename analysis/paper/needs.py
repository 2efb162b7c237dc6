# SPDX-License-Identifier: GPL-3.0-or-later
# @data      scene_needs
# @depends   tables/build-needs.csv
"""Numbers of the paper about what one question needs, of the generated hip.

needs:faces (of both surfaces), :least and :most (per cent of the processor time of everything), :memory:least and :most (of its peak
memory), :looked (faces looked at, per cent, at most); needs:QUESTION:WAY (processor time of another library over that of
ours), needs:others:memory (peak memory of those for a pose over ours); build:core, :one and :all with :targets, :packages and :mb.
"""

from pathlib import Path

import pandas as pd

import common
from common import scene_needs

PROGRAMS = ("core", "one", "all")  # rows of build-needs.csv


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    table = scene_needs.load(results)
    rows = table[table.joint == table.joint.iloc[0]]
    ours, all_of_them = rows[rows.way == "needed"], rows[rows.question == "everything"].iloc[0]
    found = {
        "needs:faces": f"{all_of_them.faces:,}",
        "needs:looked": common.digits(100 * ours.faces_looked_at.max() / all_of_them.faces, 2),
    }
    for name, share in (("needs", ours.of_all), ("needs:memory", ours.peak_bytes / all_of_them.peak_bytes)):
        found |= {f"{name}:least": common.digits(100 * share.min(), 2), f"{name}:most": common.digits(100 * share.max(), 2)}
    for row in rows[~rows.way.isin(["needed", "everything"])].itertuples():
        found[f"needs:{row.question}:{row.way}"] = common.digits(row.times_needed, 2)
    peers = rows[rows.way.isin(["fcl_collide", "ode_collide", "embree_ray8", "cgal_first_hit"]) & rows.question.isin(["touch", "all gaps"])]
    memory = peers.peak_bytes / peers.question.map(ours.set_index("question").peak_bytes)
    found["needs:others:memory"] = f"{common.digits(memory.min(), 2)} to {common.digits(memory.max(), 2)}"
    for name, row in zip(PROGRAMS, pd.read_csv(results / "tables" / "build-needs.csv").itertuples()):
        found |= {f"build:{name}:targets": str(row.targets), f"build:{name}:packages": str(row.packages)}
        found[f"build:{name}:mb"] = common.digits(row.program_MB, 2)
    return found
