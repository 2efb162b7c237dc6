#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the lists of the README.md beside this file: options from each command's --help, keys from the schemas of its documents.

    reference.py IMPINGE             says whether the page has them; exit code 1 where it has not
    reference.py IMPINGE --write     puts them there
"""
import json
import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).with_name("README.md")
QUESTIONS = ("gaps", "touch", "poses", "limits", "volume", "resect", "orient", "measure", "certify", "report")
TOOLS = ("check", "hip", "cohort")
OPTIONS = ("option", "what", "default")
BEGIN, END = "<!-- From impinge: reference.py -->\n", "<!-- End -->\n"


def said(program, *words):
    return subprocess.run([program, *words], capture_output=True, text=True, check=True).stdout


def cell(text):
    return text.replace("|", "\\|")


def table(head, rows):
    return f"| {' | '.join(head)} |\n|{' --- |' * len(head)}\n" + "".join(f"| {' | '.join(map(cell, row))} |\n" for row in rows)


def options(help_text):
    """Reads --help: for each heading its options, each with type, text and the default, which stands in []."""
    groups, rows = {}, None
    for line in help_text.splitlines():
        if re.fullmatch(r"[A-Z][\w ]*:", line):
            rows = groups.setdefault(line[:-1], [])
        elif rows is None or not line.startswith("  "):
            continue
        elif not line.startswith("   "):  # a new one; its text stands from column 30 on, or on the next line
            name, text = (line[2:30], line[30:]) if re.match(r"(?!.*\w:).{29} \S", line) or "  " in line[2:] else (line[2:], "")
            rows.append([re.sub(r" (Needs|REQUIRED)\b.*| \.\.\.", "", name).strip(), text.strip()])
        else:
            rows[-1][1] = f"{rows[-1][1]} {line.strip()}".strip()
    for rows in groups.values():
        rows[:] = [split(*row) for row in rows if "--help" not in row[0]]
    return groups


def split(name, text):
    """A row of name and type, text, and default."""
    default = re.search(r" ?\[([^][]*)\]$", text)
    text = text[: default.start()] if default else text
    name, _, given = re.sub(r":\S*| in$", "", name).partition("=") if "=VALUE" not in name else (name, "", "")
    return f"`{name}`", text, default.group(1) if default else given


UNITS = {"mm": "_mm", "deg": "_deg", "mm^2": "_mm2", "mm^3": "_mm3", "deg^2": "_deg2", "bytes": "_bytes", "1": ""}


class Keys:
    """Lists the keys of objects in the order of a schema. Keys that were listed before are only referred to."""

    def __init__(self):
        self.told = {}

    def rows(self, schema, of_command, before=""):
        for key, of in schema["properties"].items():
            kinds = of["type"] if isinstance(of.get("type"), list) else [of.get("type")]
            inner = of["items"] if "array" in kinds else of
            name = before + key + ("[]" if "array" in kinds and "properties" in inner else "")
            text = of["description"]
            if any(word not in text for word in of.get("enum", []) if word):
                text += f": {', '.join(word for word in of['enum'] if word)}"
            if not key.endswith(UNITS.get(of.get("unit"), "")):
                text += f" ({of['unit']})"
            keys = json.dumps(inner.get("properties"))
            if keys in self.told:
                at, by = self.told[keys]
                text += f"; keys as of `{at}`" + (f" of {by}" if by != of_command else "")
            yield f"`{name}`", text
            if "properties" in inner and keys not in self.told:
                self.told[keys] = name, of_command
                yield from self.rows(inner, of_command, name + ".")


def lists(program):
    """The lists for all questions, and for each one."""
    keys, text, joint, common = Keys(), "", {}, ""
    for command in QUESTIONS:
        schema = json.loads(said(program, command, "--schema"))
        groups = options(said(program, command, "--help"))
        common = common or table(OPTIONS, groups["Positionals"] + groups["The joint"] + groups["The answer"])
        joint = schema["properties"]["joint"]
        text += f"### `impinge {command}`\n\n{schema['description']}\n\n"
        if "The question" in groups:
            text += table(OPTIONS, groups["The question"]) + "\n"
        answer = schema["properties"]["answer"]
        keys.told[json.dumps(answer["properties"])] = "answer", command
        text += table(("key of `answer`", "what"), keys.rows(answer, command)) + "\n"
    for command in TOOLS:
        told = said(program, command, "--help")
        groups = options(told)
        text += f"### `impinge {command}`\n\n{told.splitlines()[0]}\n\n{table(OPTIONS, groups.get('Positionals', []) + groups['Options'])}\n"
    return common, f"{text}### `joint` of every document\n\n" + table(("key of `joint`", "what"), Keys().rows(joint, "joint"))


def main(program, *words):
    text = PAGE.read_text(encoding="utf-8")
    told = iter(lists(program))
    new = re.sub(f"{BEGIN}.*?{END}", lambda _: f"{BEGIN}\n{next(told)}\n{END}", text, flags=re.DOTALL)
    if "--write" in words:
        PAGE.write_text(new, encoding="utf-8")
    elif new != text:
        sys.exit(f"{PAGE} is not what {program} says; run {sys.argv[0]} {program} --write")


if __name__ == "__main__":
    main(*sys.argv[1:])
