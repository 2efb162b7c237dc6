# SPDX-License-Identifier: GPL-3.0-or-later
"""What the table, the figure and the paper share about limits of motion: names, and what a normal hip reaches."""

from pathlib import Path

import pandas as pd

import common

# In the order of the experiment, as a reader knows them.
MOTIONS = {
    "flexion": "flexion",
    "extension": "extension",
    "abduction": "abduction",
    "adduction": "adduction",
    "internal_rotation": "internal rotation",
    "external_rotation": "external rotation",
    "internal_rotation_at_45": "int. rot. at 45° flexion",
    "internal_rotation_at_70": "int. rot. at 70° flexion",
    "internal_rotation_at_90": "int. rot. at 90° flexion",
    "external_rotation_at_90": "ext. rot. at 90° flexion",
    "fadir": "FADIR",
    "faber": "FABER",
}
# Degrees that a clinician finds in a normal hip, soft tissue included, as they are commonly quoted; internal rotation
# in flexion.
CLINICAL = {
    "flexion": (110, 120),
    "extension": (10, 15),
    "abduction": (30, 50),
    "adduction": (20, 30),
    "external_rotation": (40, 60),
    "internal_rotation_at_90": (30, 40),
}
SHOWN = 0.1  # degrees: a bracket as narrow is one number
GENERATED = ["normal", "cam", "pincer", "mixed", "dysplastic", "patient_a", "patient_b"]
LABELS = {"patient_a": "stand-in for patient A", "patient_b": "stand-in for patient B"}


def label(joint: str) -> str:
    """The name of the joint for a reader."""
    return LABELS.get(joint, joint.replace("_", " "))


def contacts(results: Path, centre: str = "head") -> pd.DataFrame:
    """The limits by contact of the surfaces, about one centre."""
    table = common.load(results, "motion_limit_details")
    return table[table.gap_mm.isna() & (table.centre == centre)]


def over_centres(results: Path) -> str:
    """How wide a limit's interval for every centre within half a millimetre is, of generated hips and of real joints."""
    table = contacts(results)
    said = []
    for made, joints in table.groupby(table.joint.isin(GENERATED)):
        limited = joints[joints.state == "limited"]
        width = (limited.centre_high_deg - limited.centre_low_deg).dropna()
        of = "generated hips" if made else f"{joints.joint.nunique()} real joints"
        if len(width):
            ends = f"{common.digits(width.median(), 2)}° wide in the median and {common.digits_up(width.max(), 2)}° at most"
            said.append(f"in {of} {ends} ({len(width)} of {len(limited)} limits have a proven upper end)")
    return ", ".join(reversed(said))


def text(row) -> str:
    """A limit for a reader: tenths of a degree before which nothing touches; both ends after a graze."""
    if row.state == "free":
        return "free"
    if row.state == "blocked":
        return "blocked"
    if row.state == "unknown":
        return f"unknown beyond {common.rounded_down(row.limit_low_deg, 1)}"
    if row.limit_high_deg - row.limit_low_deg > SHOWN:
        return between(row.limit_low_deg, row.limit_high_deg)
    return common.rounded_down(row.limit_low_deg, 1)


def between(low: float, high: float) -> str:
    """A proven interval with its ends rounded outward."""
    return f"{common.rounded_down(low, 1)} to {common.rounded_up(high, 1)}"
