# SPDX-License-Identifier: GPL-3.0-or-later
"""What the report begins with: totals of the verdicts, the main plot, and stability and what is left out in a sentence each; and
the numbers and statements of the thesis that came out otherwise.
"""

from __future__ import annotations

import html
import io
from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd

import common
from common import error_panel, motion_limits, scene_needs, stability, tally, work_precision
from common.jobs import Job
from report import data_table, picture, section
from report.artefacts import row_label, title_of
from report.judged import MARKS, MEANINGS
from report.markup import element, fold, words
from verdicts import verdict

SHOWN = "thousand"  # the panel of the main plot: all gaps of 1,000 poses
WORDS = {"holds": "hold", "misprint": "are misprints", "imprecise": "are imprecise", "wrong": "are wrong", "inconclusive": "are undecided"}
TITLES = {"artefact": "where", "row": "row or case", "measured": "this run", "note": "why", "claim": "the thesis says", "computed": "what came out"}


def totals(verdicts: pd.DataFrame, results: Path) -> str:
    """How often each verdict was given, each number of the thesis once."""
    rows = verdict.counted(verdicts)
    found = rows.verdict.value_counts()
    compared = sum(found.get(name, 0) for name in ("reproduced", "differs", "inconclusive", "thesis-misprint"))
    tiles = "".join(
        element("li", element("b", str(found[name])) + " " + element("span", name, class_=f"verdict {name}") + "<br>" + MEANINGS[name], data_mark=MARKS[name])
        for name in MARKS
        if name in found
    )
    said = statements(results).verdict.value_counts()
    counts = ", ".join(f"{count} {WORDS[name]}" for name, count in said.items())
    kinds = tally.said(rows[rows.verdict != "input"].to_dict("records"))
    return (
        element("h2", f"The thesis: {found.get('reproduced', 0)} of the {compared} numbers that can be compared are reproduced")
        + element("ul", tiles, class_="totals")
        + element(
            "p",
            f"Apart: {kinds}. Of {said.sum()} statements {counts}. "
            + element("a", "Numbers that differ, and why", href="#differing") + " · " + element("a", "statements", href="#findings") + " · "
            + element("a", "every verdict", href="#verdicts-all"),
            class_="soft",
        )
    )


def main_plot(results: Path) -> str:
    """One panel of the figure error-against-time, and what it shows in a sentence."""
    rows = work_precision.load(results)
    scene = work_precision.scenes(rows)["hip"]
    own = rows[rows.scene == scene]
    figure, axes = plt.subplots(figsize=(6.3, 4.2))
    figure.subplots_adjust(left=0.1, right=0.79, bottom=0.12, top=0.97)
    points = work_precision.fastest(own, SHOWN)
    points = points.assign(cost=points[SHOWN] / 1e3).rename(columns={"error_um": "error", "bound_um": "bound"})
    error_panel.draw(axes, points, error_panel.MICROMETRES, common.look(list(dict.fromkeys(work_precision.LINES.values()))))
    axes.set(ylabel="time of building and 1,000 poses, s")
    drawn = io.StringIO()
    figure.savefig(drawn, format="svg", metadata=dict.fromkeys(common.drawing.UNSAID["svg"]))
    plt.close(figure)
    said = f"{speed(own, scene)} Lower left is better; at the points the spacing of a table's entries; | is its proven bound."
    return (
        element("h2", "Error against time")
        + element("p", html.escape(said) + " " + element("a", "A single query, one pose, a million", href="#error-against-time") + ".")
        + element("figure", picture.drawn(drawn.getvalue(), said))
    )


def speed(own: pd.DataFrame, scene: str) -> str:
    """Time and error of the lines that matter, and from how many poses on a table pays."""

    def best(*lines: str) -> pd.Series:
        return own[own.line.isin(lines)].nsmallest(1, SHOWN).iloc[0]

    parts = []
    for name, row in {"exact cells": best("exact cells"), "Embree's rays": best("Embree"), "the thesis' tables": best(*work_precision.THESIS)}.items():
        parts.append(f"{name} {common.digits(row[SHOWN] / 1e3, 2)} s with an error of {common.digits(row.error_um, 2)} µm")
    first = own.nsmallest(1, "one").iloc[0]
    return (
        f"All gaps of 1,000 poses of a hip ({scene.replace('_', ' ')} triangles), one thread, building included: {'; '.join(parts)} at most."
        f" For one pose {first.line} is the fastest: {common.digits(first.one, 2)} ms."
    )


