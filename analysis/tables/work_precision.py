# SPDX-License-Identifier: GPL-3.0-or-later
# @data      all_gaps
# @name      work-precision
# @question  Error, bound, bytes and times of every method of all gaps, both scans, and from how many poses on it pays.
# @options   --name NAME
# @name      ablation
# @question  What do vector instructions, float, 16 bits, the layout and the mask each bring?
# @options   --name NAME
"""Error against time for all gaps, in numbers, and the gain from each part of the kernel."""

import numpy as np
import pandas as pd

import common
from common import work_precision

COLUMNS = "scene line method setting precision_deg error_um anywhere_um bound_um bytes single_ns pose_us build_ms".split()


def main(options) -> common.Table:
    if options.name == "ablation":
        steps = work_precision.ablation(options.results)
        return steps, latex(steps)
    rows = work_precision.load(options.results)
    trees = rows[rows.line == "Embree"].sort_values("thousand").drop_duplicates("scene").set_index("scene")
    rows["pays_from_poses"] = [work_precision.pays_from(row, trees.loc[row.scene]) for row in rows.itertuples()]
    rows["pays_from_poses"] = rows.pays_from_poses.replace(np.inf, np.nan)
    table = rows[[*COLUMNS, "pays_from_poses"]]
    lines = [
        [common.tex(f"{row.scene}, {row.line}"), common.tex(row.setting), *(common.digits(value, 3) for value in (row.error_um, row.bound_um, row.pose_us, row.build_ms))]
        for row in table.itertuples()
    ]
    return table, common.tabular("@{}llrrrr@{}", [r" & & µm & bound, µm & µs a pose & ms to build \\"], lines)


def latex(steps: pd.DataFrame) -> str:
    """A line per step."""
    lines = [
        [common.tex(row.step), *(common.digits(value, 3) for value in (row.pose_us, row.times, row.error_um, row.KiB))]
        for row in steps.itertuples()
    ]
    return common.tabular("@{}lrrrr@{}", [r" & µs a pose & $\times$ & µm & KiB \\"], lines)


common.run(main, "--name")
