# SPDX-License-Identifier: GPL-3.0-or-later
# @data      sampling_error slices slice_band_limit finding_grids
"""Verdicts on the sampling error (Table 5), on the slices of a scan (Section 3.5.2) and on another author's grids (Section
3.6.3)."""

import math
from pathlib import Path

import common
from verdicts.verdict import input_row, printed_row

SCHEME = "rsid"  # Table 5 of the thesis is about this one
COLUMNS = {"max_error": "formula_max_mm", "relative_error": "formula_relative"}  # of sampling_error.csv


def rows(results: Path) -> list[dict]:
    """The rows of all three."""
    return formula_rows(results) + slice_rows(results) + grid_rows(results)


def formula_rows(results: Path) -> list[dict]:
    """Eq. 7 and 8; the note gives the error of the radius, which is something else."""
    ours = common.load(results, "sampling_error")
    ours = ours[ours.scheme == SCHEME].set_index("precision_deg")
    lines = []
    for value in common.thesis("table-5").itertuples():
        line = ours.loc[common.number(value.row)]
        lines.append(printed_row(value, line[COLUMNS[value.column]], note(line)))
    return lines


def note(line) -> str:
    """The note: what the number is, and the error of the radius if it was measured."""
    text = "a distance along the surface from an entry, not an error of the radius"
    if math.isnan(line.measured_max_mm):
        return f"{text}, which is not measured at this precision in the quick profile"
    return (
        f"{text}: that is at most {common.digits(1000 * line.measured_max_mm)} um on the meshed head, "
        f"{common.digits(1000 * line.measured_rms_mm)} um root mean square"
    )


def slice_rows(results: Path) -> list[dict]:
    """Number of slices, smallest gap, and half of that gap, which the thesis requires."""
    slices = common.load(results, "slices")
    limits = common.load(results, "slice_band_limit").set_index("distance")
    middle = limits.loc["slices, middle"]
    gaps = slices.gap_deg.dropna()
    smallest = gaps.min()
    beside = int(slices.slice.max())
    computed = {
        "above_the_middle": (beside, ""),
        "below_the_middle": (beside, ""),
        "count": (2 * slices.slice.max() + 1, "the middle slice, and as many above it as below"),
        "smallest_gap": (smallest, f"all {len(gaps)} gaps run from {smallest:.2f} to {gaps.max():.2f} degrees"),
        "required_precision": (
            round(smallest) / 2,
            f"half of the gap rounded to {round(smallest)}, as the thesis has it; half of {smallest:.2f} is {smallest / 2:.2f}, so 1.5 is on the "
            "safe side. Nor is it what Shannon's theorem asks: samples a gap apart determine band limits up to "
            f"L = {middle.band_limit:.0f}, and entries as far apart as the slices keep all of that; halving "
            "the distance serves the interpolation, not the theorem",
        ),
    }
    return [
        printed_row(value, *computed[value.column]) if value.column in computed else input_row(value)
        for value in common.thesis("section-3.5.2").itertuples()
    ]


def grid_rows(results: Path) -> list[dict]:
    """Grids of N rows and N columns: steps of 180 degrees / N and 360 degrees / N."""
    grids = common.load(results, "finding_grids").set_index("side")
    lines = []
    for value in common.thesis("section-3.6.3").itertuples():
        if value.column == "precision":
            line = grids.loc[int(value.row.partition("x")[0])]
            note = f"{line.azimuth_step_deg:.1f} degrees in the azimuth; ten times as many degrees as printed are {10 * float(value.value):g}"
            lines.append(printed_row(value, line.polar_step_deg, note, "thesis-misprint"))
    return lines
