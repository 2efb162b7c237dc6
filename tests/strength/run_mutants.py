#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""run_mutants.py BUILD TREE NUMBER [--seed S]: so many mutants of the certified core, drawn at random, against its unit tests.

make_mutants.py makes a copy of the project with all mutants in TREE, where it is built once.

A mutant is killed if a test fails, crashes or takes too long. Those that no test reaches and those that all tests pass survive; a survivor
that cannot change an answer stands in equivalent.csv with the reason. Exit code 1 if fewer than 95 % of the others are killed.
TREE/result.csv has them all."""

from __future__ import annotations

import argparse
import concurrent.futures
import csv
import dataclasses
import json
import os
import random
import subprocess
import sys
import tempfile
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
class Tests:
    """Those of a program, the quick ones first: what they reach without a mutant, and their seconds."""

    program: Path
    reached: set[int]
    parts: list[tuple[str, float]]  # filter and seconds


def tests_of(tree: Path, name: str) -> Tests:
    program = tree / f"build/release/tests/test_{name}"
    with tempfile.TemporaryDirectory() as folder:
        reached, said = Path(folder) / "reached", Path(folder) / "said.json"
        done = subprocess.run([program, f"--gtest_output=json:{said}"], env=os.environ | {"IMPINGE_REACHED": str(reached)}, capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"{name} fails without a mutant: {done.stdout[-400:]}")
        suites = json.loads(said.read_text())["testsuites"]
        seconds = {f"{suite['name']}.{test['name']}": float(test["time"].rstrip("s")) for suite in suites for test in suite["testsuite"]}
        quick = [test for test, time in seconds.items() if time < QUICK]
        slow = sorted(seconds.keys() - quick, key=seconds.get)
        parts = [(":".join(quick), sum(seconds[test] for test in quick)), *((test, seconds[test]) for test in slow)]
        return Tests(program, {int(line) for line in reached.read_text().split()}, parts)


def killer(mutant: int, programs: list[Tests]) -> str:
    """The test that fails, or nothing."""
    for tests in programs:
        for names, seconds in tests.parts:
            try:
                done = subprocess.run([tests.program, "--gtest_fail_fast", "--gtest_brief=1", f"--gtest_filter={names}"], env=os.environ | {"IMPINGE_MUTANT": str(mutant)},
                                      capture_output=True, text=True, errors="replace", timeout=20 + 5 * seconds)
            except subprocess.TimeoutExpired:
                return f"{tests.program.name} out of time"
            if done.returncode:
                failed = [line for line in done.stdout.splitlines() if line.startswith("[  FAILED  ]")]
                return failed[0].split()[3].rstrip(",") if failed else f"{tests.program.name} ended"
    return ""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("tree", type=Path)
    parser.add_argument("number", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    tree = options.tree.resolve()
    make(options.build, tree)
    with (tree / "mutants.csv").open() as file:
        mutants = list(csv.DictReader(file))
    with (Path(__file__).parent / "equivalent.csv").open() as file:
        argued = {(row["file"], row["kind"], row["original"]) for row in csv.DictReader(file)}
    drawn = random.Random(options.seed).sample(range(len(mutants)), min(options.number, len(mutants)))
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        all_tests = list(pool.map(lambda name: tests_of(tree, name), PROGRAMS))

        def attempt(k: int) -> str:
            own = mutants[k]["file"].split("/")[1]
            by = killer(k, sorted((tests for tests in all_tests if k in tests.reached), key=lambda tests: not tests.program.name.endswith(own)))
            print(f"{k} {mutants[k]['file']}:{mutants[k]['line']} {by or 'alive'}", flush=True)
            return by

        killers = dict(zip(drawn, pool.map(attempt, drawn)))
    killed, alive, equal = [], [], []
    with (tree / "result.csv").open("w", newline="") as file:
        table = csv.DictWriter(file, [*mutants[0], "killed_by", "fate"], lineterminator="\n")
        table.writeheader()
        for k in sorted(drawn):
            row = mutants[k]
            fate = "killed" if killers[k] else "equivalent" if (row["file"], row["kind"], row["original"]) in argued else "survived"
            {"killed": killed, "equivalent": equal, "survived": alive}[fate].append(k)
            table.writerow(row | {"killed_by": killers[k], "fate": fate if any(k in tests.reached for tests in all_tests) or killers[k] else f"{fate}, not reached"})
            if fate == "survived":
                print(f"survived: {row['file']}:{row['line']}: {row['kind']}: {row['original']}")
    share = len(killed) / max(1, len(killed) + len(alive))
    print(f"{len(drawn)} of {len(mutants)} mutants: {len(killed)} killed, {len(equal)} argued equivalent, {len(alive)} survived: {100 * share:.1f} %")
    return share < WANTED


if __name__ == "__main__":
    sys.exit(main())
