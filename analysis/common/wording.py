# SPDX-License-Identifier: GPL-3.0-or-later
"""Names and numbers as a reader sees them, in text, CSV and LaTeX."""

import math
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal
from pathlib import Path

import numpy as np

from common.loading import LABELS_READ, load

# How methods and schemes are called in a legend; one that is not here goes by its own name. Labels of the methods of
# experiments/methods/ come with the data: load() adds those of the sidecar.
LABELS = {
    "pairwise": "pairwise",
    "pairwise_thesis": "pairwise, each pair by itself (thesis)",
    "rsid": "RSID",
    "rsid_thesis": "RSID, raster of the thesis",
    "rsid_thesis_kept": "RSID, raster of the thesis, tables kept",
    "usid": "USID",
    "usid_thesis": "USID, resampled (thesis)",
    "usid_thesis_kept": "USID, resampled (thesis), tables kept",
    "usid_arc_thesis": "USID, equal arcs, resampled",
    "usid_pairwise": "USID, pairwise",
    "rapid": "OBB tree (RAPID)",
}


def label(name: str) -> str:
    """The name of a method or scheme for a reader."""
    return LABELS.get(name) or LABELS_READ.get(name, name.replace("_", " "))


def scheme_labels(results: Path) -> dict[str, str]:
    """The name of each scheme for a reader, from data/schemes.csv and in its order; schemes name themselves."""
    table = load(results, "schemes")
    return dict(zip(table.scheme, table.label))


def number(text: str) -> float:
    """The number in a row's name or a value: 0.5deg, 12k, 300, 0.497; NaN for N/A."""
    text = text.removesuffix("deg")
    if text == "N/A":
        return math.nan
    return float(text[:-1]) * 1000 if text.endswith("k") else float(text)


def digits(value: float, significant: int = 3) -> str:
    """A number rounded for reading: three significant digits, and a comma between thousands."""
    if not math.isfinite(value):
        return ""
    if value == 0:
        return "0"
    places = max(significant - 1 - math.floor(math.log10(abs(value))), 0)
    return f"{round(value, significant - 1 - math.floor(math.log10(abs(value)))):,.{places}f}"


def rounded_down(value: float, places: int) -> str:
    """The low end of a proven interval for a reader, never higher than it is."""
    return f"{outward(value, places, ROUND_FLOOR):f}"


def rounded_up(value: float, places: int) -> str:
    """The high end of a proven interval or a bound, never lower than it is."""
    return f"{outward(value, places, ROUND_CEILING):f}"


def digits_up(value: float, significant: int = 3) -> str:
    """As digits(), but never below the value: for a bound or a maximum."""
    if not math.isfinite(value) or value == 0:
        return digits(value)
    return f"{outward(value, significant - 1 - math.floor(math.log10(abs(value))), ROUND_CEILING):,f}"


def outward(value: float, places: int, rounding: str) -> Decimal:
    """A value rounded outward to so many decimals; zero has no sign."""
    return Decimal(repr(float(value))).quantize(Decimal(1).scaleb(-places), rounding) + 0


def plain(value: float, significant: int = 4) -> str:
    """A number for a CSV: significant digits without exponent or separators."""
    return (
        np.format_float_positional(value, precision=significant, fractional=False, trim="-")
        if math.isfinite(value)
        else ""
    )


def tex(text: str) -> str:
    """The text with LaTeX's special characters escaped."""
    special = {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"}
    return "".join(special.get(c, f"\\{c}" if c in "&%$#_{}" else c) for c in text)
