# SPDX-License-Identifier: GPL-3.0-or-later
"""What the figure and the table of strain by gap share."""

import math
from pathlib import Path

import pandas as pd

import common

# Layers of the table in the paper: radii of contact.
SHOWN = (0.1, 0.5, 2.0)


def layers(results: Path) -> pd.DataFrame:
    """One row a Poisson ratio and thickness."""
    return common.load(results, "strain_layer")


def facts(results: Path) -> dict[str, str]:
    """Numbers of the paper.

    strain:layer:POISSON:THICKNESS:COLUMN, :wider (area of contact over overlap) and :beside (per cent of the middle's
    displacement by which the surface is moved where the gap says no strain); strain:ray:GAP:DEGREES:by_gap and :angle of
    the ten degrees from there on; strain:ray:mended (largest error with the gap along the normal); strain:hip:HIP:COLUMN
    with hour (of the largest strain), largest, by_distance, hidden (largest difference of the two, of a vertex),
    mean_hidden (of an hour) and by_place (largest change of an hour's mean where the cartilage is thicker in front).
    """
    found = {}
    for row in layers(results).itertuples():
        key = f"strain:layer:{row.poisson:g}:{row.thickness:g}"
        for column in ("area", "pressure", "force", "bone_strain", "surface_strain", "bone_shear"):
            found[f"{key}:{column}"] = common.digits(getattr(row, column), 2)
        found[f"{key}:wider"] = common.digits(1 / row.area, 2)
        found[f"{key}:beside"] = f"{100 * abs(row.edge_strain):.0f}"
    rays = common.load(results, "strain_incidence")
    for row in rays.itertuples():
        key = f"strain:ray:{row.gap_mm:g}:{row.from_deg:g}"
        found[f"{key}:by_gap"] = f"{row.by_gap:.2f}"
        found[f"{key}:angle"] = f"{row.angle_deg:.0f}"
    found["strain:ray:mended"] = f"{math.ceil(1e3 * rays.mended_error.max()) / 1e3:g}"
    return found | hips(results)


def hips(results: Path) -> dict[str, str]:
    """Of every hip in its pose."""
    found = {}
    for name, rows in common.load(results, "strain_hip").groupby("hip", sort=False):
        uniform = rows[rows.cartilage == "uniform"].set_index("hour")
        by_place = rows[rows.cartilage == "by_place"].set_index("hour")
        most = uniform.largest_strain.idxmax()
        change = by_place.strain.reindex(range(1, 13), fill_value=0) - uniform.strain.reindex(
            range(1, 13), fill_value=0
        )
        values = {
            "largest": uniform.largest_strain[most],
            "by_distance": uniform.largest_strain_by_distance[most],
            "hidden": uniform.largest_difference.max(),
            "mean_hidden": (uniform.strain_by_distance - uniform.strain).max(),
            "by_place": change.abs().max(),
        }
        found[f"strain:hip:{name}:hour"] = f"{most}"
        found |= {f"strain:hip:{name}:{key}": f"{value:.2f}" for key, value in values.items()}
    return found
