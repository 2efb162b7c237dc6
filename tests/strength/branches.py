#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""branches.py TREE [--write]: which branches of the certified core do its unit tests never take?

Builds the tests with clang's coverage in TREE, runs them, and holds what no test takes against unreached.csv: each stands there with the
reason, or the exit code is 1. --write puts new ones there without a reason."""

from __future__ import annotations

import argparse
import collections
import csv
import json
import os
import subprocess
import sys
from pathlib import Path

from make_mutants import CORE, SOURCE
from run_mutants import PROGRAMS

LISTED = Path(__file__).with_name("unreached.csv")
FIELDS = ("file", "code", "never", "reason")


def run(*words, **options) -> str:
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, errors="replace", **options)
    if done.returncode:
        sys.exit(f"{words[0]} ended with {done.returncode}: {(done.stdout + done.stderr)[-2000:]}")
    return done.stdout


def measure(tree: Path) -> dict:
    """llvm-cov's document of all tests of the core."""
    run("cmake", "--preset", "release", "-B", tree, "-DCMAKE_CXX_COMPILER=clang++", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
        "-DCMAKE_CXX_FLAGS=-w -fprofile-instr-generate -fcoverage-mapping", cwd=SOURCE)
    run("cmake", "--build", tree, "--target", *(f"test_{program}" for program in PROGRAMS))
    programs = [tree / f"tests/test_{program}" for program in PROGRAMS]
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})  # threads at the same time would lose counts
    for program in programs:
        run("env", f"LLVM_PROFILE_FILE={program}.profraw", program, "--gtest_brief=1")
    run("llvm-profdata", "merge", "-o", tree / "all.profdata", *(f"{program}.profraw" for program in programs))
    objects = [word for program in programs[1:] for word in ("-object", program)]
    return json.loads(run("llvm-cov", "export", "-skip-expansions", f"-instr-profile={tree / 'all.profdata'}", programs[0], *objects))


def unreached(document: dict) -> dict[tuple[str, str, str], int]:
    """File, code and side of each branch of the core that was never taken, and its line; and how many branches there are."""
    core = {str(path) for pattern in CORE for end in (".hpp", ".cpp") for path in (SOURCE / "libcore").glob(pattern + end)}
    taken: dict[tuple, list[int]] = collections.defaultdict(lambda: [0, 0])
    for function in document["data"][0]["functions"]:
        for branch in function.get("branches", []):
            line, column, last, end, true, false, file = branch[:7]
            name = function["filenames"][file]
            if name in core:
                # Counters lose some of what threads count at the same time: a side that is all less the other may be below 0.
                for side, count in enumerate((true, false)):
                    taken[name, line, column, last, end][side] += count if count < 1 << 62 else 0
    found = {}
    for (name, line, column, last, end), counts in sorted(taken.items()):
        lines = Path(name).read_text().splitlines()[line - 1 : last]
        code = " ".join(" ".join([*lines[:-1], lines[-1][: end - 1]])[column - 1 :].split())
        for side, count in zip(("true", "false"), counts):
            if count == 0:
                found[str(Path(name).relative_to(SOURCE)), code, side] = line
    print(f"{2 * len(taken)} sides of branches, {len(found)} never taken")
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tree", type=Path)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    found = unreached(measure(options.tree.resolve()))
    with LISTED.open(newline="") as file:
        listed = {(row["file"], row["code"], row["never"]): row["reason"] for row in csv.DictReader(file)}
    if options.write:
        with LISTED.open("w", newline="") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow(FIELDS)
            table.writerows((*key, listed.get(key, "")) for key in sorted(found))
    new = [key for key in found if not listed.get(key)]
    for file, code, side in new:
        print(f"{file}:{found[file, code, side]}: never {side}: {code}")
    for key in listed.keys() - found.keys():
        print(f"now taken: {', '.join(key)}")
    return bool(new or listed.keys() - found.keys())


if __name__ == "__main__":
    sys.exit(main())
