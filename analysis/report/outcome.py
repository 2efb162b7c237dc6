# SPDX-License-Identifier: GPL-3.0-or-later
"""What the report begins with: totals of the verdicts, the main plot, and stability and what is left out in a sentence each; and
the numbers and statements of the thesis that came out otherwise.
"""

from __future__ import annotations

import html
from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd

import common
from common import error_panel, limit_time, motion_limits, scene_needs, stability, tally, work_precision
from common.jobs import Job
from findings import finding
from report import data_table, picture, section
from report.artefacts import row_label, title_of
from report.judged import MARKS, MEANINGS
from report.markup import element, fold, words
from verdicts import verdict

SHOWN = "thousand"  # the panel of the main plot: all gaps of 1,000 poses
COMPARED = ("reproduced", "differs", "inconclusive", "thesis-misprint")
KINDS = {"computed": "{} from formulas {} are reproduced", "measured": "{} measured {}"}
WORDS = {"holds": "{} hold", "imprecise": "{} are imprecise", "misprint": "{} misprints", "wrong": "{} wrong", "inconclusive": "{} undecided"}
TITLES = {"artefact": "where", "measured": "this run", "note": "why", "claim": "the statement", "computed": "what came out"}


def totals(verdicts: pd.DataFrame, results: Path) -> str:
    """How often each verdict was given, each number of the thesis once."""
    rows = verdict.counted(verdicts)
    found = rows.verdict.value_counts()
    record = common.sidecar(min((results / "data").glob("*.csv")))
    run = f"{record['profile']} run, {record['cores']} cores"
    tiles = "".join(
        element("li", f"<b>{found[name]}</b> {element('span', name, class_=f'verdict {name}')}<br>{MEANINGS[name]}")
        for name in MARKS
        if name in found
    )
    kinds = [
        "of " + KINDS[kind].format(sum(own[name] for name in COMPARED), own["reproduced"])
        for kind, own in tally.counts(rows.to_dict("records")).items()
        if kind in KINDS
    ]
    said = statements(results)
    own = said[~said.other].verdict.value_counts()
    counts = ", ".join(text.format(own[name]) for name, text in WORDS.items() if name in own)
    links = {"What differs": "differing", "statements": "findings", "all verdicts": "verdicts-all"}
    compared = sum(found.get(name, 0) for name in COMPARED)
    return (
        element("h2", f"Reproduced: {found.get('reproduced', 0)} of the {compared} numbers of the thesis that can be compared ({run})")
        + element("ul", tiles, class_="totals")
        + element(
            "p",
            f"{'; '.join(kinds).capitalize()}. Of {own.sum()} statements of the thesis {counts}; {said.other.sum()} of others are listed apart. "
            + " · ".join(element("a", title, href=f"#{name}") for title, name in links.items()),
            class_="soft",
        )
    )


def main_plot(results: Path) -> str:
    """One panel of the figure error-against-time, and what it shows in a sentence."""
    rows = work_precision.load(results)
    scene = work_precision.scenes(rows)["hip"]
    own = rows[rows.scene == scene]
    points = work_precision.fastest(own, SHOWN)
    points = points.assign(cost=points[SHOWN] / 1e3, step=points.step.where(points.step.str.endswith("°"), "")).rename(columns={"error_um": "error", "bound_um": "bound"})
    looks = common.look(list(dict.fromkeys(work_precision.LINES.values())))
    figure, axes = plt.subplots(figsize=(6.3, 2.35))
    figure.subplots_adjust(left=0.09, right=0.8, bottom=0.19, top=0.97)
    error_panel.draw(axes, points, error_panel.MICROMETRES, looks)
    error_panel.write_steps(axes, points, error_panel.MICROMETRES, looks)
    error_panel.name_lines(axes, points.assign(name=points.line), error_panel.MICROMETRES, looks, apart=True)
    axes.set(ylabel="time of 1,000 poses, s")
    said = speed(own, scene)
    return (
        element("h2", "Error against time")
        + element("p", html.escape(said) + " Lower left is better; ° is the spacing of a table, | a proven bound. " + element("a", "One pose, a million", href="#error-against-time") + ".")
        + element("figure", picture.drawn(figure, said))
    )


