# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes text and tables."""

import io
import json
import re
from collections.abc import Iterable
from pathlib import Path

import pandas as pd

from common.sidecars import digest


def write(path: Path, text: str) -> None:
    """Writes a file; makes its folder if it is missing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8", newline="\n")


def tabular(layout: str, head: list[str | list[str]], rows: list[str | list[str]]) -> str:
    """A LaTeX table in the style of the paper. Each line of head and rows is a list of cells, or text that ends in two
    backslashes, or a rule, which may begin a group of rows.
    """
    rule = "\\midrule"
    head, rows = (
        [line if isinstance(line, str) else " & ".join(line) + " \\\\" for line in lines] for lines in (head, rows)
    )
    return "\n".join(
        [
            f"\\begin{{tabular}}{{{layout}}}",
            "\\toprule",
            *head,
            *([] if rows[:1] == [rule] else [rule]),
            *rows,
            "\\bottomrule",
            "\\end{tabular}",
            "",
        ]
    )


def ruled(rows: Iterable[list[str]]) -> list[str | list[str]]:
    """The rows, with a rule before each group of rows whose keys begin alike; only the first row of a group shows them."""
    lines, before = [], None
    for first, *rest in rows:
        if first != before:
            lines.append("\\midrule")
        lines.append(["" if first == before else first, *rest])
        before = first
    return lines


def groups(first: str, widths: list[tuple[str, int]]) -> tuple[str, list[str | list[str]]]:
    """Layout and head of a table: a column `first`, and under each title one column, ours, or two, the thesis' and ours."""
    spans, rules, titles, column = [], "", [], 2
    for title, width in widths:
        spans.append(f"\\multicolumn{{{width}}}{{c}}{{{title}}}")
        rules += f"\\cmidrule(lr){{{column}-{column + width - 1}}}"
        titles.append("thesis & here" if width == 2 else "here")
        column += width
    return f"@{{}}l{'r' * (column - 2)}@{{}}", [["", *spans], rules, [first, *titles]]


# What the end of a column's name says of its unit; without one a number has the unit 1, and a word none.
UNITS = {
    "deg": "deg", "mm": "mm", "mm2": "mm^2", "mm3": "mm^3", "um": "um", "nm": "nm", "s": "s", "ms": "ms", "us": "us", "ns": "ns",
    "mib": "MiB", "KiB": "KiB", "MB": "MB", "kB": "kB", "bytes": "byte", "percent": "percent", "hours": "h", "mpa": "MPa",
}  # fmt: skip
NUMBER = re.compile(r"[<>~*†]?\s?-?\d[\d,]*(\.\d+)?(e[+-]?\d+)?\s?[%*†]?")


def unit_of(name: str, column: pd.Series) -> str:
    """The unit of a column of a table that was read again."""
    if not pd.api.types.is_numeric_dtype(column):
        return ""
    words = name.replace(",", " ").replace("_", " ").split()
    return next((UNITS[word] for word in reversed(words) if word in UNITS), "1")


def columns_of(name: str, text: str) -> list[dict[str, str]]:
    """Names and units of the columns that pandas reads in a table. Raises ValueError if numbers are written as text, with
    separators, signs or units.
    """
    table = pd.read_csv(io.StringIO(text))
    for column in table.select_dtypes(object):
        cells = table[column].dropna().astype(str)
        if column != "unit" and (bad := [cell for cell in cells if NUMBER.fullmatch(cell)]):
            raise ValueError(f"tables/{name}.csv: column {column} holds {bad[0]!r} among words: write numbers alone, and words beside them")
    return [{"name": column, "unit": unit_of(column, table[column])} for column in table.columns]


def write_table(out: Path, name: str, question: str, table: pd.DataFrame, latex: str) -> None:
    """Writes tables/NAME.csv for machines, its sidecar with units, and tables/NAME.tex for the paper."""
    flags = table.select_dtypes(bool).columns
    table = table.assign(**{flag: table[flag].map({True: "yes", False: "no"}) for flag in flags})
    text = table.to_csv(index=False, lineterminator="\n")
    record = {"question": question, "columns": columns_of(name, text), "csv_sha256": digest(text.encode())}
    write(out / "tables" / f"{name}.csv", text)
    write(out / "tables" / f"{name}.json", json.dumps(record, indent=2) + "\n")
    write(out / "tables" / f"{name}.tex", latex)
