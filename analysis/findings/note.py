# SPDX-License-Identifier: GPL-3.0-or-later
# @data      conchoid_angles conchoid_shape finding_interpolation helix_placement sampling_error_bounds scheme_savings schemes
"""Statements of the working note with which this reproduction began. Its list of suspected errors of the thesis is held to
the same standard.
"""

from pathlib import Path

import pandas as pd

import common
from findings.finding import Finding, finding, load, one, rounded

SAID_BY = "note"
FEW_PER_CENT = 0.03


def near(value: float, stated: float) -> bool:
    """Are the two numbers within a few per cent of each other?"""
    return abs(value / stated - 1) < FEW_PER_CENT


def linear(results: Path) -> Finding:
    """Item 3, for a surface about the centre."""
    table = load(results, "finding_interpolation", radius_of="thesis_raster", against="mesh", shifted="none")
    coarse, fine = (one(table, "largest_mm", faces=faces) for faces in (320, 1280))
    return finding(
        "note, 3",
        "Linear distances are off the mesh of a sphere of 22 mm by 0.40 mm (320 faces) and 0.10 mm (1,280).",
        f"{coarse:.2f} and {fine:.2f} mm.",
        "finding_interpolation: largest_mm",
        holds=near(coarse, 0.40) and near(fine, 0.10),
        otherwise="imprecise",
    )


def shifted(results: Path) -> Finding:
    """Item 3, for one off the centre."""
    table = load(results, "finding_interpolation", radius_of="thesis_raster", against="mesh")
    across, along = (table[table.shifted == axis].set_index("faces").largest_mm for axis in ("x", "z"))
    return finding(
        "note, 3",
        "With the sphere off the centre by 0.3 radii, by 0.78 and 0.32 mm.",
        f"It depends on the direction: {across[320]:.2f} and {across[1280]:.2f} mm with the shift across the axis of the table, "
        f"{along[320]:.2f} and {along[1280]:.2f} mm with the shift along it.",
        "finding_interpolation: largest_mm",
        holds=near(across[320], 0.78) and near(across[1280], 0.32),
        otherwise="imprecise",
    )


def mismatch(results: Path) -> Finding:
    """Item 4."""
    placement = common.load(results, "helix_placement")
    first, last = placement.iloc[0], placement.iloc[-1]
    return finding(
        "note, 4",
        "An index by Eq. 10 is wrong by up to 56 entries (229 turns) and 1,145 (4,584 turns), or 0.36 to 0.54 with its own dx.",
        f"{abs(first.mismatch_true_spacing):.1f} and {abs(last.mismatch_true_spacing):,.1f}; "
        f"{abs(first.mismatch_eq10_spacing):.2f} to {abs(last.mismatch_eq10_spacing):.2f}.",
        "helix_placement: mismatch_true_spacing, mismatch_eq10_spacing",
        holds=near(abs(first.mismatch_true_spacing), 56)
        and near(abs(last.mismatch_true_spacing), 1145)
        and near(abs(first.mismatch_eq10_spacing), 0.36)
        and near(abs(last.mismatch_eq10_spacing), 0.54),
        otherwise="imprecise",
    )


def savings(results: Path) -> pd.DataFrame:
    """Savings of the thesis' helix, by precision and meaning."""
    return load(results, "scheme_savings", scheme="usid").pivot(
        index="precision_deg", columns="meaning", values="saved_percent"
    )


def equal_covering(results: Path) -> Finding:
    """Item 6."""
    saved = savings(results).covering_radius.dropna()
    return finding(
        "note, 6",
        "At equal covering radius the helix saves 34 to 35 %.",
        f"{saved.min():.1f} to {saved.max():.1f} % with tables as small as the covering allows, entries on the poles included.",
        "scheme_savings: saved_percent",
        holds=(round(saved.min()), round(saved.max())) == (34, 35),
        otherwise="imprecise",
    )


def equal_error(results: Path) -> Finding:
    """Item 6."""
    saved = savings(results)
    worst, rms = saved.interpolation_p9999.dropna(), saved.interpolation_rms.dropna()
    return finding(
        "note, 6",
        "At equal interpolation error it saves 32 % (worst case) and 23 % (rms).",
        " and ".join(f"{at.min():.1f} to {at.max():.1f} %" for at in (worst, rms))
        + ", depending on the precision of the grid it is held against.",
        "scheme_savings: saved_percent",
        holds=worst.max() - worst.min() < 2 and rms.max() < 24,
        otherwise="imprecise",
    )


