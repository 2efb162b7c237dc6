# SPDX-License-Identifier: GPL-3.0-or-later
# @data      motion_frames
"""Numbers of the paper about the recorded motions: replay:poses, :overlapping of them, and replay:JOINT:least (mm) and
:least-at of each joint.
"""

from pathlib import Path

import common
from common import replay


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    frames = common.load(results, "motion_frames")
    frames = frames[frames.motion != "forward"]
    overlapping = int((frames.smallest_gap_mm <= 0).sum())
    found = {"replay:poses": str(len(frames)), "replay:overlapping": str(overlapping) if overlapping else "None"}
    for joint, group in frames.groupby("joint"):
        least = group.loc[group.smallest_gap_mm.idxmin()]
        found |= {
            f"replay:{joint}:least": f"{least.smallest_gap_mm:.2f}",
            f"replay:{joint}:least-at": replay.MOTIONS.get(least.motion, least.motion).lower(),
        }
    return found
