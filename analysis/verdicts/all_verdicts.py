# SPDX-License-Identifier: GPL-3.0-or-later
# @name      verdicts
# @question  Which numbers of the thesis came out again?
# @outputs   verdicts.csv
"""A verdict on every number of the thesis: its value beside ours, by a stated rule.

Each module of MODULES has rows(results) for some of the thesis' tables. Formula values are reproduced when ours rounds
to the digits that the thesis prints.
"""

import pandas as pd

import common
from verdicts import conchoid, hip, memory, sampling_error, saving, timing, verdict

MODULES = (conchoid, hip, memory, sampling_error, saving, timing)


def main(options) -> None:
    """Writes verdicts.csv, in the order of thesis_values.csv."""
    rows = pd.DataFrame([row for module in MODULES for row in module.rows(options.results)], columns=verdict.COLUMNS)
    order = list(common.thesis().artefact.unique())
    rows = rows.sort_values("artefact", key=lambda names: names.map(order.index), kind="stable")
    common.write(options.out / "verdicts.csv", rows.to_csv(index=False, lineterminator="\n"))


common.run(main)
