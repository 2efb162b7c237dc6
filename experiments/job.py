#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one job of the graph so that its outputs appear whole, or not at all: job.py JOB, as graph.py writes it, in JSON.

The command runs in a fresh folder laid out as the results folder, and writes there. When it ends well, each
declared output is renamed into place, except where the bytes are already there: an unchanged file keeps its
time stamp, and Ninja then leaves out what would follow from it. A job that is alone has the machine to itself.

experiments/reproduce listens on a pipe (IMPINGE_EVENTS is its number): start NAME, say NAME TEXT, end NAME.
"""

import contextlib
import fcntl
import filecmp
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path


def tell(text: str) -> None:
    """Sends one line to the process that started the graph, if it still listens."""
    with contextlib.suppress(OSError, KeyError):
        os.write(int(os.environ["IMPINGE_EVENTS"]), f"{text}\n".encode())


def relay(job: dict, child: subprocess.Popen) -> None:
    """Passes on what the command prints."""
    for line in child.stdout:
        print(line, end="", flush=True)
        if job["talks"]:
            tell(f"say {job['name']} {line.rstrip()}")


def run(job: dict, folder: Path) -> int:
    """Runs the command in the folder. Ends it if the run that started this job is gone, for example killed."""
    owner = int(os.environ.get("IMPINGE_RUN_PID", "0"))
    for ending in (signal.SIGTERM, signal.SIGHUP):  # as by Ctrl-C: the command is in a session of its own
        signal.signal(ending, signal.default_int_handler)
    child = subprocess.Popen(
        job["command"],
        cwd=folder,
        start_new_session=True,
        text=True,
        errors="replace",
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    listener = threading.Thread(target=relay, args=(job, child), daemon=True)
    listener.start()
    try:
        while True:
            try:
                code = child.wait(timeout=0.5)
                listener.join(timeout=5)
                return code
            except subprocess.TimeoutExpired:
                if owner:
                    os.kill(owner, 0)
    except (ProcessLookupError, KeyboardInterrupt):
        os.killpg(child.pid, signal.SIGKILL)
        child.wait()
        return 1


def publish(staging: Path, results: Path, outputs: list[str]) -> None:
    """Renames the outputs into place, but leaves alone a file that already has these bytes."""
    for output in outputs:
        new, old = staging / output, results / output
        if old.is_file() and filecmp.cmp(new, old, shallow=False):
            continue
        old.parent.mkdir(parents=True, exist_ok=True)
        os.replace(new, old)


def finish(job: dict, staging: Path, code: int, seconds: float) -> int:
    """Publishes a job that ended well and notes its time; reports what is wrong with one that did not."""
    missing = [output for output in job["outputs"] if not (staging / output).is_file()]
    if code != 0:
        print(f"{job['name']}: failed (exit {code}): {' '.join(job['command'])}", file=sys.stderr)
    elif missing:
        print(f"{job['name']}: ended well but did not write {', '.join(missing)}", file=sys.stderr)
    else:
        publish(staging, Path(job["results"]), job["outputs"])
        times = Path(job["graph"]) / job["profile"]
        times.mkdir(parents=True, exist_ok=True)
        (times / job["name"]).write_text(f"{seconds:.2f}\n")
        tell(f"end {job['name']}")
        return 0
    return 1


def main() -> int:
    """Stages, runs, publishes."""
    job = json.loads(sys.argv[1])
    staging = Path(job["results"]) / ".staging" / job["name"]
    shutil.rmtree(staging, ignore_errors=True)
    for output in job["outputs"]:
        (staging / output).parent.mkdir(parents=True, exist_ok=True)
    with (Path(job["graph"]) / "machine.lock").open("a") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX if job["alone"] else fcntl.LOCK_SH)
        tell(f"start {job['name']}")
        start = time.monotonic()
        code = run(job, staging)
        code = finish(job, staging, code, time.monotonic() - start)
    shutil.rmtree(staging, ignore_errors=True)
    with contextlib.suppress(OSError):
        staging.parent.rmdir()
    return code


if __name__ == "__main__":
    sys.exit(main())
