# SPDX-License-Identifier: GPL-3.0-or-later
# @name      report
# @question  Everything on one page: verdicts, tables, figures, and where each number comes from.
# @outputs   report.html
# @seconds   8 8
# @depends   SHOWN GRAPH results/reference/{verdicts.csv,run.json,tables/*.csv,earlier/*/*}
# @depends   analysis/report/*.{css,js} analysis/node_modules/plotly.js-basic-dist-min/plotly-basic.min.js
# @options   --jobs GRAPH
"""The report: one HTML file that needs nothing else; what it only links lies beside it. From verdicts.csv, and every table, figure and sidecar
of the graph.

What is shown is what the graph declares (jobs.json): a new table or figure appears here by itself.
"""

from __future__ import annotations

import html
import os
from pathlib import Path

import common
from common import work_precision
from common.jobs import Job
from common.loading import LABELS_READ
from report import claims, explore, judged, origins, outcome, picture, reference, section, turn
from report.artefacts import TOPICS, by_topic, load_jobs, repeats
from report.markup import element, fold

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
PLOTLY = HERE.parent / "node_modules" / "plotly.js-basic-dist-min" / "plotly-basic.min.js"
REFERENCE = SOURCE / "results" / "reference"
TITLE = "impinge: gaps, contact and range of motion of ball-and-socket joints"
ABOUT = (
    "From the triangle meshes of both bones of a joint such as the hip, impinge works out the gap at each vertex (the joint space along a ray from the centre"
    " of rotation), whether and where bones touch, and how far the joint turns before they do (impingement). This page measures again what a thesis of about"
    " 2009 says, <cite>Rapid Impingement Detection Systems for Ball-and-Socket Joints</cite>, and goes beyond it. Research software, not a"
    " medical device."
)


def provenance(results: Path, jobs: list[Job], kept: Path) -> str:
    """Machine and profile of this run and of the reference run."""
    first = next(name for job in jobs for name in job.data)
    record = common.sidecar(results / "data" / f"{first}.csv")
    changes = " with changes" if record["dirty"] else ""
    where = (
        f"This run: {record['profile']} profile, commit {record['commit'][:12]}{changes}, "
        f"{record['cpu']}, {record['cores']} cores, {record['compiler']}."
    )
    if reference.described(kept):
        where += f" Reference run, kept with the source: {reference.described(kept)}."
    if reference.agreement(kept):
        where += f" {reference.agreement(kept)}."
    if record["profile"] != "full":
        where += " The quick profile measures less and marks what it extrapolated."
    return where


def heading(results: Path, jobs: list[Job]) -> str:
    """Title, what it is about, and the pages beside this one."""
    names = {job.name for job in jobs}
    links = {job.question.partition(":")[0].removeprefix("The ").capitalize(): job.outputs[0] for job in jobs if job.kind == "paper"}
    links |= {"Joint3D": "joint3d.html"} if "joint3d" in names else {}
    links |= {"README": os.path.relpath(SOURCE / "README.md", results), "Verdicts (CSV)": "verdicts.csv"}
    return (
        element("h1", TITLE)
        + element("nav", "".join(element("a", title, href=file) for title, file in links.items()))
        + element("p", ABOUT)
    )


def topics(results: Path, jobs: list[Job]) -> list[str]:
    """The tables and figures, folded by what they are about. Repeats are linked, so that the page stays small."""
    names = {job.name for job in jobs}
    said = {next(iter(TOPICS)): "".join(element("p", html.escape(words)) for words in work_precision.sentences(results).values())}
    return [
        fold(title, said.get(title, "") + "".join(section.section(results, job, REFERENCE, repeats(job, names)) for job in found), "", f"{len(found)} tables and figures")
        for title, found in by_topic(jobs).items()
    ]


def judged_part(results: Path, jobs: list[Job], kept: Path) -> str:
    """The verdicts, beside those of the reference run."""
    verdicts = common.as_text(results / "verdicts.csv")
    places = {job.name for job in jobs if job.kind in ("table", "figure")}
    return judged.section(reference.with_verdicts(verdicts, kept), places)


def page(results: Path, jobs: list[Job]) -> str:
    """The whole document; no joint turns where the graph has no Joint3D."""
    names = {job.name: job for job in jobs}
    scripts = [HERE / "report.js", HERE / "explore.js"]
    parts = [
        element("header", heading(results, jobs)),
        outcome.first(results),
        outcome.limits(results),
        element("p", html.escape(provenance(results, jobs, REFERENCE)), class_="soft"),
        element("p", "Below, each line opens. " + element("button", "Open all", type="button", id="open-all"), class_="soft"),
        outcome.differing(results),
        outcome.said(results, names["findings"]),
        judged_part(results, jobs, REFERENCE),
        claims.section(jobs, REFERENCE),
        fold("Error against time or memory, to explore", explore.section(results, PLOTLY), "explore", "every method and scene"),
    ]
    if "joint3d" in names:
        shown = picture.image(results / "figures" / "figure-44.png", "The joint, seen from three sides", 400)
        parts.append(fold("A joint to turn by hand", turn.section(shown), "turn", "by joint3d.html, beside this page"))
        scripts.append(HERE / "turn.js")
    parts += [*topics(results, jobs), origins.section(results, jobs)]
    style = (HERE / "report.css").read_text()
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1"><link rel="icon" href="data:,">'
        f"<title>{TITLE}</title><style>{style}</style></head>\n<body><main>"
        + "\n".join(parts)
        + "</main>"
        + "".join(f"<script>{script.read_text()}</script>" for script in scripts)
        + "</body></html>\n"
    )


def main(options) -> None:
    """Checks every CSV of the graph against its sidecar, which may name methods, then writes report.html."""
    jobs = load_jobs(Path(options.jobs))
    for job in jobs:
        for output in job.outputs:
            if output.startswith("data/") and output.endswith(".csv"):
                for method, text in common.sidecar(options.results / output).get("labels", {}).items():
                    LABELS_READ.setdefault(method, text)
    common.write(options.out / "report.html", page(options.results, jobs))


common.run(main, "--jobs")
