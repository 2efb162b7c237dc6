# SPDX-License-Identifier: GPL-3.0-or-later
# @name      report
# @question  Everything on one page: verdicts, tables, figures, and where each number comes from.
# @outputs   report.html
# @seconds   8 8
# @depends   SHOWN GRAPH results/reference/{verdicts.csv,run.json,tables/*.csv}
# @depends   analysis/report/*.{css,js} analysis/node_modules/plotly.js-basic-dist-min/plotly-basic.min.js
# @options   --jobs GRAPH
"""The report: one HTML file that needs nothing else; what it only links lies beside it. From verdicts.csv, and every table, figure and sidecar
of the graph.

What is shown is what the graph declares (jobs.json): a new table or figure appears here by itself.
"""

from __future__ import annotations

import html
from pathlib import Path

import common
from common.jobs import Job
from report import claims, explore, judged, outcome, picture, reference, section, turn
from report.artefacts import load_jobs, place, title_of
from report.markup import element

HERE = Path(__file__).resolve().parent
PLOTLY = HERE.parent / "node_modules" / "plotly.js-basic-dist-min" / "plotly-basic.min.js"
REFERENCE = HERE.parent.parent / "results" / "reference"
ABOUT = (
    "How far apart are the two bones of a joint in a pose, and where do they touch? A thesis of about 2009, <cite>Rapid"
    " Impingement Detection Systems for Ball-and-Socket Joints</cite>, answers by looking up each vertex of one surface in a"
    " table of the other's distance from the centre of rotation, by direction: on a grid of angles (RSID) or along a helix"
    " (USID). Here all of its tables and figures are computed again, each number gets a verdict, and errors, times and limits"
    " are measured beyond it. Below each table and figure stand the command that makes it again and where its data come"
    " from; a click makes a figure larger. Research software, not a medical device."
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
    if record["profile"] != "full":
        where += " The quick profile measures less and marks what it extrapolated."
    return where


def heading(results: Path, jobs: list[Job], kept: Path) -> str:
    """Title, what the page is, which machine and profile this is, and what is in it."""
    return (
        element("h1", "Impingement of ball-and-socket joints: the thesis, reproduced")
        + element("p", ABOUT)
        + element("p", html.escape(provenance(results, jobs, kept)), class_="soft")
        + contents(jobs)
    )


def contents(jobs: list[Job]) -> str:
    """Links to every table and figure, folded by where they belong."""
    names = {job.name for job in jobs}
    groups: dict[str, list[str]] = {
        title: []
        for title in ("The thesis' tables", "The thesis' figures", "Beyond the thesis", "Real joints")
    }
    for job in jobs:
        if job.kind not in ("table", "figure"):
            continue
        if repeats(job, names):
            title = "Real joints"
        elif place(job) == (1,):
            title = "Beyond the thesis"
        else:
            title = "The thesis' figures" if job.name.startswith("figure") else "The thesis' tables"
        groups[title].append(element("a", title_of(job.name), href=f"#{job.name}"))
    return element(
        "nav",
        element("a", "What came out", href="#outcome")
        + element("a", "Verdicts", href="#verdicts-title")
        + element("a", "Error against cost", href="#explore")
        + (element("a", "A joint to turn", href="#turn") if "joint3d" in names else "")
        + "".join(
            element("details", element("summary", f"{title} ({len(links)})") + " ".join(links))
            for title, links in groups.items()
            if links
        ),
    )


def repeats(job: Job, names: set[str]) -> bool:
    """Whether it shows one more real joint in a figure or table that the page has anyway."""
    base, _, joint = job.name.rpartition("-")
    return f"scene-{joint}" in names and base in names


def artefact(results: Path, job: Job, kept: Path, names: set[str]) -> str:
    """The part of a table or figure. Repeats are linked, so that the page stays small."""
    return section.section(results, job, kept, linked=repeats(job, names))


def judged_part(results: Path, jobs: list[Job], kept: Path) -> str:
    """The verdicts, beside those of the reference run."""
    verdicts = common.as_text(results / "verdicts.csv")
    places = {job.name for job in jobs if job.kind in ("table", "figure")}
    return judged.section(reference.with_verdicts(verdicts, kept), places)


def page(results: Path, jobs: list[Job]) -> str:
    """The whole document; no joint turns where the graph has no Joint3D."""
    names = {job.name for job in jobs}
    parts = [
        heading(results, jobs, REFERENCE),
        outcome.section(results),
        judged_part(results, jobs, REFERENCE),
        explore.section(results),
    ]
    scripts = [PLOTLY, HERE / "report.js", HERE / "explore.js"]
    if "joint3d" in names:
        parts.append(turn.section(picture.image(results / "figures" / "figure-44.png", "The joint, seen from three sides")))
        scripts.append(HERE / "turn.js")
    for kind, title in (("table", "Tables"), ("figure", "Figures")):
        shown = [artefact(results, job, REFERENCE, names) for job in jobs if job.kind == kind]
        parts += [element("h2", title), *shown]
    parts.append(claims.section(jobs, REFERENCE))
    style = (HERE / "report.css").read_text()
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1"><link rel="icon" href="data:,">'
        f"<title>impinge: results</title><style>{style}</style></head>\n<body><main>"
        + "\n".join(parts)
        + "</main>"
        + "".join(f"<script>{script.read_text()}</script>" for script in scripts)
        + "</body></html>\n"
    )


def main(options) -> None:
    """Checks every CSV of the graph against its sidecar, then writes report.html."""
    jobs = load_jobs(Path(options.jobs))
    for job in jobs:
        for output in job.outputs:
            if output.startswith("data/") and output.endswith(".csv"):
                common.sidecar(options.results / output)
    common.write(options.out / "report.html", page(options.results, jobs))


common.run(main, "--jobs")
