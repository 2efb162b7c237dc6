#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is claimed: the theorems of paper/proofs.tex, the headers that say "Theorem n (label)", the tests whose suite is named
TheoremLabel, and the rounding constants with their Gappa scripts. Without an option it checks that none of these is without
the others, and that paper/claims.md says so. --write writes that page, the constants as a table of the papers (paper/rounding.tex)
and the numbers in the headers; --gappa proves the scripts."""

import csv
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "paper/claims.md"
TABLE = ROOT / "paper/rounding.tex"
THEOREM = re.compile(r"\\begin\{theorem\}\[(.*?)\]\\label\{thm:(.*?)\}\n((?:%@ .*\n)*)")
CITED = re.compile(r"Theorem (\d+) \(([\w-]+)\)")
TEST = re.compile(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+), (\w+)\)", re.M)
CASES = re.compile(r"(?:std::(min|max)<std::size_t>\()?(\d+ \* )?random_cases\(\)(?! / [(a-z])(?: / ([\d']+))?(?:, ([\d']+)\))?")
# What allows for rounding: a small number, or one in units of the last place.
SMALL = re.compile(r"constexpr (?:double|float) (k\w+) =\s*([^;]*(?:\de-\d|0x1p-)[^;]*);")
ROOMS = ("sphere", "table", "gap", "contact", "limits")


class Claims:
    def __init__(self):
        self.wrong = []
        self.theorems = {}  # by label: number, title, claim, data, show
        for number, (title, label, said) in enumerate(THEOREM.findall((ROOT / "paper/proofs.tex").read_text()), 1):
            told = dict(line[3:].split(": ", 1) for line in said.splitlines())
            self.theorems[label] = {"number": number, "title": title, **told}
        self.suites = {"Theorem" + "".join(word.capitalize() for word in label.split("-")): label for label in self.theorems}
        self.tests = {label: [] for label in self.theorems}
        self.headers = {label: [] for label in self.theorems}
        self.sources = {path: path.read_text() for path in sorted((ROOT / "libcore").rglob("*.[ch]pp"))}
        for path in sorted((ROOT / "tests").glob("*/*_test.cpp")):
            self.read_tests(path)
        for path, text in self.sources.items():
            self.read_header(path, text)
        known = "\n".join(path.read_text() for path in (ROOT / "experiments").rglob("*.[ch]pp")) + "\n".join(self.sources.values())
        names = "\n".join(path.read_text() for path in (ROOT / "analysis").glob("[tf]*/*.py"))
        for label, told in self.theorems.items():
            missing = [what for what in ("claim", "data", "show") if what not in told]
            missing += [what for what, found in (("header", self.headers), ("test", self.tests)) if not found[label]]
            self.wrong += [f"theorem {label} of paper/proofs.tex has no {what}" for what in missing]
            file, *columns = re.findall(r"`(.*?)`", told.get("data", "``"))
            stem = file.removesuffix(".csv")
            gone = [one for one in columns if f'"{one}"' not in known] + [file] * (f'"{file}"' not in known and not re.search(rf"\b{stem}\b", known))
            command = told.get("show", "").split()
            if command[:1] == ["impinge"] and not (ROOT / f"libcore/command/{command[1]}.cpp").exists():
                gone.append(told["show"])
            if "--only" in command and not re.search(rf"@name +{command[-1]}$", names, re.M):
                gone.append(told["show"])
            self.wrong += [f"theorem {label} of paper/proofs.tex names {one}, which there is not" for one in gone]
        self.read_constants()

    def read_tests(self, path):
        text, before = path.read_text(), 0
        for found in TEST.finditer(text):
            suite, name = found.groups()
            label = max((label for start, label in self.suites.items() if suite.startswith(start)), key=len, default=None)
            if label:
                end = text.find("\n}\n", found.end())
                self.tests[label].append((path, f"{suite}.{name}", cases(text[before:end])))
            elif suite.startswith("Theorem") or (suite.endswith("Attack") and (ROOT / "libcore" / path.parent.name).exists()):
                self.wrong.append(f"{path.relative_to(ROOT)}: {suite} attacks no theorem of paper/proofs.tex; name it for one")
            before = text.find("\n}\n", found.end())

    def read_header(self, path, text):
        for number, label in CITED.findall(text):
            if label not in self.theorems:
                self.wrong.append(f"{path.relative_to(ROOT)}: there is no theorem {label} in paper/proofs.tex")
                continue
            self.headers[label].append(path)
            if int(number) != self.theorems[label]["number"]:
                self.wrong.append(f"{path.relative_to(ROOT)}: {label} is Theorem {self.theorems[label]['number']}")

    def read_constants(self):
        """Each small constant is in a script, or among those that say what stands in for one."""
        self.scripts = {path: script(path) for path in sorted((ROOT / "libcore").rglob("*.gappa"))}
        self.rest = list(csv.reader((ROOT / "tests/style/not_by_gappa.csv").read_text().splitlines()[2:]))
        told = {(where, name) for _, rows in self.scripts.items() for name, where, *_ in rows}
        told |= {(where, name) for where, name, _ in self.rest}
        there = {(str(path.relative_to(ROOT / "libcore")), name): value for path, text in self.sources.items()
                 if path.relative_to(ROOT / "libcore").parts[0] in ROOMS for name, value in SMALL.findall(text)}
        self.wrong += [f"libcore/{where}: {name} is in no Gappa script and not in tests/style/not_by_gappa.csv"
                       for where, name in sorted(set(there) - told)]
        self.wrong += [f"libcore/{where} has no constant {name}" for where, name in sorted(told - set(there)) if name.startswith("k")]
        for path, rows in self.scripts.items():
            self.wrong += [f"{path.relative_to(ROOT)}: {name} is {there[where, name]}, not what the script says" for name, where, proven, *_ in rows
                           if (where, name) in there and in_words(there[where, name]) not in proven]

    def page(self):
        lines = ["# What is claimed", "", "[README.md](README.md) leads along a row. `ctest --preset release -R Theorem` runs all tests. Cases: those of `tests/run`, and at",
                 "night; of a test without a number it says itself what it tries.", "",
                 f"Made by `{Path(__file__).relative_to(ROOT)} --write` from [proofs.tex](proofs.tex), the headers that name a theorem, and the tests that",
                 "are named for one; the test `style.claims` fails where a claim has no test, a test no claim, or this page is old.", "",
                 "| claim | theorem | headers | tests: cases | data | command |", "| --- | --- | --- | --- | --- | --- |"]
        for label, told in self.theorems.items():
            headers = ", ".join(link(path) for path in dict.fromkeys(self.headers[label]))
            tests = "<br>".join(f"[{name}](../{path.relative_to(ROOT)}): {tried}" if tried else f"[{name}](../{path.relative_to(ROOT)})"
                                for path, name, tried in self.tests[label])
            lines.append(f"| {told['claim']} | {told['number']}, {told['title']} (`{label}`) | {headers} | {tests} | {told['data']} | `{told['show']}` |")
        lines += ["", "## Rounding", "", "Constants that allow for rounding. `--gappa` proves the scripts, which stand beside the headers. u = 2^-53, e = 2^-24. The largest error ever",
                  "seen is that of `tests/limits/rounding_test.cpp` in a million random cases; - where a constant is made of others.", "",
                  "| constant | script | proven | assumed | largest seen |", "| --- | --- | --- | --- | --- |"]
        for path, rows in self.scripts.items():
            lines += [f"| `{name}` | {link(path)} | {cell(proven)} | {cell(assumed)} | {seen} |" for name, _, proven, assumed, seen in rows]
        lines += ["", "What Gappa does not close, and what stands in for it:", "", "| constant | header | what stands in |", "| --- | --- | --- |"]
        lines += [f"| `{name}` | {link(ROOT / 'libcore' / where)} | {why} |" for where, name, why in self.rest]
        return "\n".join(lines) + "\n"

    def table(self):
        """The constants with a script, those of sphere/ and table/ in the paper that has the theorems on tables."""
        rows = {True: [], False: []}
        for path, said in self.scripts.items():
            for name, _, *told in said:
                row = " & ".join([f"\\texttt{{{latex(name)}}} ({latex(path.stem)})", *map(latex, told)]) + r" \\"
                rows[path.relative_to(ROOT / "libcore").parts[0] in ("sphere", "table")].append(row)
        lines = ["% SPDX-License-Identifier: GPL-3.0-or-later", f"% Made by {Path(__file__).relative_to(ROOT)} --write.",
                 r"\iftables\newcommand{\roundingrows}{%", *dict.fromkeys(rows[True]),
                 r"}\else\newcommand{\roundingrows}{%", *dict.fromkeys(rows[False]), r"}\fi"]
        return "\n".join(lines) + "\n"

    def write(self):
        for path, text in self.sources.items():
            new = CITED.sub(lambda found: f"Theorem {self.theorems[found[2]]['number']} ({found[2]})" if found[2] in self.theorems else found[0], text)
            if new != text:
                path.write_text(new)
        PAGE.write_text(self.page())
        TABLE.write_text(self.table())


def cell(text):
    return text.replace("|", "\\|")


def latex(text):
    """LaTeX of what a script says in plain text: powers, roots, lower indices, names."""
    number = lambda found: "$" + found[1] * (found[1] != "1") + r"\cdot" * (found[1] != "1") + f"{ {'e': 10, 'b': 2}[found[2]]}^{{{found[3]}}}$"
    text = re.sub(r"\b([\d.]+)([eb])(-\d+)", number, re.sub(r"[&%#_]", r"\\\g<0>", text))
    text = re.sub(r"(?<=\b[a-z]|\|)\\_(\w)\b", r"$_\1$", re.sub(r"(?<=[\w)|])\^(-?\w+)", r"$^{\1}$", text))
    return re.sub(r"the theorem `(\w+)`", r"Theorem~\\ref{thm:\1}", re.sub(r"root (\d)", r"$\\sqrt\1$", text).replace("<=", r"$\le$"))


def link(path):
    return f"[{path.parent.name}/{path.name}](../{path.relative_to(ROOT)})"


def cases(text):
    """How many random cases are tried by day and at night, as the code says; nothing where it does not."""
    asked = "\n".join(line for line in text.splitlines() if "EXPECT" not in line)
    found = [tuple(tried(count, *one) for count in (1000, 100000)) for one in CASES.findall(asked)]
    return "{:,} to {:,}".format(*max(found)) if found else ""


def tried(count, bound, times, over, limit):
    count = count * int(times.strip(" *") or 1) // int(over.replace("'", "") or 1)
    return {"min": min, "max": max}[bound](count, int(limit.replace("'", ""))) if bound and limit else count


def in_words(value):
    """20.0 * 0x1p-53 is 20 u; 0x1p-28 is 2^-28."""
    units = re.search(r"([\d.]+?)(?:\.0)? \* 0x1p-(53|24)", value)
    return units[1] + {"53": " u", "24": " e"}[units[2]] if units else value.strip("F").replace("0x1p", "2^")


def script(path):
    """The rows at the head of a script: constant; where; proven; assumed; seen."""
    return [[part.strip() for part in line[2:].split(";;")] for line in path.read_text().splitlines() if line.startswith("#;")]


def main():
    claims = Claims()
    if sys.argv[1:] == ["--write"]:
        claims.write()
        claims = Claims()
    if sys.argv[1:] == ["--gappa"]:
        for path in claims.scripts:
            done = subprocess.run(["gappa", "-Eprecision=150", "-Echange-threshold=0.001", "-Eno-auto-dichotomy", str(path)], capture_output=True, text=True)
            if done.returncode or "failed" in done.stderr.lower() or not claims.scripts[path]:
                claims.wrong.append(f"{path.relative_to(ROOT)}: {done.stderr.strip() or 'it names no constant'}")
    elif PAGE.read_text() != claims.page() or TABLE.read_text() != claims.table():
        claims.wrong.append(f"paper/claims.md or paper/rounding.tex is old: {Path(__file__).relative_to(ROOT)} --write")
    sys.exit("\n".join(claims.wrong) or None)


if __name__ == "__main__":
    main()
