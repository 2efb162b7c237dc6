# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks Ninja for the graph of results and says, in a reader's words, what happens: progress, time left, why,
list.

Called by experiments/reproduce. Ninja alone decides what runs; this reads build/.../graph/jobs.json (what can
be made, with the expected seconds), the seconds of earlier runs, and Ninja's own output. Standard library
only.
"""

from __future__ import annotations

import argparse
import collections
import contextlib
import csv
import dataclasses
import fcntl
import json
import os
import re
import shutil
import subprocess
import sys
import threading
import time
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(SOURCE / "analysis" / "common"))

import archive  # noqa: E402
import script_server  # noqa: E402
from jobs import Job, load  # noqa: E402

STATUS = "@@ "  # starts every status line of Ninja, see NINJA_STATUS


def names(job: Job) -> set[str]:
    """Everything that a reader may call it."""
    return {job.name, *job.artefacts, *job.outputs, *(Path(output).stem for output in job.outputs)}


def load_jobs(build: Path, profile: str) -> dict[str, Job]:
    """All jobs by name, with the time that each took before, or else its budget."""
    found = {}
    for job in load(build / "graph" / "jobs.json"):
        measured = build / "graph" / profile / job.name
        seconds = float(measured.read_text()) if measured.is_file() else job.budget[profile == "full"]
        found[job.name] = dataclasses.replace(job, seconds=seconds)
    return found


def find(jobs: dict[str, Job], name: str, left_out: str) -> Job:
    """The job of that name, or that makes the artefact or file of that name; left_out: what cannot be made here."""
    for job in jobs.values():
        if name == job.name:
            return job
    for job in jobs.values():
        if name in names(job):
            return job
    known = " ".join(
        sorted({job.name for job in jobs.values()} | {a for job in jobs.values() for a in job.artefacts})
    )
    print(f"reproduce: there is no '{name}'. These can be made: {known}", file=sys.stderr)
    print(left_out, end="", file=sys.stderr)
    sys.exit(2)


def words(seconds: float) -> str:
    """A duration as a person says it."""
    if seconds < 1:
        return "under 1 s"
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds >= 600 else f"{seconds // 60:.0f} min {seconds % 60:.0f} s"


def experiments_behind(job: Job, jobs: dict[str, Job]) -> list[str]:
    """The data jobs that a job rests on, directly or through others; itself if it makes data."""
    if job.kind == "data":
        return [job.name]
    makers = {output: other for other in jobs.values() for output in other.outputs}
    names: dict[str, None] = {}
    for file in job.depends:
        if file in makers:
            names.update(dict.fromkeys(experiments_behind(makers[file], jobs)))
    return list(names)


def programs_behind(job: Job, jobs: dict[str, Job], build: Path, results: Path) -> list[str]:
    """The targets of the programs that a job rests on. They are built before anything runs, since no compiler may run
    beside a stopwatch.
    """
    makers = {output: other for other in jobs.values() for output in other.outputs}
    behind, left = {job.name: job}, [job]
    while left:
        for file in left.pop().depends:
            maker = makers.get(shorten(file, build, results).removeprefix("results/"))
            if maker and maker.name not in behind:
                behind[maker.name] = maker
                left.append(maker)
    files = {Path(file) for other in behind.values() for file in other.depends}
    programs = sorted(f"program-{file.stem}" for file in files if file.suffix == ".kept")
    return programs + ["joint3d_engine"] * any(file.name == "joint3d_engine.js" for file in files)


def show_list(jobs: dict[str, Job]) -> None:
    """Each artefact once."""
    for job in jobs.values():
        behind = experiments_behind(job, jobs)
        for artefact in job.artefacts:
            print(f"{artefact}\n    {job.question}")
            print(
                f"    experiment {', '.join(behind) if len(behind) < 6 else f'all {len(behind)}'}"
                f" · script {job.script} · about {words(job.seconds)}{' alone' if job.timing else ''}"
            )
            print(f"    command    {' '.join(job.command)}")


def ninja(build: Path, *arguments: str) -> list[str]:
    """The command line of Ninja in the build folder."""
    return ["ninja", "-C", str(build), *arguments]


def start(build: Path, arguments: list[str], output, **environment: str) -> subprocess.Popen:
    """Starts Ninja; it inherits the lock that experiments/reproduce holds, and keeps it if this process is
    killed.
    """
    return subprocess.Popen(
        ninja(build, *arguments),
        stdout=output,
        stderr=subprocess.STDOUT,
        text=True,
        close_fds=False,
        env={**os.environ, **environment},
    )


def shorten(text: str, build: Path, results: Path) -> str:
    """Paths as a reader knows them."""
    for folder, short in ((results, "results"), (build, "build"), (SOURCE, "")):
        text = text.replace(f"{folder}/", f"{short}/" if short else "")
    return text


def why(build: Path, results: Path, job: Job) -> None:
    """Why Ninja would make the job again: the causes, not what follows from them."""
    run = subprocess.run(
        ninja(build, "-f", "graph/ask.ninja", "-n", "-d", "explain", f"result-{job.name}"),
        capture_output=True,
        text=True,
    )
    patterns = [
        (r"output (\S+) doesn't exist", r"\1 is not there yet"),
        (
            r"(?:restat of )?output (\S+) older than most recent input (\S+) .*",
            r"\2 changed after \1 was made",
        ),
        (r"command line (?:not found in log )?(?:changed )?for (\S+)", r"the command that makes \1 changed"),
        (r"(\S+) is dirty", None),
    ]
    causes: dict[str, None] = {}
    for line in (run.stdout + run.stderr).splitlines():
        if not line.startswith("ninja explain: "):
            continue
        text = line.removeprefix("ninja explain: ")
        for pattern, reason in patterns:
            match = re.fullmatch(pattern, text)
            if match and reason and "phony" not in text and "CMakeFiles/result" not in text:
                causes[shorten(match.expand(reason), build, results)] = None
                break
    if "no work to do" in run.stdout:
        print(f"{job.name} is up to date.")
        return
    print(f"{job.name} would be made again, because:")
    for cause in causes or ["a program behind it is not built"]:
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
        """Timings one after another, the rest side by side."""
        left = {True: 0.0, False: 0.0}
        for job in self.left.values():
            elapsed = time.monotonic() - self.running[job.name] if job.name in self.running else 0.0
            left[job.timing] += max(job.seconds - elapsed, 0)
        return left[True] + left[False] / self.parallel

    def hear(self, event: str) -> None:
        """One line from a job: start NAME, say NAME TEXT or end NAME."""
        kind, name, *text = event.rstrip("\n").split(" ", 2)
        if name not in self.left:
            return
        if kind == "start":
            self.running[name] = time.monotonic()
            if self.left[name].kind == "data":
                print(
                    f"        {name}: {self.left[name].question} (about {words(self.left[name].seconds)})",
                    flush=True,
                )
        elif kind == "say":
            print("        " + "".join(text), flush=True)
        elif kind == "end":
            job = self.left.pop(name)
            took = time.monotonic() - self.running.pop(name)
            budget = job.budget[self.profile == "full"]
            if job.kind == "data" and took > 1.2 * budget + 1:
                self.over.append(f"{name} took {words(took)}, and has {words(budget)}")
            done = f"[{self.total - len(self.left)}/{self.total}] "
            rest = f"; {words(self.seconds_left())} left" if self.left else ""
            print(f"{done:8}{name} done in {words(took)}{rest}", flush=True)


class Draft:
    """results/report.html while a run goes on, once a minute: what is made is in it, what is not says so. Where a finished
    report of an earlier run is, that one stays.
    """

    MARK = 'http-equiv="refresh"'  # near the beginning of a report that is not finished
    EVERY = 60.0  # seconds, and never more than a twentieth of the run's time

    def __init__(self, build: Path, results: Path, report: Job):
        self.page = results / "report.html"
        self.staging = results / ".staging" / "draft"
        self.lock = build / "graph" / "machine.lock"
        self.command = [*report.command, "--out", str(self.staging)]
        self.thread = threading.Thread(target=self.follow, daemon=True)
        self.ended = threading.Event()
        self.publishing = threading.Lock()
        self.cleared = b""
        self.clear()
        self.wanted = not self.page.is_file()

    def clear(self) -> None:
        """Removes what is not finished: Ninja must see that the report is not there, when it starts."""
        if self.page.is_file() and self.MARK in self.page.read_text(errors="replace")[:1000]:
            self.cleared = self.page.read_bytes()
            self.page.unlink()
        self.tidy()

    def tidy(self) -> None:
        """Leaves nothing beside the results."""
        shutil.rmtree(self.staging, ignore_errors=True)
        with contextlib.suppress(OSError):
            self.staging.parent.rmdir()

    def write(self) -> float:
        """Once, unless the report itself is being made; the seconds that it took. Never beside a timing."""
        with self.lock.open("a") as file:
            fcntl.flock(file, fcntl.LOCK_SH)
            begin = time.monotonic()
            if not self.ended.is_set():
                self.staging.mkdir(parents=True, exist_ok=True)
                done = subprocess.run(self.command, cwd=SOURCE, capture_output=True, check=False)
                with self.publishing, contextlib.suppress(OSError):
                    if done.returncode == 0 and not self.ended.is_set():  # else, say, a CSV is half there
                        os.replace(self.staging / "report.html", self.page)
            return time.monotonic() - begin

    def follow(self) -> None:
        """Until the report itself is being made."""
        pause = 5.0
        while not self.ended.wait(pause):
            self.put_back()  # a timing may be long
            pause = max(self.EVERY, 20 * self.write())

    def put_back(self) -> None:
        """What clear() removed, now that Ninja has seen that it is not there."""
        with self.publishing, contextlib.suppress(OSError):
            if self.cleared and not self.ended.is_set():
                self.staging.mkdir(parents=True, exist_ok=True)
                (self.staging / "cleared.html").write_bytes(self.cleared)
                os.replace(self.staging / "cleared.html", self.page)
            self.cleared = b""

    def end(self) -> None:
        """From now on nothing is put in the report's place."""
        with self.publishing:
            self.ended.set()


