# SPDX-License-Identifier: GPL-3.0-or-later
# @data      lut_memory scheme_savings
"""Verdict on the memory that the thesis' helix saves (Section 4.4), and what else "saves" could mean."""

import math
from pathlib import Path

import common
from verdicts.verdict import printed_row

HELIX, GRID = "usid", "rsid"  # the two systems that Section 4.4 compares
PRECISION = 1.0  # degrees


def rows(results: Path) -> list[dict]:
    """One, with the other meanings in its note."""
    memory = common.load(results, "lut_memory")
    memory = memory[memory.precision_deg == PRECISION].set_index("scheme")
    measured, filled = (
        100 * (1 - memory[column][HELIX] / memory[column][GRID]) for column in ("bytes", "filled_bytes")
    )
    savings = common.load(results, "scheme_savings")
    savings = savings[(savings.scheme == HELIX) & (savings.precision_deg == PRECISION)]
    saved = savings.set_index("meaning").saved_percent
    note = (
        f"of the radii, at equal spacing on the equator, at {PRECISION:g} deg; {filled:.1f} % with the rim masks of filled "
        f"tables; the limit for fine tables is 1 - 8/pi^2 = "
        f"{100 * (1 - 8 / math.pi**2):.1f} %. At equally wide gaps (covering radius) the helix saves "
        f"{saved.covering_radius:.1f} %, at equal interpolation error {saved.interpolation_p9999:.1f} % "
        f"(99.99th percentile) and {saved.interpolation_rms:.1f} % (root mean square): scheme_savings.csv"
    )
    return [
        printed_row(value, measured, note)
        for value in common.thesis("section-4.4").itertuples()
        if (value.row, value.column) == ("saving", "memory")
    ]
