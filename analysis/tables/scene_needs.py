# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scene-needs-totals
# @question  Memory and time of every scene with whole tables, and with what it needs.
# @data      scene_needs_totals
"""Memory and time of every scene with whole tables, and with what it needs."""

import common


def main(options) -> common.Table:
    totals = common.load(options.results, "scene_needs_totals")
    rows = totals[["scene"]].copy()
    for name in ("tables", "needed"):
        rows[f"{name}_MB"] = totals[f"{name}_bytes"] / 1e6
        rows[f"{name}_ms"] = totals[f"{name}_us"] / 1e3
    for name, unit in (("bytes_ratio", "bytes"), ("time_ratio", "us")):
        rows[name] = totals[f"tables_{unit}"] / totals[f"needed_{unit}"]
    head = [
        r" & \multicolumn{2}{c}{whole tables} & \multicolumn{2}{c}{needed} & \multicolumn{2}{c}{times less} \\",
        r"scene & MB & ms & MB & ms & memory & time \\",
    ]
    lines = [
        [common.tex(scene), *map(common.digits, cells), *(common.digits(ratio, 2) for ratio in ratios)]
        for scene, *cells, in_bytes, in_time in rows.itertuples(index=False)
        for ratios in [(in_bytes, in_time)]
    ]
    return rows, common.tabular("lrrrrrr", head, lines)


common.run(main)