def refresh(build: Path) -> None:
    """Configures again when a CMakeLists.txt, or the set of experiments, changed."""
    done = subprocess.run(ninja(build, "build.ninja"), capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"reproduce: the configuration failed\n{done.stdout}{done.stderr}")


def build_programs(build: Path, jobs: int, targets: list[str]) -> None:
    """Compiles what changed; Ninja's own progress is shown, and nothing when there is nothing to do."""
    process = start(build, ["-j", str(jobs), *targets], subprocess.PIPE, NINJA_STATUS="[%f/%t] ")
    assert process.stdout
    lines = collections.deque(maxlen=60)
    shown = 0.0
    for line in process.stdout:
        lines.append(line)
        if (
            line.startswith("[")
            and "Re-checking" not in line
            and (time.monotonic() - shown > 5 or "Linking" in line)
        ):
            print(f"Building {line.strip()}", flush=True)
            shown = time.monotonic()
    if process.wait() != 0:
        print("".join(lines))
        sys.exit("reproduce: the build failed; see above")


def planned_jobs(build: Path, target: str, jobs: dict[str, Job]) -> list[Job]:
    """What Ninja would run, in its order."""
    dry = subprocess.run(
        ninja(build, "-f", "graph/ask.ninja", "-n", target),
        capture_output=True,
        text=True,
        env={**os.environ, "NINJA_STATUS": STATUS},
    )
    if dry.returncode != 0:
        sys.exit(f"reproduce: {dry.stdout}{dry.stderr}")
    names = [
        line.removeprefix(STATUS + "job ")
        for line in dry.stdout.splitlines()
        if line.startswith(STATUS + "job ")
    ]
    return [jobs[name] for name in names]


