# SPDX-License-Identifier: GPL-3.0-or-later
# @data      motion_frames motion_zones
"""Verdicts on the hips of two patients (Tables 11 to 13, Figure 42, the colours of Section 5.2).

The recorded angles are input. The zones that the thesis reports cannot be compared with ours: the patients' scans are not
public, and our stand-ins were shaped so that zones lie there. Ours are measured all the same, and the note says whether
they agree.
"""

from pathlib import Path

import pandas as pd

import common
from common import replay
from verdicts.verdict import input_row, value_row

NEAR = 0.5  # hours beyond a printed stretch that still count as of it
MOST = 0.9  # of the area must lie there
CARTILAGE = 4.0  # mm, of Figure 42
PATIENTS = {"table-12": "patient_a", "table-13": "patient_b"}
RULE = (
    f"zones of a patient whose scan is not public; on the stand-in: each printed stretch is met, and "
    f"{100 * MOST:.0f} % of the area lies within {60 * NEAR:.0f} minutes of one"
)


def rows(results: Path) -> list[dict]:
    """The rows of Table 11, then of the zones."""
    ends = replay.ends(results)
    lines = [recorded(value, ends) for value in common.thesis("table-11").itertuples()]
    for artefact, patient in PATIENTS.items():
        values = {value.row: value for value in common.thesis(artefact).itertuples()}
        found = replay.end_zones(results, patient)
        found = found[found.within_mm == replay.RED]
        lines += [zone_row(values["red_zone"], found, ""), motion_row(values["smallest_gaps"], set(found.motion))]
    lines += [input_row(value) for value in common.thesis("section-5.2").itertuples()]
    (value,) = common.thesis("figure-42").itertuples()
    found = replay.neutral_zones(results, "patient_a")
    note = f"within {CARTILAGE:g} mm as modelled; the thesis does not say the pose"
    lines.append(zone_row(value, found[found.within_mm == CARTILAGE], note))
    return lines


def motion_row(value, red: set[str]) -> dict:
    """At the ends of which motions the stand-in's gaps are smallest, which is red in the thesis."""
    theirs = set(value.value.split(", "))
    return value_row(
        value,
        measured=", ".join(name for name in replay.MOTIONS if name in red),
        rule="motions of a patient whose scan is not public; on the stand-in: those that end with a gap below 2 mm",
        tolerance="none",
        verdict="not-comparable",
        note=f"the stand-in, shaped for it, {'agrees' if red == theirs else 'does not agree'}, in {len(red & theirs)} of {len(theirs)}",
    )


def recorded(value, ends: pd.DataFrame) -> dict:
    """An angle that was given. Refused if another angle was replayed."""
    used = ends.loc[(value.column, value.row)].angle_deg
    if used != float(value.value):
        raise common.Refused(
            f"data/motion_frames.csv ends {value.row} of {value.column} at {used:g} degrees and the thesis at "
            f"{value.value}: see libcore/hip/recorded_range.hpp"
        )
    return input_row(value)


def stretches(text: str) -> list[tuple[float, float]]:
    """Stretches in hours from texts such as 1-2 or 7; a single hour means half an hour to either side."""
    parts = [part.split("-") for part in text.split(" and ")]
    return [
        (float(part[0]), float(part[1])) if len(part) == 2 else (float(part[0]) - 0.5, float(part[0]) + 0.5)
        for part in parts
    ]


def inside(zone, stretch: tuple[float, float]) -> bool:
    """Does a zone lie within a stretch, or at most NEAR outside it?"""
    low, high = stretch[0] - NEAR, stretch[1] + NEAR
    start = (zone.from_hours - low) % 12
    return start + ((zone.to_hours - zone.from_hours) % 12 or 12) <= (high - low) % 12


def zone_row(value, found: pd.DataFrame, note: str) -> dict:
    """The zone that was found on the stand-in, in hours."""
    printed = stretches(value.value)
    within = [any(inside(zone, stretch) for stretch in printed) for zone in found.itertuples()]
    share = found.area_mm2[within].sum() / found.area_mm2.sum() if len(found) else 0.0
    met = all(any(inside(zone, stretch) for zone in found.itertuples()) for stretch in printed)
    agrees = "agrees" if met and share >= MOST else "does not agree"
    shaped = "shaped for it" if value.artefact in PATIENTS else "not shaped for it"
    return value_row(
        value,
        measured=replay.union(found),
        rule=RULE,
        tolerance=f"{60 * NEAR:.0f} minutes",
        verdict="not-comparable",
        note="; ".join(filter(None, [f"the stand-in, {shaped}, {agrees}, with {100 * share:.0f} % of the area in such zones", note])),
    )
