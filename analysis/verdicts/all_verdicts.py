# SPDX-License-Identifier: GPL-3.0-or-later
# @name      verdicts
# @question  Which numbers of the thesis came out again?
# @outputs   verdicts.csv
# @depends   results/reference/verdicts.csv
"""A verdict on every number of the thesis: its value compared with ours, by a stated rule.

Each module of MODULES has rows(results) for some of the thesis' tables. A value from a formula is reproduced if ours rounds to
the digits that the thesis prints. A measured value is reproduced if its whole range meets the rule: over rounds, stand-ins,
readings of the thesis and the kept run.
"""

from pathlib import Path

import pandas as pd

import common
from common import ranges
from verdicts import conchoid, hip, memory, sampling_error, saving, timing, verdict

KEPT = Path(__file__).resolve().parents[2] / "results" / "reference" / "verdicts.csv"
MODULES = (conchoid, hip, memory, sampling_error, saving, timing)


def main(options) -> None:
    """Writes verdicts.csv, in the order of thesis_values.csv."""
    rows = pd.DataFrame([row for module in MODULES for row in module.rows(options.results)], columns=verdict.COLUMNS)
    rows = ranges.steadied(rows, KEPT, ["artefact", "row", "column", "rule"], "note")
    order = list(common.thesis().artefact.unique())
    rows = rows.sort_values("artefact", key=lambda names: names.map(order.index), kind="stable")
    common.write(options.out / "verdicts.csv", rows.to_csv(index=False, lineterminator="\n"))


common.run(main)
