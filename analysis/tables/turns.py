# SPDX-License-Identifier: GPL-3.0-or-later
# @name      turns-by-method
# @question  Who misses the first meeting of two features or meshes in a turn, who finds a false one, and in what time?
# @data      turns turn_time
"""The test set of turns (experiments/28_turns): misses, false hits and microseconds, for our methods and others."""

import pandas as pd

import common

KEY = ["kind", "method", "setting"]
COUNTS = ["queries", "meet", "missed", "false_hits", "early", "undecided"]
LARGEST = ["largest_late_rad", "largest_early_rad"]
KINDS = ["vertex_face", "edge_edge", "face_face", "mesh"]


def main(options) -> common.Table:
    turns, times = (common.load(options.results, name) for name in ("turns", "turn_time"))
    for table in (turns, times):
        table["setting"] = table.setting.fillna("")
    rows = turns.groupby(KEY, sort=False).agg({**dict.fromkeys(COUNTS, "sum"), **dict.fromkeys(LARGEST, "max")}).reset_index()
    rows = rows.merge(times[[*KEY, "building_us", "typical_us", "median_us"]], on=KEY)
    rows["kind"] = pd.Categorical(rows.kind, KINDS, ordered=True)
    rows = rows.sort_values("kind", kind="stable", ignore_index=True).astype({"kind": str})
    rows["method"] = rows.method.map(common.label)
    return rows, latex(rows)


def latex(rows: pd.DataFrame) -> str:
    """A line per kind, method and setting."""
    lines = [
        [
            common.tex(row.kind.replace("_", " and ")),
            common.tex(f"{row.method}, {row.setting}" if row.setting else row.method),
            f"{row.missed} of {row.meet}",
            f"{row.false_hits} of {row.queries - row.meet}",
            str(row.early),
            common.digits(row.largest_late_rad, 2),
            common.digits(row.largest_early_rad, 2),
            common.digits(row.typical_us, 2),
            common.digits(row.median_us, 2),
        ]
        for row in rows.itertuples()
    ]
    head = [
        r" & & & & too & latest, & earliest, & \multicolumn{2}{c}{$\mu$s a query} \\",
        r"features & method & missed & false & early & rad & rad & median & mean \\",
    ]
    return common.tabular("@{}llrrrrrrr@{}", head, common.ruled(lines))


common.run(main)
