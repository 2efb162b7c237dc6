# SPDX-License-Identifier: GPL-3.0-or-later
# @data      helix_placement helix_lookup_error schemes scheme_errors scheme_savings lut_memory stencil_time sampling_time
# @depends   tables/figure-50-difference.csv
"""Statements on USID, the second system (Chapter 4)."""

from pathlib import Path

import pandas as pd

import common
from common import timing
from findings.finding import Finding, finding, load, one, rounded

FINEST = 0.05  # degrees
POLYHEDRA = r"cube|octahedr|icosahedr"  # in the label of a scheme
SEARCH = 1.5  # a search takes twice as many steps in stencil_time; below this there is none


def uniform(results: Path) -> Finding:
    """Eq. 9."""
    first = common.load(results, "helix_placement").iloc[0]
    constants = common.load(results, "schemes").set_index("scheme").covering_constant
    aspect = first.along_deg / first.between_turns_deg
    return finding(
        "Eq. 9",
        "With k = sqrt(w) the points of the helix are equally distributed.",
        f"With {first.turns:.0f} turns they are {rounded(first.along_deg)} degrees apart along the curve and "
        f"{rounded(first.between_turns_deg)} across, a ratio of {aspect:.2f}. The isotropic helix covers better: "
        f"N rho^2 is {rounded(constants.helix_isotropic)} against {rounded(constants.usid)}.",
        "helix_placement: along_deg, between_turns_deg; schemes: covering_constant",
        holds=abs(aspect - 1) < 0.05,
        otherwise="imprecise",
    )


def rasterised(results: Path) -> Finding:
    """Section 4.2.2."""
    lines = timing.compare(results, timing.TABLE_8)
    lines = lines[lines.precision_deg == FINEST].set_index("method")
    times = lines.measured_ms
    ours, theirs = times.usid / times.rsid, times.usid_thesis_kept / times.rsid_thesis_kept
    thesis = timing.thesis_times(timing.TABLE_8)
    printed = thesis[FINEST, "usid"] / thesis[FINEST, "rsid"]
    return finding(
        "4.2.2",
        "Rasterisation is of no help to fill the helix directly.",
        f"At {FINEST} degrees, filled by way of a temporary grid it takes {rounded(theirs, 2)} times as long as the grid "
        f"(thesis: {rounded(printed, 2)}), rasterised straight {rounded(ours, 2)} times.",
        "sampling_time: median_ms",
        holds=ours >= theirs,
        inconclusive=bool(lines.inconclusive[["usid", "rsid", "usid_thesis_kept", "rsid_thesis_kept"]].any()),
    )


def travelled_distance(results: Path) -> Finding:
    """Eq. 10 as a length."""
    first = common.load(results, "helix_placement").iloc[0]
    last = common.load(results, "helix_placement").iloc[-1]
    return finding(
        "Eq. 10",
        "The distance travelled along the helix is (4k + 1)(1 - cos phi) / 2.",
        f"The whole curve of {first.turns:.0f} turns is {first.length:.4f} long, not {first.length_eq10:.0f}; that of "
        f"{last.turns:,.0f} is {last.length:.4f}. Eq. 10 is the height travelled along the axis, and places entries at "
        "equal steps of it.",
        "helix_placement: length, length_eq10",
        holds=abs(first.length_eq10 - first.length) < 0.01,
    )


def index(results: Path) -> Finding:
    """Eq. 10 over points at equal distances."""
    placement = common.load(results, "helix_placement")
    first, last = placement.iloc[0], placement.iloc[-1]
    errors = load(results, "helix_lookup_error", turns=first.turns)
    off = one(errors, "rms_mm", lookup="eq10_true_spacing")
    exact = one(errors, "rms_mm", lookup="eq10")
    return finding(
        "4.3, step c",
        "With points equally distributed along the curve, the index is floor(T / dx).",
        f"Off by up to {rounded(abs(first.mismatch_true_spacing))} entries ({last.mismatch_true_spacing:,.0f} with "
        f"{last.turns:,.0f} turns), on the ball {rounded(off)} mm root mean square; with Eq. 10's own dx by up to "
        f"{rounded(abs(first.mismatch_eq10_spacing), 2)} to {rounded(abs(last.mismatch_eq10_spacing), 2)} entries. It is exact for "
        f"points at equal steps of Eq. 10 ({exact:.1e} mm).",
        "helix_placement: mismatch_true_spacing, mismatch_eq10_spacing; helix_lookup_error: rms_mm",
        holds=abs(first.mismatch_true_spacing) < 1,
    )


