# SPDX-License-Identifier: GPL-3.0-or-later
"""Ranges of measured quantities, over rounds, stand-ins and readings, and judgements on a whole range.

A judgement is True, False or None; None means that the range does not decide it.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

import common

# Ratios of times of two methods changed by up to this between the machines of the runs that were kept: an Intel Xeon
# and an AMD EPYC (1.23, at 300 triangles).
MACHINE = 1.25
ONCE = 2.0  # how far off, either way, a time may be that was taken once


@dataclass(frozen=True)
class Range:
    """A range from low to high."""

    low: float
    high: float

    def __truediv__(self, other: "Range") -> "Range":
        """Open above if the other may be nothing."""
        return Range(self.low / other.high, self.high / other.low if other.low > 0 else math.inf)

    def widened(self, factor: float) -> "Range":
        """The range of a positive quantity, widened by the factor both ways."""
        return Range(self.low / factor, self.high * factor)

    def within(self, least: float, most: float) -> bool | None:
        """Is all of it between least and most?"""
        if least <= self.low and self.high <= most:
            return True
        return False if self.high < least or most < self.low else None


def union(ranges: Iterable[Range]) -> Range:
    """The smallest range that holds all."""
    ranges = list(ranges)
    return Range(min(one.low for one in ranges), max(one.high for one in ranges))


def all_of(judgements: Iterable[bool | None]) -> bool | None:
    """True or False if all judgements are so, else None."""
    found = set(judgements)
    return found.pop() if len(found) == 1 else None


def both(one: bool | None, other: bool | None) -> bool | None:
    """Do both hold?"""
    if False in (one, other):
        return False
    return None if None in (one, other) else True


def time_range(time: float, spread: float, rounds: int) -> Range:
    """The range of a median time over its rounds, from its interquartile range (the notch of McGill, Tukey and Larsen 1978,
    doi:10.1080/00031305.1978.10479236). A single round has no spread and gets a factor.
    """
    if rounds < 2:
        return Range(time, time).widened(ONCE)
    off = 1.57 * spread / math.sqrt(rounds)
    return Range(max(time - off, time / ONCE), time + off)


def _weights(logs: list[float]) -> list[float]:
    """How each value enters the slope of the line that fits best."""
    mean = sum(logs) / len(logs)
    return [(value - mean) / sum((other - mean) ** 2 for other in logs) for value in logs]


def slope_range(x: Iterable[float], y: Iterable[Range]) -> Range:
    """The range of the exponent of the power law that fits best in logarithms. Each range errs by itself, and a machine may
    favour one end of the sizes.
    """
    logs, y = [math.log(value) for value in x], list(y)
    weights = _weights(logs)
    middle = sum(weight * math.log(one.low * one.high) / 2 for weight, one in zip(weights, y))
    own = math.hypot(*(weight * math.log(one.high / one.low) / 2 for weight, one in zip(weights, y)))
    off = own + math.log(MACHINE) / (max(logs) - min(logs))
    return Range(middle - off, middle + off)


def slope_limits(x: Iterable[float], y: Iterable[Range]) -> Range:
    """The least and the largest such exponent if each value may lie anywhere in its range, which may begin at nothing."""
    ends = [sorted(weight * (math.log(end) if end > 0 else -math.inf) for end in (one.low, one.high))
            for weight, one in zip(_weights([math.log(value) for value in x]), y)]
    return Range(sum(low for low, _ in ends), sum(high for _, high in ends))


def steadied(table: pd.DataFrame, kept: Path, keys: list[str], noted: str) -> pd.DataFrame:
    """The rows, each with the range of the kept run added if the kept run measured it by the same rule. If that run came to
    another verdict, the verdict is inconclusive, and the column `noted` says so.
    """
    if not kept.is_file():
        return table
    older = common.as_text(kept)
    if not {"low", "high", *keys} <= set(older.columns):
        return table
    before = older.set_index(keys)
    rows = []
    for row in table.to_dict("records"):
        key = tuple(row[name] for name in keys)
        if row.get("kind", "measured") == "measured" and row["low"] != "" and key in before.index and (was := before.loc[key]).low != "":
            ours, theirs = (Range(float(one["low"]), float(one["high"])) for one in (row, was))
            every = union([ours, theirs])
            row |= {"low": common.plain(every.low), "high": common.plain(every.high)}
            if was.verdict != row["verdict"]:
                said = f"{row['verdict']} in this run, from {ours.low:g} to {ours.high:g}, and {was.verdict} in the kept one, from {was.low} to {was.high}"
                row |= {"verdict": "inconclusive", noted: "; ".join(filter(None, [row[noted], said]))}
        rows.append(row)
    return pd.DataFrame(rows, columns=table.columns)
