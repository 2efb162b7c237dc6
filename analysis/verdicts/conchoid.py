# SPDX-License-Identifier: GPL-3.0-or-later
# @data      conchoid_angles conchoid_shape conchoid_origins
"""Verdicts on the conchoid (Table 10, Section 5.1): lengths, adjusted rays, and what Figure 53 claims."""

import math
from pathlib import Path

import pandas as pd

import common
from verdicts.verdict import claim_row, input_row, near_claim, not_counted, printed_row

RAYS = 4  # of Table 10
FINE_RAYS = 901  # of Figures 58 and 59


def rows(results: Path) -> list[dict]:
    """The rows of Table 10, then of Section 5.1."""
    angles = common.load(results, "conchoid_angles")
    shape = common.load(results, "conchoid_shape").iloc[0]
    origins = common.load(results, "conchoid_origins").set_index("origin")
    return table_10(angles) + section_5_1(angles, shape, origins)


def table_10(angles: pd.DataFrame) -> list[dict]:
    """Table 10, by Eq. 16 with the thesis' rounded constants."""
    four = angles[angles.rays == RAYS].set_index("i")
    ours = pd.DataFrame(
        {
            "original_angle": four.original_deg,
            "adjusted_angle": four.thesis_deg,
            "adjustment": four.thesis_deg - four.original_deg,
        }
    )
    exact = {"adjusted_angle": four.exact_deg, "adjustment": four.exact_deg - four.original_deg}
    lines = []
    for value in common.thesis("table-10").itertuples():
        i = int(value.row.removeprefix("i="))
        if value.column == "adjustment_of_phi":
            again = printed_row(value, ours["adjustment"][i])
            lines.append(not_counted(again, f"the same number as table-10, {value.row}, adjustment"))
            continue
        if i == 0 or value.column == "original_angle":
            lines.append(input_row(value, "given: rays at equal angles, of which the first is not turned"))
            continue
        note = f"{exact[value.column][i]:.2f} by the exact length" if value.column in exact else ""
        lines.append(printed_row(value, ours[value.column][i], note))
    return lines


def section_5_1(angles: pd.DataFrame, shape: pd.Series, origins: pd.DataFrame) -> list[dict]:
    """A row for each value."""
    values = {(value.row, value.column): value for value in common.thesis("section-5.1").itertuples()}
    ratio = shape.a_over_b
    quarter, factor = (float(values["conchoid", name].value) for name in ("quarter_length_over_b", "length_factor"))
    counts = {"at_1_degree": 91, "at_0.1_degrees": FINE_RAYS}
    segments = counts["at_1_degree"] - 1
    unrounded = math.sin(math.pi / 4) / segments
    return [
        input_row(values["conchoid", "a"]),
        input_row(values["conchoid", "b"]),
        printed_row(values["conchoid", "a_over_b"], ratio),
        printed_row(values["conchoid", "2ab_over_b2"], 2 * ratio, f"put for (a^2 + b^2) / b^2 as well, which is {ratio**2 + 1:.4f}"),
        printed_row(values["conchoid", "4ab_over_b2"], 4 * ratio),
        printed_row(values["conchoid", "length_factor"], 4 * math.sqrt(ratio)),
        printed_row(
            values["conchoid", "quarter_length_over_b"], shape.closed_form_quarter_over_b, quarter_note(shape)
        ),
        printed_row(
            values["rays", "step_of_the_sine"],
            quarter / (segments * factor),
            f"with the rounded constants; unrounded it is {unrounded:.6f}, which would print as {unrounded:.5f}",
        ),
        *(printed_row(values["rays", name], (angles.rays == count).sum()) for name, count in counts.items()),
        largest_adjustment(values["conchoid", "largest_adjustment"], angles),
        centre_claim(values["spacing", "centre_origin_excess"], origins),
        origin_claim(values["spacing", "conchoid_origin_excess"], origins.loc["conchoid_origin"]),
    ]


def quarter_note(shape: pd.Series) -> str:
    """The note on what the closed form leaves out."""
    return (
        f"the closed form puts 2ab for a^2 + b^2; the exact length is {shape.quarter_over_b:.4f} b, "
        f"{shape.quarter_over_b / shape.closed_form_quarter_over_b - 1:.2%} longer, "
        f"and would print as {shape.quarter_over_b:.2f}"
    )


def largest_adjustment(value, angles: pd.DataFrame) -> dict:
    """The largest adjustment over the rays of Figure 59."""
    fine = angles[angles.rays == FINE_RAYS]
    moved = fine[["thesis_deg", "closed_form_deg", "exact_deg"]].sub(fine.original_deg, axis=0)
    at = fine.original_deg[moved.thesis_deg.idxmin()]
    note = (
        f"at {at:.1f} degrees with 3.03 and 4.29; {moved.closed_form_deg.min():.2f} by the closed form unrounded, "
        f"{moved.exact_deg.min():.2f} by the exact length; rounded, the last ray ends "
        f"{-moved.thesis_deg.iloc[-1]:.2f} degrees short of the rim"
    )
    return printed_row(value, moved.thesis_deg.min(), note)


def excess(numerator: float, denominator: float) -> float:
    """By how many per cent one length exceeds the other."""
    return 100 * (numerator / denominator - 1)


def centre_claim(value, origins: pd.DataFrame) -> dict:
    """Segments in the middle compared with those at the bottom, from the centre of the object, which may be any of several
    points.
    """
    found = {
        name.replace("_", " "): excess(centre.middle_mm_per_deg, centre.apex_mm_per_deg)
        for name, centre in origins.drop(index="conchoid_origin").iterrows()
    }
    met = sum(near_claim(percent, value.value) for percent in found.values())
    listed = ", ".join(f"{percent:.1f} from {name}" for name, percent in found.items())
    return claim_row(
        value,
        [*found.values()],
        " from every point that the centre may be",
        f"the thesis does not say which centre it means: {met} of {len(found)} meet the claim; {listed}; middle is halfway "
        "from the apex (bottom) to the rim",
    )


def origin_claim(value, origin: pd.Series) -> dict:
    """Segments at the bottom compared with those at the top, from the conchoid's origin."""
    longer = excess(origin.apex_mm_per_deg, origin.rim_mm_per_deg)
    short = -excess(origin.rim_mm_per_deg, origin.apex_mm_per_deg)
    middle = excess(origin.middle_mm_per_deg, origin.rim_mm_per_deg)
    return claim_row(
        value,
        [longer, short, middle],
        " by every reading, for many rays at equal angles from the conchoid's origin; bottom is the apex, top the rim at 90 degrees",
        f"{longer:.1f} % longer is (a + b) / sqrt(a^2 + b^2) by the thesis' own Eq. 12; the segments at the top are {short:.1f} % shorter than "
        f"those at the bottom, and those in the middle {middle:.1f} % longer than those at the top, either of which may be meant",
    )
