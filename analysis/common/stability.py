# SPDX-License-Identifier: GPL-3.0-or-later
"""What figures and tables of stability share: the rows of data/stability.csv with those of its details, and
who is drawn as one line.
"""

from pathlib import Path

import numpy as np
import pandas as pd

import common
from common import measured

KEY = ["family", "magnitude", "method", "scalar"]
OURS = {"double": "ours, in double", "float": "ours, stored in float"}
CONTENDERS = {
    "pairwise": "pairwise rays",
    "embree_fast": "Embree, fast",
    "embree_robust": "Embree, robust",
    "cgal_first_hit": "CGAL, first hit",
    "float_before_centre": "coordinates in float before centring",
    "radius_as_eq_11": "radius as Eq. 11 has it",
    "speed_as_eq_12": "speed as Eq. 12 has it",
    "azimuths_in_float": "azimuths in float degrees",
    "azimuths_summed": "azimuths summed step by step",
}


def load(results: Path) -> pd.DataFrame:
    """One row a case; `who` is the line that it belongs to, ours first."""
    cases = measured.joined(results, "stability", "stability_detail", KEY)
    cases["who"] = cases.method.map(CONTENDERS).fillna(cases.method)
    ours = cases.kind == "ours"
    cases.loc[ours, "who"] = cases[ours].scalar.map(OURS)
    order = list(OURS.values()) + sorted(set(cases.who) - set(OURS.values()))
    cases["who"] = pd.Categorical(cases.who, [name for name in order if (cases.who == name).any()])
    return cases


def families(results: Path) -> pd.DataFrame:
    """One row a family, by its name."""
    return common.load(results, "stability_families").set_index("family")


def magnitudes(cases: pd.DataFrame) -> list[float]:
    """In the order of the run, from harmless to extreme."""
    return list(dict.fromkeys(cases.magnitude))


def bounds(cases: pd.DataFrame) -> pd.Series:
    """What the proven bound of each case comes to: held, broken, infinite, or held against no look-up at all.
    Empty where none is claimed."""
    said = cases.bound_holds.map({True: "held", "yes": "held", False: "broken", "no": "broken"})
    said[cases.bound_um.notna() & cases.error_um.isna()] = "unanswered"
    said[np.isinf(cases.bound_um)] = "infinite"
    return said
