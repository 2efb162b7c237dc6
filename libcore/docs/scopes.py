# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the declarations of a C++ header are: those of its namespaces, classes and enumerations."""
import re

SCOPE = re.compile(r"\s*(?:extern\b|(?:inline )?namespace\b|(?:friend )?(?:class|struct|union|enum)\b)")
LABEL = re.compile(r"\s*(?:public|protected|private):")
TEMPLATE = re.compile(r"template\s*<(?:[^<>]|<[^<>]*>)*>")


def code_of(line):
    """The line without its comment; strings and characters are a 0."""
    code = re.sub(
        r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'|//.*', lambda m: "" if m[0][0] == "/" else "0", line
    )
    return "" if code.startswith("#") else LABEL.sub("", code)


class Scopes:
    """Those that are open while a header is read."""

    def __init__(self):
        self.open = ["scope"]
        self.statement = ""

    def between(self):
        """Is this a place between declarations?"""
        return self.open[-1] in ("scope", "enum") and not self.statement.strip()

    def read(self, code):
        """Goes on over a line."""
        for k, c in enumerate(code):
            if c in "([":
                self.open.append("parenthesis")
            elif c in ")]":
                self.open.pop()
            elif c == "{":
                self.begin()
            elif c == "}":
                self.end(code[k + 1 :].lstrip())
            elif c == ";" and self.open[-1] == "scope":
                self.statement = ""
            if self.open[-1] == "scope" and c not in ";{}":
                self.statement += c
        self.statement += " "

    def begin(self):
        """A namespace, class or enumeration is a scope; what else braces hold is a body."""
        plain = TEMPLATE.sub("", self.statement)
        if self.open[-1] != "scope" or not SCOPE.match(plain) or "=" in plain:
            self.open.append("body")
            return
        self.open.append("enum" if "enum" in plain else "scope")
        self.statement = ""

    def end(self, rest):
        """A function ends with its body, an initialiser goes on."""
        ended = self.open.pop()
        if ended != "body" or (self.open[-1] == "scope" and rest[:1] not in (";", ",", "{", ")")):
            self.statement = ""


def declarations(lines):
    """First and last line of every declaration; of a namespace, class or enumeration those of its opening."""
    scopes = Scopes()
    first = None
    for k, line in enumerate(lines):
        code = code_of(line)
        begins = scopes.between() and code.strip(" ;") and code.strip()[0] != "}"
        scopes.read(code)
        if begins:
            first = k
        if first is not None and scopes.between():
            yield first, k
            first = None
