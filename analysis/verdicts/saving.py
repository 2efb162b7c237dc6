# SPDX-License-Identifier: GPL-3.0-or-later
# @data      lut_memory scheme_savings
"""Verdict on the memory that the thesis' helix saves (Section 4.4), and what else "saves" could mean."""

import math
from pathlib import Path

import common
from verdicts.verdict import claim_row

HELIX, ARCS, GRID = "usid", "usid_arc", "rsid"  # the two systems that Section 4.4 compares, the first by both readings
PRECISION = 1.0  # degrees, of what is said of one precision


def rows(results: Path) -> list[dict]:
    """One row for all precisions of the thesis and both readings of its helix; its note has the other meanings."""
    table = common.load(results, "lut_memory")
    precisions = [common.number(name) for name in common.thesis("table-7").row.unique()]
    table = table[table.precision_deg.isin(precisions)].pivot(index="precision_deg", columns="scheme")
    saved = {name: 100 * (1 - table[name][HELIX] / table[name][GRID]).sort_index(ascending=False) for name in ("bytes", "filled_bytes")}
    arcs = 100 * (1 - table.bytes[ARCS] / table.bytes[GRID])
    other = common.load(results, "scheme_savings")
    other = other[(other.scheme == HELIX) & (other.precision_deg == PRECISION)].set_index("meaning").saved_percent
    listed = ", ".join(f"{percent:.2f} at {precision:g}" for precision, percent in saved["bytes"].items())
    note = (
        f"of the radii, at equal spacing on the equator, by precision: {listed} degrees, which approach 1 - 8/pi^2 = "
        f"{100 * (1 - 8 / math.pi**2):.1f} %; the same at equal arcs; {saved['filled_bytes'][PRECISION]:.1f} % with the rim masks of filled tables at "
        f"{PRECISION:g}. At equally wide gaps (covering radius) the helix saves "
        f"{other.covering_radius:.1f} %, at equal interpolation error {other.interpolation_p9999:.1f} % "
        f"(99.99th percentile) and {other.interpolation_rms:.1f} % (root mean square): scheme_savings.csv"
    )
    return [
        claim_row(value, [*saved["bytes"], *arcs], ", at every precision and by both readings of the helix", note)
        for value in common.thesis("section-4.4").itertuples()
        if (value.row, value.column) == ("saving", "memory")
    ]
