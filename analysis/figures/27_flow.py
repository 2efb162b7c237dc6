# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-27
# @question  The flow of both algorithms, with the numbers of one pose (Figure 27).
# @data      diagram_scans
"""Figure 27: the flow of both algorithms, with the numbers of one pose of a hip."""

import matplotlib.pyplot as plt
from matplotlib.patches import Polygon

import common
from common import diagram

PREPARED, REPEATED, DECIDED = "#E4EEF8", "#FBF1DC", "#EFEFEF"
LEFT, RIGHT = 2.35, 7.6  # middles of the columns
WIDE = 4.3


def main(options) -> common.Figure:
    scans = common.load(options.results, "diagram_scans")
    chosen = scans.attrs["parameters"]
    scans = {row.scanned: row for row in scans.itertuples()}
    figure, axes = plt.subplots(figsize=(8.0, 8.2))
    axes.set(xlim=(0, 10), ylim=(0, 10.3))
    axes.axis("off")
    ball, socket = scans["ball"], scans["socket"]
    prepare(axes, ball, socket, chosen)
    repeat(axes, ball, chosen)
    decide(axes, ball)
    back(axes, socket)
    figure.suptitle(f"Rapid impingement detection, with the numbers of one pose\n({diagram.HIP})", fontsize=10.5)
    figure.subplots_adjust(left=0.01, right=0.99, top=0.925, bottom=0.01)
    return figure


def prepare(axes: plt.Axes, ball, socket, chosen: dict) -> None:
    """The left column: once for each joint."""
    words = {"fontsize": 10.5, "weight": "bold"}
    axes.text(LEFT, 10.0, "Sampling: once for each joint", ha="center", **words)
    axes.text(RIGHT, 10.0, "Detection: in every pose", ha="center", **words)
    look = {"facecolor": PREPARED}
    steps = [
        (9.2, f"model B: socket\n{socket.triangles:,} triangles, {socket.vertices:,} vertices"),
        (7.8, "each triangle: corners to (φ, θ, d);\ncut where it holds a pole"),
        (6.4, "drawn on the chart of angles,\nd interpolated linearly"),
        (
            5.0,
            f"look-up table of B at {chosen['precision_deg']:g}°\n{ball.entries:,} entries, {ball.filled:,} filled, "
            f"{ball.bytes / 1024:.0f} KiB",
        ),
    ]
    chain(axes, LEFT, steps, look)
    arrow(axes, (LEFT + WIDE / 2, 5.0), (RIGHT - WIDE / 2, 5.0))


def repeat(axes: plt.Axes, ball, chosen: dict) -> None:
    """The right column: for each vertex of model A."""
    steps = [
        (
            9.2,
            f"model A: ball, {ball.vertices:,} vertices\nflexion {chosen['flexion_deg']:g}°, "
            f"internal rotation {chosen['internal_rotation_deg']:g}°",
        ),
        (7.8, "each vertex $i$ into the frame of B:\n$x = R x_A + t$"),
        (6.4, "its direction ($φ_i$, $θ_i$)\nand its distance $d_i$"),
        (5.0, "$d$ = table of B at ($φ_i$, $θ_i$),\nbilinear between four entries"),
    ]
    chain(axes, RIGHT, steps, {"facecolor": REPEATED})
    arrow(axes, (RIGHT, 4.55), (RIGHT, 4.13))


def chain(axes: plt.Axes, x: float, steps: list[tuple[float, str]], look: dict) -> None:
    """Boxes one below the other."""
    for (y, text), (below, _) in zip(steps, [*steps[1:], (None, "")]):
        diagram.box(axes, (x, y), (WIDE, 0.9), text, fontsize=9, **look)
        if below is not None:
            arrow(axes, (x, y - 0.45), (x, below + 0.47))


def decide(axes: plt.Axes, ball) -> None:
    """The comparison, and how many vertices go which way."""
    half = (1.75, 0.72)
    middle = (RIGHT, 3.38)
    corners = [(0, half[1]), (half[0], 0), (0, -half[1]), (-half[0], 0)]
    axes.add_patch(
        Polygon(
            [(middle[0] + x, middle[1] + y) for x, y in corners], facecolor=DECIDED, edgecolor=diagram.INK, zorder=3
        )
    )
    axes.text(*middle, "gap $g = d - d_i$\n$g ≤ 0$ ?", ha="center", va="center", fontsize=9.5, zorder=5)
    ends = {
        5.0: (
            f"yes: impinged\n{ball.impinged:,} vertices",
            {"facecolor": "#F6C9A8", "edgecolor": diagram.POLE, "linewidth": 2},
        ),
        7.0: (f"no: free\n{ball.met - ball.impinged:,} vertices", {"facecolor": "#D5EBDF"}),
        9.0: (f"no surface\n{ball.vertices - ball.met:,} vertices", {"facecolor": "white", "linestyle": "--"}),
    }
    tails = (RIGHT - half[0] * 0.5, 3.02), (RIGHT - 0.2, 2.74), (RIGHT + half[0] * 0.5, 3.02)
    for tail, (x, (text, look)) in zip(tails, ends.items()):
        diagram.box(axes, (x, 1.85), (1.75, 0.75), text, fontsize=8.5, **look)
        arrow(axes, tail, (x, 2.25))


def back(axes: plt.Axes, socket) -> None:
    """What is stored, and the second scan."""
    diagram.box(
        axes,
        (LEFT + 0.25, 3.38),
        (WIDE + 0.4, 0.9),
        "stored: the gap of every vertex, in mm,\nimpinged or not: the distance of the surfaces",
        fontsize=9,
        facecolor=DECIDED,
    )
    arrow(axes, (RIGHT - 1.75, 3.38), (LEFT + 0.25 + WIDE / 2 + 0.2, 3.38))
    diagram.box(
        axes,
        (5.0, 0.6),
        (9.6, 0.8),
        f"second scan, the other way round: {socket.vertices:,} vertices of the socket against the table of the ball:\n"
        f"{socket.impinged:,} impinged of {socket.met:,} that face it; gap = its $d_i$ − table; "
        f"smallest gap {socket.smallest_gap_mm:.2f} mm".replace(" -", " −"),
        fontsize=9,
        facecolor=REPEATED,
    )


def arrow(axes: plt.Axes, tail, tip) -> None:
    """From one box to the next."""
    diagram.arrow(axes, tail, tip, linewidth=1.4)


common.run(main)
