# SPDX-License-Identifier: GPL-3.0-or-later
# @name      report
# @question  Everything on one page: verdicts, tables, figures, and where each number comes from.
# @outputs   report.html
# @seconds   10 10
# @depends   ${shown} joint3d.html ${plotly} ${committed} ${IMPINGE_GRAPH_DIR}/jobs.json
# @depends   analysis/report/{report.css,report.js,explore.js,turn.js}
# @options   --jobs ${IMPINGE_GRAPH_DIR}/jobs.json --plotly ${plotly} --reference ${reference}
"""The report: one HTML file that needs nothing else. From verdicts.csv, and every table, figure and sidecar
of the graph.

What is shown is what the graph declares (jobs.json): a new table or figure appears here by itself.
"""

from __future__ import annotations

import html
from pathlib import Path

import pandas as pd

import common
from common.jobs import Job
from report import explore, judged, picture, reference, section, turn
from report.artefacts import load_jobs, place, title_of
from report.markup import element

HERE = Path(__file__).resolve().parent
ABOUT = (
    "How far apart are the two bones of a joint in a pose, and where do they touch? A thesis of about 2009, <cite>Rapid"
    " Impingement Detection Systems for Ball-and-Socket Joints</cite>, answers by looking up each vertex of one surface in a"
    " table of the other's distance from the centre of rotation, by direction: on a grid of angles (RSID) or along a helix"
    " (USID). Here all of its tables and figures are computed again, each number gets a verdict, and errors, times and limits"
    " are measured beyond it. Below each table and figure stand the command that makes it again and where its data come"
    " from; a click makes a figure larger. Research software, no medical device."
)


def heading(results: Path, jobs: list[Job], kept: Path) -> str:
    """Title, what the page is, and which machine and profile this is."""
    names = [name for job in jobs for name in job.data]
    record = common.sidecar(results / "data" / f"{names[0]}.csv")
    changes = " with changes" if record["dirty"] else ""
    where = (
        f"This run: {record['profile']} profile, commit {record['commit'][:12]}{changes}, "
        f"{record['cpu']}, {record['cores']} cores, {record['compiler']}."
    )
    if reference.described(kept):
        where += f" Reference run, kept with the source: {reference.described(kept)}."
    if record["profile"] != "full":
        where += " The quick profile measures less and marks what it extrapolated."
    return (
        element("h1", "Impingement of ball-and-socket joints: the thesis, reproduced")
        + element("p", ABOUT)
        + element("p", html.escape(where), class_="soft")
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
        base, _, joint = job.name.rpartition("-")
        if f"scene-{joint}" in names and (base in names or base == "joint"):
            title = "Real joints" if base in names else "Beyond the thesis"
        elif place(job) == (1,):
            title = "Beyond the thesis"
        else:
            title = "The thesis' figures" if job.name.startswith("figure") else "The thesis' tables"
        groups[title].append(element("a", title_of(job.name), href=f"#{job.name}"))
    return element(
        "nav",
        element("a", "Verdicts", href="#verdicts-title")
        + element("a", "Error against cost", href="#explore")
        + element("a", "A joint to turn", href="#turn")
        + "".join(
            element("details", element("summary", f"{title} ({len(links)})") + " ".join(links))
            for title, links in groups.items()
            if links
        ),
    )


def page(results: Path, jobs: list[Job], library: str, kept: Path) -> str:
    """The whole document; `library` draws the plot that the reader moves about in, `kept` is the folder of the reference run."""
    verdicts = pd.read_csv(results / "verdicts.csv", dtype=str, keep_default_na=False)
    verdicts = reference.with_verdicts(verdicts, kept)
    parts = [
        heading(results, jobs, kept),
        judged.section(verdicts, {job.name for job in jobs if job.kind in ("table", "figure")}),
        explore.section(results),
        turn.section(
            results, picture.image(results / "figures" / "figure-44.png", "The joint, seen from three sides")
        ),
    ]
    for kind, title in (("table", "Tables"), ("figure", "Figures")):
        parts += [
            element("h2", title),
            *(section.section(results, job, kept) for job in jobs if job.kind == kind),
        ]
    style = (HERE / "report.css").read_text()
    scripts = [
        library,
        *((HERE / name).read_text() for name in ("report.js", "explore.js", "turn.js")),
    ]
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1"><link rel="icon" href="data:,">'
        f"<title>impinge: results</title><style>{style}</style></head>\n<body><main>"
        + "\n".join(parts)
        + "</main>"
        + "".join(f"<script>{script}</script>" for script in scripts)
        + "</body></html>\n"
    )


def main(options) -> None:
    """Checks every CSV of the graph against its sidecar, then writes report.html."""
    jobs = load_jobs(Path(options.jobs))
    for job in jobs:
        for output in job.outputs:
            if output.startswith("data/") and output.endswith(".csv"):
                common.sidecar(options.results / output)
    common.write(
        options.out / "report.html",
        page(options.results, jobs, Path(options.plotly).read_text(), Path(options.reference)),
    )


common.run(main, "--jobs", "--plotly", "--reference")
