# SPDX-License-Identifier: GPL-3.0-or-later
"""A timing table of the thesis compared with ours: times, and their ratios to the thesis' own method, which can be
compared.
"""

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

import common
from common.ranges import Range, time_range


@dataclass(frozen=True)
class TimingTable:
    """What distinguishes a timing table from another."""

    artefact: str  # of the thesis
    data: str  # name of our CSV
    key: str  # its column that names the row
    row_title: str
    row_format: str  # of the key, in LaTeX


TABLE_3 = TimingTable("table-3", "sampling_time", "precision_deg", "Precision", "{:g}\\textdegree")
TABLE_4 = TimingTable("table-4", "detection_time", "triangles", "Triangles a model", "{:,.0f}")
TABLE_8 = TimingTable("table-8", "sampling_time", "precision_deg", "Precision", "{:g}\\textdegree")
TABLE_9 = TimingTable("table-9", "detection_time", "triangles", "Triangles a model", "{:,.0f}")
TABLES = (TABLE_3, TABLE_4, TABLE_8, TABLE_9)
TICK_MS = 1000 / 64  # of the clock that the thesis read: its times to fill are whole multiples, see findings
GENERATED = "generated"  # the joint of a ball and a socket, of any number of triangles
REFERENCE = "rsid"  # the thesis' name of its own method: every ratio is to it


def thesis_times(table: TimingTable) -> dict[tuple[float, str], float]:
    """The thesis' milliseconds by row and column; NaN where it prints N/A."""
    values = common.thesis(table.artefact)
    return {(common.number(v.row), v.column): common.number(v.value) for v in values.itertuples()}


def compare(results: Path, table: TimingTable) -> pd.DataFrame:
    """One row for each row of the table, joint and method of ours: thesis and measured time, and both as ratios to the
    reference. Methods without a counterpart in the thesis' table are included. Times grow with `size`: 1 / precision, or the
    number of triangles that the joint's model really has.
    """
    ours = common.load(results, table.data)
    theirs = thesis_times(table)
    column_of = {method: column for column, method in common.counterparts(table.artefact).items()}
    reference = common.counterparts(table.artefact)[REFERENCE]
    ours = ours if "joint" in ours else ours.assign(joint=GENERATED)
    times = {(row[table.key], row.joint, row.method): row for _, row in ours.iterrows()}
    lines = []
    for (key, joint, method), row in times.items():
        column = column_of.get(method, "")
        base = times.get((key, joint, reference))
        thesis_ms = theirs.get((key, column), math.nan)
        lines.append(
            {
                table.key: key,
                "joint": joint,
                "method": method,
                "size": 1 / key if table.key == "precision_deg" else row.triangles_of_both / 2,
                "thesis_column": column,
                "thesis_ms": thesis_ms,
                "measured_ms": row.median_ms,
                "iqr_ms": row.iqr_ms,
                "rounds": row.rounds,
                **({"queries": row.queries} if "queries" in row else {}),
                "extrapolated": row.extrapolated,
                "inconclusive": row.inconclusive,
                "thesis_ratio": thesis_ms / theirs.get((key, REFERENCE), math.nan),
                "measured_ratio": row.median_ms / base.median_ms if base is not None else math.nan,
            }
        )
    order = list(dict.fromkeys([*(key for key, _ in theirs), *ours[table.key], *ours.joint, *ours.method]))
    return pd.DataFrame(lines).sort_values(
        [table.key, "joint", "method"], key=lambda names: names.map(order.index), ignore_index=True
    )


def spread(line: pd.Series) -> Range:
    """The range of a time of compare(), ms."""
    return time_range(line.measured_ms, line.iqr_ms, line.rounds)


def latex(lines: pd.DataFrame, table: TimingTable) -> str:
    """Times above, ratios below; a dagger marks times that are extrapolated from a smaller run."""
    methods = list(dict.fromkeys(lines.method))
    with_thesis = set(lines.loc[lines.thesis_column != "", "method"])
    widths = [(_short(method), 2 if method in with_thesis else 1) for method in methods]
    layout, head = common.groups(table.row_title, widths)
    body = []
    for title, theirs, ours in (
        ("time, ms", "thesis_ms", "measured_ms"),
        ("relative to RSID", "thesis_ratio", "measured_ratio"),
    ):
        body += ["\\midrule", f"\\multicolumn{{{layout.count('r') + 1}}}{{@{{}}l}}{{\\itshape {title}}} \\\\"]
        for (key, joint), group in lines.groupby([table.key, "joint"], sort=False):
            cells = [row_title(table, key, joint)]
            for method in methods:
                line = group[group.method == method]
                if method in with_thesis:
                    cells.append(_printed(line[theirs]) if theirs == "thesis_ms" else _cell(line[theirs]))
                cells.append(_cell(line[ours]) + ("\\textsuperscript{\\dag}" if line.extrapolated.any() else ""))
            body.append(cells)
    return common.tabular(layout, head, body)


def row_title(table: TimingTable, key: float, joint: str) -> str:
    """The name of a row, in LaTeX."""
    return table.row_format.format(key) + ("" if joint == GENERATED else f" ({common.tex(joint.replace('_', ' '))})")


def _short(method: str) -> str:
    """A heading that fits over two columns of numbers, broken at the comma."""
    lines = common.label(method).split(", ")
    return lines[0] if len(lines) == 1 else "\\shortstack{" + "\\\\".join(lines) + "}"


def _printed(values: pd.Series) -> str:
    """The thesis' own digits, or a dash for its N/A."""
    return f"{values.iloc[0]:,.10g}" if len(values) and math.isfinite(values.iloc[0]) else "---"


def _cell(values: pd.Series) -> str:
    """A number for reading, or a dash for none."""
    return (common.digits(values.iloc[0]) if len(values) else "") or "---"


def slope(x: pd.Series, y: pd.Series) -> float:
    """Exponent b of the power law y = a x^b that fits best in logarithms; NaN for fewer than two points."""
    known = np.isfinite(y) & (y > 0)
    return float(np.polyfit(np.log(x[known]), np.log(y[known]), 1)[0]) if known.sum() > 1 else math.nan
