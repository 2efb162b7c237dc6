# SPDX-License-Identifier: GPL-3.0-or-later
"""The recorded motions of a hip: data/motion_frames.csv and data/motion_zones.csv."""

from pathlib import Path

import numpy as np
import pandas as pd

import common

RED = 2.0  # mm: up to here the thesis shows red in Tables 12 and 13
QUARTERS = 48  # of an hour on the dial: zones are that fine
MOTIONS = {
    "abduction": "Abduction",
    "internal_rotation": "Internal rotation",
    "extension": "Extension",
    "adduction": "Adduction",
    "external_rotation": "External rotation",
    "flexion": "Flexion",
}  # in the order of Tables 12 and 13


def clock(hours: float) -> str:
    """Turns 1.5 into 1:30; 0 is 12:00."""
    minutes = round(hours * 60) % 720
    return f"{minutes // 60 or 12}:{minutes % 60:02d}"


def zones(table: pd.DataFrame) -> str:
    """Rows of motion_zones.csv in words, the largest first."""
    return ", ".join(f"{clock(row.from_hours)}-{clock(row.to_hours)}" for row in table.itertuples()) or "none"


def union(table: pd.DataFrame) -> str:
    """The union of the zones, clockwise from 12; zones begin and end at quarters of an hour."""
    filled = np.zeros(QUARTERS, dtype=bool)
    for row in table.itertuples():
        count = round((row.to_hours - row.from_hours) % 12 * 4) or QUARTERS
        filled[(round(row.from_hours * 4) + np.arange(count)) % QUARTERS] = True
    if filled.all() or not filled.any():
        return "12:00-12:00" if filled.all() else "none"
    starts = np.flatnonzero(filled & ~np.roll(filled, 1))
    lengths = [next(n for n in range(1, QUARTERS + 1) if not filled[(start + n) % QUARTERS]) for start in starts]
    return ", ".join(f"{clock(start / 4)}-{clock((start + n) / 4)}" for start, n in zip(starts, lengths))


def ends(results: Path) -> pd.DataFrame:
    """The pose at the end of each motion, by joint and motion."""
    frames = common.load(results, "motion_frames")
    return frames[frames.at_end].set_index(["joint", "motion"])


def end_zones(results: Path, joint: str) -> pd.DataFrame:
    """Zones of the socket at the ends of the motions, the largest first."""
    table = common.load(results, "motion_zones")
    return table[(table.joint == joint) & table.at_end & (table.surface == "socket")]


def neutral_zones(results: Path, joint: str) -> pd.DataFrame:
    """Zones of the socket in the modelled pose."""
    table = common.load(results, "motion_zones")
    return table[(table.joint == joint) & (table.motion == "neutral") & (table.surface == "socket")]
