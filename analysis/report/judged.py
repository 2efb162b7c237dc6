# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the report with the verdicts: how many of each, and every one with its rule; report.js filters them."""

from __future__ import annotations

import html

import pandas as pd

from common import tally
from report.artefacts import row_label, title_of
from report.markup import cell, choice, element
from verdicts import verdict

MARKS = {"reproduced": "✓", "differs": "≠", "inconclusive": "?", "thesis-misprint": "!", "not-comparable": "–", "input": "·"}
MEANINGS = {
    "reproduced": "meets the rule",
    "differs": "does not meet the rule",
    "inconclusive": "a part of its range meets the rule",
    "thesis-misprint": "wrong in the thesis",
    "not-comparable": "of another machine or patient",
    "input": "given, not computed",
}
KINDS = {"computed": "Computed from formulas", "measured": "Measured", "given": "Given by the thesis"}
HEADS = {"measured": "this run", "reference": "reference run", "row": "row or case", "artefact": "where"}


def section(verdicts: pd.DataFrame, places: set[str]) -> str:
    """All of it; places: what the page has a section of."""
    return "\n".join(
        [
            element("h2", "Verdicts", id="verdicts-title"),
            totals(verdicts),
            filters(verdicts),
            verdict_table(verdicts, places),
        ]
    )


def totals(verdicts: pd.DataFrame) -> str:
    """How often each verdict was given, each number of the thesis once: what was computed, and what was measured."""
    left_out = len(verdicts) - len(verdict.counted(verdicts))
    said = f"{left_out} more rows are not counted: another table has their number, or the thesis has none (see the rule)."
    parts = [element("p", said, class_="soft")]
    for kind, found in tally.counts(verdicts.to_dict("records")).items():
        parts += [element("h3", KINDS[kind]), tiles(found)] if found else []
    return "".join(parts)


def tiles(found: dict[str, int]) -> str:
    """One for each verdict."""
    return element(
        "ul",
        "".join(
            element(
                "li",
                f"<b>{found[name]}</b> "
                + element("span", name, class_=f"verdict {name}", data_mark=MARKS[name])
                + f'<br><span class="soft">{MEANINGS[name]}</span>',
            )
            for name in MARKS
            if name in found
        ),
        class_="totals",
    )


def filters(verdicts: pd.DataFrame) -> str:
    """Choices that report.js reads."""
    found = set(verdicts.verdict)
    return element(
        "div",
        choice("filter-artefact", "Where", {"": "all"} | {name: title_of(name) for name in verdicts.artefact.unique()})
        + choice("filter-verdict", "Verdict", {"": "all"} | {name: name for name in MARKS if name in found})
        + '<label>Text<input id="filter-text" type="search"></label><span class="soft" id="count"></span>',
        class_="filters",
    )


def explanation(row: dict[str, str]) -> str:
    """The rule of a verdict with its tolerance, and what is to be said of this one."""
    tolerance = f" ({row['tolerance']})" if row["tolerance"] not in ("", "none") else ""
    note = element("strong", html.escape(row["note"]) + ". ") if row["note"] else ""
    return element("td", note + html.escape(f"Rule: {row['rule']}{tolerance}."), class_="why")


def verdict_table(verdicts: pd.DataFrame, places: set[str]) -> str:
    """Every row, with what the filters need."""
    names = [
        name
        for name in ("artefact", "row", "column", "thesis", "measured", "low", "high", "reference", "unit")
        if name in verdicts
    ]
    titles = [*(HEADS.get(name, name) for name in names), "verdict", "why"]
    head = element("thead", element("tr", "".join(element("th", title, scope="col") for title in titles)))
    rows = "".join(verdict_row(row, names, places) for row in verdicts.to_dict("records"))
    return element("div", element("table", head + element("tbody", rows), id="verdicts"), class_="scroll")


def verdict_row(row: dict[str, str], names: list[str], places: set[str]) -> str:
    """Its values, its verdict (and the reference run's where that is another), and why."""
    where = html.escape(title_of(row["artefact"]))
    if row["artefact"] in places:
        where = element("a", where, href=f"#{row['artefact']}")
    cells = [element("td", where, data_title="where")]
    for name in names[1:]:
        rounded = name in ("measured", "low", "high", "reference")
        text = row_label(row[name]) if name == "row" else row[name]
        cells.append(cell(text, title=HEADS.get(name, name), name=name == "row", shorten=rounded))
    found = row["verdict"]
    other = row.get("verdict_reference", "")
    remark = element("span", f"reference: {other}", class_="kept") if other else ""
    inner = html.escape(found) + ("<br>" + remark if remark else "")
    mark = MARKS.get(found, "")
    cells.append(element("td", inner, class_=f"verdict {found}", data_mark=mark, data_title="verdict"))
    return element("tr", "".join(cells) + explanation(row), data_artefact=row["artefact"], data_verdict=found)
