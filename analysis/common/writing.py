# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing text and tables."""

from pathlib import Path

import pandas as pd


def write(path: Path, text: str) -> None:
    """Writes a file whose folder may be missing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8", newline="\n")


def tabular(layout: str, head: list[str], rows: list[str]) -> str:
    """A LaTeX table in the style of the paper; lines of head and rows end in two backslashes, or are rules, which may
    begin each group of rows.
    """
    rule = "\\midrule"
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


def write_table(out: Path, name: str, table: pd.DataFrame, latex: str) -> None:
    """tables/NAME.csv for machines and tables/NAME.tex for the paper."""
    flags = table.select_dtypes(bool).columns
    table = table.assign(**{flag: table[flag].map({True: "yes", False: "no"}) for flag in flags})
    write(out / "tables" / f"{name}.csv", table.to_csv(index=False, lineterminator="\n"))
    write(out / "tables" / f"{name}.tex", latex)
