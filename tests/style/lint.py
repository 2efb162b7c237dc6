# SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy on every source of libcore/ and experiments/, many in one translation unit.

lint.py BUILD CLANG_TIDY [FILE...] reads BUILD/compile_commands.json. Most of a unit's time goes into the headers that it
includes, which are the same again and again: so files of all targets share units, as long as they include the same kind of
library and give no name twice outside of functions. A name that this does not see is an error of the compiler, and then the
unit is parted.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
from ctypes.util import find_library
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OTHERS = re.compile(r"#include [<\"](?:python|CGAL|fcl|ode|bt|benchmark|embree|assimp|CLI|gsl)")  # large headers that few include
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion"]  # of clang, beside its checks
LARGEST = 100  # files in a unit
# Highway's files, once for each set of instructions that they tell apart on x86-64: none, AVX2, AVX-512.
VECTORS = ["vectors", "vectors -march=haswell -maes -mpclmul", "vectors -march=skylake-avx512"]
MIMALLOC = find_library("mimalloc")  # with which clang is faster
ENVIRONMENT = {**os.environ, "LD_PRELOAD": MIMALLOC} if MIMALLOC else None


def flags_of(entry: dict) -> list[str]:
    """What finds headers and defines macros, paths absolute."""
    words = shlex.split(entry["command"])
    flags = []
    for word, following in zip(words, [*words[1:], ""]):
        if word == "-isystem":
            flags.append(f"-isystem{following}")
        elif word.startswith(("-I", "-D", "-isystem/", "-std")):
            flags.append(word)
    return flags


def sources_of(entry: dict) -> list[Path]:
    """The file, or those of a unity build's."""
    file = Path(entry["directory"], entry["file"])
    if "/Unity/" not in str(file):
        return [file]
    return [Path(name) for name in re.findall(r'^#include "(.*)"', file.read_text(), re.MULTILINE)]


def names_in(text: str) -> set[str]:
    """What a second file must not declare outside of functions and classes: lines at the margin, as clang-format leaves them.

    A function's name has its parameters, as others overload it. Members are defined once.
    """
    lines = re.findall(r"^(?![#/}{]|(?:namespace|using namespace|template)\b|using [\w:]+;|[\w:<> ]+\(\);)\S.*", text, re.MULTILINE)
    found = (re.match(r"[^(={;]*?((?:::)?\w+)(?: final)?(?: : .*)?(?:<.*>)?\s*(?:\[.*\])?\s*(?:[={;]|(\(.*))", line) for line in lines)
    names = (match.groups(default="") for match in found if match)
    return {name + parameters for name, parameters in names if not name.startswith("::")}


def is_program(text: str) -> bool:
    """Whether the file gives nothing to others."""
    return bool(re.search(r"^int main\(", text, re.MULTILINE)) and "\nnamespace impinge" not in text


class Unit:
    """Files for one run of clang-tidy."""

    def __init__(self, kind: str):
        self.kind = kind
        self.files: list[Path] = []
        self.flags: dict[str, str] = {}  # by what they define, or themselves
        self.names: set[str] = set()

    def takes(self, kind: str, names: set[str]) -> bool:
        return self.kind == kind and len(self.files) < LARGEST and not self.names & names

    def add(self, file: Path, flags: list[str], names: set[str]) -> None:
        self.files.append(file)
        self.names |= names
        for flag in flags:
            self.flags.setdefault(flag.split("=")[0], flag)


def units(build: Path, only: set[Path]) -> list[Unit]:
    """Every file is in one of them, those of Highway in one for each set; or every one of these files."""
    made: list[Unit] = []
    seen: set[Path] = set()
    folders = tuple(f"{top}/{name}/" for top in (ROOT, build) for name in ("libcore", "experiments", "analysis/joint3d/engine"))
    for entry in json.loads((build / "compile_commands.json").read_text()):
        for file in sources_of(entry):
            if file in seen or not str(file).startswith(folders) or (only and file not in only):
                continue
            seen.add(file)
            text = file.read_text()
            names = names_in(text)
            kinds = ["others" if OTHERS.search(text) else "ours"]
            if "HWY_TARGET_INCLUDE" in text:
                kinds = VECTORS
            elif is_program(text):
                kinds, names = ["programs"], set()
            for kind in kinds:
                unit = next((unit for unit in made if unit.takes(kind, names)), None)
                if unit is None:
                    unit = Unit(kind)
                    made.append(unit)
                unit.add(file, flags_of(entry), names)
    return made


