# SPDX-License-Identifier: GPL-3.0-or-later
"""A finding is a statement, what was computed about it, and whether it holds.

A verdict follows from the numbers by a condition in the code and is never written down. Only where two places of the
text are compared and nothing is computed does the evidence say so.
"""

from pathlib import Path
from types import FunctionType, ModuleType

import pandas as pd

import common
from common.ranges import Range

COLUMNS = ["said_by", "where", "claim", "computed", "low", "high", "evidence", "verdict", "source"]
VERDICTS = ("holds", "wrong", "misprint", "imprecise", "inconclusive")
THESIS = "thesis"  # who said it: the thesis, the note, or papers
ARITHMETIC = "no data: arithmetic with the thesis' own numbers"  # evidence of what needs no experiment
READING = "no data: two places of the thesis' text, read"  # evidence of what no number of ours decides


class Finding(dict[str, str]):
    """One line of findings.csv."""


def rows(module: ModuleType, results: Path) -> list[Finding]:
    """The results of a module's functions that return a Finding, or several, in their order. SAID_BY of the module is who said it,
    if not the thesis.
    """
    found = []
    for function in vars(module).values():
        if isinstance(function, FunctionType) and function.__module__ == module.__name__:
            returned = function.__annotations__.get("return")
            if returned in (Finding, list[Finding]):
                said = function(results) if function.__code__.co_argcount else function()
                found += [said] if returned is Finding else said
    return [Finding(one, said_by=getattr(module, "SAID_BY", THESIS)) for one in found]


def finding(where: str, claim: str, computed: str, evidence: str, **rest: object) -> Finding:
    """Makes a Finding. `rest` has holds (bool), or, for what depends on rounds, joints or a machine, `value`, a Range, with
    `within`, the limits for all of it: a part of it decides nothing. It may have otherwise, the verdict if it does not hold
    (default: wrong), and source, the key of a reference with which the statement is compared.
    """
    otherwise = str(rest.get("otherwise", "wrong"))
    if otherwise not in VERDICTS:
        raise ValueError(f"{otherwise} is no verdict on a statement: use one of {VERDICTS}")
    value = rest.get("value")
    holds = value.within(*rest["within"]) if isinstance(value, Range) else rest["holds"]
    return Finding(
        where=f"Section {where}" if where[0].isdigit() else where,
        claim=claim,
        computed=computed,
        low=common.plain(value.low) if isinstance(value, Range) else "",
        high=common.plain(value.high) if isinstance(value, Range) else "",
        evidence=evidence,
        verdict="inconclusive" if holds is None else "holds" if holds else otherwise,
        source=str(rest.get("source", "")),
    )


def load(results: Path, name: str, **chosen: object) -> pd.DataFrame:
    """The rows of data/NAME.csv that have the given values."""
    table = common.load(results, name)
    for column, value in chosen.items():
        table = table[table[column] == value]
    return table


def one(table: pd.DataFrame, column: str, **chosen: object) -> float:
    """The only value of the column in the rows that have the given values."""
    for key, value in chosen.items():
        table = table[table[key] == value]
    (value,) = table[column]
    return value


def printed(artefact: str, column: str, row: str) -> str:
    """What the thesis prints in that place."""
    values = common.thesis(artefact)
    (value,) = values.value[(values.column == column) & (values.row == row)]
    return value


def rounded(value: float, significant: int = 3) -> str:
    """A number for reading, like common.digits(), but with a plain minus sign and never empty."""
    text = common.digits(value, significant)
    if not text:
        raise ValueError(f"there is no number to print: {value}")
    return text
