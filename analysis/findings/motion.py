# SPDX-License-Identifier: GPL-3.0-or-later
# @data      motion_volume_rotations
"""Statements of other papers about internal rotation, compared with the limits of generated hips."""

from pathlib import Path

from common import volume
from findings.finding import Finding, finding, load, rounded

SAID_BY = "papers"
NEAR = 1.0  # degrees, as the slope is printed to half a degree of a sample


def limits(results: Path) -> dict[tuple[str, int], float]:
    """Limits of internal rotation, degrees, by joint and flexion."""
    table = load(results, "motion_volume_rotations")
    return table.set_index(["joint", "flexion_deg"]).low_deg.to_dict()


def flexion(results: Path) -> Finding:
    """How internal rotation falls with flexion."""
    low = limits(results)
    loss = (low["normal", 70] - low["normal", 90]) / 2
    return finding(
        "PMC7754612",
        f"Past 70 degrees, 10 more of flexion cost {volume.SLOPE:g} degrees of internal rotation.",
        f"The preset normal loses {rounded(loss)} between 70 and 90.",
        "motion_volume_rotations: low_deg",
        holds=bool(abs(loss - volume.SLOPE) <= NEAR),
        otherwise="imprecise",
    )


def cam(results: Path) -> Finding:
    """What a cam costs, on one hip of each kind, since this depends on its height."""
    low = limits(results)
    loss = low["normal", 90] - low["cam", 90]
    return finding(
        "PubMed 22472271",
        f"At 90 degrees of flexion, hips with a cam turn {volume.CAM_LOSS} degrees less inwards than others.",
        f"The preset cam turns {rounded(loss)} less than normal; it is one hip, with one height of its cam.",
        "motion_volume_rotations: low_deg",
        holds=bool(abs(loss - volume.CAM_LOSS) <= NEAR),
        otherwise="imprecise",
    )
