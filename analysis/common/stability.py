# SPDX-License-Identifier: GPL-3.0-or-later
"""What figures and tables of stability share: the rows of data/stability.csv with their details, and which cases are drawn as
one line.
"""

from pathlib import Path

import numpy as np
import pandas as pd

import common
from common import measured

KEY = ["family", "magnitude", "method", "precision_deg", "scalar"]

# What readers compare: the columns of the overview, with the rows of the results that each stands for.
OURS = ["exact", "tables, 0.1° or finer", "tables, 1°", "tables, coarser"]
STEPS = {1.0: "exact test in steps of 1°", 0.1: "exact test in steps of 0.1°"}
OTHERS = {
    "vertex_gaps_in_steps": "thesis: gaps of vertices in steps",
    "radius_as_eq_11": "as printed, or in float",
    "speed_as_eq_12": "as printed, or in float",
    "float_before_centre": "as printed, or in float",
    "azimuths_in_float": "as printed, or in float",
    "azimuths_summed": "as printed, or in float",
    "pairwise": "every face, in double",
    "embree_robust": "Embree, robust",
    "embree_fast": "Embree, fast",
    "cgal_first_hit": "CGAL",
    "cgal_pairs": "CGAL",
    "fcl_collide": "FCL",
    "ode_collide": "ODE (OPCODE)",
    "vtk_collide": "VTK",
}
# What holds, what is left open and what fails: light, middling and dark, so that it is read in grey too.
HOLDS, OPEN, FAILS = "#CFE8F5", "#E3AE33", "#A5300B"
COLUMNS = [*OURS, *STEPS.values(), *dict.fromkeys(OTHERS.values())]


def load(results: Path) -> pd.DataFrame:
    """One row per case; `who` is its column in the overview, none for methods that are wrong on purpose."""
    cases = measured.joined(results, "stability", "stability_detail", KEY)
    cases["who"] = cases.method.map(OTHERS)
    steps = cases.kind == "steps"
    cases.loc[steps, "who"] = cases[steps].precision_deg.map(STEPS)
    ours = cases.kind == "ours"
    cases.loc[ours, "who"] = pd.cut(cases[ours].precision_deg, [-1, 0, 0.1, 1, 360], labels=OURS).astype(str)
    cases["broken_bounds"] = bounds(cases) == "broken"
    cases["wrong"] = cases.failures.fillna(0) + cases.broken_bounds
    cases["silent"] = cases.withheld.fillna(0) + cases.unbounded.fillna(0) + cases.refused
    cases["asked"] = cases.questions.fillna(0) + cases.refused
    return cases


def families(results: Path) -> pd.DataFrame:
    """One row per family, by its name."""
    return common.load(results, "stability_families").set_index("family")


def magnitudes(cases: pd.DataFrame) -> list[float]:
    """In the order of the run, from harmless to extreme."""
    return list(dict.fromkeys(cases.magnitude))


def bounds(cases: pd.DataFrame) -> pd.Series:
    """The result of each case's proven bound: held, broken, infinite, or not tested by any look-up. Empty if no bound is
    claimed."""
    said = cases.bound_holds.map({True: "held", "yes": "held", False: "broken", "no": "broken"})
    said[(cases.bound_um.notna() | (cases.withheld > 0)) & cases.error_um.isna() & cases.bound_holds.isna()] = "unanswered"
    said[np.isinf(cases.bound_um)] = "infinite"
    return said


def overview(cases: pd.DataFrame) -> pd.DataFrame:
    """For each family and column the counts asked, wrong and silent (withheld, without a finite bound, or refused)."""
    return cases.dropna(subset="who").groupby(["family", "who"])[["asked", "wrong", "silent"]].sum().astype(int)


STIFF = 1000  # a condition number above it


def condition(cases: pd.DataFrame, family: str) -> float:
    """The largest condition of a family."""
    return cases[cases.family == family].condition.max()


def kind(number: float) -> str:
    """The kind of a family with that condition number; one that is not stiff is extreme by its parameter."""
    return "stiff" if number > STIFF else "extreme"


def power(number: float) -> str:
    """A power of ten, in the digits of a figure."""
    if number < 1e4:
        return common.digits(number)
    if number != number:
        return "---"
    mantissa, exponent = f"{number:.0e}".split("e")
    return f"${mantissa}\\cdot 10^{{{int(exponent)}}}$"
