# SPDX-License-Identifier: GPL-3.0-or-later
# @name      sampling-error-bounds
# @question  Largest error of a look-up as a share of its bound: above 1 the bound does not hold.
# @data      sampling_error_bounds schemes
"""Largest error of a look-up as a share of what theory promises, for every scheme at the finest precision: above 1 the
promise is broken.
"""

import pandas as pd

import common

PROMISES = {
    "nearest": "nearest entry",
    "planar_face": "plane",
    "planar_face_at_pole": "plane, at a pole",
    "edge": "edge",
}


def main(options) -> common.Table:
    bounds = common.load(options.results, "sampling_error_bounds")
    bounds = bounds[(bounds.precision_deg == bounds.precision_deg.min()) & (bounds.reach != "stencil")]
    shares = bounds.pivot_table(index="scheme", columns="promise", values="share_max", aggfunc="max", sort=False)
    table = shares[list(PROMISES)].reset_index()
    labels = common.scheme_labels(options.results)
    return table, latex(table, labels)


def latex(table: pd.DataFrame, labels: dict[str, str]) -> str:
    """One line a scheme; broken promises in bold."""
    rows = []
    for line in table.to_dict("records"):
        cells = [common.digits(line[name], 2) for name in PROMISES]
        bold = [f"\\textbf{{{text}}}" if line[name] > 1 else text for name, text in zip(PROMISES, cells)]
        rows.append(f"{common.tex(labels[line['scheme']])} & {' & '.join(bold)} \\\\")
    return common.tabular(f"@{{}}l{'r' * len(PROMISES)}@{{}}", [["Scheme", *PROMISES.values()]], rows)


common.run(main)
