# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   tables/cohort-comparison.csv
"""Numbers of the paper about the cohort: cohort:hips, :found, the published statistics that were to come out of it, and
:holds, those that did within its 95 % interval.
"""

from pathlib import Path

import pandas as pd


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    table = pd.read_csv(results / "tables" / "cohort-comparison.csv")
    found = table[table.role == "found"]
    return {
        "cohort:hips": f"{table.hips.iloc[0]:,}",
        "cohort:found": str(len(found)),
        "cohort:holds": str((found.holds == "yes").sum()),
    }