def speed(own: pd.DataFrame, scene: str) -> str:
    """Time and error of the lines that matter."""

    def best(*lines: str) -> pd.Series:
        return own[own.line.isin(lines)].nsmallest(1, SHOWN).iloc[0]

    chosen = {
        "our exact cells": best("exact cells"),
        "Embree's rays": best("Embree"),
        "the thesis' tables (radii on a grid of angles, RSID, or along a helix, USID)": best(*work_precision.THESIS),
    }
    parts = [f"{name} {common.digits(row[SHOWN] / 1e3, 2)} s, error {common.digits(row.error_um, 2)} µm" for name, row in chosen.items()]
    first = own.nsmallest(1, "one").iloc[0]
    return (
        f"All gaps of 1,000 poses of {work_precision.scene_title(scene)}, building included: {'; '.join(parts).replace('error', 'largest error', 1)}."
        f" For a single pose {first.line} is the fastest, {common.digits(first.one, 2)} ms."
    )


def turning(results: Path) -> str:
    """Time and error of limits of motion, in a sentence."""
    table = limit_time.load(results)
    ours = table[table.method == limit_time.OURS[0]].nlargest(1, "faces").iloc[0]
    steps = table[~table.method.isin(limit_time.OURS)]
    beside = steps[steps.joint == ours.joint].nlargest(1, "step_deg").iloc[0]
    worst = steps.loc[(steps.missed / steps.asked).idxmax()]
    missing = (
        f"{html.escape(beside.line.split(',')[0])} in steps of {beside.step_deg:g}° takes {common.digits(beside.times_ours, 2)} times as long and misses"
        f" {int(beside.missed) or 'none'}"
    )
    if worst.joint != ours.joint and worst.missed:
        missing += f", but {int(worst.missed)} of {int(worst.asked)} of a {html.escape(worst.joint)}"
    phantoms = common.load(results, "phantoms")
    error = phantoms.error[phantoms.quantity.str.startswith("limit")].abs().max()
    return element("h2", "Range of motion") + element(
        "p",
        f"{ours.motions} limits of motion of {html.escape(ours.joint)} ({int(ours.faces):,} faces) take"
        f" {common.digits(ours.total_ms, 2)} ms, from meshes, and miss {int(ours.missed) or 'no'} contact{'s' if ours.missed > 1 else ''}; {missing}."
        f" Closed forms are met within {common.digits_up(error, 2)}°. " + element("a", "By method", href="#limit-time") + ".",
    )


def stable(results: Path) -> str:
    """Who holds in stiff and extreme cases, in a sentence, with the figure."""
    cases = stability.load(results)
    found = stability.overview(cases).reset_index()
    mine = found.who.isin(stability.OURS)
    ours, others = found[mine], found[~mine]
    silent = ours.groupby("who")[["silent", "asked"]].sum().loc[stability.OURS]
    withheld = ", ".join(f"{who} {common.digits(100 * row.silent / row.asked, 2)} %" for who, row in silent.iterrows())
    bounds = stability.bounds(cases[cases.kind == "ours"]).value_counts()
    asked, failing = (rows.groupby("who").family.nunique() for rows in (others, others[others.wrong > 0]))
    unnamed = {*stability.STEPS.values(), stability.OTHERS["radius_as_eq_11"]}  # not methods of anybody
    named = ", ".join(f"{who.replace(', ', ' ')} in {count} of {asked[who]}" for who, count in failing.sort_values(ascending=False).items() if who not in unnamed)
    never = [who for who in asked.index if who not in failing.index and who not in unnamed]
    said = (
        f"{found.family.nunique()} families of cases, from harmless to extreme. Of {ours.asked.sum():,} answers of ours {ours.wrong.sum()} are wrong; withheld are"
        f" of {withheld}. Of {bounds.sum():,} bounds {bounds.get('broken', 0)} broke and"
        f" {bounds.get('held', 0):,} held, and the others say nothing. Families in which others fail: {named}"
        + (f"; in none {', '.join(never)}." if never else ".")
    )
    return (
        element("h2", "Stiff and extreme cases")
        + element("p", html.escape(said) + " " + element("a", "The worst case of each", href="#stability-summary") + ".")
        + element("figure", picture.image(results / "figures" / "stability-overview.svg", said), id="stability")
    )


