# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-1
# @question  The steps of planning an operation of the hip, and where impingement detection stands (Figure 1).
# @data      slices_to_surface_image head_maps
# @depends   data/head_maps/patient_a.ply scenes/patient_a{,-flexion}/{ball.ply,socket.ply,summary.json}
# @options   --joint patient_a --motion flexion
# @outputs   png svg pdf
# @seconds   3 3
"""Figure 1: the steps of planning a hip operation, each with a picture of what this framework makes of it."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.patches import Circle, FancyArrowPatch, FancyBboxPatch

import common
from common import dial_plot, gap_colours, hip, panels, render, sphere_deviation

WIRES, RING = (0.05, 0.05, 0.05), "#d4006a"
OUTSIDE, PART, OURS = "#F2F2F2", "#E4EEF8", "#FBF1DC"
WIDE, HIGH = 0.285, 0.42  # of a step, shares of the figure
PLACES = {  # middles
    "scan": (0.16, 0.70),
    "setup": (0.16, 0.24),
    "motion": (0.50, 0.47),
    "report": (0.84, 0.70),
    "correct": (0.84, 0.24),
}

WORDS = {
    "scan": ("1  Models", "segmented from CT or MRI\n(here: simulated CT, its bone edges)", PART, "-"),
    "setup": ("2  Set-up", "centre of rotation from a fitted sphere,\nrecorded range of motion", PART, "-"),
    "correct": (
        "5  Bone correction",
        "further studies: what would be\nremoved (ring: rises above the sphere)",
        OUTSIDE,
        "--",
    ),
}


def main(options) -> common.Figure:
    joint = hip.load(options.results, options.joint)
    posed = hip.load(options.results, f"{options.joint}-{options.motion}")
    head = sphere_deviation.load(options.results, joint)
    title = hip.title(joint.name)
    words = WORDS | {"motion": levels(posed), "report": smallest_gap(posed)}
    figure = plt.figure(figsize=(9.0, 6.9))
    axes = {name: step(figure, name, words[name]) for name in PLACES}
    draw_slice(axes["scan"], common.load(options.results, "slices_to_surface_image"))
    with render.screen():
        draw_setup(axes["setup"], joint, head)
        draw_motion(axes["motion"], posed)
        draw_report(axes["report"], posed)
        draw_correction(axes["correct"], joint, head)
    for tail, tip in (("scan", "motion"), ("setup", "motion"), ("motion", "report"), ("report", "correct")):
        join(figure, tail, tip)
    figure.suptitle(
        "Planning an operation of the hip: where impingement detection stands\n"
        f"(scan: simulated, of a generated hip; else: {title[0].lower()}{title[1:]})",
        fontsize=10.5,
        y=0.995,
    )
    return figure


def levels(posed: hip.Hip) -> tuple[str, str, str, str]:
    """What the colours of the simulated pose mean."""
    red, orange, yellow = gap_colours.colours_of(posed.summary, "socket").upper[1:4]
    text = f"IMPINGEMENT DETECTION, by gaps:\nred to {red:g}, orange to {orange:g}, yellow to {yellow:g} mm"
    return "3  Motion simulation", text, OURS, "-"


def smallest_gap(posed: hip.Hip) -> tuple[str, str, str, str]:
    """What the report of that pose says first."""
    least = posed.summary["smallest_gap"]
    text = f"{hip.pose(posed)}: smallest gap {least['gap_mm']:.1f} mm,\nat {least['clock']} on the clock of the socket"
    return "4  Impingement report", text, PART, "-"


def step(figure: plt.Figure, name: str, words: tuple[str, str, str, str]) -> plt.Axes:
    """A box with its heading and what is said below; the axes between them are for a picture."""
    title, text, colour, line = words
    x, y = PLACES[name][0] - WIDE / 2, PLACES[name][1] - HIGH / 2
    ours = name == "motion"
    figure.add_artist(
        FancyBboxPatch(
            (x, y),
            WIDE,
            HIGH,
            boxstyle="round,pad=0,rounding_size=0.012",
            facecolor=colour,
            edgecolor=RING if ours else "#303030",
            linewidth=2.4 if ours else 1.1,
            linestyle=line,
            zorder=0,
        )
    )
    figure.text(x + WIDE / 2, y + HIGH - 0.014, title, ha="center", va="top", fontsize=10.5, weight="bold")
    figure.text(x + WIDE / 2, y + 0.012, text, ha="center", va="bottom", fontsize=8.5, linespacing=1.3)
    axes = figure.add_axes((x + 0.012, y + 0.078, WIDE - 0.024, HIGH - 0.128), zorder=1)
    axes.axis("off")
    return axes


def join(figure: plt.Figure, tail: str, tip: str) -> None:
    """An arrow between the borders of two steps."""
    (x0, y0), (x1, y1) = PLACES[tail], PLACES[tip]
    if x0 == x1:
        ends = (x0, y0 - HIGH / 2), (x1, y1 + HIGH / 2)
    else:
        up = np.clip(y1 - y0, -0.1, 0.1)
        ends = (x0 + WIDE / 2, y0 + up), (x1 - WIDE / 2, y1 - up if abs(y1 - y0) > 0.3 else y0 + up)
    look = {"arrowstyle": "-|>", "mutation_scale": 16, "linewidth": 1.8, "color": "#303030"}
    figure.add_artist(FancyArrowPatch(*ends, shrinkA=0, shrinkB=1, zorder=3, **look))


def show(axes: plt.Axes, image: np.ndarray) -> None:
    """A picture as it is, on the colour of its step."""
    clear = np.dstack([image, np.where((image == 255).all(axis=-1), 0, 255).astype(np.uint8)])
    axes.imshow(clear, interpolation="none")
    axes.autoscale(False)


def draw_slice(axes: plt.Axes, image: pd.DataFrame) -> None:
    """The slice through the centre of a simulated scan, and the level of the surface."""
    x, y = np.unique(image.x_mm), np.unique(image.y_mm)
    values = image.value_hu.to_numpy().reshape(len(y), len(x))
    chosen = image.attrs["parameters"]
    axes.imshow(values, cmap="gray", origin="lower", extent=(x[0], x[-1], y[0], y[-1]))
    axes.contour(
        x, y, values, levels=[0.5 * (chosen["bone_hu"] + chosen["tissue_hu"])], colors="#E69F00", linewidths=1
    )


def draw_setup(axes: plt.Axes, joint: hip.Hip, head: sphere_deviation.HeadMap) -> None:
    """The head with the sphere that gives the centre."""
    view = hip.view("anterior", joint, [head.ball])
    wires = render.rings(hip.sphere_rings(1.01 * head.fit.radius_mm), WIRES, 1.4)
    show(axes, render.picture([render.plain_surface(head.ball, hip.BALL), wires], view))
    axes.plot(*view.place(np.zeros(3)), "+", color=RING, markersize=12, markeredgewidth=2.2)


def draw_motion(axes: plt.Axes, posed: hip.Hip) -> None:
    """The joint at the end of a recorded motion, coloured by its gaps."""
    view = hip.view("oblique", posed, [posed.ball, posed.socket])
    show(axes, render.picture(gap_colours.both(posed), view))


def draw_report(axes: plt.Axes, posed: hip.Hip) -> None:
    """The socket with its clock."""
    panel = panels.take("", [gap_colours.of_part(posed, "socket")], dial_plot.camera(posed))
    show(axes, panel.image)
    dial_plot.draw(axes, panel, posed, fontsize=7.5)


def draw_correction(axes: plt.Axes, joint: hip.Hip, head: sphere_deviation.HeadMap) -> None:
    """Where the head rises above its sphere."""
    view = hip.view("superior", joint, [head.ball])
    show(axes, render.picture([sphere_deviation.coloured(head)], view))
    region = sphere_deviation.excess(head)
    if region:
        pixels = 1.15 * region.reach / view.size * view.pixels / 2
        axes.add_patch(Circle(view.place(region.middle), pixels, fill=False, edgecolor=RING, linewidth=2))


common.run(main, "--joint", "--motion")
