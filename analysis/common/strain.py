# SPDX-License-Identifier: GPL-3.0-or-later
"""What the figure and the table of strain by gap share."""

from pathlib import Path

import pandas as pd

import common

# Layers of the table: radii of contact.
SHOWN = (0.1, 0.5, 2.0)


def layers(results: Path) -> pd.DataFrame:
    """One row per Poisson ratio and thickness."""
    return common.load(results, "strain_layer")


def facts(results: Path) -> dict[str, str]:
    """Numbers for the paper: strain:layer:POISSON:THICKNESS:pressure, the pressure by gap divided by the elastic one."""
    return {
        f"strain:layer:{row.poisson:g}:{row.thickness:g}:pressure": common.digits(row.pressure, 2)
        for row in layers(results).itertuples()
    }
