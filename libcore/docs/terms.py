# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of terms in the comments of headers.

A row is `//   name(x), other()   what they are`, and goes on in lines that are indented by eight blanks or more.
"""
import functools
import re

TERM = re.compile(r"//   +(\w+(?:\([^)]*\))?(?:, \w+(?:\([^)]*\))?)*)(?:  +(\S.*)|$)")
MORE = re.compile(r"//        +(\S.*)")
NAMED = re.compile(r"\b(?:\w+/)+\w+\.hpp\b")


@functools.cache
def terms(path):
    """What the tables of terms in the comments of a header say: name -> text."""
    found, names = {}, []
    for line in map(str.strip, path.read_text(encoding="utf-8").splitlines()):
        row, more = TERM.match(line), MORE.match(line)
        if names and more:
            found.update({name: f"{found[name]} {more[1]}".strip() for name in names})
            continue
        names = re.findall(r"(\w+)(?:\([^)]*\))?", row[1]) if row else []
        found.update({name: row[2] or "" for name in names})
    return {name: text for name, text in found.items() if text}


def all_terms(path, root):
    """Terms of a header and of those that it names; its own count more."""
    named = [root / name for name in dict.fromkeys(NAMED.findall(path.read_text(encoding="utf-8")))]
    found = {}
    for other in [other for other in named if other.is_file()] + [path]:
        found.update(terms(other))
    return found