def first_turn(results: Path) -> Finding:
    """Section 4.3."""
    usid, rsid = (common.load(results, "scheme_errors").set_index("scheme").loc[name] for name in ("usid", "rsid"))
    return finding(
        "4.3",
        "Inside the first and the last turn, three neighbours are enough.",
        f"Within 1 degree of a pole the error (root mean square times entries) is {usid.entries_rms_poles:,.0f}, "
        f"{usid.entries_rms_poles / usid.entries_rms:.1f} times that over the whole sphere; RSID has {rsid.entries_rms_poles:,.0f} "
        "there: the entry on the pole stands for a missing row.",
        "scheme_errors: entries_rms_poles, entries_rms",
        holds=usid.entries_rms_poles < 1.5 * usid.entries_rms,
        otherwise="imprecise",
    )


def saving(results: Path) -> Finding:
    """Section 4.4."""
    saved = load(results, "scheme_savings", scheme="usid", precision_deg=1.0).set_index("meaning").saved_percent
    filled = load(results, "lut_memory", precision_deg=1.0).set_index("scheme").filled_bytes
    return finding(
        "4.4",
        "USID takes about 20 % less memory.",
        f"{saved.equator_spacing:.1f} % at equal spacing on the equator, {100 * (1 - filled.usid / filled.rsid):.1f} % with the rim masks "
        f"of filled tables. At equal covering {saved.covering_radius:.1f} %, at equal "
        f"interpolation error {saved.interpolation_p9999:.1f} % (99.99th percentile) or {saved.interpolation_rms:.1f} % (rms): it "
        "saves more than was claimed.",
        "scheme_savings: saved_percent; lut_memory: filled_bytes",
        holds=abs(saved.equator_spacing - 20) < 1,
    )


def same_result(results: Path) -> Finding:
    """Figure 50."""
    table = pd.read_csv(results / "tables" / "figure-50-difference.csv")
    largest = table.loc[table.largest_difference_mm.idxmax()]
    pairs = table.drop_duplicates(["joint", "surface"])
    changed = table.groupby(["joint", "surface"]).changed.max().sum()
    return finding(
        "4.4, Figure 50",
        "USID produces the same result as RSID.",
        f"The gaps differ by up to {rounded(largest.largest_difference_mm, 2)} mm; at the threshold that parts most, "
        f"{changed:,} of {pairs.met_by_both.sum():,} vertices of {joints(table.joint.nunique())} change sides.",
        "tables/figure-50-difference: largest_difference_mm, changed",
        holds=changed == 0,
        otherwise="imprecise",
    )


def joints(count: int) -> str:
    """In words."""
    return "one joint" if count == 1 else f"{count} joints"


def search(results: Path) -> Finding:
    """Section 4.5."""
    labels = common.scheme_labels(results)
    times = common.load(results, "stencil_time").sort_values("entries")
    ratios = times.groupby("scheme").median_ns.agg(lambda values: values.iloc[-1] / values.iloc[0])
    growth = times.entries.max() / times.entries.min()
    solid = ratios[
        [name for name in ratios.index if pd.Series([labels[name]]).str.contains(POLYHEDRA, case=False)[0]]
    ]
    listed = ", ".join(f"{labels[name]} {value:.2f}" for name, value in solid.items())
    return finding(
        "4.5",
        "To look up on a subdivided polyhedron takes a search, O(n log n) for n vertices.",
        f"The cell follows in closed form. With {growth:,.0f} times as many entries, where a search takes twice as many steps, "
        f"the time to find them changes by the factor {listed}.",
        "stencil_time: median_ns",
        holds=solid.min() > SEARCH,
        inconclusive=any(timing.disqualified(times, name) for name in solid.index),
        source="baumgardner1985",
    )


def most_points(results: Path) -> Finding:
    """Section 4.5."""
    finest = load(results, "lut_memory", precision_deg=FINEST).set_index("scheme")
    constant = common.load(results, "schemes").set_index("scheme").covering_constant.helix_isotropic
    return finding(
        "4.5",
        "Generalised spiral points are limited to 12,000.",
        f"The rule has no largest number: the isotropic helix, a spiral of the same family, is filled with "
        f"{finest.entries.helix_isotropic:,} entries, and covers with N rho^2 = {rounded(constant)}.",
        "lut_memory: entries; schemes: covering_constant",
        holds=finest.entries.helix_isotropic <= 12000,
        source="saff1997",
    )
