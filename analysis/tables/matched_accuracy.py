# SPDX-License-Identifier: GPL-3.0-or-later
# @name      matched-accuracy
# @question  Time and memory of every method at 10, 1, 0.1 and 0.01 micrometres.
# @data      error_against_time error_against_time_spread
"""What each line of settings needs for a given error: time of a query and bytes at 10, 1, 0.1 and 0.01 um, on each scene, with
Embree and the thesis' own method.

Between two settings the logarithm of time and bytes is linear in the logarithm of the error. Nothing is extrapolated: a line
whose finest setting errs more has no value; one whose coarsest setting errs less has the value of that setting.
"""

import math

import numpy as np
import pandas as pd

import common
from common import pareto

TARGETS = [10.0, 1.0, 0.1, 0.01]  # um
PEERS = {"embree": "embree_ray", "thesis": ("rsid_thesis", "usid_thesis")}  # what their lines begin with
SHOWN_LINES = 4  # fastest at each target, in the paper


def main(options) -> common.Table:
    table = pareto.load(options.results)
    table = table[pareto.competes(table)]
    lines = pd.DataFrame(
        [
            {"scene": scene, "line": line, "target_um": target, **at(group, target)}
            for (scene, line), group in table.groupby(["scene", "line"], sort=False)
            for target in TARGETS
        ]
    )
    for peer, methods in PEERS.items():
        best = (
            lines[lines.line.str.startswith(methods)]
            .groupby(["scene", "target_um"])
            .query_ns.min()
            .rename(f"{peer}_ns")
        )
        lines = lines.merge(best, on=["scene", "target_um"], how="left")
        lines[f"times_faster_than_{peer}"] = lines.pop(f"{peer}_ns") / lines.query_ns
    return lines, latex(lines)


def at(group: pd.DataFrame, target: float) -> dict[str, float]:
    """Cost of the line at an error, by the settings on its own front. A setting that is dominated by another of the same line
    does not count.
    """
    found = {}
    for cost in ("query_ns", "bytes"):
        own = group[pareto.front(group.error_um.to_numpy(), group[cost].to_numpy())]
        own = own.drop_duplicates("error_um").sort_values("error_um")
        error, value = np.log(own.error_um.clip(lower=1e-12)), np.log(own[cost])
        goal = math.log(target)
        if goal < error.iloc[0]:
            found[cost] = math.nan
        else:
            found[cost] = math.exp(np.interp(goal, error, value))
    found["bytes"] = round(found["bytes"], 0)
    return found


def latex(lines: pd.DataFrame) -> str:
    """The fastest lines at each target on one scene."""
    names = list(lines.scene.unique())
    scene = pareto.main_scene(names)
    rows = []
    for target, group in lines[lines.scene == scene].groupby("target_um", sort=False):
        best = group[np.isfinite(group.query_ns)].sort_values("query_ns").head(SHOWN_LINES)
        for k, line in enumerate(best.itertuples()):
            rows.append(
                f"{f'{target:g}' if k == 0 else ''} & {common.tex(pareto.label(line.line))} & "
                f"{common.digits(line.query_ns)} & {common.digits(line.bytes / 1024)} & "
                f"{common.digits(line.times_faster_than_embree, 2)} & "
                f"{common.digits(line.times_faster_than_thesis, 2)} \\\\"
            )
        rows.append("\\addlinespace")
    return common.tabular(
        "@{}llrrrr@{}",
        [
            " & & & & \\multicolumn{2}{c}{times faster than} \\\\",
            "\\cmidrule(l){5-6}",
            "Error, \\textmu m & Method & query, ns & memory, KiB & Embree & thesis \\\\",
        ],
        rows[:-1],
    )


common.run(main)
