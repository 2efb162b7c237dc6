# SPDX-License-Identifier: GPL-3.0-or-later
"""The report: one HTML file that needs nothing else. From verdicts.csv, and every table, figure and sidecar
of the graph.

What is shown is what the graph declares (jobs.tsv): a new table or figure appears here by itself.
"""

from __future__ import annotations

import html
import json
import re
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

import common
import data_table
import explore
import picture
import reference
import turn
from markup import cell, element

MARKS = {"reproduced": "✓", "differs": "≠", "thesis-misprint": "!", "not-comparable": "–", "input": "·"}
MEANINGS = {
    "reproduced": "came out again",
    "differs": "came out otherwise",
    "thesis-misprint": "wrong in the thesis",
    "not-comparable": "of another machine or patient",
    "input": "given, not computed",
}
ABOUT = (
    "How far apart are the two bones of a joint in a pose, and where do they touch? A thesis of about 2009, <cite>Rapid"
    " Impingement Detection Systems for Ball-and-Socket Joints</cite>, answers by looking up each vertex of one surface in a"
    " table of the other's distance from the centre of rotation, by direction: on a grid of angles (RSID) or along a helix"
    " (USID). Here all of its tables and figures are computed again, each number gets a verdict, and errors, times and limits"
    " are measured beyond it. Below each table and figure stand the command that makes it again and where its data come"
    " from; a click makes a figure larger. Research software, no medical device."
)
PROVENANCE = {
    "question": "Question",
    "command": "Command",
    "profile": "Profile",
    "seed": "Seed",
    "commit": "Commit",
    "dirty": "Uncommitted changes",
    "driver_sha256": "SHA-256 of the program",
    "csv_sha256": "SHA-256 of the CSV",
    "compiler": "Compiler",
    "flags": "Flags",
    "cpu": "CPU",
    "cores": "Cores",
    "memory_mib": "Memory, MiB",
    "governor": "Frequency governor",
    "load": "Load before",
    "system": "System",
    "started_utc": "Started",
    "duration_s": "Took, s",
    "libraries": "Libraries",
    "parameters": "Parameters",
}


@dataclass(frozen=True)
class Job:
    """What the graph says of one table or figure."""

    name: str
    kind: str
    outputs: list[str]
    data: list[str]  # names of the CSVs that it is made from
    script: str
    question: str


def load_jobs(path: Path) -> list[Job]:
    """Tables and figures: those of the thesis by their numbers, then the others in the order of the graph."""
    jobs = []
    for line in path.read_text().splitlines():
        name, kind, _, _, _, _, outputs, depends, command, question = line.split("\t")
        data = [
            Path(file).stem
            for file in depends.split(";")
            if file.startswith("data/") and file.endswith(".csv")
        ]
        script = next((word for word in command.split() if word.endswith(".py")), "")
        jobs.append(Job(name, kind, outputs.split(";"), data, script, question))
    return sorted(jobs, key=place)


def place(job: Job) -> tuple:
    """The thesis' tables, then its figures, by number; then all others."""
    thesis = re.fullmatch(r"(table|figure)-(\d+).*", job.name)
    return (0, thesis[1] == "figure", int(thesis[2])) if thesis else (1,)


def totals(verdicts: pd.DataFrame) -> str:
    """How often each verdict was given."""
    counts = verdicts.verdict.value_counts()
    return element(
        "ul",
        "".join(
            element(
                "li",
                f"<b>{counts[name]}</b> "
                + element("span", name, class_=f"verdict {name}", data_mark=MARKS[name])
                + f'<br><span class="soft">{MEANINGS[name]}</span>',
            )
            for name in MARKS
            if name in counts
        ),
        class_="totals",
    )


def filters(verdicts: pd.DataFrame) -> str:
    """Choices that report.js reads."""

    def choice(name: str, title: str, values: dict[str, str]) -> str:
        options = "".join(
            element("option", text, value=value) for value, text in {"": "all", **values}.items()
        )
        return element("label", title + element("select", options, id=f"filter-{name}"))

    found = set(verdicts.verdict)
    return element(
        "div",
        choice("artefact", "Where", {name: title_of(name) for name in verdicts.artefact.unique()})
        + choice("verdict", "Verdict", {name: name for name in MARKS if name in found})
        + '<label>Text<input id="filter-text" type="search"></label><span class="soft" id="count"></span>',
        class_="filters",
    )


def explanation(row: dict[str, str]) -> str:
    """The rule of a verdict with its tolerance, and what is to be said of this one."""
    tolerance = f" ({row['tolerance']})" if row["tolerance"] not in ("", "none") else ""
    note = element("strong", html.escape(row["note"]) + ". ") if row["note"] else ""
    return element("td", note + html.escape(f"Rule: {row['rule']}{tolerance}."), class_="why")


HEADS = {"measured": "this run", "reference": "reference run", "row": "row or case", "artefact": "where"}


