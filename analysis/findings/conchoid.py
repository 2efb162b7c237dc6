# SPDX-License-Identifier: GPL-3.0-or-later
# @data      conchoid_angles conchoid_origins conchoid_shape conchoid_surface weighted_sampling
"""Statements on the conchoid (Section 5.1)."""

import math
from pathlib import Path

import common
from common.ranges import Range
from findings.finding import Finding, finding, load, printed, rounded
from verdicts.verdict import near_claim

RAYS = 4  # of the thesis' example
FINE_RAYS = 901  # of its Figures 58 and 59


def excess(one: float, other: float) -> float:
    """By how many per cent one length exceeds the other."""
    return 100 * (one / other - 1)


def middle_segments(results: Path) -> Finding:
    """Segments in the middle, seen from the centre of the object."""
    origins = common.load(results, "conchoid_origins").set_index("origin")
    middle = origins.loc["cap_extent_middle"]
    centres = origins.drop(index="conchoid_origin")
    every = [excess(row.middle_mm_per_deg, row.apex_mm_per_deg) for row in centres.itertuples()]
    return finding(
        "5.1.1",
        "From the centre of the object, the segments in the middle are up to 20 % longer than those at the bottom.",
        f"{excess(middle.middle_mm_per_deg, middle.apex_mm_per_deg):.1f} % from the middle of the extent, {min(every):.0f} to "
        f"{max(every):.0f} % from other centres; but the longest are at the rim, "
        f"{excess(middle.rim_mm_per_deg, middle.apex_mm_per_deg):.1f} % longer.",
        "conchoid_origins: middle_mm_per_deg, rim_mm_per_deg, apex_mm_per_deg",
        holds=middle.largest_mm_per_deg < 1.01 * middle.middle_mm_per_deg,
        otherwise="imprecise",
    )


def bottom_segments(results: Path) -> Finding:
    """Segments at the bottom, seen from the conchoid's own origin."""
    origin = load(results, "conchoid_origins", origin="conchoid_origin").iloc[0]
    longer = excess(origin.apex_mm_per_deg, origin.rim_mm_per_deg)
    return finding(
        "5.1.1",
        "From the conchoid's origin, the segments at the bottom are up to 30 % longer than those at the top.",
        f"{longer:.1f} % longer with many rays; those at the top are {-excess(origin.rim_mm_per_deg, origin.apex_mm_per_deg):.1f} % shorter.",
        "conchoid_origins: apex_mm_per_deg, rim_mm_per_deg",
        holds=near_claim(longer, printed("section-5.1", "conchoid_origin_excess", "spacing")),
        otherwise="imprecise",
    )


def quarter_length(results: Path) -> Finding:
    """The length of a quarter: Eq. 14 and its evaluation."""
    shape = common.load(results, "conchoid_shape").iloc[0]
    return finding(
        "Eq. 14",
        "The length of the curve from the apex to the rim is 3.03 b.",
        f"{shape.quarter_over_b:.4f} b: 2ab was put for a^2 + b^2, which gives {shape.closed_form_quarter_over_b:.4f} b.",
        "conchoid_shape: quarter_over_b, closed_form_quarter_over_b",
        holds=f"{shape.quarter_over_b:.2f}" == "3.03",
        otherwise="imprecise",
    )


def segment_length(results: Path) -> Finding:
    """The length of a segment: the text before Eq. 15 has 3.03 b / n with n rays, Eq. 15 has n - 1."""
    angles = load(results, "conchoid_angles", rays=RAYS).set_index("i")
    last = angles.thesis_deg[RAYS - 1]
    share = (RAYS - 1) / RAYS * math.sin(math.radians(last) / 2)
    short = math.degrees(2 * math.asin(share))
    return finding(
        "5.1.2",
        "n rays cut the curve into segments of the length 3.03 b / n.",
        f"Into n - 1 of them, as in Eq. 15. With 3.03 b / n the last of {RAYS} rays would end at {short:.1f} degrees, and not at "
        f"{last:.1f}.",
        "conchoid_angles: thesis_deg",
        holds=abs(short - last) < 1,
        otherwise="misprint",
    )


def last_ray(results: Path) -> Finding:
    """The last ray by Eq. 16 with its rounded constants."""
    angles = load(results, "conchoid_angles", rays=FINE_RAYS)
    last = angles.thesis_deg.iloc[-1]
    return finding(
        "Eq. 16",
        "The last of the adjusted rays stands at 90 degrees.",
        f"At {last:.3f} degrees with 3.03 and 4.29, at {angles.closed_form_deg.iloc[-1]:.3f} without rounding.",
        "conchoid_angles: thesis_deg, closed_form_deg",
        holds=abs(last - 90) < 0.01,
        otherwise="imprecise",
    )


def largest_adjustment(results: Path) -> Finding:
    """The largest adjustment in Figure 59."""
    angles = load(results, "conchoid_angles", rays=FINE_RAYS)
    moved = angles[["thesis_deg", "closed_form_deg", "exact_deg"]].sub(angles.original_deg, axis=0).min()
    return finding(
        "5.1.2, Figure 59",
        "No ray is turned by more than about -4 degrees.",
        f"{moved.thesis_deg:.2f} by Eq. 16, {moved.closed_form_deg:.2f} without rounded constants, {moved.exact_deg:.2f} by the "
        "exact length.",
        "conchoid_angles: thesis_deg, closed_form_deg, exact_deg",
        holds=round(moved.thesis_deg) == -4,
    )


def on_the_surface(results: Path) -> Finding:
    """Rings of rays on the turned curve."""
    surface = common.load(results, "conchoid_surface").groupby("sampling")
    spread = surface.largest_mm2.max() / surface.smallest_mm2.min()
    return finding(
        "5.1.1, 5.1.2, 6.2",
        "With the rays adjusted on each slice, the surface is equally sampled.",
        f"The areas that points stand for differ by the factor {rounded(spread.thesis_rings)}, and by "
        f"{rounded(spread.equal_angle_rings)} without adjustment: rings still crowd at the apex. Along an equal-area spiral the "
        f"factor is {spread.equal_area_spiral:.2f}. Section 6.2 takes it back: uniform on each slice alone.",
        "conchoid_surface: smallest_mm2, largest_mm2",
        holds=spread.thesis_rings < 1.5,
        otherwise="imprecise",
    )


def weighted(results: Path) -> Finding:
    """Weighted sampling (Section 5.1) as a scheme, which the thesis never made of it: by the error of gaps on every cap, with
    the same number of entries."""
    table = common.load(results, "weighted_sampling").set_index(["joint", "precision_deg", "scheme"])
    grid, rings, area = (table.xs(scheme, level="scheme") for scheme in ("rsid", "weighted_rings", "conchoid"))
    by_rings = rings.rms_um / grid.rms_um
    by_area = area.rms_um * area.entries / (grid.rms_um * grid.entries)
    joints = table.index.unique("joint")
    return finding(
        "5.1",
        "The rays have to be adjusted to fit the hip joint's shape, so that its surface is equally sampled.",
        f"With as many entries, the adjusted rays change the error of a gap (root mean square) by the factor {by_rings.min():.2f} to "
        f"{by_rings.max():.2f}, by cap and precision, on {len(joints)} caps: better on some and worse on others. Equal areas, at equal "
        f"entries, by {by_area.min():.2f} to {by_area.max():.2f}.",
        "weighted_sampling: rms_um, entries",
        value=Range(by_rings.min(), by_rings.max()),
        within=(0, 1),
    )
