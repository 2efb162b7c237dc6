# SPDX-License-Identifier: GPL-3.0-or-later
# @data      scene_needs
"""What one question needs, compared with all of them and with other libraries, from data/scene_needs.csv: a row per joint,
question and way."""

from pathlib import Path

import pandas as pd

import common

QUESTIONS = {
    "touch": "do the surfaces meet? (a pose)",
    "smallest gap": "smallest gap (a pose)",
    "all gaps": "all gaps (a pose)",
    "limits": "limits of 12 motions",
    "volume": "volume of all rotations",
    "measures": "measures of the shape",
}


def load(results: Path) -> pd.DataFrame:
    """The rows with the label of each way, `peak_MB`, `touched_MB`, and `of_all`: processor time over that of everything."""
    table = common.load(results, "scene_needs")
    table["label"] = table.way.map(common.label)
    for name in ("peak", "touched"):
        table[f"{name}_MB"] = table[f"{name}_bytes"] / 1e6
    everything = table[table.question == "everything"].set_index("joint")
    table["of_all"] = table.cpu_ms / table.joint.map(everything.cpu_ms)
    return table

