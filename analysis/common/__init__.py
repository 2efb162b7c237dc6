# SPDX-License-Identifier: GPL-3.0-or-later
"""What every table and figure needs: its arguments and its end are here; reading, words, writing and drawing come from the
modules below.

Every script is called as PYTHONPATH=analysis python3 SCRIPT --results DIR [--out DIR]: it reads DIR/data/NAME.csv and
writes under the folder --out (by default the working folder) laid out as the results folder. The same input gives the
same bytes.
"""

import argparse
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

import pandas as pd

from common.drawing import COLOURS, SMALL, THESIS_GREY, WIDTH, Figure, save_figure, style
from common.drawing import key, look, marks, note
from common.heads import job_of
from common.loading import as_text, load
from common.sidecars import Refused, sidecar
from common.thesis_values import counterparts, methods_of, reading_names, readings, same_number, thesis
from common.wording import digits, digits_up, label, number, plain, rounded_down, rounded_up, scheme_labels, tex
from common.writing import groups, ruled, tabular, write, write_table

Table = tuple[pd.DataFrame, str]  # and its LaTeX


def arguments(*more: str) -> argparse.Namespace:
    """The arguments --results and --out, and `more` required ones."""
    parser = argparse.ArgumentParser(description=sys.modules["__main__"].__doc__)
    parser.add_argument("--results", type=Path, required=True, help="the results folder")
    parser.add_argument("--out", type=Path, default=Path("."), help="where to write, laid out as the results folder")
    for name in more:
        parser.add_argument(name, required=True)
    return parser.parse_args()


def run(main: Callable[[argparse.Namespace], Table | Figure | None], *more: str) -> NoReturn:
    """Calls main(arguments(*more)) and writes the table or figure that it returns, with the name from --name or from the
    script's head. A refusal is one clear line and exit code 1.
    """
    options = arguments(*more)
    script = Path(sys.argv[0])
    style()
    try:
        made = main(options)
    except Refused as refusal:
        sys.exit(f"{script.name}: {refusal}")
    if made is not None:
        job = job_of(script, getattr(options, "name", None))
        if isinstance(made, tuple):
            write_table(options.out, job["name"], job["question"], *made)
        else:
            save_figure(made, options.out, job["name"], job["outputs"].split())
    sys.exit(0)
