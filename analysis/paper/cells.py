# SPDX-License-Identifier: GPL-3.0-or-later
# @data      schemes scheme_errors scheme_savings lookup_time stencil_time helix_placement
# @data      conchoid_surface sampling_error slice_band_limit
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
    Cells("scheme_savings", "saved", ("scheme", "meaning", "precision_deg")),
    Cells("sampling_error", "error", ("scheme", "precision_deg")),
    Cells("slice_band_limit", "slices", ("distance",), 4),
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
        | helix(results)
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
    """stencil-growth:smallest and :largest over the schemes, time to find the entries of the finer table by that of the
    coarser; :entries, how many times as many those are.
    """
    times = common.load(results, "stencil_time").sort_values("entries")
    ratio = times.groupby("scheme").median_ns.agg(lambda values: values.iloc[-1] / values.iloc[0])
    return {
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
    and value of the scheme that is best at it; best:error, which need the least memory for the same error; schemes, their number; icosahedral-time, times RSID's
    look-up.
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
    }
    found = {"schemes": str(len(schemes)), "covering-floor": common.digits(8 * math.pi / 3**1.5)}
    for name, values in criteria.items():
        found[f"best:{name}"] = labels[values.idxmin()]
        found[f"best:{name}:value"] = common.digits(values.min())
    worst, rms = found["best:worst"], found["best:rms"]
    found["best:error"] = f"{worst}, by both measures" if worst == rms else f"{worst} at the 99.99th percentile, {rms} in the root mean square"
    ratio = lookup.median_ns.icosahedral_gnomonic / lookup.median_ns.rsid
    return found | {"icosahedral-time": common.digits(ratio)}


def helix(results: Path) -> dict[str, str]:
    """aspect:TURNS of the spacings, mismatch:TURNS:true, by how many entries an index is off at most."""
    found = {}
    for row in common.load(results, "helix_placement").itertuples():
        found[f"aspect:{row.turns:g}"] = f"{row.along_deg / row.between_turns_deg:.2f}"
        found[f"mismatch:{row.turns:g}:true"] = common.digits(abs(row.mismatch_true_spacing))
    return found
