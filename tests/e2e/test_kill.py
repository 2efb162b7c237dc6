# SPDX-License-Identifier: GPL-3.0-or-later
"""`kill -9` of experiments/reproduce at random moments: run again, it makes the bytes of an undisturbed run.

  test_kill.py [--kills N] [--seed N] [--only NAME]... [--configure]

Each kill begins with an empty results folder and strikes at a moment drawn evenly from the time that the
undisturbed run took. Then the run is repeated to its end, and every file is compared (result_bytes.py says
what a time is). --configure also removes CMake's build.ninja before each kill, so that some strike while it
runs.
"""

from __future__ import annotations

import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from result_bytes import untimed_bytes  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("IMPINGE_BUILD_DIR", ROOT / "build" / "release"))


def parse() -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=5)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", action="append", help="what is made, one after the other in turn")
    parser.add_argument("--configure", action="store_true")
    return parser.parse_args()


def command(results: Path, name: str) -> list[str]:
    """One artefact and what it needs."""
    return [str(ROOT / "experiments" / "reproduce"), "--results", str(results), "--only", name]


def to_the_end(results: Path, name: str) -> float:
    """The seconds that a whole run takes."""
    begin = time.monotonic()
    done = subprocess.run(command(results, name), cwd="/", capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{name}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return time.monotonic() - begin


def killed(results: Path, name: str, moment: float) -> bool:
    """Whether the run was still going when it was killed."""
    process = subprocess.Popen(
        command(results, name), cwd="/", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    try:
        process.wait(timeout=moment)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGKILL)
    return process.wait() == -signal.SIGKILL


def differences(expected: dict[str, str], found: dict[str, str]) -> list[str]:
    """Files that are missing, too many, or of other bytes."""
    return sorted(name for name in expected.keys() | found.keys() if expected.get(name) != found.get(name))


def empty(results: Path) -> None:
    """The folder itself stays."""
    for path in results.iterdir():
        shutil.rmtree(path) if path.is_dir() else path.unlink()


def strike(results: Path, name: str, moment: float, undisturbed: dict[str, str]) -> bool:
    """One kill and the run after it. True when the kill met a run that was going."""
    empty(results)
    was_going = killed(results, name, moment)
    left = sum(len(files) for _, _, files in os.walk(results))  # jobs may still be ending
    to_the_end(results, name)
    wrong = differences(undisturbed, untimed_bytes(results))
    print(
        f"{name}: killed after {moment:6.2f} s, {left:3} files there{'' if was_going else ' (had ended)'}: "
        f"{'DIFFERS ' + ' '.join(wrong) if wrong else 'same bytes'}",
        flush=True,
    )
    if wrong:
        sys.exit(1)
    return was_going


def main(results: Path) -> int:
    """All kills."""
    options = parse()
    moments = random.Random(options.seed)
    names = options.only or ["scheme-points"]
    seconds, undisturbed = {}, {}
    for name in names:
        to_the_end(results, name)  # builds
        empty(results)
        seconds[name] = to_the_end(results, name)
        undisturbed[name] = untimed_bytes(results)
        print(f"{name}: undisturbed in {seconds[name]:.2f} s, {len(undisturbed[name])} files", flush=True)
    met = 0
    for k in range(options.kills):
        name = names[k % len(names)]
        if options.configure:
            (BUILD / "build.ninja").unlink(missing_ok=True)
        met += strike(results, name, moments.uniform(0.0, seconds[name]), undisturbed[name])
    print(f"{options.kills} kills, {met} of them while it ran: the same bytes each time")
    return 0 if met > 0 else 1


if __name__ == "__main__":
    with tempfile.TemporaryDirectory(prefix="impinge-kill-") as folder:
        sys.exit(main(Path(folder)))
