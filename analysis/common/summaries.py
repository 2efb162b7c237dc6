# SPDX-License-Identifier: GPL-3.0-or-later
"""The answers of `impinge gaps` for a pose, from which pictures are made."""

import json
from pathlib import Path

OPPOSITE = {"flexion": "extension", "abduction": "adduction", "internal_rotation": "external_rotation"}


def pose_words(motion: dict[str, float]) -> str:
    """The pose as it is typed, flexion=90,external_rotation=10; "as scanned" if nothing turns."""
    words = [f"{name if angle > 0 else OPPOSITE[name]}={abs(angle):g}" for name, angle in motion.items() if angle]
    return ",".join(words) or "as scanned"


def read(folder: Path) -> dict:
    """The answer in summary.json, with the joint's centre, axes and side, and the pose in words."""
    document = json.loads((folder / "summary.json").read_text())
    joint = document["joint"]
    return {
        **document["answer"],
        "centre": dict(zip("xyz", joint["centre"]["position"])),
        "axes": joint["axes"],
        "side": joint["side"],
        "pose": pose_words(document["request"]["pose"]),
    }
