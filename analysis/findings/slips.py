# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   verdicts.csv
"""Where the thesis contradicts itself, a formula or a clock: formulas, references, axes, tables (Chapters 3 to 5). Then the
misprints that verdicts.csv names.
"""

import math
import re
from pathlib import Path

import common
from common import timing
from findings.finding import ARITHMETIC, READING, Finding, finding, printed

QUADRANT = (0, 3)  # hours, the anterosuperior one: from superior at 12 to anterior at 3


def arctangent() -> Finding:
    """The arctangent of Eq. 6, evaluated every degree."""
    azimuths = [degree + 0.5 for degree in range(360)]
    found = [math.degrees(math.atan(math.sin(math.radians(a)) / math.cos(math.radians(a)))) for a in azimuths]
    off = [abs(theta - a) for theta, a in zip(found, azimuths)]
    right, turned, opposite = (sum(abs(value - by) < 1e-9 for value in off) for by in (0, 360, 180))
    return finding(
        "Eq. 6",
        "The arctangent of y / x is theta, from 0 to 360 degrees.",
        f"Of {len(azimuths)} directions about the axis {right} come out, {turned} a turn too low and {opposite}, those with "
        "x < 0, as the opposite direction: the signs of both x and y are needed, which so short a notation may mean.",
        ARITHMETIC,
        holds=opposite == 0,
        otherwise="imprecise",
    )


def axes() -> Finding:
    """Section 3.2 against Figure 31, Algorithm 1 and Section 3.1."""
    return finding(
        "3.2",
        "The angle phi is the abscissa of the grid, and the other the ordinate.",
        "In Figure 31 and Algorithm 1 theta is; and phi is the row of the table by Section 3.1, so that 1 degree makes 181 rows "
        "of 360.",
        READING,
        holds=False,
        otherwise="misprint",
    )


def indices() -> Finding:
    """Indices in Sections 3.3 and 4.3, with a vertex that the two equations take there and back."""
    x, y, z = 3.0, 4.0, 12.0
    d = math.hypot(x, y, z)
    theta, phi = math.atan2(y, x), math.acos(z / d)  # Eq. 6
    back = d * math.sin(phi) * math.cos(theta), d * math.sin(phi) * math.sin(theta), d * math.cos(phi)  # Eq. 5
    return finding(
        "3.3, 4.3",
        "Eq. 5 gives the indices, phi and theta, of a vertex.",
        f"Eq. 6 does: of the vertex ({x:g}, {y:g}, {z:g}) it gives {math.degrees(phi):.1f} and {math.degrees(theta):.1f} degrees, "
        "from which Eq. 5 makes the vertex.",
        ARITHMETIC,
        holds=math.dist(back, (x, y, z)) > 1e-9,
        otherwise="misprint",
    )


def comparison_of_methods() -> Finding:
    """What Section 4.5 says about another section."""
    return finding(
        "4.5",
        "Section 3.5.2 compares the first system with existing methods.",
        "Section 3.6 does; 3.5.2 is on the slices of a scan.",
        READING,
        holds=False,
        otherwise="misprint",
    )


def unequal_segments() -> Finding:
    """Unequal segments (Section 5.1.1): segments of equal angles at the apex and at the rim, relative to each other."""
    a, b = (float(printed("section-5.1", name, "conchoid")) for name in "ab")
    by_8 = 1.0  # sqrt(2) pi / n holds no direction
    by_12 = (a + b) / math.hypot(a, b)  # the square root of r^2 + r'^2 at 0 and at 90 degrees
    return finding(
        "5.1.1",
        "Eq. 8 proves that segments of the conchoid are unequal.",
        f"By Eq. 8, the relative error, one at the apex is {by_8:.2f} times as long as one at the rim; by Eq. 12, which is meant, "
        f"{by_12:.2f} times.",
        ARITHMETIC,
        holds=abs(by_8 - by_12) < 0.01,
        otherwise="misprint",
    )


