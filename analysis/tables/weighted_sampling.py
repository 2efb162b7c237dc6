# SPDX-License-Identifier: GPL-3.0-or-later
# @name      weighted-sampling
# @question  Error of gaps, entries and time of the thesis' weighted sampling (Eq. 16) on acetabular caps, beside the grid, the helix and equal areas.
# @data      weighted_sampling
"""Weighted sampling on every cap, compared with the grid that has as many entries."""

import pandas as pd

import common

GRID = "rsid"
AT = 1.0  # degrees, of what the paper shows


def main(options) -> common.Table:
    table = common.load(options.results, "weighted_sampling")
    grid = table[table.scheme == GRID].set_index(["joint", "precision_deg"])
    base = grid.loc[pd.MultiIndex.from_frame(table[["joint", "precision_deg"]])]
    for name in ("entries", "rms_um", "max_um"):
        table[f"{name}_to_grid"] = table[name].to_numpy() / base[name].to_numpy()
    table["answered_percent"] = 100 * table.answered / table.asked
    # An error of second order falls as entries grow: entries that the grid would need for the same one.
    table["entries_at_equal_rms_to_grid"] = table.entries_to_grid * table.rms_um_to_grid
    return table.drop(columns=["asked", "answered"]), latex(table[table.precision_deg == AT])


def latex(table: pd.DataFrame) -> str:
    """A cap in every row: root mean square and largest error by scheme; entries and times below."""
    schemes = table.drop_duplicates("scheme")
    head = ["cap", *(f"\\multicolumn{{2}}{{c}}{{{common.tex(label)}}}" for label in schemes.label)]
    rows = []
    for joint, group in table.groupby("joint", sort=False):
        lines = [group[group.scheme == scheme].iloc[0] for scheme in schemes.scheme]
        rows.append([common.tex(joint.replace("_", " ")), *(common.digits(line[name], 2) for line in lines for name in ("rms_um", "max_um"))])
    timed = table[table.look_up_ns.notna()]
    for title, name in (("entries", "entries"), ("look-up, ns", "look_up_ns"), ("filling, ms", "fill_ms")):
        values = [timed[timed.scheme == scheme][name].iloc[0] for scheme in schemes.scheme]
        rows.append([title, *(f"\\multicolumn{{2}}{{r}}{{{common.digits(value)}}}" for value in values)])
    units = ["", *["rms, µm & max, µm"] * len(schemes)]
    return common.tabular(f"@{{}}l{'rr' * len(schemes)}@{{}}", [head, units], rows)


common.run(main)
