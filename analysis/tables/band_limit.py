# SPDX-License-Identifier: GPL-3.0-or-later
# @name      slice-band-limit
# @question  Band limits that the samples of a CT scan determine, and the entries they need.
# @data      slice_band_limit
# @options   --data slice_band_limit --name NAME
# @name      band-limit
# @question  Band limits that carry the shape of the generated head, and the entries that sampling theorems ask for.
# @data      band_limit
# @options   --data band_limit --name NAME
# @name      band-limit-real-joints
# @question  Band limits that carry the shape of real heads, and the entries that sampling theorems ask for.
# @data      band_limit_bones
# @options   --data band_limit_bones --name NAME
# @when      JOINTS
"""Band limits and the entries that the sampling theorems require, one row per case."""

import pandas as pd

import common

HEADS = {
    "surface": "surface",
    "distance": "samples",
    "gap_deg": "gap, \\textdegree",
    "filling": "filling",
    "covered_share": "covered",
    "carried": "carried",
    "band_limit": "$L$",
    "optimal": "$L^2$",
    "mcewen_wiaux": "McEwen--Wiaux",
    "driscoll_healy": "Driscoll--Healy",
    "oversampling": "RSID 1\\textdegree{} /",
}


def main(options) -> common.Table:
    table = common.load(options.results, options.data)
    if "asked" in table:
        shares = table.asked == "power_share"
        table.insert(3, "carried_percent", (100 * table.value).where(shares))
        table.insert(4, "left_out_mm", table.value.where(~shares))
        table = table.drop(columns=["asked", "value"])
        shown = table.assign(carried=[carried(line) for line in table.itertuples()])
    else:
        shown = table
    return table, latex(shown)


def carried(line) -> str:
    """What the band limit has to reach."""
    return f"all but {line.left_out_mm:g} mm" if pd.isna(line.carried_percent) else f"{line.carried_percent:g} %"


def latex(table: pd.DataFrame) -> str:
    """Names, then the entries. A surface is named only once."""
    columns = [name for name in HEADS if name in table]
    rows = []
    last = None
    for line in table[columns].to_dict("records"):
        start = (line.get("surface"), line.get("filling"))
        if start == last and start[0] is not None:
            line |= dict.fromkeys(["surface", "filling", "covered_share"], "")
        last = start
        rows.append([cell(name, line[name]) for name in columns])
    kinds = "".join("l" if name in ("surface", "distance", "filling", "carried") else "r" for name in columns)
    return common.tabular(f"@{{}}{kinds}@{{}}", [[HEADS[name] for name in columns]], rows)


def cell(column: str, value: object) -> str:
    """One value for LaTeX."""
    if isinstance(value, str):
        return common.tex(value)
    if column == "covered_share":
        return f"{100 * value:.0f}\\,\\%"
    if column in ("gap_deg", "oversampling"):
        return common.digits(value)
    return f"{value:,.0f}"


common.run(main, "--data", "--name")
