# SPDX-License-Identifier: GPL-3.0-or-later
"""What every table and figure shares: its arguments and its end here; reading, words, writing and drawing from the
modules below.

Every script is called as PYTHONPATH=analysis python3 SCRIPT --results DIR [--out DIR]: it reads DIR/data/NAME.csv and
writes under the folder --out (by default the working folder) laid out as the results folder. The same input gives the
same bytes.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import NoReturn

from common.drawing import COLOURS, SMALL, THESIS_GREY, WIDTH, look, save_figure, scheme_looks, style
from common.loading import load
from common.sidecars import Refused, sidecar
from common.thesis_values import counterparts, methods_of, thesis
from common.wording import digits, digits_up, label, number, plain, rounded_down, rounded_up, scheme_labels, tex
from common.writing import tabular, write, write_table

__all__ = [
    "COLOURS",
    "Refused",
    "SMALL",
    "THESIS_GREY",
    "WIDTH",
    "arguments",
    "counterparts",
    "digits",
    "digits_up",
    "label",
    "load",
    "look",
    "methods_of",
    "number",
    "plain",
    "rounded_down",
    "rounded_up",
    "run",
    "save_figure",
    "scheme_labels",
    "scheme_looks",
    "sidecar",
    "style",
    "tabular",
    "tex",
    "thesis",
    "write",
    "write_table",
]


def arguments(description: str | None, *more: str) -> argparse.Namespace:
    """--results, --out and further required options of the same kind."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--results", type=Path, required=True, help="the results folder")
    parser.add_argument(
        "--out", type=Path, default=Path("."), help="where to write, laid out as the results folder"
    )
    for name in more:
        parser.add_argument(name, required=True)
    return parser.parse_args()


def run(main) -> NoReturn:
    """Calls main(); a refusal is one clear line and exit code 1."""
    try:
        main()
    except Refused as refusal:
        sys.exit(f"{Path(sys.argv[0]).name}: {refusal}")
    sys.exit(0)
