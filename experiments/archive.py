# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the results of a run into one tar that stands for itself: data with their sidecars, tables, figures, report and
paper, the scripts that made them, checksums, and `recheck`, which holds all of it against the checksums and makes
tables and figures again without compiling anything.
"""

from __future__ import annotations

import gzip
import io
import shutil
import tarfile
from collections.abc import Callable, Iterable
from pathlib import Path

from sidecars import digest

SOURCE = Path(__file__).resolve().parent.parent
README = """\
Results of impinge, research software for the impingement of ball-and-socket joints; no medical device.

results/     data (CSV, each with a sidecar that tells where it comes from), tables, figures, report.html, paper.pdf
analysis/    the scripts that make tables, figures, verdicts and report from the data
paper/       the text of the paper
graph/       jobs.json: what was made from what, by which command
SHA256SUMS   of every file here
recheck      ./recheck holds every file against SHA256SUMS and every CSV against its sidecar, then makes tables,
             figures, report and paper again and compares them; --only NAME makes that one, --sums none of them

BONES in a command, or in the summary of a scene, is the folder of real joints, which are not packed.
recheck needs Python 3 with numpy, pandas, matplotlib, pillow and VTK, and latexmk for the paper.
"""


def relative(text: str, places: dict[str, str]) -> str:
    """Paths of this machine as they are called in the archive."""
    for place, name in places.items():
        text = text.replace(place, name)
    return text


def members(outputs: Iterable[str], results: Path, places: dict[str, str]) -> dict[str, bytes | Path]:
    """Every file of the results by its name in the archive; the summaries of scenes name their meshes as found there."""
    files: dict[str, bytes | Path] = {f"results/{output}": results / output for output in outputs}
    for name, file in files.items():
        if name.endswith("/summary.json"):
            files[name] = relative(file.read_text(), places).encode()
    return files


def sources(jobs: str) -> dict[str, bytes | Path]:
    """What stands beside the results, by its name in the archive."""
    files: dict[str, bytes | Path] = {}
    for folder, kinds in (("analysis/*", ("py", "css", "js", "csv")), ("paper", ("tex", "bib"))):
        for kind in kinds:
            for file in SOURCE.glob(f"{folder}/*.{kind}"):
                files[str(file.relative_to(SOURCE))] = file
    plotly = "analysis/node_modules/plotly.js-basic-dist-min/plotly-basic.min.js"
    files[plotly] = SOURCE / plotly
    reference = SOURCE / "results" / "reference"
    for file in (reference / "verdicts.csv", reference / "run.json", *sorted(reference.glob("tables/*.csv"))):
        if file.is_file():
            files[f"results/{file.relative_to(reference.parent)}"] = file
    files["LICENSE"] = SOURCE / "LICENSE"
    files["recheck"] = SOURCE / "experiments" / "recheck.py"
    files["graph/jobs.json"] = jobs.encode()
    files["README"] = README.encode()
    return files


def add(tar: tarfile.TarFile, name: str, content: bytes | Path) -> None:
    """One file, without owner, time or rights of this machine: equal results make equal archives."""
    info = tarfile.TarInfo(name)
    info.mode = 0o755 if name.endswith("/recheck") else 0o644
    if isinstance(content, bytes):
        info.size = len(content)
        tar.addfile(info, io.BytesIO(content))
        return
    info.size = content.stat().st_size
    with content.open("rb") as file:
        tar.addfile(info, file)


def write(results: Path, files: dict[str, bytes | Path], say: Callable[[str], None]) -> Path:
    """Writes results/impinge-results.tar.gz of these files, whole or not at all."""
    files["SHA256SUMS"] = "".join(f"{digest(files[name])}  {name}\n" for name in sorted(files)).encode()
    archive = results / "impinge-results.tar.gz"
    partial = archive.with_suffix(".partial")
    say(f"packing {len(files)} files")
    try:
        with (
            partial.open("wb") as raw,
            gzip.GzipFile(filename="", fileobj=raw, mode="wb", compresslevel=6, mtime=0) as packed,
            tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as tar,
        ):
            for name in sorted(files):
                add(tar, f"impinge-results/{name}", files[name])
        shutil.move(partial, archive)
    finally:
        partial.unlink(missing_ok=True)
    return archive
