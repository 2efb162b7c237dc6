# SPDX-License-Identifier: GPL-3.0-or-later
# @data      motion_frames
"""Numbers of the paper about the recorded motions: replay:poses, and :overlapping of them."""

from pathlib import Path

import common


def facts(results: Path) -> dict[str, str]:
    """Both."""
    frames = common.load(results, "motion_frames")
    overlapping = int((frames.smallest_gap_mm <= 0).sum())
    return {"replay:poses": str(len(frames)), "replay:overlapping": str(overlapping) if overlapping else "None"}
