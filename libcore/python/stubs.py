#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the part of impinge/__init__.pyi that follows from the schemas of the program's documents.

    stubs.py IMPINGE             says whether the file has it; exit code 1 where it has not
    stubs.py IMPINGE --write     puts it there
"""
import json
import subprocess
import sys
import textwrap
from pathlib import Path

STUBS = Path(__file__).with_name("impinge") / "__init__.pyi"
QUESTIONS = ("limits", "volume", "measure", "resect", "orient", "certify", "report")  # methods; touch and gaps take arrays of poses
DOCUMENTS = ("touch", "gaps", "poses")  # of Joint.ask()
FIRST = {"report": ["out: str | PathLike[str]"]}  # that is no part of the request
ARRAYS = {"volume": "Volume", "resect": "Resection", "orient": "Orientation", "certify": "Certificate"}  # answers with more than JSON
MOTION = ["flexion", "abduction", "internal_rotation"]
PLAIN = {"string": "str", "integer": "int", "number": "float", "boolean": "bool"}


def camel(key):
    return "".join(word.capitalize() for word in key.split("_"))


class Dicts:
    """The text of each TypedDict, by its name."""

    def __init__(self):
        self.made = {}

    def type_of(self, schema, key, parent):
        kind = schema.get("type")
        if "enum" in schema:
            words = ", ".join(json.dumps(word) for word in schema["enum"] if word is not None)
            return f"Literal[{words}]" + (" | None" if None in schema["enum"] else "")
        if isinstance(kind, list):
            return self.type_of({**schema, "type": kind[0]}, key, parent) + " | None"
        if kind == "array":
            return f"list[{self.type_of(schema['items'], key.removesuffix('s'), parent)}]"
        if kind == "object" and parent == "ReportAnswer":  # those of its questions
            return f"{camel(key).replace('Measures', 'Measure')}Answer"
        return self.dict_of(schema, camel(key), parent) if kind == "object" else PLAIN[kind]

    def dict_of(self, schema, name, parent=""):
        properties = schema["properties"]
        if list(properties) == MOTION:
            name = "Motion"
        lines = []
        for key, of in properties.items():
            unit = f" ({of['unit']})" if of.get("unit", "1") not in ("1", "") else ""
            lines.append(f"    {key}: {self.type_of(of, key, name)}  # {of['description']}{unit}")
        body = "\n".join(lines)
        if self.made.get(name, body) != body:
            name = parent + name
        self.made[name] = body
        return name


def parts(program):
    """The text before the class Joint, and its methods."""
    dicts, methods = Dicts(), []
    for question in DOCUMENTS + QUESTIONS:
        schema = json.loads(subprocess.run([program, question, "--schema"], capture_output=True, text=True, check=True).stdout)
        answer = dicts.dict_of(schema["properties"]["answer"], f"{question.capitalize()}Answer")
        if question in DOCUMENTS:
            continue
        asked = FIRST.get(question, [])[:]
        for key, of in schema["properties"]["request"]["properties"].items():
            kind = dicts.type_of(of, key, "").replace("list[Motion]", "Motions | Sequence[str]").replace("Motion | None", "Poses | None").replace("list[str]", "str | Sequence[str]")
            asked.append(f"{key}: {'Poses' if kind == 'Motion' else kind} = ...")
        text = textwrap.fill(f'"""{schema["description"]} As `impinge {question}`; each argument and key: help().', 118, initial_indent=" " * 8,
                             subsequent_indent=" " * 8) + '"""'
        line = f"    def {question}(self{''.join(', ' + one for one in asked)}) -> {ARRAYS.get(question, answer)}:"
        if len(line) > 120:
            line = textwrap.fill(f"self, {', '.join(asked)}", 112, initial_indent=" " * 8, subsequent_indent=" " * 8, break_on_hyphens=False)
            line = f"    def {question}(\n{line}\n    ) -> {ARRAYS.get(question, answer)}:"
        methods.append(f"{line}\n{text}\n")
    return ("".join(f"class {name}(TypedDict):\n{body}\n\n" for name, body in dicts.made.items()), "".join(methods))


def replaced(text, begin, end, part):
    before, rest = text.split(begin + "\n")
    return before + begin + "\n" + part + end + rest.split(end, 1)[1]


def main(program, *options):
    text = STUBS.read_text(encoding="utf-8")
    documents, methods = parts(program)
    new = replaced(text, "# From the schemas of documents: stubs.py.", "# End of these.", documents)
    new = replaced(new, "    # From the schemas of requests: stubs.py.", "    # End of these methods.", methods)
    if "--write" in options:
        STUBS.write_text(new, encoding="utf-8")
    elif new != text:
        sys.exit(f"{STUBS} is not what {program} says; run {sys.argv[0]} {program} --write")


if __name__ == "__main__":
    main(*sys.argv[1:])
