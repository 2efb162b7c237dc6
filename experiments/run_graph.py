#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes what experiments/reproduce is asked for, and says in a reader's words what happens: progress, time left, why, list.

Ninja alone decides what runs; this reads the graph (graph.py), the seconds of earlier runs, and Ninja's own output.
Standard library only.
"""

from __future__ import annotations

import argparse
import collections
import csv
import dataclasses
import difflib
import filecmp
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import graph
import tally
from graph import SOURCE, Job, Setup

JOINT3D_LEFT_OUT = (
    "Joint3D, the page that moves a joint, is left out: experiments/reproduce --only joint3d installs its packages and makes it"
)
RESULTS = "results.ninja"
STATUS = "@@ "  # starts every status line of Ninja, see NINJA_STATUS


def expected(setup: Setup, job: Job) -> Job:
    """Seconds that a job is expected to take: as last time, or else its budget."""
    measured = setup.graph / setup.profile / job.name
    seconds = float(measured.read_text()) if measured.is_file() else job.budget[setup.profile == "full"]
    return dataclasses.replace(job, seconds=seconds)


def find(jobs: dict[str, Job], name: str) -> Job:
    """The job with that name, or the job that makes the artefact or file with that name. Refuses other names, with similar ones."""
    known = {}
    for job in jobs.values():
        for other in (*job.outputs, *(Path(output).stem for output in job.outputs)):
            known.setdefault(other, job)
    known |= {artefact: job for job in jobs.values() for artefact in job.artefacts} | jobs
    if name not in known:
        near = " ".join(difflib.get_close_matches(name, known, n=6)) or "none is like it"
        left_out = "" if "joint3d" in jobs else f". {JOINT3D_LEFT_OUT}"
        graph.refuse(f"there is no '{name}'. Near: {near}; --list has all names{left_out}")
    return known[name]


def words(seconds: float) -> str:
    """A duration as a person says it."""
    if seconds < 1:
        return "under 1 s"
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds >= 600 else f"{seconds // 60:.0f} min {seconds % 60:.0f} s"


def show_list(setup: Setup, jobs: dict[str, Job]) -> None:
    """Lists each artefact once."""
    for job in jobs.values():
        data = [other.name for other in graph.behind(jobs, [job]) if other.kind == "data"]
        for artefact in job.artefacts:
            print(f"{artefact}\n    {job.question}")
            print(
                f"    experiment {', '.join(data) if len(data) < 6 else f'all {len(data)}'}"
                f" · script {job.script} · about {words(job.seconds)}{' alone' if job.timing else ''}"
            )
            print(f"    command    {setup.shorten(' '.join(job.command))}")


def write_whole(path: Path, text: str) -> None:
    """Writes a file as a whole or not at all; leaves it alone if it already has these bytes."""
    if not path.is_file() or path.read_text() != text:
        partial = path.with_name(f"{path.name}.partial")
        partial.write_text(text)
        os.replace(partial, path)


def start(folder: Path, *arguments: str, output=subprocess.PIPE, **environment: str) -> subprocess.Popen:
    """Starts Ninja; it inherits the lock that experiments/reproduce holds, and keeps it if this process is killed."""
    return subprocess.Popen(
        ["ninja", "-C", str(folder), *arguments],
        stdout=output,
        stderr=subprocess.STDOUT,
        text=True,
        close_fds=False,
        env={**os.environ, **environment},
    )


def dry_run(folder: Path, *arguments: str) -> str:
    """What Ninja says it would do."""
    process = start(folder, "-n", *arguments, NINJA_STATUS=STATUS)
    said = process.communicate()[0]
    if process.returncode != 0:
        sys.exit(f"reproduce: {said}")
    return said


REASONS = [
    (r"output (\S+) doesn't exist", r"\1 is not there yet"),
    (r"(?:restat of )?output (\S+) older than most recent input (\S+) .*", r"\2 changed after \1 was made"),
    (r"recorded mtime of (\S+) older than most recent input (\S+) .*", r"\2 changed after \1 was made"),
    (r"command line (?:not found in log )?(?:changed )?for (\S+)", r"the command that makes \1 changed"),
]


def why(setup: Setup, jobs: dict[str, Job], job: Job) -> None:
    """Why Ninja would make the job again: the causes, without their consequences. Changes nothing."""
    programs = graph.programs_behind(jobs, [job])
    causes = [f"program {name} is not built yet" for name in programs if not Path(setup.program(name)).is_file()]
    if not causes:
        # In files for asking only: with build.ninja itself a dry run stops at "would configure again".
        with tempfile.TemporaryDirectory() as folder:
            built, made = Path(folder) / "programs.ninja", Path(folder) / "results.ninja"
            built.write_text("include build.ninja\n")
            made.write_text(graph.ninja_file(setup, jobs))
            said = dry_run(setup.build, "-d", "explain", "-f", str(built), *programs)
            said += dry_run(setup.graph, "-d", "explain", "-f", str(made), str(setup.results / job.outputs[0]))
        lines = [line.removeprefix("ninja explain: ") for line in said.splitlines() if line.startswith("ninja explain: ")]
        matches = [(re.fullmatch(pattern, line), reason) for line in lines for pattern, reason in REASONS]
        causes = [setup.shorten(match.expand(reason)) for match, reason in matches if match and "phony" not in match[0]]
    print(f"{job.name} would be made again, because:" if causes else f"{job.name} is up to date.")
    for cause in dict.fromkeys(causes):
        print(f"  {cause}")


class Progress:
    """Follows the jobs and estimates the time left from the times of earlier runs."""

    def __init__(self, planned: list[Job], parallel: int, profile: str):
        self.left = {job.name: job for job in planned}
        self.running: dict[str, float] = {}  # name to when it started
        self.over: list[str] = []  # experiments that took more than their budget, in words
        self.profile = profile
        self.total = len(planned)
        self.parallel = parallel

    def seconds_left(self) -> float:
        """Seconds left: timings run one after another, the others side by side."""
        left = {True: 0.0, False: 0.0}
        for job in self.left.values():
            elapsed = time.monotonic() - self.running[job.name] if job.name in self.running else 0.0
            left[job.timing] += max(job.seconds - elapsed, 0)
        return left[True] + left[False] / self.parallel

    def hear(self, event: str) -> None:
        """One line from a job: start NAME, say NAME TEXT or end NAME."""
        kind, name, *text = event.rstrip("\n").split(" ", 2)
        job = self.left.get(name)
        if not job:
            return
        if kind == "start":
            self.running[name] = time.monotonic()
            if job.kind == "data":
                print(f"        {name}: {job.question} (about {words(job.seconds)})", flush=True)
        elif kind == "say":
            print("        " + "".join(text), flush=True)
        elif kind == "end":
            del self.left[name]
            took = time.monotonic() - self.running.pop(name)
            budget = job.budget[self.profile == "full"]
            if job.kind == "data" and took > 1.2 * budget + 1:
                self.over.append(f"{name} took {words(took)}, and has {words(budget)}")
            done = f"[{self.total - len(self.left)}/{self.total}] "
            rest = f"; {words(self.seconds_left())} left" if self.left else ""
            print(f"{done:8}{name} done in {words(took)}{rest}", flush=True)


def build_programs(setup: Setup, targets: list[str], parallel: int) -> None:
    """Compiles what changed before anything runs, so that no compiler runs beside a stopwatch. Shows Ninja's own progress, or
    nothing if there is nothing to do.
    """
    if not (setup.build / "build.ninja").is_file():
        print(f"Configuring {setup.build}", flush=True)
        command = ["cmake", "--preset", "release", "-B", str(setup.build)]
        done = subprocess.run(command, cwd=SOURCE, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"reproduce: the configuration failed\n{done.stderr}")
    process = start(setup.build, "-j", str(parallel), *targets, NINJA_STATUS="[%f/%t] ")
    lines: collections.deque[str] = collections.deque(maxlen=60)
    shown = 0.0
    for line in process.stdout or ():
        lines.append(line)
        due = time.monotonic() - shown > 5 or "Linking" in line
        if line.startswith("[") and "Re-checking" not in line and due:
            print(f"Building {line.strip()}", flush=True)
            shown = time.monotonic()
    if process.wait() != 0:
        print("".join(lines))
        sys.exit("reproduce: the build failed; see above")
    for name in targets:
        built, kept = setup.build / graph.ELSEWHERE.get(name, f"experiments/{name}"), Path(setup.program(name))
        if not kept.is_file() or not filecmp.cmp(built, kept, shallow=False):
            kept.parent.mkdir(parents=True, exist_ok=True)
            os.replace(shutil.copy(built, f"{kept}.partial"), kept)


def planned_jobs(setup: Setup, targets: list[str], jobs: dict[str, Job]) -> list[Job]:
    """The jobs that Ninja would run, in its order."""
    said, mark = dry_run(setup.graph, "-f", RESULTS, *targets), f"{STATUS}job "
    return [jobs[line.removeprefix(mark)] for line in said.splitlines() if line.startswith(mark)]


def run_jobs(setup: Setup, targets: list[str], progress: Progress) -> int:
    """Runs the graph and passes on what the jobs report; keeps Ninja's own output in case of a failure."""
    read, write = os.pipe()
    os.set_inheritable(write, True)
    log = setup.graph / "ninja.log"
    environment = {"IMPINGE_RUN_PID": str(os.getpid()), "IMPINGE_EVENTS": str(write)}
    with log.open("w") as output:
        arguments = ["-f", RESULTS, "-j", str(progress.parallel), *targets]
        process = start(setup.graph, *arguments, output=output, **environment)
    os.close(write)
    with os.fdopen(read, errors="replace") as events:
        for event in events:
            progress.hear(event)
    if code := process.wait():
        _, _, failure = log.read_text(errors="replace").partition("FAILED: ")
        print("\n".join(failure.splitlines()[2:42]), file=sys.stderr)
    return code


