# SPDX-License-Identifier: GPL-3.0-or-later
# @data      finding_comparison finding_interpolation sampling_error sampling_error_sphere slice_band_limit detection_time
"""Statements on the joint and on RSID, the first system (Chapters 2 and 3)."""

from pathlib import Path

import common
from common import timing
from common.ranges import Range, slope_range
from findings.finding import Finding, finding, load, one, printed, rounded

EXACT = 1e-9  # mm, what rounding leaves
THESIS_FACES = 3000  # of the models that it fills tables of
PATIENT = 12000  # of the models of its patient
LEVEL = 0.25  # exponent up to which a time hardly grows, as in the verdicts


def cam_and_pincer() -> Finding:
    """Cam and pincer: a matter of definitions that rests on the cited paper; nothing is computed."""
    return finding(
        "2.1.3",
        "Cam impingement is over-coverage by the socket, pincer impingement a reduced offset of the head.",
        "The other way round, by the definition in the paper that the thesis cites for it; nothing is computed: a cam is an "
        "aspherical head with reduced offset, a pincer an acetabulum that covers too much.",
        "no data: a definition, cited",
        holds=False,
        source="ganz2003",
    )


def comparison(results: Path) -> Finding:
    """The comparison in Algorithms 2 and 3, for the scan of the socket."""
    socket = load(results, "finding_comparison", surface="socket").iloc[0]
    return finding(
        "Algorithms 2, 3",
        "The comparison d <= d_i finds impingement in both scans.",
        f"In a clear pose it calls {socket.impinged_as_written:,} of {socket.vertices_met:,} vertices of the socket "
        f"impinged; the signed gap calls {socket.impinged_by_gap:,}.",
        "finding_comparison: impinged_as_written, impinged_by_gap",
        holds=socket.impinged_as_written == socket.impinged_by_gap,
    )


def saved_distances(results: Path) -> Finding:
    """Saved distances: the colours need distances even without impingement."""
    ball = load(results, "finding_comparison", surface="ball").iloc[0]
    return finding(
        "Algorithms 2, 3",
        "The distance between the surfaces is saved, for colours up to 4 mm.",
        f"As written it is saved of impinged vertices only: of {ball.impinged_as_written:,} of {ball.vertices_met:,} "
        "vertices of the ball that face the socket in a clear pose.",
        "finding_comparison: vertices_met, impinged_as_written",
        holds=ball.impinged_as_written == ball.vertices_met,
        otherwise="imprecise",
    )


def linear_in_the_angles(results: Path) -> Finding:
    """Distances that are linear in the angles (Section 3.2)."""
    table = load(results, "finding_interpolation", radius_of="thesis_raster", against="mesh")
    centred = table[table.shifted == "none"]
    shifted = table[table.shifted != "none"].groupby("faces").largest_mm.max()
    listed = " and ".join(f"{rounded(row.largest_mm, 2)} mm ({row.faces:,} faces)" for row in centred.itertuples())
    moved = " and ".join(f"{rounded(value, 2)} mm" for value in shifted)
    to_sphere = load(results, "finding_interpolation", radius_of="thesis_raster", against="sphere", shifted="none")
    return finding(
        "3.2",
        "A triangle is sampled exactly by distances that are linear in the two angles.",
        f"Off the triangles of a sphere of 22 mm by up to {listed}; by {moved} where its centre is off by 0.3 radii. "
        f"The sphere itself is met to {to_sphere.largest_mm.max():.0e} mm.",
        "finding_interpolation: largest_mm",
        holds=table.largest_mm.max() < EXACT,
        otherwise="imprecise",
    )


def linear_time(results: Path) -> Finding:
    """Time by query in Tables 4 and 9, from the thesis' own times. It does not count its vertices; our joints with as many
    triangles have as many, to a few per cent, by Euler's formula.
    """
    data = common.load(results, timing.TABLE_9.data)
    method = common.counterparts("table-9")["rsid"]
    large, small = (rows.groupby("joint").first() for n in (PATIENT, THESIS_FACES) for rows in [data[(data.triangles == n) & (data.method == method)]])
    share = [rows.queries / rows.triangles_of_both for rows in (small, large)]
    thesis = timing.thesis_times(timing.TABLE_9)
    ns = [[1e6 * thesis[n, "rsid"] / (2 * n * part) for part in parts] for n, parts in zip((THESIS_FACES, PATIENT), share)]
    ours = [1e6 * rows.median_ms / rows.queries for rows in (small, large)]
    listed = [f"{rounded(min(values))} to {rounded(max(values))}" if len(values) > 1 else rounded(values[0])
              for values in map(list, (*ns, *ours))]
    return finding(
        "Tables 4, 9",
        "The time to test a pose is in proportion to the number of vertices.",
        f"By the thesis' own times a query takes {listed[0]} ns at {THESIS_FACES:,} triangles a model and {listed[1]} at "
        f"{PATIENT:,}, by the vertices of our joints; here {listed[2]} and {listed[3]} ns.",
        "detection_time: queries, median_ms",
        value=Range(min(ns[1]) / max(ns[0]), max(ns[1]) / min(ns[0])),
        within=(0, 1.5),
        otherwise="imprecise",
    )


