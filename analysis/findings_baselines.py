# SPDX-License-Identifier: GPL-3.0-or-later
"""Statements about the methods that Section 3.6 compares with."""

from __future__ import annotations

from pathlib import Path

from finding import finding, load, rounded


def rows(results: Path) -> list[dict]:
    """All of them."""
    return [every_triangle(results), lost_triangles(results), field_memory(results)]


def generated(results: Path, method: str):
    """The rows of one method on the generated pair."""
    table = load(results, "baselines", method=method)
    return table[table.joint == table.joint.iloc[0]]


def every_triangle(results: Path) -> dict:
    """Section 3.6.3."""
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


def lost_triangles(results: Path) -> dict:
    """Section 3.6.3."""
    table = generated(results, "maciel_triangles").set_index("size")
    coarse, fine = table.loc[10], table.loc[400]
    lost = 100 * fine.points_missed / fine.points
    return finding(
        "3.6.3",
        "With one triangle a direction, many triangles are lost even in a table of 400 x 400.",
        f"10 x 10 rays lose {int(coarse.faces_missed):,} of {int(coarse.faces):,}, 400 x 400 lose {int(fine.faces_missed):,}; but "
        f"{rounded(lost, 2)} % of the vertices still do not meet the triangle of their ray and get no answer.",
        "baselines: faces_missed, points_missed",
        holds=fine.faces_missed > 0,
        otherwise="imprecise",
    )


def field_memory(results: Path) -> dict:
    """Section 3.6.2."""
    field = generated(results, "cartesian_field").sort_values("size").iloc[-1]
    table = generated(results, "rsid")
    enough = table[table.rms_error_mm <= field.rms_error_mm].sort_values("bytes").iloc[0]
    return finding(
        "3.6.2",
        "A distance field on a Cartesian grid takes more memory and more time to fill for less resolution.",
        f"{int(field['size'])} nodes a side take {rounded(field.bytes / 1e3)} kB and {rounded(field.build_ms, 2)} ms for an error of "
        f"{rounded(1e3 * field.rms_error_mm, 2)} micrometres (root mean square); RSID at {enough['size']:g} degrees takes "
        f"{rounded(enough.bytes / 1e3)} kB and {rounded(enough.build_ms, 2)} ms for {rounded(1e3 * enough.rms_error_mm, 2)}.",
        "baselines: bytes, build_ms, rms_error_mm",
        holds=bool(enough.bytes < field.bytes and enough.build_ms < field.build_ms),
        otherwise="imprecise",
    )
