# SPDX-License-Identifier: GPL-3.0-or-later
"""What figures and tables of stability share: the rows of data/stability.csv with those of its details, and
who is drawn as one line.
"""

from pathlib import Path

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


def power(value: float) -> str:
    """A magnitude as a tick: 0.01, 3, a power of ten, or how far it is below 1."""
    if 0.99 < value < 1:
        return f"1−{power(1 - value)}"
    if value == 0 or 1e-3 <= abs(value) < 1e5:
        return f"{value:g}"
    mantissa, exponent = f"{value:.0e}".split("e")
    digits = "" if mantissa == "1" else mantissa.replace("-", "−") + "·"
    return f"${digits}10^{{{int(exponent)}}}$"
