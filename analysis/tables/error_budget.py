# SPDX-License-Identifier: GPL-3.0-or-later
# @name      error-budget
# @question  What each stage adds to the error of a gap of the generated pair.
# @data      error_budget
# @options   --data error_budget --name NAME
# @name      error-budget-bones
# @question  What each stage adds to the error of a gap of each real joint.
# @data      error_budget_bones
# @options   --data error_budget_bones --name NAME
# @when      JOINTS
"""The error budget of a gap, stage by stage, for the thesis' RSID table stored in 16 bits: root mean square and largest
error of each stage, their sum, and the error of the resulting gap.
"""

import math

import pandas as pd

import common

SCHEME = "rsid"  # the thesis' own
STORAGE = "uint16"  # so that every stage has its part
STAGES = ["mesh", "mesh_estimate", "centre", "table", "arithmetic", "storage", "sum", "total"]


def main(options) -> common.Table:
    data = common.load(options.results, options.data)
    chosen = ((data.scheme == SCHEME) & (data.storage == STORAGE)) | (data.stage == "mesh_estimate")
    data = data[chosen]
    lines = []
    for joint in data.joint.unique():
        own = data[data.joint == joint]
        estimate = own[own.stage == "mesh_estimate"].set_index("stage")
        for precision, group in own.groupby("precision_deg", sort=False):
            stages = pd.concat([group.set_index("stage"), estimate])
            line = {"joint": joint, "precision_deg": precision, "vertices": int(group.vertices.max())}
            for stage in STAGES:
                for kind in ("rms_um", "max_um"):
                    line[f"{stage}_{kind}"] = stages[kind].get(stage, math.nan)
            lines.append(line)
    table = pd.DataFrame(lines)
    return table, latex(table)


def cell(line: dict, stage: str) -> str:
    """rms and largest error in one cell; an estimate of the mesh replaces an unknown one."""
    estimated = stage == "mesh" and math.isnan(line["mesh_max_um"])
    source = "mesh_estimate" if estimated else stage
    rms, largest = (common.digits(line[f"{source}_{kind}"], 2) for kind in ("rms_um", "max_um"))
    mark = r"$\approx$" if estimated else ""
    return f"{mark}{rms} / {largest}"


def latex(table: pd.DataFrame) -> str:
    """One line per joint and precision: rms / largest of each stage, micrometres."""
    shown = {
        "mesh": "mesh",
        "centre": "centre",
        "table": "table",
        "storage": "storage",
        "sum": "sum",
        "total": "measured",
    }
    rows = [
        f"{common.tex(line['joint'].replace('_', ' '))} & {line['precision_deg']:g}\\textdegree & "
        + " & ".join(cell(line, stage) for stage in shown)
        + r" \\"
        for line in table.to_dict("records")
    ]
    return common.tabular(f"@{{}}ll{'r' * len(shown)}@{{}}", [["Joint", "Precision", *shown.values()]], rows)


common.run(main, "--data", "--name")
