# SPDX-License-Identifier: GPL-3.0-or-later
# @data      contact contact_agreement
"""Numbers of the paper about touch and smallest gaps: contact:METHOD:us the longest time of the three gaps at 12,000
triangles, contact:METHOD:um the largest error of its gaps, contact:METHOD:fcl the ratio to FCL's answer, of touch the
least of the three gaps, of distance the median, contact:poses, :wrong, :between, :beyond and :unexplained of the
agreement, contact:impinged the poses with impinged surfaces, and contact:missed those of them without an impinged vertex.
"""

from pathlib import Path

import common
from common import contact


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    table = contact.load(results)
    found = {}
    for method in table.method.unique():
        rows = table[(table.method == method) & (table.triangles == contact.TRIANGLES)]
        ratio = contact.over_distance(table, method)
        if method in ("culled", "coherent"):
            ratio = contact.ratios(table, method, contact.TRIANGLES, "fcl_collide").min()
        found[f"contact:{method}:us"] = common.digits(rows.us_pose.max(), 2)
        found[f"contact:{method}:fcl"] = common.digits(ratio, 2)
        found[f"contact:{method}:um"] = common.digits(rows.error_um.max(), 2)
    agreed = common.load(results, "contact_agreement").iloc[0]
    wrong = agreed.culled_wrong + agreed.coherent_wrong + agreed.least_gap_wrong
    counts = {"poses": agreed.poses, "impinged": agreed.impinged + agreed.missed, "missed": agreed.missed}
    counts |= {"wrong": wrong, "between": agreed.between_vertices}
    counts |= {"beyond": agreed.beyond, "unexplained": agreed.unexplained}
    return found | {f"contact:{name}": str(int(count)) for name, count in counts.items()}
