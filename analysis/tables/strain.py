# SPDX-License-Identifier: GPL-3.0-or-later
# @name      strain-by-gap-table
# @question  Strain by gap over that of an elastic layer, by Poisson ratio and thickness.
# @data      strain_layer
"""Strain by gap, and what follows from it, compared with the elastic solution of a layer."""

import pandas as pd

import common
from common import strain


def main(options) -> common.Table:
    rows = strain.layers(options.results).drop(columns="approach")
    for name in rows.columns[2:]:
        rows[name] = rows[name].map(lambda value: common.plain(value, 3))
    return rows, latex(strain.layers(options.results))


def latex(layers: pd.DataFrame) -> str:
    """Three thicknesses for each Poisson ratio."""
    head = [
        r" & & \multicolumn{3}{c}{by gap over elastic} & \multicolumn{4}{c}{elastic strain over that by gap} \\",
        r"\cmidrule(lr){3-5}\cmidrule(l){6-9}",
        r"$\nu$ & $h/a$ & area & pressure & force & at the bone & at the surface & shear & beside \\",
    ]
    lines = []
    for row in layers[layers.thickness.isin(strain.SHOWN)].sort_values("poisson", kind="stable").itertuples():
        cells = [f"{row.poisson:g}", f"{row.thickness:g}", f"{row.area:.2f}"]
        cells += [f"{value:.2f}" if pd.notna(value) else r"$\infty$" for value in (row.pressure, row.force)]
        values = (row.bone_strain, row.surface_strain, row.bone_shear, row.edge_strain)
        lines.append(cells + [f"${value:.2f}$" for value in values])
    return common.tabular("@{}rrrrrrrrr@{}", head, common.ruled(lines))


common.run(main)
