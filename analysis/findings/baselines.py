# SPDX-License-Identifier: GPL-3.0-or-later
# @data      baselines all_gaps
"""Statements about the methods that Chapter 2 and Section 3.6 compare with."""

import dataclasses
import math
from pathlib import Path

import pandas as pd

from common import fast, timing
from common.ranges import MACHINE, Range, time_range
from findings.finding import ARITHMETIC, Finding, finding, load, rounded

PATIENT = 12000  # triangles of each model, as the thesis' patient
TABLE = "cube_gnomonic_mesh_exact"
FINE = 1000  # faces of a ball that is not coarse
MANY = 0.5  # per cent of the triangles, some tens of them
EXACT_UM = 1  # micrometres: nearer to the surface than any table of the thesis


def grid_memory() -> Finding:
    """Memory of a grid (Section 2.2.2)."""
    size = 1024**3 * 8
    return finding(
        "2.2.2",
        "A distance field of 1024 x 1024 x 1024 in double takes 8 GB.",
        f"{size:,} bytes: {size / 2**30:g} GiB, {size / 1e9:.2f} GB.",
        ARITHMETIC,
        holds=size == 8 * 2**30,
    )


def vertex_times(results: Path) -> pd.DataFrame:
    """Time for a vertex of the ball by every way to find its gap, with one thread and the widest instructions."""
    table = fast.load(results)
    table = table[(table.direction == "ball->socket") & (table.threads == 1)]
    return table[table.instruction_set.isin(["none", fast.best_set(table)])]


def no_distances(results: Path) -> Finding:
    """Methods without distances (Sections 2.2.1, 3.4 and 3.6.1)."""
    times = vertex_times(results)
    times = times[times.triangles == PATIENT].set_index("method")
    rays, closest = times.loc["embree_ray8"], times.loc["embree_closest"]
    return finding(
        "2.2.1, 3.4, 3.6.1, Chapter 6",
        "RAPID and the current methods by hierarchies of bounding volumes do not provide the distances between two surfaces.",
        f"True of RAPID. A later one does, Embree's: of every vertex at {PATIENT:,} triangles along the ray to {rounded(1e3 * rays.error_um, 1)} nm in "
        f"{rounded(rays.ns_vertex, 2)} ns a vertex, of the closest point in {rounded(closest.ns_vertex, 2)} ns.",
        "all_gaps: max_over_um, ns_vertex",
        holds=bool(rays.error_um > EXACT_UM),
        otherwise="imprecise",
        source="wald2014",
    )


def tree_growth(results: Path) -> Finding:
    """How a tree's time grows (Section 3.6.1), by the time of one of the n points."""
    times = vertex_times(results)
    cube = (times.method == TABLE) & (times.setting == "n=291") & (times.storage == "uint16")
    small, large = times.triangles[cube].min(), PATIENT

    def spread(rows: pd.DataFrame, triangles: int) -> Range:
        (line,) = rows[rows.triangles == triangles].itertuples()
        return time_range(line.ns_vertex, line.iqr_ns, line.rounds)

    tree, table = (
        (spread(rows, large) / spread(rows, small)).widened(MACHINE) for rows in (times[times.method == "embree_ray8"], times[cube])
    )
    by_log = math.log(large) / math.log(small)
    return finding(
        "3.6.1",
        "The distances of n points take O(n log n) with a tree, and O(n) with the table.",
        f"From {small:,} to {large:,} triangles the time of a point grows by the factor {tree.low:.2f} to {tree.high:.2f} with Embree's tree, where "
        f"log n grows by {by_log:.2f}, and by {table.low:.2f} to {table.high:.2f} with a table of one size, which has to be filled first.",
        "all_gaps: ns_vertex, iqr_ns, both as shares of what log n allows",
        value=Range(max(tree.low / 1.5, table.low) / by_log, max(tree.high / 1.5, table.high) / by_log),
        within=(0, 1),
        otherwise="imprecise",
    )


def generated(results: Path, method: str):
    """The rows of one method on the generated pair."""
    table = load(results, "baselines", method=method)
    return table[table.joint == table.joint.iloc[0]]


def every_triangle(results: Path) -> Finding:
    """Every triangle is tested (Section 3.6.3)."""
    table = load(results, "baselines", method="rsid", size=1.0)
    missed = table.faces_missed
    worst = table.loc[(missed / table.faces).idxmax()]
    joints = len(table)
    where = f"in the worst of {joints} joints" if joints > 1 else "of the generated pair"
    return finding(
        "3.6.3",
        "RSID samples all the triangles, without missing a single one.",
        f"At 1 degree {int(worst.faces_missed):,} of {int(worst.faces):,} triangles of the ball hold no entry, {where}; "
        f"no vertex is left without an answer for that, since a look-up interpolates.",
        "baselines: faces_missed",
        holds=bool((missed == 0).all()),
    )


def lost_triangles(results: Path) -> Finding:
    """Lost triangles (Section 3.6.3). It uses hips, since the faces of the generated ball are all of one size and no smaller
    than the distance of the rays, and the thesis speaks of models as fine as its patient's.
    """
    table = load(results, "baselines", method="maciel_triangles", size=400)
    table = table[table.faces >= FINE]
    lost = 100 * table.faces_missed / table.faces
    even, hips = lost.iloc[0], lost.iloc[1:]
    unanswered = 100 * table.points_missed / table.points
    return finding(
        "3.6.3",
        "With one triangle a direction, many triangles are lost even in a table of 400 x 400.",
        f"400 x 400 rays lose {rounded(hips.min(), 2)} to {rounded(hips.max(), 2)} % of the triangles of {len(hips)} hips, and "
        f"{rounded(even, 2)} % of those of the generated ball, which are all of one size; {rounded(unanswered.min(), 2)} to "
        f"{rounded(unanswered.max(), 2)} % of the vertices do not meet the triangle of their ray and get no answer.",
        "baselines: faces_missed, points_missed",
        value=Range(hips.min(), hips.max()),
        within=(MANY, 100),
        otherwise="imprecise",
    )


def field_memory(results: Path) -> Finding:
    """Memory of a distance field (Section 3.6.2)."""
    field = generated(results, "cartesian_field").sort_values("size").iloc[-1]
    table = generated(results, "rsid")
    enough = table[table.rms_error_mm <= field.rms_error_mm].sort_values("bytes").iloc[0]
    built = [time_range(line.build_ms, line.build_iqr_ms, 2 if line.build_iqr_ms > 0 else 1) for line in (enough, field)]
    return finding(
        "3.6.2",
        "A distance field on a Cartesian grid takes more memory and more time to fill for less resolution.",
        f"{int(field['size'])} nodes a side take {rounded(field.bytes / 1e3)} kB and {rounded(field.build_ms, 2)} ms for an error of "
        f"{rounded(1e3 * field.rms_error_mm, 2)} micrometres (root mean square); RSID at {enough['size']:g} degrees takes "
        f"{rounded(enough.bytes / 1e3)} kB and {rounded(enough.build_ms, 2)} ms for {rounded(1e3 * enough.rms_error_mm, 2)}.",
        "baselines: bytes, build_ms, rms_error_mm, RSID's time and bytes as shares, the larger",
        value=Range(*(max(share, enough.bytes / field.bytes) for share in dataclasses.astuple((built[0] / built[1]).widened(MACHINE)))),
        within=(0, 1),
        otherwise="imprecise",
    )