def left_out(results: Path) -> str:
    """What a single question does not work out."""
    table = scene_needs.load(results)
    rows = table[table.joint == table.joint.iloc[0]]
    ours, everything = rows[rows.way == "needed"], rows[rows.question == "everything"].iloc[0]

    def span(share: pd.Series) -> str:
        return f"{common.digits(100 * share.min(), 2)} to {common.digits(100 * share.max(), 2)} %"

    same = "the same answers" if ours.differs.max() == 0 else f"answers within {ours.differs.max():.2g} of those"
    looked = common.digits(100 * ours.faces_looked_at.max() / everything.faces, 2)
    sooner = ", ".join(rows[rows.times_needed < 1].label.str.split(",").str[0].unique())
    return element("h2", "What is left out") + element(
        "p",
        f"Only what a question needs is worked out: asked alone it takes {span(ours.of_all)} of the time and"
        f" {span(ours.peak_bytes / everything.peak_bytes)} of the memory of all together, has {same}, and looks at {looked} % of"
        f" {int(everything.faces):,} faces one by one at most. "
        + (f"Sooner on a single pose: {sooner}. " if sooner else "")
        + element("a", "By question", href="#scene-needs") + ".",
    )  # fmt: skip


def to_check() -> str:
    """How a reader checks any of it."""
    command = element("code", "experiments/reproduce --only table-9")
    claims, origins = element("a", "All claims", href="#claims"), element("a", "where the data come from", href="#origins")
    return element("h2", "Check a claim") + element(
        "p", f"Each table and figure names its command, such as {command}. {claims}; {origins}."
    )


def limits(results: Path) -> str:
    """What it does not do, and what an answer hangs on."""
    texts = [
        "Gaps run along rays from the centre of rotation. Where a surface is oblique they exceed the shortest distance, which is bounded"
        " apart; of a surface that a ray meets twice only one layer counts.",
        "Limits of motion hold for the centre of rotation that is given. The range of a limit over all centres within 0.5 mm of it is"
        f" {motion_limits.over_centres(results)}.",
        "Errors and bounds are those of computing, not of the scan, its segmentation or the mesh. Cartilage is a thickness that does not"
        " deform; there are no ligaments, muscles or other soft tissue.",
        "The hips of this page are generated unless a real joint is named, and the thesis' two patients are stand-ins: their scans are not"
        " public. 24 of the 63 figures of the thesis are other people's pictures and are "
        + element("a", "not made", href="#thesis-figures") + ".",
        "Nothing here may guide the treatment of a patient.",
    ]  # fmt: skip
    return element("h2", "What it does not do") + element("ul", "".join(element("li", text) for text in texts), class_="limits")


def differing(results: Path) -> str:
    """Numbers of the thesis that came out otherwise, each once, with how far they are off and why."""
    table = verdict.counted(common.as_text(results / "verdicts.csv"))
    table = table[table.verdict.isin(["differs", "thesis-misprint"])]
    table = table.assign(artefact=table.artefact.map(title_of) + ", " + table.row.map(row_label), column=table.column.map(words))
    table = table[["artefact", "column", "thesis", "measured", "verdict", "note"]].rename(columns=TITLES)
    return fold("Numbers that differ, and why", data_table.grid(table, None, cards=True), "differing", f"{len(table)} of the thesis")


def statements(results: Path) -> pd.DataFrame:
    """Those of the thesis that do not hold come first, and those of others last."""
    table = common.as_text(results / "tables" / "findings.csv")
    order = table.verdict.map({"wrong": 0, "misprint": 1, "imprecise": 2, "inconclusive": 3}).fillna(4)
    return table.assign(order=order, other=table.said_by != finding.THESIS).sort_values(["other", "order"], kind="stable")


def said(results: Path, job: Job) -> str:
    """All statements; job: the table of them."""
    table = statements(results)
    count = f"{(~table.other).sum()} that were looked into, and {table.other.sum()} of others"
    table = table[["number", "where", "claim", "computed", "verdict"]].rename(columns=TITLES)
    return fold("Statements of the thesis", data_table.grid(table, None, cards=True) + section.origin(job), job.name, count)


def first(results: Path) -> str:
    """The first screen below the title, in two columns."""
    left = main_plot(results) + turning(results) + left_out(results) + to_check()
    columns = element("section", left) + element("section", stable(results))
    return totals(common.as_text(results / "verdicts.csv"), results) + element("div", columns, class_="first")
