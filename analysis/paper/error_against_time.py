# SPDX-License-Identifier: GPL-3.0-or-later
# @data      error_against_time error_against_time_spread all_gaps sampling_error_proven error_budget euclidean
# @depends   tables/matched-accuracy.csv
"""Numbers of the paper about error against run time, proven bounds and Euclidean distances.

benchmark:methods, :scenes, :settings, :bounded (rows with a proven bound) and :searched (by branch and bound);
tightness:least and :median of the latter; matched:TARGET:line, :query_ns, :kib, :embree and :thesis of
the fastest line of the main scene at that error (um); proven:SCHEME:PRECISION:COLUMN of the head;
budget:STAGE:max_um of the generated pair at 1 degree;
euclidean:ZONE:gap_median and :gap_max, the largest over all joints and poses; thousand:WHAT:s and :um of the fastest of the thesis'
tables, of Embree's rays and of exact cells (WAYS), all gaps of 1,000 poses of the hip; work:embree, work:pays, work:real and work:ablation, sentences
of common/work_precision.py.
"""

from pathlib import Path

import numpy as np
import pandas as pd

import common
from common import pareto, work_precision


NEGLIGIBLE = 0.001  # micrometres, of a stage of the budget


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    said = {f"work:{name}": text for name, text in work_precision.sentences(results).items()}
    return benchmark(results) | matched(results) | proven(results) | euclidean(results) | thousand(results) | said


WAYS = {"thesis": work_precision.THESIS, "embree": ["Embree"], "cells": ["exact cells"]}


def thousand(results: Path) -> dict[str, str]:
    """The fastest of each."""
    rows = work_precision.load(results)
    own = rows[rows.scene == work_precision.scenes(rows)["hip"]]
    found = {}
    for name, lines in WAYS.items():
        row = own[own.line.isin(lines)].nsmallest(1, "thousand").iloc[0]
        found |= {f"thousand:{name}:s": common.digits(row.thousand / 1e3, 2), f"thousand:{name}:um": common.digits(row.error_um, 2)}
    return found


def benchmark(results: Path) -> dict[str, str]:
    """How many took part, and how tight the proven bounds are."""
    table = pareto.load(results)
    tightness = table.tightness[np.isfinite(table.attained_um)]  # of the bounds that were searched for
    return {
        "benchmark:methods": str(table.method.nunique()),
        "benchmark:scenes": str(table.scene.nunique()),
        "benchmark:settings": f"{len(table):,}",
        "benchmark:bounded": f"{np.isfinite(table.bound_um).sum():,}",
        "benchmark:searched": f"{len(tightness):,}",
        "tightness:least": common.digits(tightness.min(), 2),
        "tightness:median": common.digits(tightness.median(), 2),
    }


def matched(results: Path) -> dict[str, str]:
    """The fastest line at each error."""
    lines = pd.read_csv(results / "tables" / "matched-accuracy.csv")
    scene = pareto.main_scene(lines.scene)
    joint, _, triangles = scene.rpartition("_")
    found = {"matched:scene": f"{joint.replace('_', ' ')} pair of {int(triangles):,} triangles each" if triangles.isdigit() else scene.replace("_", " ")}
    own = lines[(lines.scene == scene) & np.isfinite(lines.query_ns)]
    for target, group in own.groupby("target_um"):
        best = group.loc[group.query_ns.idxmin()]
        name = f"matched:{target:g}"
        found |= {
            f"{name}:line": pareto.label(best.line),
            f"{name}:query_ns": common.digits(best.query_ns),
            f"{name}:kib": common.digits(best.bytes / 1024),
            f"{name}:embree": common.digits(best.times_faster_than_embree, 2) or "---",
            f"{name}:thesis": common.digits(best.times_faster_than_thesis, 2) or "---",
        }
    return found


def proven(results: Path) -> dict[str, str]:
    """Bound, measured error and tightness of the head's tables, and the stages of the budget."""
    found = {}
    for row in common.load(results, "sampling_error_proven").itertuples():
        name = f"proven:{row.scheme}:{row.precision_deg:g}"
        found[f"{name}:bound_um"] = common.digits_up(1000 * row.bound_mm)
        found[f"{name}:measured_um"] = common.digits(1000 * row.measured_max_mm)
        found[f"{name}:a_priori_um"] = common.digits_up(1000 * row.a_priori_mm)
    budget = common.load(results, "error_budget")
    chosen = (budget.scheme == "rsid") & (budget.storage == "uint16") & (budget.precision_deg == 1)
    for row in budget[chosen].itertuples():
        found[f"budget:{row.stage}:max_um"] = common.digits(row.max_um, 2) if row.max_um >= NEGLIGIBLE else f"less than {NEGLIGIBLE:g}"
    return found


def euclidean(results: Path) -> dict[str, str]:
    """How much radial gaps overstate, by zone."""
    table = common.load(results, "euclidean")
    found = {}
    for zone, group in table.groupby("zone"):
        found[f"euclidean:{zone}:gap_median"] = common.digits(group.gap_median.max(), 4)
        found[f"euclidean:{zone}:gap_max"] = common.digits(group.gap_max.max(), 4)
    return found