def run_jobs(build: Path, target: str, progress: Progress, parallel: int, draft: Draft | None) -> int:
    """Runs the graph and tells what the jobs tell; Ninja's own output is kept for a failure."""
    read, write = os.pipe()
    os.set_inheritable(write, True)
    scripts = [job.command for job in progress.left.values() if script_server.parts(job.command)]
    server, asks = script_server.start(scripts[0], SOURCE) if scripts else (None, None)
    asking = {script_server.SOCKET: str(asks.fileno())} if asks else {}
    log = build / "graph" / "ninja.log"
    with log.open("w") as output:
        process = start(
            build,
            ["-j", str(parallel), target],
            output,
            IMPINGE_RUN_PID=str(os.getpid()),
            IMPINGE_EVENTS=str(write),
            **asking,
        )
    os.close(write)
    if asks:
        asks.close()
    if draft:
        draft.thread.start()
    with os.fdopen(read, errors="replace") as events:
        for event in events:
            if draft and event == "start report\n":
                draft.end()
            progress.hear(event)
    code = process.wait()
    if server:
        server.wait()
    if draft:
        draft.end()
        draft.thread.join(timeout=60)
        draft.tidy()
    if code != 0:
        _, _, failure = log.read_text(errors="replace").partition("FAILED: ")
        print("\n".join(failure.splitlines()[2:42]), file=sys.stderr)
    return code


