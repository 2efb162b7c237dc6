#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one job of the graph so that its outputs appear whole, or not at all.

The command runs in a fresh folder laid out as the results folder, and writes there. When it ends well, each
declared output is renamed into place, except where the bytes are already there: an unchanged file keeps its
time stamp, and Ninja then leaves out what would follow from it. With --lock, a job run --alone has the
machine to itself.

experiments/reproduce listens on a pipe (IMPINGE_EVENTS is its number): start NAME, say NAME TEXT, end NAME.
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
import threading
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
    parser.add_argument("--talks", action="store_true", help="what it prints is progress")
    parser.add_argument("--outputs", nargs="+", required=True)
    split = sys.argv.index("--")
    options = parser.parse_args(sys.argv[1:split])
    options.command = sys.argv[split + 1 :]
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


def tell(text: str) -> None:
    """One line to whoever started the graph, if anybody listens still."""
    with contextlib.suppress(OSError, KeyError):
        os.write(int(os.environ["IMPINGE_EVENTS"]), f"{text}\n".encode())


def relay(name: str, talks: bool, child: subprocess.Popen) -> None:
    """Passes on what the command prints."""
    for line in child.stdout:
        print(line, end="", flush=True)
        if talks:
            tell(f"say {name} {line.rstrip()}")


def run(options: argparse.Namespace, folder: Path) -> int:
    """Runs the command in the folder; ends it when the run that started this job is gone (killed, say)."""
    owner = int(os.environ.get("IMPINGE_RUN_PID", "0"))
    child = subprocess.Popen(
        options.command,
        cwd=folder,
        start_new_session=True,
        text=True,
        errors="replace",
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    listener = threading.Thread(target=relay, args=(options.name, options.talks, child), daemon=True)
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
    """Renames the outputs into place; one whose bytes are there already is left alone."""
    for output in outputs:
        new, old = staging / output, results / output
        if old.is_file() and filecmp.cmp(new, old, shallow=False):
            continue
        old.parent.mkdir(parents=True, exist_ok=True)
        os.replace(new, old)


def finish(options: argparse.Namespace, staging: Path, code: int, seconds: float) -> int:
    """Publishes a job that ended well and notes how long it took; says what is wrong with another."""
    missing = [output for output in options.outputs if not (staging / output).is_file()]
    if code != 0:
        print(f"{options.name}: failed (exit {code}): {' '.join(options.command)}", file=sys.stderr)
    elif missing:
        print(f"{options.name}: ended well but did not write {', '.join(missing)}", file=sys.stderr)
    else:
        publish(staging, options.results, options.outputs)
        options.state.mkdir(parents=True, exist_ok=True)
        (options.state / options.name).write_text(f"{seconds:.2f}\n")
        tell(f"end {options.name}")
        return 0
    return 1


def main() -> int:
    """Stages, runs, publishes."""
    options = parse()
    staging = options.results / ".staging" / options.name
    shutil.rmtree(staging, ignore_errors=True)
    for output in options.outputs:
        (staging / output).parent.mkdir(parents=True, exist_ok=True)
    with machine(options.lock, options.alone):
        tell(f"start {options.name}")
        start = time.monotonic()
        code = run(options, staging)
        code = finish(options, staging, code, time.monotonic() - start)
    shutil.rmtree(staging, ignore_errors=True)
    with contextlib.suppress(OSError):
        staging.parent.rmdir()
    return code


if __name__ == "__main__":
    sys.exit(main())