def constant_time(results: Path) -> Finding:
    """Constant time (Section 3.6.1), on one joint, since another shape has other gaps."""
    lines = timing.compare(results, timing.TABLE_4)
    mine = lines[(lines.method == common.counterparts("table-4")["rapid"]) & (lines.joint == timing.GENERATED)]
    exponent = slope_range(mine["size"], [timing.spread(line) for _, line in mine.iterrows()])
    return finding(
        "3.6.1",
        "The time of an OBB tree does not depend on the number of triangles.",
        f"It grows with the power {exponent.low:.2f} to {exponent.high:.2f} from {mine.triangles.min():,} to {mine.triangles.max():,} "
        "triangles of the generated pair.",
        "detection_time: median_ms, iqr_ms",
        value=exponent,
        within=(-LEVEL, LEVEL),
    )


def sampling_error(results: Path) -> Finding:
    """The sampling error in Table 5."""
    formula = load(results, "sampling_error", scheme="rsid", precision_deg=1.0).iloc[0]
    sphere = load(results, "sampling_error_sphere", precision_deg=1.0).iloc[0]
    return finding(
        "Eq. 7, Table 5",
        f"The largest sampling error at 1 degree is {formula.formula_max_mm:.3f} mm.",
        f"That is a distance along the surface, on a sphere {rounded(sphere.tangential_max_mm)} mm. The error of the radius "
        f"is {sphere.radial_max_mm:.0e} mm on the sphere and {rounded(formula.measured_max_mm)} mm on a meshed head.",
        "sampling_error: measured_max_mm; sampling_error_sphere: tangential_max_mm",
        holds=abs(formula.measured_max_mm / formula.formula_max_mm - 1) < 0.1,
        otherwise="imprecise",
    )


def finer_tables(results: Path) -> Finding:
    """Finer tables: Table 5 compared with the smallest possible error."""
    flat = load(results, "finding_interpolation", radius_of="mesh", against="sphere", shifted="none")
    flat = 1e3 * flat.sort_values("faces").set_index("faces")[["largest_mm", "rms_mm"]]
    listed = ", ".join(f"{rounded(um)} ({faces:,} faces)" for faces, um in flat.largest_mm.items())
    finest = common.number(printed("table-5", "max_error", "0.05deg"))
    return finding(
        "Table 5",
        f"A finer table lowers the error, to {finest:g} mm at 0.05 degrees.",
        f"Of the table, but not of the joint: flat faces lie inside the sphere behind them by up to {listed} micrometres, those "
        f"of {THESIS_FACES:,} by {rounded(flat.rms_mm[THESIS_FACES])} root mean square, and no table of them is nearer to it.",
        "finding_interpolation: largest_mm, rms_mm",
        holds=flat.largest_mm[THESIS_FACES] < 1e3 * finest,
        otherwise="imprecise",
    )


def required_precision(results: Path) -> Finding:
    """The required precision (Section 3.5.2). Samples a gap apart determine band limits up to half a turn divided by the gap.
    Entries need be no closer to keep these, so rounding of the limit to a whole number plays no part.
    """
    limit = load(results, "slice_band_limit", distance="slices, middle").iloc[0]
    asked = limit.gap_deg
    claimed = common.number(printed("section-3.5.2", "required_precision", "slices"))
    return finding(
        "3.5.2",
        f"Slices 3 degrees apart ask, by Shannon's theorem, for samples {claimed:g} degrees apart.",
        f"Slices {limit.gap_deg:.2f} degrees apart determine band limits up to 180 / {limit.gap_deg:.2f} = "
        f"{180 / limit.gap_deg:.1f}, which entries as far apart keep: {claimed:g} degrees are {asked / claimed:.1f} times closer "
        "than the theorem asks, on the safe side. Half the distance helps the interpolation.",
        "slice_band_limit: gap_deg",
        holds=abs(claimed / asked - 1) < 0.1,
    )
