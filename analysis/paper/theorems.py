# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   paper/claims.md
"""The theorems, as paper/claims.md has them, so that both papers give them the same numbers.

theorem:LABEL, its number; where:thm:LABEL, the headers that rest on it and the tests that are named for it.
"""

import re
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "paper" / "claims.md"


def facts(results: Path) -> dict[str, str]:
    """Of each row of its first table."""
    found = {}
    rows = re.findall(r"^\| [^|]* \| (\d+), [^|]*\(`([\w-]+)`\) \| ([^|]*) \| ([^|]*) \|", PAGE.read_text(), re.MULTILINE)
    for number, label, headers, tests in rows:
        suite = "Theorem" + "".join(word.capitalize() for word in label.split("-"))
        names = ", ".join(re.findall(r"\[(.*?)\]", headers))
        found[f"theorem:{label}"] = number
        found[f"where:thm:{label}"] = f"In {names}. Tests: {suite}... ({tests.count('](')})."
    return found
