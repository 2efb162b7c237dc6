# SPDX-License-Identifier: GPL-3.0-or-later
# @data      claims
"""Statements of the last chapter that the thesis did not show."""

import math
from pathlib import Path

from common.ranges import MACHINE, Range
from findings.finding import Finding, finding, load, rounded


def values(results: Path, claim: str) -> dict:
    """A dict from (setting, quantity) to the value."""
    table = load(results, "claims", claim=claim)
    return table.set_index(["setting", "quantity"]).value.to_dict()


def deforming(results: Path) -> Finding:
    """Deforming surfaces (Chapter 6)."""
    found = values(results, "deforming surface updated in place")
    gains = [
        found[cap, "time anew"] / found[cap, "time in place"]
        for cap, quantity in found
        if quantity == "time in place"
    ]
    return finding(
        "Chapter 6",
        "Updating the table of a deformed surface is very efficient.",
        f"In place, with the same bits, {rounded(gains[0], 2)} times faster than filling anew where a cap of 5 degrees moves, "
        f"{rounded(gains[-1], 2)} times where one of 45 does.",
        "claims: time in place, time anew",
        value=Range(min(gains), max(gains)).widened(MACHINE),
        within=(1, math.inf),
        otherwise="imprecise",
    )


def same_distance(results: Path) -> Finding:
    """Self-collision at the same distance (Chapter 6)."""
    found = values(results, "self-collision found while sampling")
    share = {setting: value for (setting, quantity), value in found.items() if quantity == "crossing pairs found"}
    tight = [value for setting, value in share.items() if setting.endswith("within 0.001 mm")]
    wide = [value for setting, value in share.items() if setting.endswith("within 0.1 mm")]
    return finding(
        "Chapter 6",
        "Self-collision shows where sample points of two triangles have the same direction and the same distance.",
        f"Of {int(found['exact', 'pairs crossing'])} pairs that cross, {rounded(max(tight), 2) if max(tight) else 'none'}"
        f"{' %' if max(tight) else ''} at best put the same distance to 0.001 mm into an entry, and {rounded(min(wide), 2)} % "
        "or more distances within 0.1 mm: a tolerance that follows from the spacing belongs to it.",
        "claims: crossing pairs found",
        holds=min(tight) > 99,
        otherwise="imprecise",
    )


def added_distance(results: Path) -> Finding:
    """Layers as an added distance (Chapter 6)."""
    found = values(results, "several layers")
    neck = found["normal hip, whole ball", "distance added, largest error"]
    facing = found["normal hip, under the socket", "distance added, rms error"]
    return finding(
        "Chapter 6",
        "Several layers follow from one table by adding a distance.",
        f"A layer of 2 mm is off by {rounded(1e3 * facing, 2)} micrometres (root mean square) under the socket of a normal hip, "
        f"where the head is a sphere, and by up to {rounded(neck, 2)} mm on its neck, which rays meet obliquely.",
        "claims: distance added",
        holds=neck < 0.1,
        otherwise="imprecise",
    )
