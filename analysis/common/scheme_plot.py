# SPDX-License-Identifier: GPL-3.0-or-later
"""What the figures of sampling schemes share: values off the scale, names beside points, and spheres side by side."""

import math
import textwrap
from collections.abc import Callable

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.text import Text

import common

# N rho^2 of the best covering of the plane by circles (Kershner 1939)
FLOOR = 8 * math.pi / (3 * math.sqrt(3))
FLOOR_TEXT = r"no scheme can do better: $8\pi/(3\sqrt{3})$ = " + f"{FLOOR:.3f}"


def reach(values: pd.Series) -> float:
    """The largest value that is drawn on a linear axis. Larger ones, beyond three medians, are only written."""
    return float(values[values <= 3 * values.median()].max())


def name_points(axes: plt.Axes, x: pd.Series, y: pd.Series, names: list[str]) -> None:
    """A name near each point, joined to it by a thin line: the nearest place where both cover least of points, names and lines."""
    axes.figure.canvas.draw()
    points = axes.transData.transform(np.column_stack([x, y]))
    frame = axes.get_window_extent()
    taken = [(px - 5, py - 4, px + 5, py + 4) for px, py in points]
    lines: list[np.ndarray] = []
    for k in np.argsort(-np.abs(points[:, 1] - np.median(points[:, 1]))):
        best = None
        for dx, dy in _offsets():
            text = _name(axes, names[k], (x.iloc[k], y.iloc[k]), (dx, dy))
            text.get_window_extent()  # puts it in its place
            box = Text.get_window_extent(text)  # of the words, without the line to the point
            text.remove()
            outside = box.x0 < frame.x0 or box.x1 > frame.x1 or box.y0 < frame.y0 or box.y1 > frame.y1
            area = (box.x0, box.y0, box.x1, box.y1)
            end = np.clip(points[k], (box.x0, box.y0), (box.x1, box.y1))
            line = points[k] + (end - points[k]) * np.linspace(0, 1, 30)[:, None]
            others = [other for i, other in enumerate(taken) if i != k]
            cost = 10 * outside + 2 * _meet(area, taken[k]) + sum(2 * _meet(area, other) + _inside(line, other) for other in others)
            cost += sum(2 * _inside(other, area) + _cross(line, other) for other in lines)
            if best is None or cost < best[0]:
                best = (cost, (dx, dy), area, line)
            if cost == 0:
                break
        _name(axes, names[k], (x.iloc[k], y.iloc[k]), best[1])
        taken.append(best[2])
        lines.append(best[3])


def _name(axes: plt.Axes, name: str, at: tuple, offset: tuple[float, float]) -> Text:
    """The words and their line. A white box behind them, since words with a halo would be curves in the PDF, which no search finds."""
    dx, _ = offset
    box = {"facecolor": "white", "edgecolor": "none", "pad": 0.5, "alpha": 0.8}
    leader = {"arrowstyle": "-", "color": common.THESIS_GREY, "linewidth": 0.6, "shrinkA": 0, "shrinkB": 4}
    look = {"va": "center", "arrowprops": leader, "bbox": box, "zorder": 4}
    return common.note(axes, name, at, offset, ha="left" if dx > 0 else "right" if dx < 0 else "center", **look)


def _meet(a: tuple, b: tuple) -> bool:
    """Whether two boxes (x0, y0, x1, y1) overlap."""
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def _inside(line: np.ndarray, box: tuple) -> bool:
    """Whether points (n, 2) of a line lie in a box."""
    return bool(((line > box[:2]) & (line < box[2:])).all(axis=1).any())


def _cross(a: np.ndarray, b: np.ndarray) -> bool:
    """Whether two straight lines, given by points on them, cross."""

    def side(line: np.ndarray, point: np.ndarray) -> float:
        (x0, y0), (x1, y1) = line[0], line[-1]
        return np.sign((x1 - x0) * (point[1] - y0) - (y1 - y0) * (point[0] - x0))

    return side(a, b[0]) != side(a, b[-1]) and side(b, a[0]) != side(b, a[-1])


def _offsets() -> list[tuple[float, float]]:
    """Where a name may stand, in points from its own: near before far, right before left, then above and below."""
    near = [(9, 0), (-9, 0), (0, 11), (0, -11)]
    return near + [(dx, dy) for away in (10, 18, 28, 40, 55, 72, 90) for dy in (away, -away) for dx in (9, -9, 30, -30)]


def panels(
    title: str, names: dict[str, str], draw: Callable[[plt.Axes, str], None], size: tuple[float, float]
) -> plt.Figure:
    """A picture per scheme under its label, five in a row; draw(axes, scheme) fills one. Sizes are in inches."""
    columns = 5
    lines = math.ceil(len(names) / columns)
    figure, grid = plt.subplots(lines, columns, figsize=(columns * size[0], lines * size[1]), squeeze=False)
    for axes in grid.flat:
        axes.set_axis_off()
    for axes, (scheme, label) in zip(grid.flat, names.items()):
        draw(axes, scheme)
        axes.set_title(textwrap.fill(label, int(11.5 * size[0])), fontsize=common.SMALL, loc="center", pad=3)
    figure.subplots_adjust(wspace=0.06, hspace=0.2)
    figure.suptitle(title, x=0.125, y=0.88 + 0.5 / (lines * size[1]), ha="left", va="bottom", fontsize=11)
    return figure
