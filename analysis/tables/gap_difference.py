# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-50-difference
# @question  How far are the gaps by RSID and by USID apart, at 1 degree (beside Figure 50)?
# @depends   scenes/{SCENES}-{rsid,usid}/{gaps.csv,summary.json}
# @options   --joints SCENES
"""How far the gaps from the two tables of the thesis are apart, and how many vertices change sides of a threshold (Figure
50: USID "produces the same result").
"""

from pathlib import Path

import numpy as np
import pandas as pd

import common
from common import summaries

SCHEMES = ("rsid", "usid")  # the two systems of the thesis


def main(options) -> common.Table:
    rows = []
    for joint in options.joints.split(","):
        folders = [options.results / "scenes" / f"{joint}-{scheme}" for scheme in SCHEMES]
        rows += differences(joint, *folders)
    table = pd.DataFrame(rows)
    return table, latex(table)


def differences(joint: str, one: Path, other: Path) -> list[dict]:
    """One row for each surface and each threshold, which are the levels that the scene colours."""
    gaps = pd.merge(*(pd.read_csv(folder / "gaps.csv") for folder in (one, other)), on=["surface", "vertex"])
    summary = summaries.read(one)
    rows = []
    for surface, group in gaps.groupby("surface", sort=False):
        first, second = group.gap_mm_x.to_numpy(), group.gap_mm_y.to_numpy()
        met = np.isfinite(first) & np.isfinite(second)
        apart = np.abs(first - second)[met]
        for level in summary["colours"][surface][:-1]:
            threshold = level["up_to"]
            inside = [int((gap <= threshold).sum()) for gap in (first[met], second[met])]
            rows.append(
                {
                    "joint": joint,
                    "surface": surface,
                    "vertices": len(group),
                    "met_by_both": int(met.sum()),
                    "met_by_one": int((np.isfinite(first) != np.isfinite(second)).sum()),
                    "largest_difference_mm": apart.max(initial=0.0),
                    "rms_difference_mm": float(np.sqrt(np.mean(apart**2))) if len(apart) else 0.0,
                    "threshold_mm": threshold,
                    **{f"impinged_{scheme}": count for scheme, count in zip(SCHEMES, inside)},
                    "changed": int(((first[met] <= threshold) != (second[met] <= threshold)).sum()),
                }
            )
    return rows


def latex(table: pd.DataFrame) -> str:
    """The thresholds of each surface, one below the other."""
    heads = ["joint", "surface", "met by one", "largest, mm", "rms, mm", "threshold, mm"]
    heads += [f"{common.label(scheme)}" for scheme in SCHEMES] + ["changed"]
    rows, last = [], None
    for line in table.itertuples():
        place = (line.joint, line.surface)
        words = [
            common.tex(line.joint.replace("_", " ")),
            line.surface,
            f"{line.met_by_one:,}",
            f"{line.largest_difference_mm:.4f}",
            f"{line.rms_difference_mm:.4f}",
        ]
        counts = [f"{getattr(line, f'impinged_{scheme}'):,}" for scheme in SCHEMES]
        cells = [
            *(words if place != last else [""] * len(words)),
            f"{line.threshold_mm:.2f}",
            *counts,
            f"{line.changed:,}",
        ]
        rows.append(cells)
        last = place
    return common.tabular("@{}llrrrrrrr@{}", [heads], rows)


common.run(main, "--joints")