def text_of(unit: Unit) -> str:
    """One translation unit. Programs get a namespace each, behind the headers of all."""
    if unit.kind != "programs":
        before = "#define HWY_COMPILE_ONLY_STATIC\n" * (unit.kind in VECTORS)
        return before + "".join(f'#include "{file}"\n' for file in unit.files)
    headers = [line for file in unit.files for line in re.findall("^#include .*", file.read_text(), re.MULTILINE)]
    programs = [f'namespace program_{k} {{\n#define main(...) main_{k}(__VA_ARGS__)\n#include "{file}"\n#undef main\n}}' for k, file in enumerate(unit.files)]
    return "\n".join([*dict.fromkeys(headers), *programs, ""])


def is_clean(unit: Unit, at: Path, clang_tidy: list[str]) -> bool:
    """Prints what clang-tidy says."""
    at.write_text(text_of(unit))
    mains = ",".join(["main", *(f"main_{k}" for k in range(LARGEST))])
    settings = (ROOT / ".clang-tidy").read_text()
    settings += f"  - {{ key: bugprone-exception-escape.FunctionsThatShouldNotThrow, value: '{mains}' }}\n"
    words = [*clang_tidy, "--quiet", f"--config={settings}", str(at), "--", *unit.flags.values(), *WARNINGS, *unit.kind.split()[1:]]
    done = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    errors = re.findall(".*clang-diagnostic-error.*", done.stdout) if done.returncode and len(unit.files) > 1 else []
    if errors:
        print(f"{at.name} does not compile as one:\n" + "\n".join(errors))
        named = {Path(error.split(":")[0]) for error in errors}
        parts = [Unit(unit.kind), Unit(unit.kind)]  # those that it names, and the others; where that parts nothing, halves
        parted = 0 < len(named & {*unit.files}) < len(unit.files)
        for k, file in enumerate(unit.files):
            parts[file in named if parted else 2 * k // len(unit.files)].add(file, list(unit.flags.values()), set())
        return all([is_clean(part, at.with_name(f"{at.stem}_{k}.cpp"), clang_tidy) for k, part in enumerate(parts)])
    print(done.stdout, end="", flush=True)
    return done.returncode == 0


def finds_a_fault(at: Path, clang_tidy: list[str]) -> bool:
    """Whether it says something of a fault, and not nothing of anything."""
    at.write_text("#include <vector>\nnamespace impinge {\nint* nothing() { return 0; }\n}\n")
    words = [*clang_tidy, "--quiet", f"--config-file={ROOT / '.clang-tidy'}", str(at), "--", "-std=c++20"]
    return "modernize-use-nullptr" in subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True, check=False).stdout


def main() -> None:
    """Exit code 1 for any warning."""
    build, clang_tidy = Path(sys.argv[1]).resolve(), [sys.argv[2]]
    own_code = build / "tests" / "style" / "own_code.so"
    if own_code.exists():
        clang_tidy.append(f"--load={own_code}")
    only = {Path(name).resolve() for name in sys.argv[3:]}
    made = sorted(units(build, only), key=lambda unit: -len(unit.files))
    folder = build / "lint"
    folder.mkdir(exist_ok=True)
    if not finds_a_fault(folder / "fault.cpp", clang_tidy):
        sys.exit(f"{' '.join(clang_tidy)} says nothing of a fault: is tests/style/own_code.cpp made for this clang-tidy?")
    print(f"{len({file for unit in made for file in unit.files})} files in {len(made)} units")
    sys.exit(not all([is_clean(unit, folder / f"unit_{k}.cpp", clang_tidy) for k, unit in enumerate(made)]))


if __name__ == "__main__":
    main()
