# SPDX-License-Identifier: GPL-3.0-or-later
"""A table of the report: this run's values, and below them in grey those of the reference run where they differ."""

from __future__ import annotations

import html
import json
from pathlib import Path

import pandas as pd

from report import reference
from report.markup import cell, element, words

SCROLLED = 25  # rows above which a table gets a window of its own
MOST = 150  # rows in the page: the rest is in the file


def grid(table: pd.DataFrame, kept: pd.DataFrame | None, units: dict[str, str] = {}, cards: bool = False) -> str:
    """The rows, none of whose units is 1; kept has the same shape. On a phone a row of cards is a card, and of other tables a line that scrolls."""
    titles = [words(name, units.get(name, "")) for name in table.columns]
    table = table.assign(unit=table.unit.replace("1", "")) if "unit" in table else table
    numbers = [{"class_": "number"} if pd.to_numeric(table[name].replace("", "0"), errors="coerce").notna().all() else {} for name in table.columns]
    head = element("tr", "".join(element("th", title, scope="col", **look) for title, look in zip(titles, numbers)))
    older = kept.itertuples(index=False) if kept is not None else [None] * len(table)
    body = "".join(
        element("tr", "".join(cell(value, shorten=True, kept=old) for value, old in zip(row, was or row)))
        for row, was in zip(table.head(MOST).itertuples(index=False), older)
    )
    style = "scroll long" if len(table) > SCROLLED and not cards else "scroll"
    inner = element("table", element("thead", head) + element("tbody", body), **({"class_": "cards"} if cards else {}))
    return element("div", inner, class_=style, tabindex="0")


def remark(path: Path, table: pd.DataFrame, kept: pd.DataFrame | None) -> str:
    """What stands below the rows."""
    said = []
    if len(table) > MOST:
        said.append(f"The first {MOST} of {len(table):,} rows; all are in tables/{path.name}.")
    if kept is not None and table.equals(kept):
        said.append("The reference run has the same values.")
    elif kept is not None and reference.aligned(table, kept):
        said.append("Grey: the reference run's value, where it differs.")
    elif kept is not None and max(len(table), len(kept)) > MOST:
        said.append(f"The reference run's, with other rows, is results/reference/tables/{path.name}.")
    return element("p", " ".join(said), class_="soft") if said else ""


def units_of(path: Path) -> dict[str, str]:
    """The unit of each column, from the table's sidecar."""
    sidecar = path.with_suffix(".json")
    columns = json.loads(sidecar.read_text())["columns"] if sidecar.is_file() else []
    return {column["name"]: column["unit"] for column in columns}


def meanings(path: Path, results: Path, data: list[str]) -> dict[str, str]:
    """What the columns of a table mean, in the words of the data that it is made from; those that say it of another column are left out."""
    said: dict[str, str] = {}
    for name in data:
        for column in json.loads((results / "data" / f"{name}.json").read_text())["columns"]:
            said.setdefault(column["name"], column.get("meaning", ""))
    names = pd.read_csv(path, nrows=0).columns
    return {name: said[name] for name in names if said.get(name) and not said[name].startswith(("likewise", "the same", "as in ", "of th"))}


def explained(meant: dict[str, str]) -> str:
    """The meanings, folded."""
    lines = "".join(element("dt", words(name)) + element("dd", html.escape(text)) for name, text in meant.items())
    return element("details", element("summary", "What the columns mean") + element("dl", lines)) if meant else ""


def section(path: Path, folder: Path) -> str:
    """A CSV of this run beside the reference's in that folder."""
    table, kept = reference.beside(path, folder)
    together = kept is not None and reference.aligned(table, kept)
    units = units_of(path)
    shown = grid(table, kept if together else None, units) + remark(path, table, kept)
    if kept is not None and not together and max(len(table), len(kept)) <= MOST:
        shown += element("details", element("summary", "The reference run's table") + grid(kept, None, units))
    return shown
