# SPDX-License-Identifier: GPL-3.0-or-later
"""What the report's parts are written with: elements, and the cells of tables."""

from __future__ import annotations

import html
import json
import math
import re

import common


def element(tag: str, inner: str, **attributes: str) -> str:
    """An element; inner is HTML already, attribute values are escaped here."""
    words = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{html.escape(value)}"' for key, value in attributes.items()
    )
    return f"<{tag}{words}>{inner}</{tag}>"


def choice(name: str, title: str, options: dict[str, str]) -> str:
    """A list to choose from, by what each value is called."""
    inner = "".join(element("option", html.escape(text), value=value) for value, text in options.items())
    return element("label", title + element("select", inner, id=name))


def data_script(name: str, value: object) -> str:
    """A script element that holds the value as JSON, for the page's own scripts to read."""
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"))
    text = text.replace("<", "\\u003c")  # nothing in it may end the script
    return f'<script type="application/json" id="{name}">{text}</script>'


def written(value: str, shorten: bool, name: bool = False) -> tuple[str, bool]:
    """HTML of a value, and whether it is a number; of long numbers four digits where that is asked for."""
    try:
        number = float("" if name else value)
    except ValueError:
        return html.escape(value), False
    if re.fullmatch(r"\d{4,}(\.0)?", value):
        return f"{number:,.0f}", True
    if not shorten or len(value) <= 7 or not math.isfinite(number):
        return html.escape(value.removesuffix(".0") if shorten else value), True
    return (f"{number:.3g}" if abs(number) < 1e-5 else common.digits(number, 4)), True


def cell(value: str, title: str = "", shorten: bool = False, name: bool = False, kept: str | None = None) -> str:
    """A table cell; numbers to the right unless they are names. kept: what the reference run has there."""
    text, number = written(value, shorten, name)
    attributes = {"data_title": title} if title else {}
    if number:
        attributes["class_"] = "number"
    if kept is not None and kept != value:
        text += "<br>" + element("span", written(kept, shorten)[0] or "none", class_="kept")
    return element("td", text, **attributes)
