# SPDX-License-Identifier: GPL-3.0-or-later
# @name      error-order
# @question  Order of the error of every table in its precision, fitted beside proven.
# @data      error_against_time error_against_time_spread
"""How fast the error of each table falls with its precision: the fitted exponent of the largest and the mean square error,
beside the proven one.

Within a face the error is of second order in the spacing, across an edge of first (where the interpolant is exact on
planes there is none within a face, and no order of it): a mesh with edges gives 1 once the spacing is below that of the
edges, a mesh finer than the table looks smooth and gives 2.
"""

import numpy as np
import pandas as pd

import common
from common import pareto


def main(options) -> common.Table:
    table = pareto.load(options.results)
    table = table[np.isfinite(table.precision_deg) & (table.storage == "double") & (table.error_um > 0)]
    lines = []
    for (scene, method), group in table.groupby(["scene", "method"], sort=False):
        if group.precision_deg.nunique() < 2:
            continue
        lines.append(
            {
                "scene": scene,
                "method": method,
                "settings": len(group),
                "order_max": order(group.precision_deg, group.error_um),
                "order_rms": order(group.precision_deg, group.rms_um),
                "proven_across_edges": 1,
                "proven_in_a_face": 2 if group.interpolant.iloc[0] == "smooth" else None,
            }
        )
    lines = pd.DataFrame(lines)
    return lines, latex(lines)


def order(precision: pd.Series, error: pd.Series) -> float:
    """Exponent of the power law that fits best in logarithms."""
    return float(np.polyfit(np.log(precision), np.log(error), 1)[0])


def latex(lines: pd.DataFrame) -> str:
    """One line a method, one column a scene: exponents of the largest and the mean square error."""
    scenes = list(lines.scene.unique())
    rows = []
    for method, group in lines.groupby("method", sort=False):
        own = group.set_index("scene")
        cells = [f"{own.order_max[s]:.1f} / {own.order_rms[s]:.1f}" if s in own.index else "" for s in scenes]
        rows.append(f"{common.tex(common.label(method))} & {' & '.join(cells)} \\\\")
    titles = [common.tex(s.replace("_", " ").replace("generated", "").strip()) for s in scenes]
    return common.tabular(f"@{{}}l{'r' * len(scenes)}@{{}}", [["Method", *titles]], rows)


common.run(main)
