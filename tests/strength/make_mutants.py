#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_mutants.py BUILD TREE: copies the project to TREE and puts mutants into the certified core of the copy.

All mutants are in one build, and IMPINGE_MUTANT=N switches on the N-th (mutants.hpp). TREE/mutants.csv lists them. A mutant is one
change of an expression: a comparison that is flipped, or includes its border where it did not; a slack that is dropped; a sum that
becomes a difference; the smaller of two for the larger; a condition that is negated; arguments of one type that are swapped.
BUILD has the compile_commands.json of the optimised build, from which clang reads each source (python3-clang)."""

from __future__ import annotations

import csv
import dataclasses
import json
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from clang.cindex import Cursor, CursorKind, Index, TypeKind

SOURCE = Path(__file__).resolve().parents[2]
# Signs, verdicts, contact, limits, cells of rotations, and proofs of clearance.
CORE = """sphere/orientation sphere/plane_side sphere/face_plane sphere/expansion gap/certified_gap gap/exact_side gap/measured_gap
 gap/face_overlay gap/overlay contact/* limits/* rotations/*""".split()
FLIPPED = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "==": "!=", "!=": "=="}
BORDER = {"<": "<=", ">": ">=", "<=": "<", ">=": ">"}
SLACK = re.compile(r"slack|ulp|rounding|epsilon|kU\b|kRound|widen|margin|kError|error|allow|sagitta|1e-|0x1p-", re.I)
NUMBERS = {TypeKind.DOUBLE, TypeKind.FLOAT, TypeKind.INT, TypeKind.LONG, TypeKind.LONGLONG, TypeKind.UINT, TypeKind.ULONG}
INTEGERS = NUMBERS - {TypeKind.DOUBLE, TypeKind.FLOAT}


@dataclasses.dataclass
class Place:
    """An expression, and the parts of it that may hold others: spans in bytes of the file."""

    begin: int
    end: int
    kind: str
    parts: list[tuple[int, int]]
    mutated: str  # with {0}, {1} for the parts
    line: int


def kind_of(cursor: Cursor) -> CursorKind | None:
    """None for what these bindings do not know."""
    try:
        return cursor.kind
    except ValueError:
        return None


def span(cursor: Cursor) -> tuple[int, int]:
    return cursor.extent.start.offset, cursor.extent.end.offset


class File:
    def __init__(self, path: Path):
        self.path = path
        self.text = path.read_bytes()
        self.places: dict[tuple, Place] = {}

    def said(self, begin: int, end: int) -> str:
        return self.text[begin:end].decode()

    def add(self, cursor: Cursor, kind: str, parts: list[tuple[int, int]], mutated: str) -> None:
        begin, end = span(cursor)
        self.places.setdefault((begin, end, kind), Place(begin, end, kind, parts, mutated, cursor.extent.start.line))

    def binary(self, cursor: Cursor) -> None:
        left, right = (span(child) for child in cursor.get_children())
        between = self.said(left[1], right[0])
        sign = re.sub(r"//.*|\s", "", between)
        kinds = [child.type.get_canonical().kind for child in cursor.get_children()]
        parts = [left, right]
        if sign in FLIPPED:
            self.add(cursor, "flip", parts, f"({{0}}) {FLIPPED[sign]} ({{1}})")
            zero = "0" in (self.said(*left), self.said(*right)) or "0.0" in (self.said(*left), self.said(*right))
            if sign in BORDER and (zero or any(kind in INTEGERS for kind in kinds)):
                self.add(cursor, "border", parts, f"({{0}}) {BORDER[sign]} ({{1}})")
        elif sign in ("+", "-", "*") and all(kind in NUMBERS for kind in kinds):
            slack = [bool(SLACK.search(self.said(*part))) for part in parts]
            if slack == [False, True] or (slack == [True, False] and sign != "-"):
                self.add(cursor, "slack", parts, f"({{{slack.index(False)}}})")
            elif sign != "*":
                self.add(cursor, "sign", parts, f"({{0}}) {'-' if sign == '+' else '+'} ({{1}})")

    def call(self, cursor: Cursor) -> None:
        begin, end = span(cursor)
        said = self.said(begin, end)
        arguments = list(cursor.get_arguments())
        spans = [span(argument) for argument in arguments]
        if any(part[0] <= begin or part[1] > end or part[0] >= part[1] for part in spans):
            return
        declared = re.search(r"\w\s+[&*]?$", self.said(max(0, begin - 40), begin).replace("return ", "(")) or ".insert(" in said
        least = re.match(r"std::(min|max)\(", said)
        if least and len(arguments) == 2:
            other = {"min": "max", "max": "min"}[least[1]]
            self.add(cursor, "least", spans, f"std::{other}({{0}}, {{1}})")
        elif re.match(r"[\w:.>()\[\]-]+\($", self.said(begin, spans[0][0]) if spans else "") and not declared:
            for k in range(len(arguments) - 1):
                types = [argument.type.get_canonical().spelling for argument in arguments[k : k + 2]]
                if types[0] and types[0] == types[1] and self.said(*spans[k]) != self.said(*spans[k + 1]):
                    head, middle, tail = self.said(begin, spans[k][0]), self.said(spans[k][1], spans[k + 1][0]), self.said(spans[k + 1][1], end)
                    if "{" in head + tail or "//" in said:
                        continue
                    self.add(cursor, "swap", spans[k : k + 2], f"{head}{{1}}{middle}{{0}}{tail}")
                    break

    def condition(self, cursor: Cursor) -> None:
        test = next(iter(cursor.get_children()), None)
        while test is not None and kind_of(test) == CursorKind.UNEXPOSED_EXPR and len(list(test.get_children())) == 1:
            test = next(iter(test.get_children()))
        if test is not None and kind_of(test) in (CursorKind.CALL_EXPR, CursorKind.MEMBER_REF_EXPR, CursorKind.DECL_REF_EXPR) and re.search(r"[\w)]$", self.said(*span(test))):
            self.add(test, "negate", [span(test)], "!bool({0})")

    def visit(self, cursor: Cursor) -> None:
        children = list(cursor.get_children())
        if kind_of(cursor) == CursorKind.BINARY_OPERATOR and len(children) == 2:
            self.binary(cursor)
        elif kind_of(cursor) == CursorKind.CALL_EXPR:
            self.call(cursor)
        elif kind_of(cursor) == CursorKind.IF_STMT:
            self.condition(cursor)


def walk(cursor: Cursor, files: dict[str, File], file: File | None = None) -> None:
    """Every expression of the core's files once; what a macro made, or stands in a declaration of types, is left out."""
    for child in cursor.get_children():
        where = child.location.file
        of = files.get(where.name) if where else None
        if kind_of(cursor) == CursorKind.TRANSLATION_UNIT and of is None:
            continue
        if kind_of(child) in (CursorKind.STATIC_ASSERT, CursorKind.TYPE_ALIAS_DECL):
            continue
        if of is not None:
            begin, end = span(child)
            if child.extent.start.file and child.extent.start.file.name == where.name and begin < end:
                try:
                    of.visit(child)
                except UnicodeDecodeError:
                    pass
        walk(child, files, of)


def render(file: File, begin: int, end: int, places: list[tuple[int, Place]]) -> str:
    """The text of a span with its mutants, the outermost first."""
    inside = [(number, place) for number, place in places if begin <= place.begin and place.end <= end]
    text, at = [], begin
    while inside:
        first = min(inside, key=lambda item: (item[1].begin, -item[1].end))[1]
        here = [item for item in inside if (item[1].begin, item[1].end) == (first.begin, first.end)]
        number, place = here[0]
        rest = [item for item in inside if item is not here[0] and item[1].end <= first.end]
        text.append(file.said(at, first.begin))
        parts = [render(file, *part, [item for item in rest if (item[1].begin, item[1].end) != (first.begin, first.end)]) for part in place.parts]
        original, position = "", first.begin
        for part, said in zip(place.parts, parts):
            original += file.said(position, part[0]) + said
            position = part[1]
        original += file.said(position, first.end)
        choice = f"({original})" if place.kind != "negate" else f"bool({original})"
        for number, place in here:
            choice = f"(mutants::on({number}) ? {place.mutated.format(*parts)} : {choice})"
        text.append(choice)
        at = first.end
        inside = [item for item in inside if item[1].begin >= first.end]
    text.append(file.said(at, end))
    return "".join(text)


def chosen(places: list[Place]) -> list[Place]:
    """Those that can stand together: not across one another, and at most three deep, since each doubles the text of its parts."""
    kept: list[Place] = []
    for place in sorted(places, key=lambda p: (p.end - p.begin, p.begin)):
        inner = [k for k in kept if place.begin <= k.begin and k.end <= place.end and (k.begin, k.end) != (place.begin, place.end)]
        across = any(k.begin < place.begin < k.end < place.end or place.begin < k.begin < place.end < k.end for k in kept)
        held = all(any(part[0] <= k.begin and k.end <= part[1] for part in place.parts) for k in inner)
        same = all(k.parts == place.parts for k in kept if (k.begin, k.end) == (place.begin, place.end))
        if not across and held and same and len(inner) <= 4:
            kept.append(place)
    return sorted(kept, key=lambda p: (p.begin, p.end))


def main() -> None:
    build, tree = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    core = [path for pattern in CORE for end in (".hpp", ".cpp") for path in sorted((SOURCE / "libcore").glob(pattern + end))]
    files = {str(path): File(path) for path in core}
    commands = [shlex.split(entry["command"]) for entry in json.loads((build / "compile_commands.json").read_text())]
    folders = {word for words in commands for word in words if word.startswith("-I") and "/libcore" in word}
    flags = ["-std=c++20", "-isystem", "/usr/include/eigen3", "-I", str(SOURCE / "libcore"), *sorted(folders)]
    index = Index.create()
    for path in core:
        if path.suffix == ".cpp" or not path.with_suffix(".cpp").exists():
            unit = index.parse(str(path), args=["-x", "c++", *flags])
            serious = [d.spelling for d in unit.diagnostics if d.severity >= 3]
            if serious:
                sys.exit(f"{path}: {serious[0]}")
            walk(unit.cursor, files)
    shutil.rmtree(tree, ignore_errors=True)
    for name in subprocess.run(["git", "-C", SOURCE, "ls-files"], check=True, capture_output=True, text=True).stdout.splitlines():
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(SOURCE / name, tree / name)
    number = 0
    with (tree / "mutants.csv").open("w", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(("mutant", "file", "line", "kind", "original", "mutated"))
        for path, file in files.items():
            name = Path(path).relative_to(SOURCE)
            places = list(enumerate(chosen(list(file.places.values())), number))
            number += len(places)
            for k, place in places:
                parts = [" ".join(file.said(*part).split()) for part in place.parts]
                table.writerow((k, name, place.line, place.kind, " ".join(file.said(place.begin, place.end).split()), " ".join(place.mutated.format(*parts).split())))
            (tree / name).write_text(render(file, 0, len(file.text), places))
    print(f"{number} mutants in {len(files)} files")


if __name__ == "__main__":
    main()
