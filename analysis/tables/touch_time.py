# SPDX-License-Identifier: GPL-3.0-or-later
# @name      touch-time
# @question  How long does it take to know whether bones touch in a pose, ours beside FCL?
# @data      touch_time
"""Time of a pose by joint, kind of poses and whether they touch: a column per method, and our rate relative to FCL's."""

import common

OURS = "body_pairs"
KEYS = ["joint", "faces", "poses", "state"]


def main(options) -> common.Table:
    data = common.load(options.results, "touch_time")
    data["us"] = 1e3 * data.median_ms
    times = data.pivot(index=KEYS, columns="method", values="us")
    methods = [method for method in data.method.unique() if method != OURS]
    table = times[[OURS, *methods]].rename(columns=lambda method: f"{method}_us").reset_index()
    ours = data[data.method == OURS].set_index(KEYS)
    table = table.join(ours[["count", "rate_over_fcl"]], on=KEYS)
    head = ["joint", "faces", "poses", "state", *(rf"{common.tex(common.label(method))}, \textmu s" for method in [OURS, *methods]),
            "rate over FCL"]
    lines = [
        [common.tex(row[0]), f"{row[1]:,}", row[2], row[3], *(common.digits(value, 2) for value in row[4 : 5 + len(methods)]),
         common.digits(row[-1], 2)]
        for row in table.itertuples(index=False)
    ]
    return table, common.tabular("@{}lrll" + "r" * (len(methods) + 2) + "@{}", [" & ".join(head) + r" \\"], common.ruled(lines))


common.run(main)
