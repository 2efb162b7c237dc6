# SPDX-License-Identifier: GPL-3.0-or-later
# @data      stability stability_detail stability_families
"""Numbers of the paper about stiff and extreme cases.

stability:families, :cases, :failures (of ours), :broken (bounds) and :refused; stability:share, the largest
error of ours over what its analysis allows, in per cent.
"""

from pathlib import Path

import common
from common import stability


def facts(results: Path) -> dict[str, str]:
    """How ours fared."""
    cases = stability.load(results)
    families = stability.families(results)
    ours = cases[cases.kind == "ours"]
    in_double = ours[ours.scalar == "double"]
    allowed = in_double.family.map(families.threshold)
    share = (in_double.error_over_condition_u / allowed)[allowed > 0]
    return {
        "stability:families": str(len(families)),
        "stability:cases": f"{len(ours):,}",
        "stability:failures": str(int(ours.failures.sum())),
        "stability:broken": str(int(ours.bound_holds.isin([False, "no"]).sum())),
        "stability:refused": str(int((ours.refused > 0).sum())),
        "stability:share": common.digits(100 * share.max(), 2),
    }
