# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the report about one table or figure: what it shows, the command that makes it again, and its files."""

from __future__ import annotations

import html
from pathlib import Path

from common.jobs import Job
from report import data_table, picture
from report.artefacts import heading
from report.markup import element


ABOVE = {"stability-overview": "stability"}  # figures that the first screen has, and where


def section(results: Path, job: Job, kept: Path, linked: bool) -> str:
    """A table or figure that opens at its heading; kept: the folder of the reference run; linked: a figure is a file beside the
    page, and not in it.
    """
    shown = job.outputs[0]
    if job.name in ABOVE:
        body = element("p", element("a", "On the first screen", href=f"#{ABOVE[job.name]}") + ".")
    elif linked and job.kind == "figure":
        file = shown.replace(".svg", ".png")
        body = element("p", element("a", file, href=file))
    elif job.kind == "table":
        path = results / shown
        body = data_table.section(path, kept) + data_table.explained(data_table.meanings(path, results, job.data))
    else:
        widest = picture.SMALLER if job.name.startswith("figure-") else picture.WIDEST
        body = element("figure", picture.image(results / shown, job.question, widest))
    title = element("summary", element("h3", html.escape(heading(job))))
    return element("details", title + body + origin(job), id=job.name, class_="artefact")


def origin(job: Job) -> str:
    """The command that makes it again, its file, its script, and the data that it is made from."""
    again = element("code", f"experiments/reproduce --only {job.name}")
    file = element("a", job.outputs[0], href=job.outputs[0])
    data = ", ".join(element("a", name, href=f"#data-{name}") for name in job.data)
    return element("p", f"Again: {again} · file: {file} · script: {job.script}" + (f" · data: {data}" if data else ""), class_="source")
