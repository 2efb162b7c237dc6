# SPDX-License-Identifier: GPL-3.0-or-later
"""What the report's parts are written with: elements, and the cells of tables."""

from __future__ import annotations

import html
import json
import math
import re

import common
from common import motion_limits
from common.wording import LABELS

# Words of columns of tables/NAME.csv that are no words of a reader, and the signs of units.
NAMES = {
    "iqr": "spread (IQR)", "rsid": "RSID", "usid": "USID", "rapid": "RAPID", "fcl": "FCL", "lut entries": "entries", "rms": "RMS",
    "mcewen wiaux": "McEwen and Wiaux", "driscoll healy": "Driscoll and Healy", "nyquist": "Nyquist", "poisson": "Poisson ratio",
    "patient a": "patient A", "patient b": "patient B", "stand in": "stand-in", "any centre": "any centre within 0.5 mm,", "i": "ray",
    "p99": "99th percentile", "p9999": "99.99th percentile", "eq16": "Eq. 16", "cpu": "processor time", "of all": "share of everything",
    "um to grid": "error over the grid's", "to grid": "over the grid's", "times needed": "time over ours",
    "times embree": "times as fast as Embree", "embree": "Embree",
}  # fmt: skip
SIGNS = {
    "deg": "°", "mm": "mm", "mm2": "mm²", "mm3": "mm³", "um": "µm", "nm": "nm", "s": "s", "ms": "ms", "us": "µs", "ns": "ns", "mib": "MiB",
    "MiB": "MiB", "KiB": "KiB", "MB": "MB", "kB": "kB", "bytes": "bytes", "percent": "%", "hours": "h", "mpa": "MPa", "rad": "rad",
}  # fmt: skip


def element(tag: str, inner: str, **attributes: str) -> str:
    """An element; inner is HTML already, attribute values are escaped here."""
    words = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{html.escape(value)}"' for key, value in attributes.items()
    )
    return f"<{tag}{words}>{inner}</{tag}>"


def fold(title: str, inner: str, name: str = "", remark: str = "") -> str:
    """A part of the page that opens at its heading; the remark stands beside it."""
    beside = " " + element("span", html.escape(remark), class_="soft") if remark else ""
    attributes = {"id": name} if name else {}
    return element("details", element("summary", element("h2", html.escape(title)) + beside) + inner, class_="part", **attributes)


def choice(name: str, title: str, options: dict[str, str]) -> str:
    """A list to choose from, by what each value is called."""
    inner = "".join(element("option", html.escape(text), value=value) for value, text in options.items())
    return element("label", title + element("select", inner, id=name))


def data_script(name: str, value: object) -> str:
    """A script element that holds the value as JSON, for the page's own scripts to read."""
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"))
    text = text.replace("<", "\\u003c")  # nothing in it may end the script
    return f'<script type="application/json" id="{name}">{text}</script>'


def words(name: str, unit: str = "") -> str:
    """What a reader calls a column: "iqr_ms" is "spread (IQR), ms". Its unit is what its first or last word says, or `unit`."""
    parts = name.replace("_", " ").split()
    units = [k for k, part in enumerate(parts) if part in SIGNS and (part in ("percent", "mib") or k in (0, len(parts) - 1))]
    sign = SIGNS[parts.pop(units[-1])] if units else "" if set(parts) & set(SIGNS) else SIGNS.get(unit, "")
    said = " ".join(parts).removesuffix(",")
    for word, text in NAMES.items():
        said = re.sub(rf"(?<!\w){word}(?!\w)", text, said)
    return ",\u00a0".join(part for part in (said, sign) if part)  # a unit does not stand alone on a line


def readable(value: str) -> str:
    """What a reader calls the name in a cell: "rsid_thesis" is "RSID, raster of the thesis"."""
    if value in motion_limits.LABELS:
        return motion_limits.LABELS[value]
    method, *rest = value.split(", ")  # a line of a plot also says how its table is stored
    named = method in LABELS or re.fullmatch(r"[a-z0-9]+(_[a-z0-9]+)+", method)
    return ", ".join([common.label(method), *rest]) if named else value


def written(value: str, shorten: bool, name: bool = False) -> tuple[str, bool]:
    """HTML of a value, and whether it is a number; of long numbers four digits where that is asked for."""
    try:
        number = float("" if name else value)
    except ValueError:
        return html.escape(readable(value) if shorten else value), False
    if re.fullmatch(r"\d{4,12}(\.0)?", value):
        return f"{number:,.0f}", True
    if not shorten or len(value) <= 7 or not math.isfinite(number):
        return html.escape(value.removesuffix(".0") if shorten else value), True
    return (f"{number:.3g}" if not 1e-5 <= abs(number) < 1e12 else common.digits(number, 4)), True


def digits(value: str) -> str:
    """A number of a CSV in the digits of a reader, as text."""
    return html.unescape(written(value, shorten=True)[0])


def cell(value: str, shorten: bool = False, name: bool = False, kept: str | None = None) -> str:
    """A table cell; numbers to the right unless they are names. kept: what the reference run has there."""
    text, number = written(value, shorten, name)
    attributes = {"class_": "number"} if number else {}
    if kept is not None and kept != value:
        text += "<br>" + element("span", written(kept, shorten)[0] or "none", class_="kept")
    return element("td", text, **attributes)
