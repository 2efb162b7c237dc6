# SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy on the sources of libcore/ and experiments/, a file at a time on every core.

lint.py BUILD CLANG_TIDY [--changed | FILE...] reads BUILD/compile_commands.json. With --changed it looks at the sources that
changed since a commit, and at those that include what changed, directly or not: since HEAD left the branch that the
environment names as IMPINGE_BASE, origin/main without it; on that branch itself, since HEAD's first parent. It looks at all
where .clang-tidy changed, or where the clone is too shallow to have that commit.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from ctypes.util import find_library
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = tuple(f"{ROOT}/{name}/" for name in ("libcore", "experiments"))
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion"]  # of clang, beside its checks
# Highway's files are looked at for one set of instructions at a time: those that every x86-64 has, and AVX2.
VECTORS = [["-DHWY_COMPILE_ONLY_STATIC"], ["-DHWY_COMPILE_ONLY_STATIC", "-march=haswell", "-maes", "-mpclmul"]]
MIMALLOC = find_library("mimalloc")  # with which clang is faster
ENVIRONMENT = {**os.environ, "LD_PRELOAD": MIMALLOC} if MIMALLOC else None


def commands(build: Path) -> dict[Path, list[str]]:
    """What finds headers and defines macros, for each source; those of a unity build are in the file that includes them."""
    found: dict[Path, list[str]] = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = Path(entry["directory"], entry["file"])
        unity = "/Unity/" in str(file)
        sources = [Path(name) for name in re.findall('^#include "(.*)"', file.read_text(), re.MULTILINE)] if unity else [file]
        words = shlex.split(entry["command"])
        flags = [word for word in words if word.startswith(("-I", "-D", "-std"))]
        flags += [f"-isystem{word}" for before, word in zip(words, words[1:]) if before == "-isystem"]
        found |= {source: flags for source in sources if str(source).startswith(FOLDERS)}
    return found


def git(*words: str) -> list[str] | None:
    """The lines that it says; none where it fails."""
    done = subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True, check=False)
    return None if done.returncode else done.stdout.splitlines()


def changed() -> tuple[str, set[Path] | None]:
    """Since when, and the files; none where Git does not know."""
    named = os.environ.get("IMPINGE_BASE", "")
    since = named or "origin/main"
    base, head = git("merge-base", since, "HEAD"), git("rev-parse", "HEAD")
    if named and not base:
        sys.exit(f"IMPINGE_BASE: Git finds no commit of {named} behind HEAD; fetch it, or name another")
    if not base or base == head:
        since, base = "the first parent", git("rev-parse", "--verify", "HEAD^1")
    if not base:
        return since, None
    names = (git("diff", "--name-only", base[0]) or []) + (git("ls-files", "--others", "--exclude-standard") or [])
    return since, {ROOT / name for name in names}


def behind(files: set[Path], build: Path, sources: set[Path]) -> set[Path]:
    """The sources among the files, and those that include one, directly or not."""
    texts = {*sources, *build.glob("libcore/**/generated/**/*.hpp")}
    texts.update(header for folder in FOLDERS for header in Path(folder).rglob("*.hpp"))
    includers: dict[str, list[tuple[str, Path]]] = {}  # by the name alone of what is included
    for file in texts:
        for name in re.findall(r'^#\s*include [<"](.*)[>"]', file.read_text(), re.MULTILINE):
            includers.setdefault(Path(name).name, []).append((name, file))
    left, seen = [*files], set(files)
    while left:
        header = left.pop()
        for name, file in includers.get(header.name, []):
            if file not in seen and str(header).endswith(f"/{name}"):
                seen.add(file)
                left.append(file)
    return seen & sources


def said_of(clang_tidy: str, file: Path, flags: list[str]) -> str:
    """What clang-tidy says; nothing where the file is clean."""
    words = [clang_tidy, "--quiet", f"--config-file={ROOT / '.clang-tidy'}", str(file), "--", *flags, *WARNINGS]
    done = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    return (done.stdout or done.stderr or f"{file}: clang-tidy failed\n") if done.returncode else ""


def main() -> None:
    """Exit code 1 for any warning."""
    build, clang_tidy, asked = Path(sys.argv[1]).resolve(), sys.argv[2], sys.argv[3:]
    found = commands(build)
    files, since = {Path(name).resolve() for name in asked} or set(found), ""
    if asked == ["--changed"]:
        since, files = changed()
        if files is None or ROOT / ".clang-tidy" in files:
            files = set(found)
        files = behind(files, build, set(found))
    fault = build / "fault.cpp"  # one that it must find: where it sees nothing it would call everything clean
    fault.write_text("namespace impinge {\nint* nothing() { return 0; }\n}\n")
    if "modernize-use-nullptr" not in said_of(clang_tidy, fault, ["-std=c++20"]):
        sys.exit(f"{clang_tidy} says nothing of a fault")
    runs = []
    for file in sorted(files & set(found)):
        runs += [(file, found[file] + more) for more in (VECTORS if "HWY_TARGET_INCLUDE" in file.read_text() else [[]])]
    print(f"{len({file for file, _ in runs})} files" + (f", changed since {since}, or with what they include" if since else ""), flush=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        said = [text for text in pool.map(lambda run: said_of(clang_tidy, *run), runs) if text]
    sys.exit("".join(said) or None)


if __name__ == "__main__":
    main()
