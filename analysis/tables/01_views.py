# SPDX-License-Identifier: GPL-3.0-or-later
# @name      table-1
# @question  The names of the views, and where the cameras of our pictures look (Table 1 of the thesis).
"""Table 1: the views by their anatomical names and as computer graphics calls them, and the directions in which the cameras of
our pictures look for them.
"""

import pandas as pd

import common
from common import hip

# As in the thesis, which has no such name for the medial view.
GRAPHICS = {
    "superior": "top view",
    "inferior": "bottom view",
    "anterior": "front view",
    "posterior": "back view",
    "lateral": "side view, of the joint's own side",
    "medial": "none",
}
WORDS = {
    "R": "the right",
    "L": "the left",
    "A": "the front",
    "P": "the back",
    "S": "the top",
    "I": "the bottom",
}


def main(options) -> common.Table:
    right, left = hip.looks(1.0), hip.looks(-1.0)
    rows = pd.DataFrame(
        [
            {
                "anatomy": f"{view} view",
                "computer_graphics": graphics,
                "camera_right_hip_looks": way(right[view]),
                "camera_left_hip_looks": way(left[view]),
            }
            for view, graphics in GRAPHICS.items()
        ]
    )
    return rows, latex(rows)


def way(look: tuple[float, float, float]) -> str:
    """The anatomical direction of an axis."""
    letter = next(letter for letter, axis in hip.DIRECTIONS.items() if axis == tuple(look))
    return f"to {WORDS[letter]}"


def latex(rows: pd.DataFrame) -> str:
    """Names, then where the cameras look."""
    lines = [[common.tex(value) for value in row] for row in rows.itertuples(index=False)]
    return common.tabular("@{}llll@{}", [["anatomy", "computer graphics", "camera, right hip", "camera, left hip"]], lines)


common.run(main)