def stable(results: Path) -> str:
    """Who holds in stiff and extreme cases, in a sentence, with the figure."""
    cases = stability.load(results)
    found = stability.overview(cases).reset_index()
    mine = found.who.isin(stability.OURS)
    ours, others = found[mine], found[~mine]
    bounds = stability.bounds(cases[cases.kind == "ours"]).value_counts()
    failing = others[others.wrong > 0].groupby("who").family.nunique().sort_values(ascending=False)
    asked = others.groupby("who").family.nunique()
    named = ", ".join(f"{who} in {count} of {asked[who]}" for who, count in failing.head(4).items())
    said = (
        f"In {found.family.nunique()} families of cases, from harmless to extreme, {ours.wrong.sum() or 'none'} of our {ours.asked.sum():,} answers"
        f" {'is' if ours.wrong.sum() < 2 else 'are'} wrong, and {common.digits(100 * ours.silent.sum() / ours.asked.sum(), 2)} % are left open."
        f" Of our bounds {bounds.get('broken', 0)} broke; {bounds.get('held', 0):,} held, {bounds.get('infinite', 0) + bounds.get('unanswered', 0):,} say nothing."
        f" Of {len(asked)} other ways {len(failing)} fail somewhere: {named} families."
    )
    return (
        element("h2", "Stiff and extreme cases")
        + element("p", html.escape(said) + " " + element("a", "More", href="#stability-overview") + ".")
        + element("figure", picture.image(results / "figures" / "stability-overview.svg", said))
    )


def left_out(results: Path) -> str:
    """What a single question does not work out."""
    table = scene_needs.load(results)
    rows = table[table.joint == table.joint.iloc[0]]
    ours, everything = rows[rows.way == "needed"], rows[rows.question == "everything"].iloc[0]
    memory = ours.peak_bytes / everything.peak_bytes

    def span(share: pd.Series) -> str:
        return f"{common.digits(100 * share.min(), 2)} to {common.digits(100 * share.max(), 2)} %"

    said = (
        f"A question works out only what it looks at. Alone, on a joint of {int(everything.faces):,} faces, one takes {span(ours.of_all)} of the time"
        f" and {span(memory)} of the memory of all questions together, and looks at {common.digits(100 * ours.faces_looked_at.max() / everything.faces, 2)} %"
        " of the faces one by one at most; the answers are the same."
    )
    return element("h2", "Left out") + element("p", said + " " + element("a", "By question", href="#scene-needs") + ".")


def to_check() -> str:
    """How a reader checks any of it."""
    return element("h2", "Check a claim") + element(
        "p",
        "Each table and figure below names the command that measures it again, such as "
        + element("code", "experiments/reproduce --only table-9")
        + ": " + element("a", "all claims, with minutes and what to expect", href="#claims") + "."
        " Each number of the thesis has " + element("a", "its rule", href="#verdicts-all") + ", and each CSV "
        + element("a", "its program, commit and machine", href="#origins") + ".",
    )  # fmt: skip


def limits(results: Path) -> str:
    """What it does not do, and what an answer hangs on."""
    table = motion_limits.contacts(results)
    interval = (table.centre_high_deg - table.centre_low_deg)[table.state == "limited"]
    texts = [
        "Gaps run along rays from the centre of rotation. Where a surface is oblique they exceed the shortest distance, which is bounded"
        " apart; of a surface that a ray meets twice only one layer counts.",
        "Limits of motion hold for the centre of rotation that is given. Over all centres within 0.5 mm of it a limit here has a range of"
        f" {common.digits(interval.median(), 2)}° in the median, and of {common.digits_up(interval.max(), 2)}° at most.",
        "Errors and bounds are those of computing, not of the scan, its segmentation or the mesh. Cartilage is a thickness that does not"
        " deform; there are no ligaments, muscles or other soft tissue.",
        "The hips of this page are generated unless a real joint is named, and the thesis' two patients are stand-ins: their scans are not"
        " public. 24 of the 63 figures of the thesis are other people's pictures and are "
        + element("a", "not made", href="#thesis-figures") + ".",
        "Research software, not a medical device: nothing here may guide the treatment of a patient.",
    ]  # fmt: skip
    return element("h2", "What it does not do") + element("ul", "".join(element("li", text) for text in texts), class_="limits")


def differing(results: Path) -> str:
    """Numbers of the thesis that came out otherwise, each once, with how far they are off and why."""
    table = verdict.counted(common.as_text(results / "verdicts.csv"))
    table = table[table.verdict.isin(["differs", "thesis-misprint"])]
    table = table.assign(artefact=table.artefact.map(title_of), row=table.row.map(row_label), column=table.column.map(words))
    table = table[["artefact", "row", "column", "thesis", "measured", "verdict", "note"]].rename(columns=TITLES)
    return fold("Numbers that differ, and why", data_table.grid(table, None, cards=True), "differing", f"{len(table)} of the thesis")


def statements(results: Path) -> pd.DataFrame:
    """Those of the thesis that do not hold come first."""
    table = common.as_text(results / "tables" / "findings.csv")
    order = table.verdict.map({"wrong": 0, "misprint": 1, "imprecise": 2, "inconclusive": 3}).fillna(4)
    return table.assign(order=order).sort_values("order", kind="stable")[["number", "where", "claim", "computed", "verdict"]]


def said(results: Path, job: Job) -> str:
    """All statements; job: the table of them."""
    table = statements(results).rename(columns=TITLES)
    return fold("Statements of the thesis", data_table.grid(table, None, cards=True) + section.origin(job), job.name, f"{len(table)} that were computed")


def first(results: Path) -> str:
    """The first screen below the title."""
    verdicts = common.as_text(results / "verdicts.csv")
    parts = [main_plot(results), stable(results), left_out(results), to_check()]
    return totals(verdicts, results) + element("div", "".join(element("section", part) for part in parts), class_="first")