def verdict_table(verdicts: pd.DataFrame, places: set[str]) -> str:
    """Every row, with what the filters need; places: what the page has a section of."""
    names = [
        name
        for name in ("artefact", "row", "column", "thesis", "measured", "reference", "unit")
        if name in verdicts
    ]
    titles = [*(HEADS.get(name, name) for name in names), "verdict", "why"]
    head = element("thead", element("tr", "".join(element("th", title) for title in titles)))
    rows = "".join(verdict_row(row, names, places) for row in verdicts.to_dict("records"))
    return element("div", element("table", head + element("tbody", rows), id="verdicts"), class_="scroll")


def verdict_row(row: dict[str, str], names: list[str], places: set[str]) -> str:
    """Its values, its verdict (and the reference run's where that is another), and why."""
    where = html.escape(title_of(row["artefact"]))
    if row["artefact"] in places:
        where = element("a", where, href=f"#{row['artefact']}")
    cells = [element("td", where, data_title="where")]
    for name in names[1:]:
        rounded = name in ("measured", "reference")
        cells.append(cell(row[name], title=HEADS.get(name, name), name=name == "row", shorten=rounded))
    found = row["verdict"]
    other = row.get("verdict_reference", "")
    remark = element("span", f"reference: {other}", class_="kept") if other else ""
    inner = html.escape(found) + ("<br>" + remark if remark else "")
    mark = MARKS.get(found, "")
    cells.append(element("td", inner, class_=f"verdict {found}", data_mark=mark, data_title="verdict"))
    return element("tr", "".join(cells) + explanation(row), data_artefact=row["artefact"], data_verdict=found)


def provenance(results: Path, name: str) -> str:
    """Where a CSV comes from, folded."""
    record = common.sidecar(results / "data" / f"{name}.csv")
    lines = []
    for key, title in PROVENANCE.items():
        if key in record:
            value = record[key]
            text = (
                json.dumps(value, ensure_ascii=False) if isinstance(value, (dict, list, bool)) else str(value)
            )
            lines.append(element("dt", title) + element("dd", html.escape(text)))
    for key, title in (
        ("inconclusive", "Inconclusive timings"),
        ("control", "Control (one case against itself)"),
    ):
        if key in (record.get("timing") or {}):
            value = record["timing"][key]
            value = (
                {k: v for k, v in value.items() if k != "samples_ms"} if isinstance(value, dict) else value
            )
            lines.append(
                element("dt", title) + element("dd", html.escape(json.dumps(value) if value else "none"))
            )
    return element(
        "details", element("summary", f"Where data/{name}.csv comes from") + element("dl", "".join(lines))
    )


def title_of(name: str) -> str:
    """What a reader calls a table or figure: "Table 9: queries", "Figure 36: cargen left", "Error against time"."""
    words = re.sub(r"^(table|figure)-(\d+)-", r"\1 \2: ", name).replace("-", " ").replace("_", " ")
    return words[0].upper() + words[1:]


def section(results: Path, job: Job, kept: Path) -> str:
    """A table or figure with its caption, source and way to make it again; kept: the folder of the reference run."""
    shown = job.outputs[0]
    if job.kind == "table":
        body = element("p", html.escape(job.question)) + data_table.section(results / shown, kept)
    else:
        body = element(
            "figure",
            picture.image(results / shown, job.question) + element("figcaption", html.escape(job.question)),
        )
    again = f"experiments/reproduce --only {job.name}"
    source = f"{shown} · {job.script} · " + element("code", again)
    return (
        element("h3", title_of(job.name), id=job.name)
        + body
        + element("p", source, class_="source")
        + "".join(provenance(results, name) for name in job.data)
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
        element("h2", "Verdicts", id="verdicts-title"),
        totals(verdicts),
        filters(verdicts),
        verdict_table(verdicts, {job.name for job in jobs if job.kind in ("table", "figure")}),
        explore.section(results),
        turn.section(
            results, picture.image(results / "figures" / "figure-44.png", "The joint, seen from three sides")
        ),
    ]
    for kind, title in (("table", "Tables"), ("figure", "Figures")):
        parts += [element("h2", title), *(section(results, job, kept) for job in jobs if job.kind == kind)]
    style = (common.HERE / "report.css").read_text()
    scripts = [
        library,
        *((common.HERE / name).read_text() for name in ("report.js", "explore.js", "turn.js")),
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


def main() -> None:
    """Checks every CSV of the graph against its sidecar, then writes report.html."""
    options = common.arguments(__doc__, "--jobs", "--plotly", "--reference")
    jobs = load_jobs(Path(options.jobs))
    for job in jobs:
        for output in job.outputs:
            if output.startswith("data/") and output.endswith(".csv"):
                common.sidecar(options.results / output)
    common.write(
        options.out / "report.html",
        page(options.results, jobs, Path(options.plotly).read_text(), Path(options.reference)),
    )


common.run(main)