def fibonacci(results: Path) -> Finding:
    """Section B."""
    constants = common.load(results, "schemes").set_index("scheme").covering_constant
    return finding(
        "note, B",
        "The Fibonacci lattice does not cover better than plain rows of latitude.",
        f"N rho^2 is {rounded(constants.fibonacci)} against {rounded(constants.latitude_rows)}.",
        "schemes: covering_constant",
        holds=constants.fibonacci >= constants.latitude_rows,
    )


def octahedron(results: Path) -> Finding:
    """Section B, at equal error."""
    saved = load(results, "scheme_savings", precision_deg=1.0, meaning="interpolation_p9999").set_index("scheme")
    solid = saved.saved_percent.octahedral_equal_area
    return finding(
        "note, B",
        "The equal-area octahedron saves 32 %.",
        f"{one(load(results, 'scheme_savings', precision_deg=1.0, meaning='covering_radius'), 'saved_percent', scheme='octahedral_equal_area'):.0f} % "
        f"at equal covering; at equal interpolation error (99.99th percentile) {solid:.0f} %.",
        "scheme_savings: saved_percent",
        holds=solid > 30,
        otherwise="imprecise",
    )


def solid_angle(results: Path) -> Finding:
    """Item 10."""
    shape = common.load(results, "conchoid_shape").iloc[0]
    ratio = shape.apex_mm2_per_sr / shape.rim_mm2_per_sr
    return finding(
        "note, 10",
        "From the conchoid's origin, equal solid angles carry 2.64 times as much surface at the apex as at the rim, where the "
        "angle of incidence is 41 degrees.",
        f"{ratio:.2f} times; {shape.rim_incidence_deg:.1f} degrees.",
        "conchoid_shape: apex_mm2_per_sr, rim_mm2_per_sr, rim_incidence_deg",
        holds=near(ratio, 2.64) and near(shape.rim_incidence_deg, 41),
    )


def best_sphere(results: Path) -> Finding:
    """Item 10."""
    shape = common.load(results, "conchoid_shape").iloc[0]
    lowest, highest = shape.sphere_lowest_mm, shape.sphere_highest_mm
    return finding(
        "note, 10",
        "The sphere that fits the cap best has a radius of 25.2 mm and residuals of -0.74 to 0.31 mm.",
        f"{shape.sphere_radius_mm:.2f} mm and {lowest:.2f} to {highest:.2f} mm.",
        "conchoid_shape: sphere_radius_mm, sphere_lowest_mm, sphere_highest_mm",
        holds=near(shape.sphere_radius_mm, 25.2) and near(lowest, -0.74) and near(highest, 0.31),
        otherwise="imprecise",
    )


def closed_form(results: Path) -> Finding:
    """Section C.7."""
    angles = load(results, "conchoid_angles", rays=901)
    moved = angles[["thesis_deg", "closed_form_deg"]].sub(angles.original_deg, axis=0).min()
    return finding(
        "note, C.7",
        "The closed form of Eq. 16 turns a ray by up to -3.86 degrees.",
        f"{moved.closed_form_deg:.2f}; {moved.thesis_deg:.2f} come from the rounded constants.",
        "conchoid_angles: closed_form_deg, thesis_deg",
        holds=f"{moved.closed_form_deg:.2f}" == "-3.86",
        otherwise="imprecise",
    )


def face_bound(results: Path) -> Finding:
    """Section C.2."""
    bounds = common.load(results, "sampling_error_bounds")
    labels = common.scheme_labels(results)
    schemes = bounds.scheme.nunique()
    broken = bounds[~bounds.holds].groupby("reach")
    nearest = broken.get_group("covering") if "covering" in broken.groups else bounds[:0]
    farthest = broken.get_group("stencil") if "stencil" in broken.groups else bounds[:0]
    left = ", ".join(labels[name] for name in farthest.scheme.unique()) or "none"
    return finding(
        "note, C.2",
        "Inside a flat face a look-up errs by at most rho^2 / 2 r (1 + 2 tan^2 psi), rho the covering radius.",
        f"Away from the poles {nearest.scheme.nunique()} of {schemes} schemes break it; with the reach of the stencil for "
        f"rho: {left}.",
        "sampling_error_bounds: holds",
        holds=nearest.empty,
        otherwise="imprecise",
    )
