# SPDX-License-Identifier: GPL-3.0-or-later
"""What the report begins with: what came out, as the main plot, the statements of the thesis, and the numbers that differ."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

import common
from common import work_precision
from report import data_table, picture
from report.artefacts import row_label, title_of
from report.markup import element
from verdicts import verdict

WORDS = {"holds": "hold", "misprint": "misprints"}
PLOTS = {
    "error-against-time": "All gaps of a pose of a hip: the largest error of both scans against time; lower left is better.",
    "contact-against-time": "Touch, smallest gap, first contact and filling: what is missed or wrong against time.",
}


def differing(results: Path) -> pd.DataFrame:
    """Numbers of the thesis that came out otherwise, each once."""
    table = verdict.counted(common.as_text(results / "verdicts.csv"))
    table = table[table.verdict.isin(["differs", "thesis-misprint"])]
    table = table.assign(artefact=table.artefact.map(title_of), row=table.row.map(row_label))
    return table[["artefact", "row", "column", "thesis", "measured", "note"]].rename(columns={"artefact": "where"})


def statements(results: Path) -> pd.DataFrame:
    """Those of the thesis that do not hold come first."""
    table = common.as_text(results / "tables" / "findings.csv")
    order = table.verdict.map({"wrong": 0, "misprint": 1, "imprecise": 2}).fillna(3)
    return table.assign(order=order).sort_values("order", kind="stable")[["number", "where", "claim", "computed", "verdict"]]


def section(results: Path) -> str:
    """Counts, the main plot, and two tables."""
    said, numbers = statements(results), differing(results)
    counts = ", ".join(f"{count} {WORDS.get(name, name)}" for name, count in said.verdict.value_counts().items())
    plots = [
        element("figure", picture.image(results / "figures" / f"{name}.svg", text) + element("figcaption", text))
        for name, text in PLOTS.items()
    ]
    return (
        element("h2", "What came out", id="outcome")
        + plots[0]
        + "".join(element("p", sentence) for sentence in work_precision.sentences(results).values())
        + plots[1]
        + element("h3", "Statements of the thesis")
        + element("p", f"Of {len(said)} that were computed: {counts}.")
        + data_table.grid(said, None)
        + element("h3", "Numbers that differ")
        + element("p", f"{len(numbers)}, each with how far it is off and why. All verdicts are below.")
        + data_table.grid(numbers, None)
    )
