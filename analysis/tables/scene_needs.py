# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scene-needs-totals
# @question  Memory and time of every scene with everything done, and with what it needs.
# @data      scene_needs_totals
"""Memory and time of every scene with everything done, and with what it needs."""

import common


def main(options) -> common.Table:
    totals = common.load(options.results, "scene_needs_totals")
    rows = totals[["scene"]].copy()
    for name in ("everything", "tables", "plan"):
        rows[f"{name}_MB"] = (totals[f"{name}_bytes"] / 1e6).map(common.digits)
        rows[f"{name}_ms"] = (totals[f"{name}_us"] / 1e3).map(common.digits)
    rows["bytes_ratio"] = totals.bytes_ratio.map(lambda value: common.digits(value, 2))
    rows["time_ratio"] = totals.time_ratio.map(lambda value: common.digits(value, 2))
    rows["same"] = totals.identical
    return rows, latex(rows)


def latex(rows) -> str:
    """Scene; memory and time of everything, of whole tables, of the plan; both ratios."""
    head = [
        r" & \multicolumn{2}{c}{everything} & \multicolumn{2}{c}{whole tables} & \multicolumn{2}{c}{plan}"
        r" & \multicolumn{2}{c}{times less} \\",
        r"scene & MB & ms & MB & ms & MB & ms & memory & time \\",
    ]
    lines = []
    for row in rows.itertuples():
        cells = [row.everything_MB, row.everything_ms, row.tables_MB, row.tables_ms, row.plan_MB, row.plan_ms]
        lines.append([common.tex(row.scene), *cells, row.bytes_ratio, row.time_ratio])
    return common.tabular("lrrrrrrrr", head, lines)


common.run(main)