def closing(results: Path, job: Job | None) -> None:
    """Says where the results are and counts the verdicts; for a single job, says what it makes."""
    if job:
        for output in job.outputs:
            print(f"made     {results / output}")
        return
    pages = [("report", "report.html"), ("Joint3D", "joint3d.html"), *(("paper", f"{name}.pdf") for name in graph.PAPERS), ("verdicts", "verdicts.csv")]
    for what, name in pages:
        if (results / name).is_file():
            print(f"{what:9}{results / name}")
    with (results / "verdicts.csv").open(newline="") as file:
        print("verdicts " + tally.said(csv.DictReader(file)))


def run(setup: Setup, jobs: dict[str, Job], job: Job | None, parallel: int) -> int:
    """Builds, then runs what is not up to date: one job with what it needs, or all jobs."""
    begin = time.monotonic()
    setup.results.mkdir(parents=True, exist_ok=True)
    build_programs(setup, graph.programs_behind(jobs, [job] if job else [*jobs.values()]), parallel)
    write_whole(setup.graph / "jobs.json", graph.record(setup, jobs))
    write_whole(setup.graph / RESULTS, graph.ninja_file(setup, jobs))
    targets = [str(setup.results / job.outputs[0])] if job else []
    planned = planned_jobs(setup, targets, jobs)
    if not planned:
        print(f"nothing to do: {job.name if job else 'every result'} is up to date in {setup.results}")
        closing(setup.results, job)
        return 0
    progress = Progress(planned, parallel, setup.profile)
    print(f"{len(planned)} of {len(jobs)} jobs to run, about {words(progress.seconds_left())}", flush=True)
    if run_jobs(setup, targets, progress) != 0:
        print("reproduce: a job failed, see above; the next run goes on from what is done", file=sys.stderr)
        return 1
    for line in progress.over:
        print(f"over its budget: {line}")
    print(f"done in {words(time.monotonic() - begin)}")
    closing(setup.results, job)
    return 0


def main() -> int:
    """Reads the command line that experiments/reproduce passes on."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("action", choices=["run", "list", "why"])
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--results", type=Path, required=True)
    parser.add_argument("--profile", required=True)
    parser.add_argument("--jobs", type=int, required=True)
    parser.add_argument("--bones", type=Path)
    parser.add_argument("--name")
    options = parser.parse_args()
    setup = Setup(options.build, options.results, options.profile, options.bones)
    jobs = {name: expected(setup, job) for name, job in graph.all_jobs(setup).items()}
    job = find(jobs, options.name) if options.name else None
    if options.action == "list":
        show_list(setup, jobs)
    elif options.action == "why" and job:
        why(setup, jobs, job)
    else:
        if not job and "joint3d" not in jobs:
            print(JOINT3D_LEFT_OUT, flush=True)
        return run(setup, jobs, job, options.jobs)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit("\nreproduce: stopped; the next run goes on from here")
    except BrokenPipeError:  # who reads the list has read enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
