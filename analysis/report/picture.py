# SPDX-License-Identifier: GPL-3.0-or-later
"""A figure inside the report, in as few bytes as a screen needs; the files themselves stay beside it."""

from __future__ import annotations

import base64
import html
import io
import re
from pathlib import Path

import PIL.Image

import common

MOST_LINES = 50_000  # bytes of an SVG in the page
WIDEST = 1280  # pixels of a picture in the page: main is 80 rem wide


def lighter(path: Path) -> bytes:
    """A PNG as WebP, no wider than a screen shows: a tenth of the bytes. The file itself stays beside the report."""
    with PIL.Image.open(path) as picture:
        if picture.width > WIDEST:
            picture = picture.resize((WIDEST, round(picture.height * WIDEST / picture.width)), PIL.Image.LANCZOS)
        webp = io.BytesIO()
        picture.convert("RGB").save(webp, "WEBP", quality=70, method=4)
    return webp.getvalue()


def packed(path: Path) -> tuple[str, bytes]:
    """Kind and bytes of a picture: drawn lines where they take little room, pixels where those take less."""
    if path.suffix == ".svg" and path.stat().st_size < MOST_LINES:
        return "image/svg+xml", path.read_bytes()
    return "image/webp", lighter(path.with_suffix(".png"))


def box(svg: str) -> tuple[int, int]:
    """Pixels of a drawing on a page."""
    found = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg[:4000])
    if not found:
        raise common.Refused("an SVG has no viewBox from 0 0: save the figure by matplotlib")
    return round(float(found[1]) * 4 / 3), round(float(found[2]) * 4 / 3)  # points, to pixels


def size(path: Path) -> tuple[int, int]:
    """Width and height, whose ratio keeps the picture's place in the page until it is there."""
    if path.suffix == ".svg":
        return box(path.read_text(encoding="utf-8"))
    with PIL.Image.open(path) as picture:
        scale = min(1, WIDEST / picture.width)
        return round(picture.width * scale), round(picture.height * scale)


def image(path: Path, title: str) -> str:
    """The picture inside the page."""
    kind, content = packed(path)
    return shown(kind, content, size(path if kind != "image/webp" else path.with_suffix(".png")), title)


def drawn(svg: str, title: str) -> str:
    """A picture of the page alone."""
    return shown("image/svg+xml", svg.encode(), box(svg), title)


def shown(kind: str, content: bytes, shape: tuple[int, int], title: str) -> str:
    """The element that holds it."""
    width, height = shape
    data = base64.b64encode(content).decode("ascii")
    return (
        f'<img alt="{html.escape(title)}" width="{width}" height="{height}" loading="lazy" decoding="async"'
        f' src="data:{kind};base64,{data}">'
    )
