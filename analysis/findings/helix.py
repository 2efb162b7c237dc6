# SPDX-License-Identifier: GPL-3.0-or-later
# @data      helix_placement helix_lookup_error schemes scheme_errors scheme_savings lut_memory stencil_time sampling_time
# @depends   tables/figure-50-difference.csv
"""Statements on USID, the second system (Chapter 4)."""

import math
from pathlib import Path

import pandas as pd

import common
from common import timing
from common.ranges import MACHINE, Range, time_range, union
from findings.finding import Finding, finding, load, one, printed, rounded
from verdicts.verdict import near_claim

FINEST = 0.05  # degrees
POLYHEDRA = r"cube|octahedr|icosahedr"  # in the label of a scheme
SEARCH = 1.5  # a search takes twice as many steps in stencil_time; below this there is none


def uniform(results: Path) -> Finding:
    """Uniform points (Eq. 9)."""
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
    """Filling the helix by the raster (Section 4.2.2), with tables that are kept or made anew."""
    lines = timing.compare(results, timing.TABLE_8)
    lines = lines[lines.precision_deg == FINEST].set_index("method")
    times = {method: timing.spread(line) for method, line in lines.iterrows()}
    straight = times["usid"] / times["rsid"]
    by_grid = [times[f"usid_thesis{kept}"] / times[f"rsid_thesis{kept}"] for kept in ("_kept", "")]
    thesis = timing.thesis_times(timing.TABLE_8)
    printed = thesis[FINEST, "usid"] / thesis[FINEST, "rsid"]
    ms = lines.measured_ms
    return finding(
        "4.2.2",
        "Rasterisation is of no help to fill the helix directly.",
        f"At {FINEST} degrees, filled by way of a temporary grid it takes {rounded(ms.usid_thesis_kept / ms.rsid_thesis_kept, 2)} times as long as the "
        f"grid (thesis: {rounded(printed, 2)}), {rounded(ms.usid_thesis / ms.rsid_thesis, 2)} times if tables are made anew, rasterised straight "
        f"{rounded(ms.usid / ms.rsid, 2)} times.",
        "sampling_time: median_ms, iqr_ms",
        value=union((straight / way).widened(MACHINE) for way in by_grid),
        within=(1, math.inf),
    )


def travelled_distance(results: Path) -> Finding:
    """The travelled distance of Eq. 10 as a length."""
    first = common.load(results, "helix_placement").iloc[0]
    last = common.load(results, "helix_placement").iloc[-1]
    return finding(
        "Eq. 10",
        "The distance travelled along the helix is (4k + 1)(1 - cos phi) / 2.",
        f"The whole curve of {first.turns:.0f} turns is {first.length:.4f} long, not {first.length_eq10:.0f}, "
        f"{100 * (first.length_eq10 / first.length - 1):.2f} % more; that of {last.turns:,.0f} is {last.length:.4f}. Eq. 10 "
        "is the height travelled along the axis, and places entries at equal steps of it.",
        "helix_placement: length, length_eq10",
        holds=abs(first.length_eq10 - first.length) < 0.01,
        otherwise="imprecise",
    )


def index(results: Path) -> Finding:
    """The index by Eq. 10 among points at equal distances."""
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
    """The first turn (Section 4.3)."""
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
    """The saving (Section 4.4), by the thesis' own two tables."""
    saved = load(results, "scheme_savings", scheme="usid", precision_deg=1.0).set_index("meaning").saved_percent
    table = common.load(results, "lut_memory")
    ours = table.pivot(index="precision_deg", columns="scheme", values="bytes")
    percent = 100 * (1 - ours.usid / ours.rsid).sort_index(ascending=False)
    filled = table[table.precision_deg == 1.0].set_index("scheme").filled_bytes
    return finding(
        "4.4",
        "USID takes about 20 % less memory.",
        f"{', '.join(f'{value:.1f} % at {precision:g}' for precision, value in percent.items())} degrees at equal spacing on the equator; "
        f"{100 * (1 - filled.usid / filled.rsid):.1f} % at 1 degree with the rim masks of filled tables. At equal covering "
        f"{saved.covering_radius:.1f} %, at equal interpolation error {saved.interpolation_p9999:.1f} % (99.99th percentile) or "
        f"{saved.interpolation_rms:.1f} % (rms).",
        "scheme_savings: saved_percent; lut_memory: bytes, filled_bytes",
        holds=all(near_claim(value, printed("section-4.4", "memory", "saving")) for value in percent),
        otherwise="imprecise",
    )


def same_result(results: Path) -> Finding:
    """The same result in Figure 50, as far as the thesis' tables of 1 degree are right by its Table 5."""
    table = pd.read_csv(results / "tables" / "figure-50-difference.csv")
    largest = table.groupby("joint").largest_difference_mm.max()
    pairs = table.drop_duplicates(["joint", "surface"])
    changed = table.groupby(["joint", "surface"]).changed.max().sum()
    error = float(printed("table-5", "max_error", "1deg"))
    return finding(
        "4.4, Figure 50",
        "USID produces the same result as RSID.",
        f"To {error:g} mm, the error that the thesis gives both tables: the gaps differ by up to {rounded(largest.min(), 2)} to "
        f"{rounded(largest.max(), 2)} mm. At the threshold that parts most, {changed:,} of {pairs.met_by_both.sum():,} vertices of "
        f"{joints(table.joint.nunique())} change sides.",
        "tables/figure-50-difference: largest_difference_mm, changed",
        value=Range(largest.min(), largest.max()),
        within=(0, error),
        otherwise="imprecise",
    )


def joints(count: int) -> str:
    """The joints in words."""
    return "one joint" if count == 1 else f"{count} joints"


def search(results: Path) -> Finding:
    """The search (Section 4.5)."""
    labels = common.scheme_labels(results)
    times = common.load(results, "stencil_time").sort_values("entries")
    times = times[times.scheme.map(labels).str.contains(POLYHEDRA, case=False)]
    found = {}
    for name, rows in times.groupby("scheme"):
        few, many = (time_range(line.median_ms, line.iqr_ms, line.rounds) for line in (rows.iloc[0], rows.iloc[-1]))
        found[name] = (many / few).widened(MACHINE)
    growth = times.entries.max() / times.entries.min()
    listed = ", ".join(f"{labels[name]} {value.low:.2f} to {value.high:.2f}" for name, value in found.items())
    return finding(
        "4.5",
        "To look up on a subdivided polyhedron takes a search, O(n log n) for n vertices.",
        f"The cell follows in closed form. With {growth:,.0f} times as many entries, where a search takes twice as many steps, "
        f"the time to find them changes by the factor {listed}.",
        "stencil_time: median_ms, iqr_ms",
        value=union(found.values()),
        within=(SEARCH, math.inf),
        source="baumgardner1985",
    )


def most_points(results: Path) -> Finding:
    """The most points (Section 4.5)."""
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
