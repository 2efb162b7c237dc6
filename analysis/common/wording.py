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
    """What a reader calls a method or scheme."""
    return LABELS.get(name) or LABELS_READ.get(name, name.replace("_", " "))


def scheme_labels(results: Path) -> dict[str, str]:
    """What a reader calls each scheme, from data/schemes.csv and in its order: schemes name themselves."""
    table = load(results, "schemes")
    return dict(zip(table.scheme, table.label))


def number(text: str) -> float:
    """A row's name or a value as a number: 0.5deg, 12k, 300, 0.497; NaN for N/A."""
    text = text.removesuffix("deg")
    if text == "N/A":
        return math.nan
    return float(text[:-1]) * 1000 if text.endswith("k") else float(text)


def digits(value: float, significant: int = 3) -> str:
    """Rounded for reading: three significant digits, thousands kept apart by a comma."""
    if not math.isfinite(value):
        return ""
    if value == 0:
        return "0"
    places = max(significant - 1 - math.floor(math.log10(abs(value))), 0)
    return f"{round(value, significant - 1 - math.floor(math.log10(abs(value)))):,.{places}f}"


def rounded_down(value: float, places: int) -> str:
    """The low end of what is proven, as a reader sees it: no higher than it is."""
    return f"{outward(value, places, ROUND_FLOOR):f}"


def rounded_up(value: float, places: int) -> str:
    """A high end of what is proven, or a bound: no lower than it is."""
    return f"{outward(value, places, ROUND_CEILING):f}"


def digits_up(value: float, significant: int = 3) -> str:
    """As digits(), no lower than the value: a bound, or what is reached at most."""
    if not math.isfinite(value) or value == 0:
        return digits(value)
    return f"{outward(value, significant - 1 - math.floor(math.log10(abs(value))), ROUND_CEILING):,f}"


def outward(value: float, places: int, rounding: str) -> Decimal:
    """To that many places; zero without a sign."""
    return Decimal(repr(float(value))).quantize(Decimal(1).scaleb(-places), rounding) + 0


def plain(value: float, significant: int = 4) -> str:
    """Rounded for a CSV: significant digits without exponent or separators."""
    return (
        np.format_float_positional(value, precision=significant, fractional=False, trim="-")
        if math.isfinite(value)
        else ""
    )


def tex(text: str) -> str:
    """Text with LaTeX's own characters made harmless."""
    special = {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"}
    return "".join(special.get(c, f"\\{c}" if c in "&%$#_{}" else c) for c in text)
