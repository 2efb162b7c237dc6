# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the report in which a reader moves about: error against cost of every method, on any scene, with any measure
of error and any cost on the axes. From data/error_against_time.csv and error_against_time_spread.csv; explore.js draws.
"""

from __future__ import annotations

import base64
import gzip
from pathlib import Path

import numpy as np
import pandas as pd

import common
from common import pareto
from report.markup import choice, data_script

# Columns that may stand on the axes, and what a reader calls them; the first is shown at first.
ERRORS = {
    "error_um": "largest error measured, µm",
    "p99_um": "99th percentile of the error, µm",
    "rms_um": "root mean square error, µm",
    "bound_um": "proven bound, µm",
}
STORAGES = {"double": "double", "float": "float", "uint16": "16 bits"}  # of tables; the first is shown at first
MARKERS = ["circle", "square", "diamond", "triangle-up", "cross", "x", "star"]


def significant(values: pd.Series) -> list[float | None]:
    """As JSON has them: four digits, nothing for what is not there."""
    return [float(f"{value:.4g}") if np.isfinite(value) and value > 0 else None for value in values]


def lines(table: pd.DataFrame) -> list[dict]:
    """One line of the plot a scene and method: its settings in the order of the table."""
    names = list(dict.fromkeys(table.line))
    looks = common.look(names)
    found = []
    for (scene, line), group in table.groupby(["scene", "line"], sort=False):
        k = names.index(line)
        found.append(
            {
                "scene": scene,
                "name": pareto.label(line),
                "kind": group.kind.iloc[0],
                "storage": group.storage.iloc[0],
                "colour": looks[line]["color"],
                "marker": MARKERS[k // len(common.COLOURS) % len(MARKERS)],
                "setting": [pareto.step_of(row) for row in group.itertuples()],
                **{column: significant(group[column]) for column in (*ERRORS, *pareto.COSTS)},
            }
        )
    return found


def packed(script: Path) -> str:
    """A script in a third of its bytes, which explore.js unpacks when the plot is asked for."""
    text = base64.b64encode(gzip.compress(script.read_bytes(), mtime=0)).decode("ascii")
    return f'<script type="text/plain" id="explore-library">{text}</script>'


def section(results: Path, library: Path) -> str:
    """The controls, the plot's place, its data, and the library that draws it."""
    table = pareto.load(results)
    first = pareto.main_scene(list(table.scene.unique()))
    scenes = {name: name.replace("_", " ") for name in [first, *(s for s in table.scene.unique() if s != first)]}
    shown = lines(table[pareto.competes(table)])
    return (
        "<p>Lower left is better. Click a name to hide its line, double-click to show it alone; point at a marker for its"
        " numbers; drag to zoom, double-click the plot to see everything, exact methods too."
        " Only methods that give the radius along a direction are shown.</p>"
        f'<div class="filters">{choice("explore-scene", "Scene", scenes)}{choice("explore-storage", "Tables in", STORAGES)}'
        f'{choice("explore-error", "Horizontal axis", ERRORS)}'
        f'{choice("explore-cost", "Vertical axis", pareto.COSTS)}</div><div id="explore-plot" role="img" aria-label="Error against cost'
        ' of every method"></div>' + data_script("explore-data", shown) + packed(library)
    )
