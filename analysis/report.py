# SPDX-License-Identifier: GPL-3.0-or-later
"""The report: one HTML file that needs nothing else. From verdicts.csv, and every table, figure and sidecar
of the graph.

What is shown is what the graph declares (jobs.tsv): a new table or figure appears here by itself.
"""

from __future__ import annotations

import base64
import html
import io
import json
import re
from dataclasses import dataclass
from pathlib import Path

import pandas as pd
import PIL.Image

import common
import explore
import turn
import verdict

MARKS = {"reproduced": "✓", "differs": "≠", "thesis-misprint": "!", "not-comparable": "–", "input": "·"}
MEANINGS = {
    "reproduced": "came out again",
    "differs": "came out otherwise",
    "thesis-misprint": "wrong in the thesis",
    "not-comparable": "of another machine or patient",
    "input": "given, not computed",
}
MOST_LINES = 250_000  # bytes of an SVG in the page
WIDEST = 1600  # pixels of a picture in the page: main is 80 rem wide, on a screen of fine pixels
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


def element(tag: str, inner: str, **attributes: str) -> str:
    """An element; inner is HTML already, attribute values are escaped here."""
    words = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{html.escape(value)}"' for key, value in attributes.items()
    )
    return f"<{tag}{words}>{inner}</{tag}>"


def cell(value: str, title: str = "", shorten: bool = False, name: bool = False) -> str:
    """A table cell; numbers to the right unless they are names, long ones rounded if that is asked for."""
    attributes = {"data_title": title} if title else {}
    try:
        number = float("" if name else value)
    except ValueError:
        return element("td", html.escape(value), **attributes)
    plain = f"{number:,.10g}"
    text = plain if len(plain) <= 10 else common.digits(number, 4)
    return element("td", text if shorten else html.escape(value), class_="number", **attributes)


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

    def choice(name: str, values: list[str]) -> str:
        options = '<option value="">all</option>' + "".join(element("option", value) for value in values)
        return element("label", name.capitalize() + element("select", options, id=f"filter-{name}"))

    return element(
        "div",
        choice("artefact", list(verdicts.artefact.unique()))
        + choice("verdict", [name for name in MARKS if name in set(verdicts.verdict)])
        + '<label>Text<input id="filter-text" type="search"></label><span class="soft" id="count"></span>',
        class_="filters",
    )


def explanation(row: dict[str, str]) -> str:
    """The rule of a verdict with its tolerance, and what is to be said of this one."""
    tolerance = f" ({row['tolerance']})" if row["tolerance"] not in ("", "none") else ""
    note = element("strong", html.escape(row["note"]) + ". ") if row["note"] else ""
    return element("td", note + html.escape(f"Rule: {row['rule']}{tolerance}."), class_="why")


def verdict_table(verdicts: pd.DataFrame) -> str:
    """Every row, with what the filters need."""
    names = [
        name
        for name in ("artefact", "row", "column", "thesis", "reference", "measured", "unit")
        if name in verdicts
    ]
    head = element(
        "thead", element("tr", "".join(element("th", name) for name in [*names, "verdict", "why"]))
    )
    rows = []
    for row in verdicts.to_dict("records"):
        found = row["verdict"]
        cells = [cell(row[name], title=name, name=name == "row") for name in names]
        cells.append(
            element(
                "td",
                html.escape(found),
                class_=f"verdict {found}",
                data_mark=MARKS.get(found, ""),
                data_title="verdict",
            )
        )
        rows.append(
            element(
                "tr", "".join(cells) + explanation(row), data_artefact=row["artefact"], data_verdict=found
            )
        )
    return element(
        "div", element("table", head + element("tbody", "".join(rows)), id="verdicts"), class_="scroll"
    )


def data_table(path: Path) -> str:
    """A CSV as it is."""
    table = pd.read_csv(path, dtype=str, keep_default_na=False)
    head = element("tr", "".join(element("th", name.replace("_", " ")) for name in table.columns))
    body = "".join(
        element("tr", "".join(cell(value, shorten=True) for value in row))
        for row in table.itertuples(index=False)
    )
    return element("div", element("table", element("thead", head) + element("tbody", body)), class_="scroll")


def lighter(path: Path) -> bytes:
    """A PNG as WebP, no wider than a screen shows: a tenth of the bytes. The file itself stays beside the report."""
    with PIL.Image.open(path) as picture:
        if picture.width > WIDEST:
            picture = picture.resize(
                (WIDEST, round(picture.height * WIDEST / picture.width)), PIL.Image.LANCZOS
            )
        webp = io.BytesIO()
        picture.convert("RGB").save(webp, "WEBP", quality=82, method=4)
    return webp.getvalue()


def packed(path: Path) -> tuple[str, bytes]:
    """Kind and bytes of a picture: drawn lines where they take little room, pixels where those take less."""
    if path.suffix == ".gif":
        return "image/gif", path.read_bytes()
    if path.suffix == ".svg" and path.stat().st_size < MOST_LINES:
        return "image/svg+xml", path.read_bytes()
    return "image/webp", lighter(path.with_suffix(".png"))


def image(path: Path, title: str) -> str:
    """The picture inside the page."""
    kind, content = packed(path)
    content = base64.b64encode(content).decode("ascii")
    return (
        f'<img alt="{html.escape(title)}" loading="lazy" decoding="async" src="data:{kind};base64,{content}">'
    )


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


def section(results: Path, job: Job) -> str:
    """A table or figure with its caption, source and way to make it again."""
    shown = job.outputs[0]
    if job.kind == "table":
        body = element("p", html.escape(job.question)) + data_table(results / shown)
    else:
        body = element(
            "figure", image(results / shown, job.question) + element("figcaption", html.escape(job.question))
        )
    again = f"experiments/reproduce --only {job.name}"
    source = f"{shown} · {job.script} · " + element("code", again)
    return (
        element("h3", job.name, id=job.name)
        + body
        + element("p", source, class_="source")
        + "".join(provenance(results, name) for name in job.data)
    )


def heading(results: Path, jobs: list[Job]) -> str:
    """Title, and which machine and profile this is."""
    names = [name for job in jobs for name in job.data]
    record = common.sidecar(results / "data" / f"{names[0]}.csv")
    changes = " with changes" if record["dirty"] else ""
    where = (
        f"{record['profile']} profile, commit {record['commit'][:12]}{changes}, "
        f"{record['cpu']}, {record['cores']} cores, {record['compiler']}"
    )
    return (
        element("h1", "Impingement of ball-and-socket joints: the thesis, reproduced")
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
        groups[title].append(element("a", job.name, href=f"#{job.name}"))
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


def page(results: Path, jobs: list[Job], library: str, reference: Path) -> str:
    """The whole document; `library` draws the plot that the reader moves about in."""
    verdicts = pd.read_csv(results / "verdicts.csv", dtype=str, keep_default_na=False)
    verdicts = verdict.with_reference(verdicts, reference)
    parts = [
        heading(results, jobs),
        element("h2", "Verdicts", id="verdicts-title"),
        totals(verdicts),
        filters(verdicts),
        verdict_table(verdicts),
        explore.section(results),
        turn.section(
            results, image(results / "figures" / "figure-44.png", "The joint, seen from three sides")
        ),
    ]
    for kind, title in (("table", "Tables"), ("figure", "Figures")):
        parts += [element("h2", title), *(section(results, job) for job in jobs if job.kind == kind)]
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
