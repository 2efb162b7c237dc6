#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one job of the graph so that its outputs appear whole, or not at all.

The command runs in a fresh folder laid out as the results folder, and writes there. When it ends well, each declared
output is renamed into place, except where the bytes are already there: an unchanged file keeps its time stamp, and Ninja
then leaves out what would follow from it. With --lock, a job run --alone has the machine to itself.
"""

import argparse
import contextlib
import fcntl
import filecmp
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path


def parse() -> argparse.Namespace:
    """The command line; everything after -- is the job's own command."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--name", required=True)
    parser.add_argument("--results", type=Path, required=True)
    parser.add_argument("--state", type=Path, required=True, help="where the time each job took is kept")
    parser.add_argument("--lock", type=Path, help="file that timings hold alone and other jobs share")
    parser.add_argument("--alone", action="store_true")
    parser.add_argument("--outputs", nargs="+", required=True)
    split = sys.argv.index("--")
    options = parser.parse_args(sys.argv[1:split])
    options.command = sys.argv[split + 1:]
    return options


@contextlib.contextmanager
def machine(lock: Path | None, alone: bool):
    """Holds the machine: shared with other jobs, or alone for a timing."""
    if lock is None:
        yield
        return
    with lock.open("a") as file:
        fcntl.flock(file, fcntl.LOCK_EX if alone else fcntl.LOCK_SH)
        yield


def run(command: list[str], folder: Path) -> int:
    """Runs the command; ends it when the run that started this job is gone (killed, say)."""
    owner = int(os.environ.get("IMPINGE_RUN_PID", "0"))
    child = subprocess.Popen(command, cwd=folder, start_new_session=True)
    try:
        while True:
            try:
                return child.wait(timeout=0.5)
            except subprocess.TimeoutExpired:
                if owner:
                    os.kill(owner, 0)
    except (ProcessLookupError, KeyboardInterrupt):
        os.killpg(child.pid, signal.SIGKILL)
        child.wait()
        return 1


def publish(staging: Path, results: Path, outputs: list[str]) -> None:
    """Renames the outputs into place; one whose bytes are there already is left alone."""
    for output in outputs:
        new, old = staging / output, results / output
        if old.is_file() and filecmp.cmp(new, old, shallow=False):
            continue
        old.parent.mkdir(parents=True, exist_ok=True)
        os.replace(new, old)


def main() -> int:
    """Stages, runs, publishes, and notes how long it took."""
    options = parse()
    staging = options.results / ".staging" / options.name
    shutil.rmtree(staging, ignore_errors=True)
    for output in options.outputs:
        (staging / output).parent.mkdir(parents=True, exist_ok=True)
    with machine(options.lock, options.alone):
        start = time.monotonic()
        code = run(options.command, staging)
        seconds = time.monotonic() - start
    missing = [output for output in options.outputs if not (staging / output).is_file()]
    if code == 0 and missing:
        print(f"{options.name}: the command ended well but did not write {', '.join(missing)}", file=sys.stderr)
        code = 1
    if code == 0:
        publish(staging, options.results, options.outputs)
        options.state.mkdir(parents=True, exist_ok=True)
        (options.state / options.name).write_text(f"{seconds:.2f}\n")
    else:
        print(f"{options.name}: failed (exit {code}): {' '.join(options.command)}", file=sys.stderr)
    shutil.rmtree(staging, ignore_errors=True)
    with contextlib.suppress(OSError):
        staging.parent.rmdir()
    return 0 if code == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
