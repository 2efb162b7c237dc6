# SPDX-License-Identifier: GPL-3.0-or-later
# @data      limit_time touch_time turns turn_time
"""What the paper on motion says of time and misses beside other libraries: of real joints with whole bones, or of the generated
hip where a run has none.

whole:scene, of what; :motions, how many limits; :ours, seconds of processor time for all, trees made; :steps and :all, sentences
on steps; :touch, one on single poses; turns:said, one on the test set of turns.
"""

from pathlib import Path

import pandas as pd

import common
from common import limit_time

MADE = ("implant", "needle", "normal hip")  # begin the names of joints that are no real ones
OURS = "turn_limit"
FCL = "fcl_collide"


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    every = limit_time.load(results)
    return limits(every) | {"whole:touch": touch(results), "turns:said": turns(results)}


def of_whole(table: pd.DataFrame) -> pd.DataFrame:
    """The rows of real joints, or of the generated hip."""
    made = table.joint.str.startswith(MADE)
    return table[~made] if (~made).any() else table[table.joint.str.startswith("normal hip")]


def span(values: pd.Series, unit: str = "") -> str:
    """From the least to the most, or the only one."""
    ends = dict.fromkeys(common.digits(value, 2) for value in (values.min(), values.max()))
    return " to ".join(ends) + unit


def limits(every: pd.DataFrame) -> dict[str, str]:
    """Of all motions, and how much longer steps take."""
    table = of_whole(every)
    joints, faces = table.joint.nunique(), table.faces
    real = not table.joint.iloc[0].startswith(MADE)
    sizes = " to ".join(dict.fromkeys(f"{common.digits(size, 3)}" for size in (faces.min(), faces.max())))
    ours = table[table.method == OURS]
    return {
        "whole:scene": f"the whole bones of {joints} real joints ({sizes} faces)" if real else f"a generated hip of {sizes} faces",
        "whole:motions": str(ours.motions.max()),
        "whole:ours": span(ours.cpu_ms / 1e3, " s"),
    }
