#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""run_mutants.py BUILD TREE NUMBER [--seed S]: so many mutants of the certified core, drawn at random, against its unit tests.

make_mutants.py makes a copy of the project with all mutants in TREE, where it is built once.

A mutant is killed if a test fails, crashes or takes too long. Those that no test reaches and those that all tests pass survive; a survivor
that cannot change an answer stands in equivalent.csv with the reason, and is run only if --only names it: no test would end it early.
Exit code 1 if fewer than 95 % of the others are killed. TREE/result.csv has them all."""

from __future__ import annotations

import argparse
import collections
import concurrent.futures
import csv
import dataclasses
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PROGRAMS = ("sphere", "gap", "contact", "limits", "rotations", "change")
WANTED = 0.95
QUICK = 1.0  # seconds: slower tests run one by one, after the others


def make(build: Path, tree: Path) -> None:
    """The copy with its mutants, and its tests."""
    here = Path(__file__).resolve().parent
    flags = f"-std=c++20 -w -include {tree / 'tests/strength/mutants.hpp'}"
    for words in ([sys.executable, here / "make_mutants.py", build, tree],
                  ["cmake", "--preset", "release", f"-DCMAKE_CXX_FLAGS={flags}"],
                  ["cmake", "--build", "--preset", "release", "--target", *(f"test_{program}" for program in PROGRAMS)]):
        done = subprocess.run(words, cwd=tree if tree.exists() else None, capture_output=True, text=True)
        if done.returncode:
            sys.exit((done.stdout + done.stderr)[-2000:])


@dataclasses.dataclass
class Test:
    name: str
    seconds: float
    reached: set[int]  # the mutants whose place it runs


@dataclasses.dataclass
class Tests:
    """Those of a program."""

    program: Path
    tests: list[Test]

    def quick(self, mutant: int) -> tuple[list[str], float]:
        """Those quick ones that reach a mutant, to be run together, and their seconds."""
        those = [test for test in self.tests if mutant in test.reached and test.seconds < QUICK]
        return [test.name for test in those], sum(test.seconds for test in those)

    def slow(self, mutant: int) -> list[tuple[list[str], float]]:
        return [([test.name], test.seconds) for test in self.tests if mutant in test.reached and test.seconds >= QUICK]


def tests_of(tree: Path, name: str) -> Tests:
    """Each test runs by itself, without a mutant, to say what it reaches."""
    program = tree / f"build/release/tests/test_{name}"
    suite, tests = "", []
    for line in subprocess.run([program, "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout.splitlines():
        word = line.split("#")[0].strip()
        if not line.startswith(" "):
            suite = word
            continue
        with tempfile.TemporaryDirectory() as folder:
            reached, start = Path(folder) / "reached", time.monotonic()
            done = subprocess.run([program, f"--gtest_filter={suite}{word}"], env=os.environ | {"IMPINGE_REACHED": str(reached)}, capture_output=True, text=True)
            if done.returncode:
                sys.exit(f"{name} fails without a mutant: {done.stdout[-400:]}")
            numbers = {int(number) for number in reached.read_text().split()} if reached.exists() else set()
            tests.append(Test(suite + word, time.monotonic() - start, numbers))
    return Tests(program, tests)


def killer(mutant: int, programs: list[Tests]) -> str:
    """The test that fails, or nothing. All quick tests come before the slow ones."""
    quick = [(tests, *tests.quick(mutant)) for tests in programs]
    slow = [(tests, *part) for tests in programs for part in tests.slow(mutant)]
    for tests, names, seconds in [part for part in quick if part[1]] + sorted(slow, key=lambda part: part[2]):
        # Seconds of the processor, since the machine may be busy; and not so much memory that others lack it.
        limits = ["prlimit", f"--cpu={10 + 3 * int(seconds)}", f"--as={4 << 30}"]
        done = subprocess.run([*limits, tests.program, "--gtest_fail_fast", "--gtest_brief=1", f"--gtest_filter={':'.join(names)}"],
                              env=os.environ | {"IMPINGE_MUTANT": str(mutant)}, capture_output=True, text=True, errors="replace")
        if done.returncode:
            failed = [line for line in done.stdout.splitlines() if line.startswith("[  FAILED  ]")]
            ended = "out of time" if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL) else "ended"
            return failed[0].split()[3].rstrip(",") if failed else f"{tests.program.name} {ended}"
    return ""


def argued_equivalent(mutants: list[dict[str, str]]) -> set[int]:
    """A row of equivalent.csv is about the nth mutant of its file with that kind and original."""
    with (Path(__file__).parent / "equivalent.csv").open() as file:
        rows = {(row["file"], row["kind"], row["original"], int(row["nth"])) for row in csv.DictReader(file)}
    found, count = set(), collections.Counter()
    for k, row in enumerate(mutants):
        place = row["file"], row["kind"], row["original"]
        count[place] += 1
        if (*place, count[place]) in rows:
            found.add(k)
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("tree", type=Path)
    parser.add_argument("number", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", type=int, nargs="+", metavar="MUTANT", help="these numbers, none at random")
    parser.add_argument("--built", action="store_true", help="TREE is as an earlier run left it")
    options = parser.parse_args()
    tree = options.tree.resolve()
    if not options.built:
        make(options.build, tree)
    with (tree / "mutants.csv").open() as file:
        mutants = list(csv.DictReader(file))
    argued = argued_equivalent(mutants)
    drawn = random.Random(options.seed).sample(range(len(mutants)), min(options.number, len(mutants)))
    if options.only:
        drawn = options.only
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        all_tests = list(pool.map(lambda name: tests_of(tree, name), PROGRAMS))

        def attempt(k: int) -> str:
            own = mutants[k]["file"].split("/")[1]
            by = killer(k, sorted(all_tests, key=lambda tests: not tests.program.name.endswith(own)))
            print(f"{k} {mutants[k]['file']}:{mutants[k]['line']} {by or 'alive'}", flush=True)
            return by

        tried = [k for k in drawn if options.only or k not in argued]
        killers = dict.fromkeys(drawn, "") | dict(zip(tried, pool.map(attempt, tried)))
    killed, alive, equal = [], [], []
    with (tree / "result.csv").open("w", newline="") as file:
        table = csv.DictWriter(file, [*mutants[0], "killed_by", "fate"], lineterminator="\n")
        table.writeheader()
        for k in sorted(drawn):
            row = mutants[k]
            fate = "killed" if killers[k] else "equivalent" if k in argued else "survived"
            {"killed": killed, "equivalent": equal, "survived": alive}[fate].append(k)
            table.writerow(row | {"killed_by": killers[k], "fate": fate if killers[k] or any(k in test.reached for tests in all_tests for test in tests.tests) else f"{fate}, not reached"})
            if fate == "survived":
                print(f"survived: {row['file']}:{row['line']}: {row['kind']}: {row['original']}")
    share = len(killed) / max(1, len(killed) + len(alive))
    print(f"{len(drawn)} of {len(mutants)} mutants: {len(killed)} killed, {len(equal)} argued equivalent, {len(alive)} survived: {100 * share:.1f} %")
    return share < WANTED


if __name__ == "__main__":
    sys.exit(main())
