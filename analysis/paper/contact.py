# SPDX-License-Identifier: GPL-3.0-or-later
# @data      contact contact_agreement
"""Numbers of the paper about touch: contact:culled:us the longest time of the three gaps at 12,000 triangles,
contact:culled:fcl the least ratio of FCL's time to it, contact:poses, :wrong, :between and :unexplained of the agreement,
contact:impinged the poses with impinged surfaces, and contact:missed those of them without an impinged vertex.
"""

from pathlib import Path

import common
from common import contact

TRIANGLES = 12000  # of each model


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    table = contact.load(results)
    times = table[table.triangles == TRIANGLES].pivot(index="gap_case", columns="method", values="us_pose")
    agreed = common.load(results, "contact_agreement").iloc[0]
    wrong = agreed.culled_wrong + agreed.least_gap_wrong
    counts = {"poses": agreed.poses, "impinged": agreed.impinged + agreed.missed, "missed": agreed.missed}
    counts |= {"wrong": wrong, "between": agreed.between_vertices, "unexplained": agreed.unexplained}
    return {
        "contact:culled:us": common.digits(times.culled.max(), 2),
        "contact:culled:fcl": common.digits((times.fcl_collide / times.culled).min(), 2),
        **{f"contact:{name}": str(int(count)) for name, count in counts.items()},
    }
