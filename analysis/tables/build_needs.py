# SPDX-License-Identifier: GPL-3.0-or-later
# @name      build-needs
# @question  What do a program on the core alone, one with a single question, and all of impinge need to be built and to run?
# @depends   programs/core_alone programs/one_question programs/impinge_program
# @options   --graph GRAPH
"""The targets, sources and Debian packages from which three programs are built, their size, and the size of the libraries that
they load."""

import re
import subprocess
import tempfile
from pathlib import Path

import pandas as pd

import common

PROGRAMS = {
    "core_alone": ("experiments/core_alone", "core: smallest gap, touch, sphere"),
    "one_question": ("experiments/one_question", "one question of two scans"),
    "impinge_program": ("impinge", "all of impinge"),
}
# What every C++ program on Debian has.
COMPILER = re.compile(r"lib(c\b|c6|gcc|stdc\+\+|c\+\+|m\b)|linux-libc-dev|ld-linux|linux-vdso")


def main(options) -> common.Table:
    graph = Path(options.graph).parent
    rows = pd.DataFrame([weighed(graph, name, *about) for name, about in PROGRAMS.items()])
    lines = [
        [common.tex(row.program), str(row.targets), str(row.sources), str(row.packages),
         *(common.digits(value) for value in (row.program_MB, row.loaded_MB))]
        for row in rows.itertuples()
    ]  # fmt: skip
    head = [["", "targets", "sources", "packages", "program, MB", "libraries, MB"]]
    return rows, common.tabular("@{}lrrrrr@{}", head, lines)


def weighed(graph: Path, name: str, target: str, words: str) -> dict:
    """A row: what the build knows about a program, and what the program loads."""
    build, program = graph.parent, graph / "programs" / name
    inputs = output("ninja", "-C", build, "-t", "inputs", target).split()
    objects = [file for file in inputs if file.endswith(".o")]
    read = set(re.findall(r"^    (.+)$", output("ninja", "-C", build, "-t", "deps", *objects), re.MULTILINE))
    sources = {(build / file).resolve() for file in read if file.endswith(".cpp") and "/Unity/" not in file}
    headers = sorted(file for file in read if file.startswith("/usr/include/"))
    packages = {line.split(":")[0] for line in output("dpkg", "-S", *headers).splitlines()}
    packages = sorted(package for package in packages if not COMPILER.match(package))
    return {
        "program": words,
        "targets": sum(file.endswith(".a") and file.startswith(("libcore/", "experiments/")) for file in inputs),
        "sources": len(sources),
        "packages": len(packages),
        "program_MB": stripped_bytes(program) / 1e6,
        "loaded_MB": sum(file.stat().st_size for file in loaded(program)) / 1e6,
        "names": " ".join(packages),
    }


def output(*command: str | Path) -> str:
    return subprocess.run([*map(str, command)], check=False, capture_output=True, text=True).stdout


def stripped_bytes(program: Path) -> int:
    with tempfile.NamedTemporaryFile() as copy:
        output("strip", "-o", copy.name, program)
        return Path(copy.name).stat().st_size


def loaded(program: Path) -> set[Path]:
    """Shared libraries other than the compiler's."""
    found = re.findall(r"=> (/\S+)", output("ldd", program))
    return {Path(file).resolve() for file in found if not COMPILER.match(Path(file).name)}


common.run(main, "--graph")
