# SPDX-License-Identifier: GPL-3.0-or-later
"""A figure inside the report, in as few bytes as a screen needs; the files themselves stay beside it."""

from __future__ import annotations

import base64
import html
import io
import re
from pathlib import Path

import matplotlib.pyplot as plt
import PIL.Image

import common

MOST_LINES = 50_000  # bytes of an SVG in the page
WIDEST, SMALLER = 1040, 800  # pixels of a picture in the page, and of a figure of the thesis
PIXELS = 96  # of a page, in an inch


def lighter(path: Path, widest: int) -> bytes:
    """A PNG as WebP, no wider than a page shows: a tenth of the bytes. The file itself stays beside the report."""
    with PIL.Image.open(path) as picture:
        if picture.width > widest:
            picture = picture.resize((widest, round(picture.height * widest / picture.width)), PIL.Image.LANCZOS)
        return webp(picture)


def webp(picture: PIL.Image.Image) -> bytes:
    """The bytes of a picture for the eye."""
    file = io.BytesIO()
    picture.convert("RGB").save(file, "WEBP", quality=60, method=4)
    return file.getvalue()


def packed(path: Path, widest: int) -> tuple[str, bytes]:
    """Kind and bytes of a picture: drawn lines where they take little room, pixels where those take less."""
    if path.suffix == ".svg" and path.stat().st_size < MOST_LINES:
        return "image/svg+xml", path.read_bytes()
    return "image/webp", lighter(path.with_suffix(".png"), widest)


def box(svg: str) -> tuple[int, int]:
    """Pixels of a drawing on a page."""
    found = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg[:4000])
    if not found:
        raise common.Refused("an SVG has no viewBox from 0 0: save the figure by matplotlib")
    return round(float(found[1]) * 4 / 3), round(float(found[2]) * 4 / 3)  # points, to pixels


def size(path: Path, widest: int) -> tuple[int, int]:
    """Width and height, whose ratio keeps the picture's place in the page until it is there."""
    if path.suffix == ".svg":
        return box(path.read_text(encoding="utf-8"))
    with PIL.Image.open(path) as picture:
        scale = min(1, widest / picture.width)
        return round(picture.width * scale), round(picture.height * scale)


def image(path: Path, title: str, widest: int = WIDEST) -> str:
    """The picture inside the page."""
    kind, content = packed(path, widest)
    return shown(kind, content, size(path if kind != "image/webp" else path.with_suffix(".png"), widest), title)


def drawn(figure: plt.Figure, title: str) -> str:
    """A picture of the page alone, in twice the pixels of a page that is read at arm's length."""
    with io.BytesIO() as file:
        figure.savefig(file, dpi=2 * PIXELS)
        plt.close(figure)
        with PIL.Image.open(file) as picture:
            return shown("image/webp", webp(picture), (picture.width // 2, picture.height // 2), title)


def shown(kind: str, content: bytes, shape: tuple[int, int], title: str) -> str:
    """The element that holds it."""
    width, height = shape
    data = base64.b64encode(content).decode("ascii")
    return (
        f'<img alt="{html.escape(title)}" width="{width}" height="{height}" loading="lazy" decoding="async"'
        f' src="data:{kind};base64,{data}">'
    )
