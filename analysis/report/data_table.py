# SPDX-License-Identifier: GPL-3.0-or-later
"""A table of the report: this run's values, and below them in grey those of the reference run where they differ."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from report import reference
from report.markup import cell, element

SCROLLED = 25  # rows above which a table gets a window of its own
MOST = 150  # rows in the page: the rest is in the file


def grid(table: pd.DataFrame, kept: pd.DataFrame | None) -> str:
    """The rows; kept has the same shape."""
    head = element("tr", "".join(element("th", name.replace("_", " "), scope="col") for name in table.columns))
    older = kept.itertuples(index=False) if kept is not None else [None] * len(table)
    body = "".join(
        element("tr", "".join(cell(value, shorten=True, kept=old) for value, old in zip(row, was or row)))
        for row, was in zip(table.head(MOST).itertuples(index=False), older)
    )
    style = "scroll long" if len(table) > SCROLLED else "scroll"
    inner = element("table", element("thead", head) + element("tbody", body))
    return element("div", inner, class_=style, tabindex="0")


def remark(path: Path, table: pd.DataFrame, kept: pd.DataFrame | None) -> str:
    """What stands below the rows."""
    words = []
    if len(table) > MOST:
        words.append(f"The first {MOST} of {len(table):,} rows; all are in tables/{path.name}.")
    if kept is not None and table.equals(kept):
        words.append("The reference run has the same values.")
    elif kept is not None and reference.aligned(table, kept):
        words.append("Grey: the reference run's value, where it differs.")
    elif kept is not None and max(len(table), len(kept)) > MOST:
        words.append(f"The reference run's, with other rows, is results/reference/tables/{path.name}.")
    return element("p", " ".join(words), class_="soft") if words else ""


def section(path: Path, folder: Path) -> str:
    """A CSV of this run beside the reference's in that folder."""
    table, kept = reference.beside(path, folder)
    together = kept is not None and reference.aligned(table, kept)
    shown = grid(table, kept if together else None) + remark(path, table, kept)
    if kept is not None and not together and max(len(table), len(kept)) <= MOST:
        shown += element("details", element("summary", "The reference run's table") + grid(kept, None))
    return shown
