# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the report with every verdict, by the rule that gave it; report.js filters them."""

from __future__ import annotations

import html

import pandas as pd

from common.tally import NOT_COUNTED
from report.artefacts import row_label, title_of
from report.markup import cell, choice, digits, element, fold, words

MARKS = {"reproduced": "✓", "differs": "≠", "inconclusive": "?", "thesis-misprint": "!", "not-comparable": "–", "input": "·"}
MEANINGS = {
    "reproduced": "meets its rule",
    "differs": "does not meet it",
    "inconclusive": "a part of its range does",
    "thesis-misprint": "slip in the thesis",
    "not-comparable": "of another machine or patient",
    "input": "given, not computed",
}
COLUMNS = {
    "where": "where", "row": "row or case", "column": "column", "thesis": "thesis", "measured": "this run", "range": "its range",
    "reference": "reference run", "unit": "unit",
}  # fmt: skip
ROUNDED = ("measured", "range", "reference")
UNCOUNTED = "Not counted, because another table has the number or the thesis gives none"


def section(verdicts: pd.DataFrame, places: set[str]) -> str:
    """All of it; places: what the page has a section of."""
    verdicts = verdicts.assign(range=[" to ".join(filter(None, ends)) for ends in zip(verdicts.low.map(digits), verdicts.high.map(digits))])
    names = [name for name in COLUMNS if name in verdicts or name == "where"]
    titles = [*(COLUMNS[name] for name in names), "verdict", "why"]
    head = element("thead", element("tr", "".join(element("th", title, scope="col") for title in titles)))
    groups = "".join(group(rule, rows, names, places) for rule, rows in by_rule(verdicts).items())
    table = element("div", element("table", head + groups, id="verdicts", class_="cards"), class_="scroll")
    return fold("Every verdict, by its rule", filters(verdicts) + table, "verdicts-all", f"{len(verdicts)} rows")


def by_rule(verdicts: pd.DataFrame) -> dict[str, list[dict[str, str]]]:
    """The rows under each rule with its tolerance, the rules with most rows first, and what is not counted last."""
    found: dict[str, list[dict[str, str]]] = {}
    for row in verdicts.to_dict("records"):
        tolerance = f" ({row['tolerance']})" if row["tolerance"] not in ("", "none") else ""
        left_out = row["rule"].startswith(NOT_COUNTED)
        found.setdefault(UNCOUNTED if left_out else f"Rule: {row['rule']}{tolerance}", []).append(row)
    return dict(sorted(found.items(), key=lambda item: (item[0] == UNCOUNTED, -len(item[1]))))


def filters(verdicts: pd.DataFrame) -> str:
    """Choices that report.js reads."""
    found = set(verdicts.verdict)
    return element(
        "div",
        choice("filter-artefact", "Where", {"": "all"} | {name: title_of(name) for name in verdicts.artefact.unique()})
        + choice("filter-verdict", "Verdict", {"": "all"} | {name: f"{name}: {MEANINGS[name]}" for name in MARKS if name in found})
        + '<label>Text<input id="filter-text" type="search"></label><span class="soft" id="count"></span>',
        class_="filters",
    )


def group(rule: str, rows: list[dict[str, str]], names: list[str], places: set[str]) -> str:
    """A rule, and the rows that it judges."""
    head = element("th", html.escape(rule), colspan=str(len(names) + 2), scope="rowgroup")
    return element("tbody", element("tr", head, class_="rule") + "".join(verdict_row(row, names, places) for row in rows))


def verdict_row(row: dict[str, str], names: list[str], places: set[str]) -> str:
    """Its values, its verdict (and the reference run's where that is another), and what is to be said of it."""
    where = html.escape(title_of(row["artefact"]))
    if row["artefact"] in places:
        where = element("a", where, href=f"#{row['artefact']}")
    cells = [element("td", where)]
    for name in names[1:]:
        text = row_label(row[name]) if name == "row" else words(row[name]) if name == "column" else row[name]
        cells.append(cell(text, name=name in ("row", "column"), shorten=name in ROUNDED))
    counted, found = not row["rule"].startswith(NOT_COUNTED), row["verdict"]
    other = row.get("verdict_reference", "")
    inner = html.escape(found) + ("<br>" + element("span", f"reference: {other}", class_="kept") if other else "")
    looks = f"verdict {found}" if counted else "verdict input"
    cells.append(element("td", inner, class_=looks, data_mark=MARKS.get(found, "") if counted else MARKS["input"]))
    why = row["note"] if counted else row["rule"].removeprefix(NOT_COUNTED) + (f". {row['note']}" if row["note"] else "")
    cells.append(element("td", html.escape(why), class_="why"))
    return element("tr", "".join(cells), data_artefact=row["artefact"], data_verdict=found)
