# SPDX-License-Identifier: GPL-3.0-or-later
# @data      stability stability_detail stability_families scene_needs_totals
"""Numbers of the paper about stiff and extreme cases, and about what a scene can leave out.

stability:families, :cases, :failures (of ours), :broken (bounds) and :refused; stability:share, the largest
error of ours over what its analysis allows, in per cent; stability:FAMILY:WHO, failures of another method;
needs:SCENE:COLUMN:least and :most over all joints, and needs:joints.
"""

from pathlib import Path

import common
from common import stability

RATIOS = ("bytes_ratio", "time_ratio", "tables_time_ratio")


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    return extremes(results) | needs(results)


def extremes(results: Path) -> dict[str, str]:
    """How ours fared, and how often others failed where."""
    cases = stability.load(results)
    families = stability.families(results)
    ours = cases[cases.kind == "ours"]
    in_double = ours[ours.scalar == "double"]
    allowed = in_double.family.map(families.threshold)
    share = (in_double.error_over_condition_u / allowed)[allowed > 0]
    found = {
        "stability:families": str(len(families)),
        "stability:cases": f"{len(ours):,}",
        "stability:failures": str(int(ours.failures.sum())),
        "stability:broken": str(int(ours.bound_holds.isin([False, "no"]).sum())),
        "stability:refused": str(int((ours.refused > 0).sum())),
        "stability:share": common.digits(100 * share.max(), 2),
    }
    others = cases[cases.kind != "ours"]
    for (family, method), group in others.groupby(["family", "method"]):
        found[f"stability:{family}:{method}"] = f"{int(group.failures.sum()):,}"
    return found


def needs(results: Path) -> dict[str, str]:
    """How many times fewer bytes and less time a plan takes, by what is asked."""
    table = common.load(results, "scene_needs_totals")
    question = table.scene.str.split(" ", n=1).str[1]
    found = {"needs:joints": str(table.scene.str.split(" ", n=1).str[0].nunique())}
    for name, group in table.groupby(question):
        for column in RATIOS:
            key = f"needs:{name.replace(' ', '-')}:{column}"
            found |= {
                f"{key}:least": common.digits(group[column].min(), 2),
                f"{key}:most": common.digits(group[column].max(), 2),
            }
    return found