def closing(results: Path, job: Job | None) -> None:
    """Where the results are, and how the verdicts count; of one job, what it makes."""
    if job:
        for output in job.outputs:
            print(f"made     {results / output}")
        return
    pages = (
        ("report", "report.html"),
        ("Joint3D", "joint3d.html"),
        ("paper", "paper.pdf"),
        ("verdicts", "verdicts.csv"),
    )
    for what, name in pages:
        if (results / name).is_file():
            print(f"{what:9}{results / name}")
    if (results / "verdicts.csv").is_file():
        with (results / "verdicts.csv").open(newline="") as file:
            rows = [row for row in csv.DictReader(file) if not row["rule"].startswith("not counted: ")]
        counts = collections.Counter(row["verdict"] for row in rows)
        print("verdicts " + ", ".join(f"{count} {verdict}" for verdict, count in counts.most_common()))


def run(build: Path, results: Path, jobs: dict[str, Job], job: Job | None, profile: str, parallel: int) -> int:
    """Builds, then runs what is not up to date: one job and what it needs, or all."""
    target = f"result-{job.name}" if job else "results"
    try:
        results.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        print(f"reproduce: --results {results}: {error.strerror}", file=sys.stderr)
        return 2
    begin = time.monotonic()
    draft = None if job else Draft(build, results, jobs["report"])
    if draft and draft.wanted:
        draft.write()
    programs = programs_behind(job, jobs, build, results) if job else ["programs"]
    if programs:
        build_programs(build, parallel, programs)
    if draft:
        draft.clear()
    planned = planned_jobs(build, target, jobs)
    if not planned:
        print(f"nothing to do: {job.name if job else 'every result'} is up to date in {results}")
        closing(results, job)
        return 0
    progress = Progress(planned, parallel, profile)
    print(f"{len(planned)} of {len(jobs)} jobs to run, about {words(progress.seconds_left())}", flush=True)
    if run_jobs(build, target, progress, parallel, draft if draft and draft.wanted else None) != 0:
        print(
            "reproduce: a job failed, see above; the next run goes on from what is done",
            file=sys.stderr,
        )
        return 1
    for line in progress.over:
        print(f"over its budget: {line}")
    print(f"done in {words(time.monotonic() - begin)}")
    closing(results, job)
    return 0


def pack(build: Path, results: Path, jobs: dict[str, Job]) -> None:
    """The results as one archive, which names no folder of this machine."""
    bones = re.search(r"^IMPINGE_BONES:PATH=(.+)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE)
    places = {
        **({bones[1]: "BONES"} if bones else {}),
        str(results): "results",
        f"{build.relative_to(SOURCE) if build.is_relative_to(SOURCE) else build}/": "",
    }
    kept = [
        # Data are of another machine: its program and its meshes are not packed.
        dataclasses.replace(job, depends=[], command=[Path(job.command[0]).stem]) if job.kind == "data" else job
        for job in load(build / "graph" / "jobs.json")
    ]
    graph = json.dumps([dataclasses.asdict(job) for job in kept], indent=1)
    outputs = [output for job in jobs.values() for output in job.outputs]
    files = archive.members(outputs, results, places) | archive.sources(archive.relative(graph, places))
    path = archive.write(results, files, lambda text: print(text, flush=True))
    print(f"archive  {path}")


def main() -> int:
    """The command line that experiments/reproduce gives."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("action", choices=["run", "list", "why"])
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--results", type=Path, required=True)
    parser.add_argument("--profile", required=True)
    parser.add_argument("--jobs", type=int, required=True)
    parser.add_argument("--name")
    parser.add_argument("--archive", action="store_true")
    parser.add_argument(
        "--as-it-is", action="store_true", help="another run holds the build folder: configure nothing"
    )
    options = parser.parse_args()
    if not options.as_it_is:
        refresh(options.build)
    jobs = load_jobs(options.build, options.profile)
    left_out = (options.build / "graph" / "left_out").read_text()
    if options.action == "list":
        show_list(jobs)
    elif options.action == "why":
        why(options.build, options.results, find(jobs, options.name, left_out))
    else:
        job = find(jobs, options.name, left_out) if options.name else None
        print("" if job else left_out, end="", flush=True)
        code = run(options.build, options.results, jobs, job, options.profile, options.jobs)
        if code == 0 and options.archive:
            pack(options.build, options.results, jobs)
        return code
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit("\nreproduce: stopped; the next run goes on from here")
    except BrokenPipeError:  # who reads the list has read enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
