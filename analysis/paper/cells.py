# SPDX-License-Identifier: GPL-3.0-or-later
# @data      schemes scheme_covering scheme_errors scheme_savings lookup_time stencil_time helix_placement helix_lookup_error
# @data      conchoid_shape conchoid_origins conchoid_surface sampling_error sampling_error_surfaces slice_band_limit band_limit
"""Numbers of whole CSVs as facts for the paper: PREFIX:KEY...:COLUMN for each number of each row.

A key is the text of a column that tells the rows apart; 0.5 and 229 are printed as such.
"""

import math
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

import common


@dataclass(frozen=True)
class Cells:
    """One CSV, how its facts begin, what tells its rows apart and how many digits the paper prints."""

    data: str
    prefix: str
    keys: tuple[str, ...] = ()
    significant: int = 3


CELLS = (
    Cells("schemes", "scheme", ("scheme",)),
    Cells("scheme_covering", "covering", ("scheme",)),
    Cells("scheme_errors", "interpolation", ("scheme",)),
    Cells("scheme_savings", "saved", ("scheme", "meaning", "precision_deg")),
    Cells("lookup_time", "lookup", ("scheme",)),
    Cells("helix_placement", "helix", ("turns",)),
    Cells("helix_lookup_error", "helix-error", ("turns", "placement", "lookup"), 2),
    Cells("conchoid_shape", "conchoid", (), 4),
    Cells("conchoid_origins", "origin", ("origin",)),
    Cells("sampling_error", "error", ("scheme", "precision_deg")),
    Cells("sampling_error_surfaces", "surface", ("surface", "scheme", "precision_deg", "interpolant")),
    Cells("slice_band_limit", "slices", ("distance",), 4),
    Cells("band_limit", "band", ("surface", "filling", "asked", "value"), 4),
)


def facts(results: Path) -> dict[str, str]:
    """All of them, and what takes more than one cell."""
    every = {}
    for cells in CELLS:
        every |= of_table(common.load(results, cells.data), cells)
    return (
        every
        | stencil_growth(results)
        | area_spread(results)
        | scheme_extremes(results)
        | helix_lengths(results)
    )


def of_table(table: pd.DataFrame, cells: Cells) -> dict[str, str]:
    """One for each number."""
    numbers = table.select_dtypes("number").columns.difference(list(cells.keys))
    found = {}
    for row in table.to_dict("records"):
        name = ":".join([cells.prefix, *(key_text(row[key]) for key in cells.keys)])
        found |= {f"{name}:{column}": readable(row[column], cells.significant) for column in numbers}
    return found


def key_text(value: object) -> str:
    """A number without trailing zeros; a name as it is."""
    return f"{value:g}" if isinstance(value, (int, float)) else str(value)


def readable(value: float, significant: int) -> str:
    """Whole numbers in full, others rounded."""
    if value == int(value) if pd.notna(value) else False:
        return f"{int(value):,}"
    return common.digits(value, significant) or "---"


def stencil_growth(results: Path) -> dict[str, str]:
    """stencil-growth:SCHEME, time to find the entries of the finer table by that of the coarser; :entries, how many
    times as many those are.
    """
    times = common.load(results, "stencil_time").sort_values("entries")
    ratio = times.groupby("scheme").median_ns.agg(lambda values: values.iloc[-1] / values.iloc[0])
    growth = {f"stencil-growth:{name}": common.digits(value) for name, value in ratio.items()}
    return growth | {
        "stencil-growth:smallest": common.digits(ratio.min()),
        "stencil-growth:largest": common.digits(ratio.max()),
        "stencil-growth:entries": f"{times.entries.max() / times.entries.min():,.0f}",
    }


def area_spread(results: Path) -> dict[str, str]:
    """area-spread:SAMPLING, largest by smallest area that a point of the conchoid stands for."""
    groups = common.load(results, "conchoid_surface").groupby("sampling")
    spread = groups.largest_mm2.max() / groups.smallest_mm2.min()
    return {f"area-spread:{name}": common.digits(value) for name, value in spread.items()}


def scheme_extremes(results: Path) -> dict[str, str]:
    """covering-floor, N rho^2 of the hexagonal lattice; best:CRITERION and best:CRITERION:value, the label
    and value of the scheme that is best at it; schemes, their number; usid-memory, per cent of RSID's at equal worst
    error; usid-time and icosahedral-time, times its look-up.
    """
    labels = common.scheme_labels(results)
    schemes = common.load(results, "schemes").set_index("scheme")
    errors = common.load(results, "scheme_errors").set_index("scheme")
    lookup = common.load(results, "lookup_time").set_index("scheme")
    criteria = {
        "covering": schemes.covering_constant,
        "worst": errors.entries_p9999,
        "rms": errors.entries_rms,
        "lookup": lookup.median_ns,
        "area": schemes.max_area_ratio,
    }
    found = {"schemes": str(len(schemes)), "covering-floor": common.digits(8 * math.pi / 3**1.5)}
    for name, values in criteria.items():
        found[f"best:{name}"] = labels[values.idxmin()]
        found[f"best:{name}:value"] = common.digits(values.min())
    usid = savings_of(results, "usid").interpolation_p9999
    found["usid-memory"] = common.digits(100 - usid, 2)
    for key, scheme in (("usid-time", "usid"), ("icosahedral-time", "icosahedral_gnomonic")):
        found[key] = common.digits(lookup.median_ns[scheme] / lookup.median_ns.rsid)
    return found


def savings_of(results: Path, scheme: str) -> pd.Series:
    """By meaning, at 1 degree."""
    table = common.load(results, "scheme_savings")
    table = table[(table.scheme == scheme) & (table.precision_deg == 1)]
    return table.set_index("meaning").saved_percent


def helix_lengths(results: Path) -> dict[str, str]:
    """length:TURNS of the curve to four decimals, aspect:TURNS of its spacings, mismatch:TURNS:true and :eq10, by how
    many entries an index is off at most with either spacing.
    """
    found = {}
    for row in common.load(results, "helix_placement").itertuples():
        found[f"length:{row.turns:g}"] = f"{row.length:,.4f}"
        found[f"aspect:{row.turns:g}"] = f"{row.along_deg / row.between_turns_deg:.2f}"
        found[f"mismatch:{row.turns:g}:true"] = common.digits(abs(row.mismatch_true_spacing))
        found[f"mismatch:{row.turns:g}:eq10"] = common.digits(abs(row.mismatch_eq10_spacing))
    return found
