# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing text and tables."""

from collections.abc import Iterable
from pathlib import Path

import pandas as pd


def write(path: Path, text: str) -> None:
    """Writes a file whose folder may be missing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8", newline="\n")


def tabular(layout: str, head: list[str | list[str]], rows: list[str | list[str]]) -> str:
    """A LaTeX table in the style of the paper; a line of head and rows is a list of cells, or text that ends in two
    backslashes, or a rule, which may begin each group of rows.
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
    """The rows, with a rule before each group that begins alike; only the first of a group says how."""
    lines, before = [], None
    for first, *rest in rows:
        if first != before:
            lines.append("\\midrule")
        lines.append(["" if first == before else first, *rest])
        before = first
    return lines


def groups(first: str, widths: list[tuple[str, int]]) -> tuple[str, list[str | list[str]]]:
    """Layout and head of a table with a column `first` and under each title one column, ours, or two, the thesis' and ours."""
    spans, rules, titles, column = [], "", [], 2
    for title, width in widths:
        spans.append(f"\\multicolumn{{{width}}}{{c}}{{{title}}}")
        rules += f"\\cmidrule(lr){{{column}-{column + width - 1}}}"
        titles.append("thesis & here" if width == 2 else "here")
        column += width
    return f"@{{}}l{'r' * (column - 2)}@{{}}", [["", *spans], rules, [first, *titles]]


def write_table(out: Path, name: str, table: pd.DataFrame, latex: str) -> None:
    """tables/NAME.csv for machines and tables/NAME.tex for the paper."""
    flags = table.select_dtypes(bool).columns
    table = table.assign(**{flag: table[flag].map({True: "yes", False: "no"}) for flag in flags})
    write(out / "tables" / f"{name}.csv", table.to_csv(index=False, lineterminator="\n"))
    write(out / "tables" / f"{name}.tex", latex)
