# SPDX-License-Identifier: GPL-3.0-or-later
"""A verdict is one line of verdicts.csv. This has the rules that several tables share."""

from collections.abc import Iterable

import pandas as pd

import common
from common.ranges import Range
from common.tally import NOT_COUNTED

COLUMNS = [*"artefact row column kind thesis measured low high unit rule tolerance verdict note".split()]
KINDS = {"formula": "computed", "timing": "measured", "observation": "measured", "input": "given"}  # of a value of the thesis
CLAIM_TOLERANCE = 2  # percentage points; the thesis gives its claims in tens, as "about 20%" or "up to 30%"
VERDICTS = ("reproduced", "differs", "inconclusive", "thesis-misprint", "not-comparable", "input")


def row(artefact: str, name: str, column: str, **rest: object) -> dict[str, object]:
    """One line of verdicts.csv; what is not given stays empty. `kind` is measured, or computed for what follows from formulas,
    without a clock or a joint.
    """
    return {**dict.fromkeys(COLUMNS, ""), "artefact": artefact, "row": name, "column": column, "kind": "measured", **rest}


def value_row(value, **rest: object) -> dict[str, object]:
    """The line of a value of common.thesis()."""
    return row(value.artefact, value.row, value.column, **{"thesis": value.value, "unit": value.unit, "kind": KINDS[value.kind], **rest})


def not_counted(line: dict[str, object], why: str) -> dict[str, object]:
    """The same line without being counted in sums: its number is counted elsewhere, or there is none."""
    return {**line, "rule": NOT_COUNTED + why, "tolerance": ""}


def ranged(found: Range, significant: int = 4) -> dict[str, str]:
    """The columns of a range."""
    return {name: common.plain(end, significant) for name, end in (("low", found.low), ("high", found.high))}


def judged(good: bool | None) -> str:
    """The verdict on a range of which all, nothing, or only a part meets the rule."""
    return {True: "reproduced", False: "differs", None: "inconclusive"}[good]


def counted(rows: pd.DataFrame) -> pd.DataFrame:
    """The rows that sums count: each number of the thesis once."""
    return rows[~rows.rule.str.startswith(NOT_COUNTED)]


def rounds_to(measured: float, printed: str) -> bool:
    """Does the value have the printed digits when it is rounded to as many?"""
    decimals = len(printed.partition(".")[2])
    return float(f"{measured:.{decimals}f}") == float(printed)  # as numbers: -0 is 0


def printed_row(value, measured: float, note: str = "", otherwise: str = "differs", also: Iterable[float] = ()) -> dict[str, object]:
    """A value that follows from a formula. It is reproduced if ours rounds to the printed digits, else `otherwise` is the
    verdict; the note is added. `also` are further values that the thesis may mean: all must round so, or none. `value` is a
    line of common.thesis().
    """
    every = [measured, *also]
    good = {rounds_to(one, value.value) for one in every}
    return value_row(
        value,
        measured=common.plain(measured, 10),
        **(ranged(Range(min(every), max(every)), 10) if also else {}),
        rule="equal when rounded to the digits printed",
        tolerance="half a unit of the last digit",
        verdict="inconclusive" if len(good) > 1 else "reproduced" if good == {True} else otherwise,
        note=note,
    )


def near_claim(percent: float, value: str) -> bool:
    """Does it meet a claim in tens of per cent?"""
    return abs(percent - float(value)) <= CLAIM_TOLERANCE


def claim_row(value, readings: list[float], rule: str, note: str) -> dict[str, object]:
    """A claim in tens of per cent, by every way to read it, the first of which is shown: all must meet it, or none."""
    good = {near_claim(percent, value.value) for percent in readings}
    return value_row(
        value,
        kind="computed",
        measured=common.plain(readings[0]),
        **ranged(Range(min(readings), max(readings))),
        rule=f"within {CLAIM_TOLERANCE} percentage points{rule}",
        tolerance=f"{CLAIM_TOLERANCE} percentage points",
        verdict="inconclusive" if len(good) > 1 else "reproduced" if good == {True} else "differs",
        note=note,
    )


def input_row(value, rule: str = "given, not computed") -> dict[str, object]:
    """A value that both the thesis and we take from elsewhere, or that could not be different."""
    return value_row(value, measured=value.value, rule=rule, verdict="input")
