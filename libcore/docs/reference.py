#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference of libcore, by Doxygen: `reference.py OUT` writes OUT/html.

Doxygen reads copies of the headers in which comments.py has made documentation of the comments. What it complains of,
public names without documentation above all, is printed, a line each, and the exit code is then 1.
"""
import pathlib
import re
import shutil
import subprocess
import sys

from comments import documented

HERE = pathlib.Path(__file__).resolve().parent


def copy_headers(libcore, out):
    """Writes the headers as Doxygen is to read them."""
    shutil.rmtree(out, ignore_errors=True)
    for path in sorted([*libcore.rglob("*.hpp"), *libcore.rglob("*.dox")]):
        if path.name.endswith("-inl.hpp"):  # what is compiled for each instruction set, of no use elsewhere
            continue
        is_header = path.suffix == ".hpp"
        lines = documented(path, libcore) if is_header else path.read_text(encoding="utf-8").splitlines()
        copy = out / path.relative_to(libcore)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text("\n".join(lines) + "\n", encoding="utf-8")


def run_doxygen(headers, out):
    """Writes the reference, and returns what Doxygen complains of, with paths as in the project."""
    options = {"INPUT": headers, "STRIP_FROM_PATH": headers, "STRIP_FROM_INC_PATH": headers}
    options |= {"OUTPUT_DIRECTORY": out, "WARN_LOGFILE": out / "warnings.log"}
    text = (HERE / "Doxyfile").read_text(encoding="utf-8")
    text += "".join(f'{name} = "{value}"\n' for name, value in options.items())
    shutil.rmtree(out / "html", ignore_errors=True)
    subprocess.run(["doxygen", "-"], input=text, text=True, check=True, stdout=subprocess.DEVNULL)
    warnings = (out / "warnings.log").read_text(encoding="utf-8")
    return list(dict.fromkeys(warnings.replace(f"{headers}/", "libcore/").splitlines()))


def bare_concepts(headers):
    """Concepts without documentation, of which Doxygen 1.9 does not complain."""
    for path in sorted(headers.rglob("*.hpp")):
        for bare in re.findall(
            r"(?<!\*/)\ntemplate <[^\n]*>\nconcept (\w+)", path.read_text(encoding="utf-8")
        ):
            yield f"libcore/{path.relative_to(headers)}: warning: Concept {bare} is not documented."


def main():
    out = pathlib.Path(sys.argv[1]).resolve()
    headers = out / "headers"
    copy_headers(HERE.parent, headers)
    warnings = [*run_doxygen(headers, out), *bare_concepts(headers)]
    print("\n".join(warnings) or "Every public name of libcore is documented.")
    return 1 if warnings else 0


if __name__ == "__main__":
    sys.exit(main())
