# SPDX-License-Identifier: GPL-3.0-or-later
"""The full run that is committed (results/reference/, written by experiments/keep_reference.py), to show beside this one."""

from __future__ import annotations

import json
from pathlib import Path

import pandas as pd

import common

KEYS = ["artefact", "row", "column"]
RULE = ["thesis", "unit", "rule", "tolerance"]


def described(folder: Path) -> str:
    """Which run it is; empty where none is kept."""
    path = folder / "run.json"
    if not path.is_file():
        return ""
    run = json.loads(path.read_text())
    return (
        f"{run['profile']} profile, commit {run['commit'][:12]}, {run['cpu']}, {run['cores']} cores, "
        f"{run['compiler']}, {run['started_utc'][:10]}"
    )


def agreement(folder: Path) -> str:
    """How far the full runs kept before, of other days, give the same verdicts; empty where none is kept."""
    return ". ".join(agreement_of(folder, earlier) for earlier in sorted((folder / "earlier").glob("*"), reverse=True))


def agreement_of(folder: Path, earlier: Path) -> str:
    """The same of one of them."""
    both = common.as_text(folder / "verdicts.csv").merge(common.as_text(earlier / "verdicts.csv"), on=[*KEYS, *RULE], suffixes=("", "_earlier"))
    same = (both.verdict == both.verdict_earlier).sum()
    flips = both[["verdict", "verdict_earlier"]].isin(["reproduced", "differs"]).all(axis=1) & (both.verdict != both.verdict_earlier)
    return (
        f"One before it ({described(earlier)}) has the same verdict on {same} of the {len(both)} numbers that both judge by the same rule; "
        f"{flips.sum()} turn from reproduced to differs or back"
    )


def with_verdicts(verdicts: pd.DataFrame, folder: Path) -> pd.DataFrame:
    """The rows with what the reference measured, and its verdict where that is another; as they are where there is none."""
    path = folder / "verdicts.csv"
    if not path.is_file():
        return verdicts
    kept = common.as_text(path)[[*KEYS, "measured", "verdict"]]
    merged = verdicts.merge(kept, on=KEYS, how="left", suffixes=("", "_reference"), validate="one_to_one")
    merged = merged.rename(columns={"measured_reference": "reference"}).fillna("")
    other = (merged.verdict_reference != "") & (merged.verdict_reference != merged.verdict)
    return merged.assign(verdict_reference=merged.verdict_reference.where(other, ""))


def beside(path: Path, folder: Path) -> tuple[pd.DataFrame, pd.DataFrame | None]:
    """A table of this run, and the reference's of the same name if there is one."""
    kept = folder / "tables" / path.name
    return common.as_text(path), common.as_text(kept) if kept.is_file() else None


def varies(text: str) -> bool:
    """Whether another run may have another word here: values and flags, not names."""
    if text in ("", "yes", "no"):
        return True
    try:
        float(text)
    except ValueError:
        return False
    return True


def aligned(table: pd.DataFrame, kept: pd.DataFrame) -> bool:
    """Whether the two have the same columns, as many rows, and the same names in the same cells."""
    if list(table.columns) != list(kept.columns) or len(table) != len(kept):
        return False
    pairs = zip(table.to_numpy().ravel(), kept.to_numpy().ravel())
    return all(a == b or (varies(a) and varies(b)) for a, b in pairs)
