#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""turns.py make FOLDER [--seed N] [--pairs N] [--meshes N]: the test set (README.md).
turns.py score FOLDER ANSWERS.csv [--tolerance RAD]: what answers miss. Columns: query, angle_rad (empty: none) and, if given,
microseconds."""
import argparse
import csv
import random
import statistics
from pathlib import Path

from exact import angle
from pairs import LARGEST, pairs

POINTS = [f"{of}{k}_{x}" for of in "ab" for k in range(3) for x in "xyz"]
HEAD = ["query", "kind", "family", "axis_x", "axis_y", "axis_z", "largest_rad", "first_rad"]


def exponent(points):
    """Of the power of two by which coordinates are divided, so that the largest is 16 to 32."""
    return max(abs(c) for x in points for c in x).bit_length() - 5


def number(c, e):
    """The double c / 2^e, exactly, in as few digits as hold it."""
    x = float(c) / 2.0 ** e
    assert int(x * 2.0 ** e) == c
    return repr(int(x)) if x == int(x) else repr(x)


def head(query, kind, of):
    first = "" if of["first"] is None else f'{angle(of["axis"], of["first"]):f}'
    return [query, kind, of["family"], *of["axis"], LARGEST, first]


def write_pairs(folder, seed, count):
    with open(folder / "pairs.csv", "w", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(HEAD + POINTS)
        for k, of in enumerate(pairs(random.Random(seed), count)):
            e = exponent(of["a"] + of["b"])
            cells = []
            for points in (of["a"], of["b"]):
                cells += [number(c, e) for x in points for c in x] + [""] * (9 - 3 * len(points))
            rows.writerow(head(f"pair{k:05}", of["kind"], of) + cells)


def write_off(path, mesh, e):
    lines = ["OFF", f'{len(mesh["vertices"])} {len(mesh["faces"])} 0']
    lines += [" ".join(number(c, e) for c in x) for x in mesh["vertices"]]
    lines += [f"3 {a} {b} {c}" for a, b, c in mesh["faces"]]
    path.write_text("\n".join(lines) + "\n")


def write_meshes(folder, seed, count):
    from meshes import meshes
    (folder / "meshes").mkdir(exist_ok=True)
    with open(folder / "meshes.csv", "w", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(HEAD + ["turning", "resting"])
        for k, of in enumerate(meshes(random.Random(seed), count)):
            e = exponent(of["a"]["vertices"] + of["b"]["vertices"])
            names = [f"meshes/{k:03}_{what}.off" for what in ("turning", "resting")]
            for name, mesh in zip(names, (of["a"], of["b"])):
                write_off(folder / name, mesh, e)
            rows.writerow(head(f"mesh{k:03}", "mesh", of) + names)


def queries(folder):
    for name in ("pairs.csv", "meshes.csv"):
        with open(folder / name, newline="") as file:
            yield from csv.DictReader(file)


def score(folder, answers, tolerance):
    """A row for each kind and family that was answered."""
    with open(answers, newline="") as file:
        given = {row["query"]: row for row in csv.DictReader(file)}
    groups = {}
    for query in queries(folder):
        if query["query"] in given:
            groups.setdefault((query["kind"], query["family"]), []).append((query, given[query["query"]]))
    print("kind,family,queries,misses,false_hits,early,largest_late_rad,largest_early_rad,median_us")
    for (kind, family), rows in sorted(groups.items()):
        both = [(float(a["angle_rad"]) - float(q["first_rad"])) for q, a in rows if q["first_rad"] and a["angle_rad"]]
        missed = sum(bool(q["first_rad"]) and not a["angle_rad"] for q, a in rows) + sum(d > tolerance for d in both)
        false = sum(not q["first_rad"] and bool(a["angle_rad"]) for q, a in rows)
        times = [float(a["microseconds"]) for _, a in rows if a.get("microseconds")]
        print(kind, family, len(rows), missed, false, sum(d < -tolerance for d in both), f"{max([0.0, *both]):.3g}",
              f"{max([0.0, *(-d for d in both)]):.3g}", f"{statistics.median(times):.3g}" if times else "", sep=",")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    make = commands.add_parser("make")
    make.add_argument("folder", type=Path)
    for name, default in (("seed", 1), ("pairs", 10_000), ("meshes", 200)):
        make.add_argument(f"--{name}", type=int, default=default)
    judge = commands.add_parser("score")
    judge.add_argument("folder", type=Path)
    judge.add_argument("answers", type=Path)
    judge.add_argument("--tolerance", type=float, default=1e-6)
    asked = parser.parse_args()
    if asked.command == "score":
        return score(asked.folder, asked.answers, asked.tolerance)
    asked.folder.mkdir(parents=True, exist_ok=True)
    write_pairs(asked.folder, asked.seed, asked.pairs)
    write_meshes(asked.folder, asked.seed, asked.meshes)


if __name__ == "__main__":
    main()
