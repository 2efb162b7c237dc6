# SPDX-License-Identifier: GPL-3.0-or-later
# @name      report
# @question  Everything on one page: verdicts, tables, figures, and where each number comes from.
# @outputs   report.html
# @seconds   8 8
# @depends   ${shown} ${joint3d_page} ${plotly} ${committed} ${IMPINGE_GRAPH_DIR}/jobs.json
# @depends   analysis/report/{report.css,report.js,explore.js,turn.js}
# @options   --jobs ${IMPINGE_GRAPH_DIR}/jobs.json --plotly ${plotly} --reference ${reference}
"""The report: one HTML file that needs nothing else; what it only links lies beside it. From verdicts.csv, and every table, figure and sidecar
of the graph.

What is shown is what the graph declares (jobs.json): a new table or figure appears here by itself. While a run goes on
(experiments/run_graph.py calls this now and then), what is not made yet says so.
"""

from __future__ import annotations

import html
from pathlib import Path

import common
from common.jobs import Job
from report import claims, explore, judged, outcome, picture, reference, section, turn
from report.artefacts import load_jobs, place, title_of
from report.markup import element

SHOWN = ("data", "table", "figure", "verdicts", "page")  # kinds of jobs that the report waits for
HERE = Path(__file__).resolve().parent
ABOUT = (
    "How far apart are the two bones of a joint in a pose, and where do they touch? A thesis of about 2009, <cite>Rapid"
    " Impingement Detection Systems for Ball-and-Socket Joints</cite>, answers by looking up each vertex of one surface in a"
    " table of the other's distance from the centre of rotation, by direction: on a grid of angles (RSID) or along a helix"
    " (USID). Here all of its tables and figures are computed again, each number gets a verdict, and errors, times and limits"
    " are measured beyond it. Below each table and figure stand the command that makes it again and where its data come"
    " from; a click makes a figure larger. Research software, not a medical device."
)


def is_made(results: Path, job: Job) -> bool:
    """Whether all that it writes is there."""
    return all((results / output).is_file() for output in job.outputs)


def provenance(results: Path, jobs: list[Job], kept: Path) -> str:
    """Machine and profile of this run, as far as it has measured, and of the reference run."""
    where = ""
    tables = (results / "data" / f"{name}.csv" for job in jobs for name in job.data)
    if first := next((table for table in tables if table.is_file()), None):
        record = common.sidecar(first)
        changes = " with changes" if record["dirty"] else ""
        where = (
            f"This run: {record['profile']} profile, commit {record['commit'][:12]}{changes}, "
            f"{record['cpu']}, {record['cores']} cores, {record['compiler']}."
        )
    if reference.described(kept):
        where += f" Reference run, kept with the source: {reference.described(kept)}."
    if first and record["profile"] != "full":
        where += " The quick profile measures less and marks what it extrapolated."
    return where


def heading(results: Path, jobs: list[Job], kept: Path, missing: set[str]) -> str:
    """Title, what the page is, which machine and profile this is, and what is in it."""
    unfinished = ""
    if missing:
        shown = [job.name for job in jobs if job.kind in ("table", "figure")]
        made = f"{len(set(shown) - missing)} of {len(shown)} tables and figures are made"
        unfinished = element("p", f"<strong>Not finished: {made}.</strong> While a run goes on, this page follows it.")
    return (
        element("h1", "Impingement of ball-and-socket joints: the thesis, reproduced")
        + unfinished
        + element("p", ABOUT)
        + element("p", html.escape(provenance(results, jobs, kept)), class_="soft")
        + contents(jobs)
    )


def not_made(title: str, name: str, level: str = "h2") -> str:
    """What stands in the place of a part whose files are not there."""
    return element(level, title, id=name) + element("p", "Not made yet.", class_="soft")


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


def artefact(results: Path, job: Job, kept: Path, missing: set[str], names: set[str]) -> str:
    """The part of a table or figure. Repeats are linked, so that the page stays small."""
    if job.name in missing:
        return not_made(title_of(job.name), job.name, "h3")
    return section.section(results, job, kept, linked=repeats(job, names))


def judged_part(results: Path, jobs: list[Job], kept: Path) -> str:
    """The verdicts, beside those of the reference run."""
    verdicts = common.as_text(results / "verdicts.csv")
    places = {job.name for job in jobs if job.kind in ("table", "figure")}
    return judged.section(reference.with_verdicts(verdicts, kept), places)


def live_parts(results: Path, jobs: list[Job], kept: Path, missing: set[str]) -> tuple[list[str], list[str]]:
    """What a reader chooses and moves in, and the scripts for what of it is there; no joint turns where the graph has no
    Joint3D.
    """

    def joint() -> str:
        front = picture.image(results / "figures" / "figure-44.png", "The joint, seen from three sides")
        return turn.section(front)

    choices = [
        ("outcome", "What came out", ["findings", "verdicts", "error-against-time"], lambda: outcome.section(results), ""),
        ("verdicts-title", "Verdicts", ["verdicts"], lambda: judged_part(results, jobs, kept), "report.js"),
        ("explore", "Error against cost", ["10_error_against_time"], lambda: explore.section(results), "explore.js"),
        ("turn", "A joint to turn by hand", ["joint3d", "figure-44"], joint, "turn.js"),
    ]
    names = {job.name for job in jobs}
    parts, scripts = [], []
    for anchor, title, needed, make, script in choices:
        if not names.issuperset(needed):
            continue
        there = missing.isdisjoint(needed)
        parts.append(make() if there else not_made(title, anchor))
        scripts += [(HERE / script).read_text()] if there and script else []
    return parts, scripts


def page(results: Path, jobs: list[Job], library: str, kept: Path) -> str:
    """The whole document; `library` draws the plot that the reader moves about in, `kept` is the folder of the reference run."""
    missing = {job.name for job in jobs if job.kind in SHOWN and not is_made(results, job)}
    live, scripts = live_parts(results, jobs, kept, missing)
    parts = [heading(results, jobs, kept, missing), *live]
    names = {job.name for job in jobs}
    for kind, title in (("table", "Tables"), ("figure", "Figures")):
        parts += [
            element("h2", title),
            *(artefact(results, job, kept, missing, names) for job in jobs if job.kind == kind),
        ]
    parts.append(claims.section(jobs, kept))
    style = (HERE / "report.css").read_text()
    # run_graph.py knows an unfinished report by it.
    again = '<meta http-equiv="refresh" content="60">' if missing else ""
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8">{again}'
        '<meta name="viewport" content="width=device-width, initial-scale=1"><link rel="icon" href="data:,">'
        f"<title>impinge: results</title><style>{style}</style></head>\n<body><main>"
        + "\n".join(parts)
        + "</main>"
        + "".join(f"<script>{script}</script>" for script in [library, *scripts])
        + "</body></html>\n"
    )


def main(options) -> None:
    """Checks every CSV of the graph against its sidecar, then writes report.html."""
    jobs = load_jobs(Path(options.jobs))
    for job in jobs:
        for output in job.outputs:
            if output.startswith("data/") and output.endswith(".csv") and (options.results / output).is_file():
                common.sidecar(options.results / output)
    common.write(
        options.out / "report.html",
        page(options.results, jobs, Path(options.plotly).read_text(), Path(options.reference)),
    )


common.run(main, "--jobs", "--plotly", "--reference")
