# SPDX-License-Identifier: GPL-3.0-or-later
"""What the figures of experiment 12_scene_needs share: its questions, and the tables with joint and question apart."""

from pathlib import Path

import pandas as pd

import common

QUESTIONS = {
    "all gaps": "all gaps, one pose",
    "smallest gap": "smallest gap, one pose",
    "touch in a motion": "touch, 19 poses",
    "gaps in a motion": "all gaps to 0.05 mm, 181 poses",
    "local change": "table after a local change",
    "motion volume": "free rotations, 16,384 cells",
}


def load(results: Path, name: str) -> pd.DataFrame:
    """A table of the experiment with the columns `joint` and `question` that the name of a scene consists of."""
    table = common.load(results, name)
    parts = table.scene.str.split(" ", n=1, expand=True)
    return table.assign(joint=parts[0], question=parts[1])
