#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks an archive of results: every file against SHA256SUMS, every CSV against its sidecar; then makes tables, figures,
verdicts, report and paper again from the data and compares. Nothing in the archive is changed.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT / "analysis" / "common"))
sys.dont_write_bytecode = True

import jobs  # noqa: E402
from sidecars import Refused, digest, sidecar  # noqa: E402


def damaged() -> list[str]:
    """What is not as it was packed, in words."""
    found = []
    for line in (ROOT / "SHA256SUMS").read_text().splitlines():
        expected, name = line.split("  ", 1)
        if not (ROOT / name).is_file():
            found.append(f"{name} is missing")
        elif digest(ROOT / name) != expected:
            found.append(f"{name} is not the file that was packed")
    for table in sorted((ROOT / "results" / "data").glob("*.csv")):
        try:
            sidecar(table)
        except Refused:
            found.append(f"results/data/{table.name} is not the table that its sidecar describes")
    return found


def here(word: str) -> str:
    """A word of a command, paths of the archive made absolute; also in NAME=PATH:PATH."""
    name, equals, value = word.rpartition("=")
    pieces = [str(ROOT / piece) if piece and (ROOT / piece).exists() else piece for piece in value.split(":")]
    return name + equals + ":".join(pieces)


def make(job: jobs.Job) -> str:
    """Runs a job in a fresh folder: 'same', 'otherwise', or why it cannot be run."""
    command = ["env", *job.command[3:]] if job.command[1:3] == ["-E", "env"] else job.command  # CMake may not be there
    with tempfile.TemporaryDirectory(prefix="impinge-recheck-") as folder:
        for output in job.outputs:
            (Path(folder) / output).parent.mkdir(parents=True, exist_ok=True)
        try:
            done = subprocess.run(
                [here(word) for word in command],
                cwd=folder,
                capture_output=True,
                text=True,
                check=False,
            )
        except OSError as error:
            return f"cannot be made here: {error.strerror}: {error.filename}"
        if done.returncode != 0:
            reason = (done.stderr or done.stdout).strip().splitlines()
            return f"cannot be made here: {reason[-1] if reason else 'no reason given'}"
        made = all(digest(Path(folder) / output) == digest(ROOT / "results" / output) for output in job.outputs)
        return "same" if made else "otherwise"


def main() -> int:
    """Checks, then makes again."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sums", action="store_true", help="check the files alone, make nothing")
    parser.add_argument("--only", metavar="NAME", help="make this table or figure alone")
    options = parser.parse_args()
    faults = damaged()
    print("\n".join(faults) if faults else "every file is as it was packed")
    if faults or options.sums:
        return 1 if faults else 0
    counts = {"same": 0, "otherwise": 0, "not made": 0}
    every = jobs.load(ROOT / "graph" / "jobs.json")
    made = [job for job in every if job.kind not in ("data", "page") and not job.timing]  # they need a compiler
    chosen = [job for job in made if options.only in (None, job.name)]
    if not chosen:
        print(f"recheck: there is no '{options.only}' that is made from data", file=sys.stderr)
        return 2
    for job in chosen:
        found = make(job)
        counts[found if found in counts else "not made"] += 1
        print(f"{job.name}: {found}", flush=True)
    print(", ".join(f"{count} {what}" for what, count in counts.items()))
    print(
        "Bytes also differ with another version of matplotlib, VTK or LaTeX." if counts["otherwise"] else "",
        end="",
    )
    return 1 if counts["not made"] else 0


if __name__ == "__main__":
    sys.exit(main())