def angles_of_table_10() -> Finding:
    """The angles of Table 10 (Section 5.1.3), compared with the equation that it names."""
    table = common.thesis("table-10").pivot(index="row", columns="column", values="value").astype(float).iloc[1:]
    ratios = table.adjusted_angle / table.original_angle
    last = len(table)
    by_16 = [math.degrees(2 * math.asin(3.03 * i / (last * 4.29))) for i in range(1, last + 1)]
    return finding(
        "5.1.3",
        "Eq. 9 gives the angles of Table 10.",
        "By Eq. 9, the helix, all angles would grow by one factor, and those of Table 10 do by "
        f"{', '.join(f'{value:.3f}' for value in ratios)}; Eq. 16 gives {', '.join(f'{angle:.1f}' for angle in by_16)}, as printed.",
        ARITHMETIC,
        holds=ratios.max() - ratios.min() < 0.01,
        otherwise="misprint",
    )


def cartilage() -> Finding:
    """Cartilage in Sections 2.1.1 and 3.4: an offset of each bone's surface, or a threshold between the bones."""
    return finding(
        "3.4",
        "Each bone gets an offset of 4 mm for its cartilage, and there is impingement where the bones are nearer than that thickness.",
        "Two such layers meet where the bones are 8 mm apart, and the threshold is 4 mm: that is right if 4 mm are both layers "
        "together, 2 mm each, as Section 2.1.1 can be read.",
        READING,
        holds=False,
        otherwise="imprecise",
    )


def zones() -> Finding:
    """Zones: Section 3.4 compared with Figures 42 and 43, hour by hour of the dial."""
    red = printed("figure-42", "clock", "red_zone")
    stretches = [(int(a) % 12, int(b)) for a, b in re.findall(r"(\d+)-(\d+)", red)]
    hours = [hour for start, end in stretches for hour in range(start, end)]
    outside = [hour for hour in hours if not QUADRANT[0] <= hour < QUADRANT[1]]
    opposite = [hour for hour in outside if QUADRANT[0] <= hour - 6 < QUADRANT[1]]
    return finding(
        "3.4",
        f"Zones at {red} o'clock match a study that found them in the anterosuperior quadrant.",
        f"That quadrant is 12 to 3 o'clock: {len(outside)} of the {len(hours)} hours lie outside of it, {len(opposite)} in the "
        "opposite one.",
        ARITHMETIC,
        holds=not outside,
        otherwise="imprecise",
    )


def clock_ticks() -> Finding:
    """The times of Table 8, as multiples of a clock tick."""
    times = sorted({time for time in timing.thesis_times(timing.TABLE_8).values() if math.isfinite(time)})
    counts = [round(time / timing.TICK_MS) for time in times]
    off = max(abs(time - count * timing.TICK_MS) for time, count in zip(times, counts))
    short = sum(count == 1 for count in counts)
    return finding(
        "Tables 3, 8",
        f"To fill a table takes {times[0]:g} ms at 1 degree, {times[1]:g} at 0.5 degrees and {times[3]:g} at 0.1.",
        f"All {len(times)} different times are whole ticks of a clock of {timing.TICK_MS:.3f} ms, to {off:.2f} ms; the first {short} "
        f"are one tick, {times[3]:g} ms are {counts[3]}. So short a time is known to a tick at best, and with it every ratio to it.",
        ARITHMETIC,
        holds=off > 1,
        otherwise="imprecise",
    )


def rapid_times() -> Finding:
    """The same measurements of RAPID, printed twice."""
    first, second = (
        {(value.row, value.column): value.value for value in common.thesis(table).itertuples()}
        for table in ("table-4", "table-9")
    )
    key = ("12k", "rapid")
    others = [name for name in first if name != key]
    return finding(
        "Tables 4, 9",
        f"RAPID takes {first[key]} ms at 12,000 triangles.",
        f"In Table 4; in Table 9 it is {second[key]} ms, which rounds to it. Of the other {len(others)} entries that they share "
        f"{sum(first[name] == second[name] for name in others)} are the same.",
        ARITHMETIC,
        holds=all(common.same_number(first[name], second[name]) for name in first),
        otherwise="imprecise",
    )


def misprints(results: Path) -> list[Finding]:
    """A finding for each number that verdicts.csv calls a misprint of the thesis."""
    verdicts = common.as_text(results / "verdicts.csv")
    return [
        finding(
            row.artefact.replace("table-", "Table ").replace("section-", ""),
            f"{row.row.replace('_', ' ')}, {row.column.replace('_', ' ')}: {row.thesis} {row.unit}.",
            f"{float(row.measured):,.5g} {row.unit}: {row.note}.",
            "verdicts.csv: measured",
            holds=False,
            otherwise="misprint",
        )
        for row in verdicts[verdicts.verdict == "thesis-misprint"].itertuples()
    ]
