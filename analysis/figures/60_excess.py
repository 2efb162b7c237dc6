# SPDX-License-Identifier: GPL-3.0-or-later
# @data      head_maps
# @depends   data/head_maps/JOINT.ply
# @depends   scenes/JOINT/{ball.ply,socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @seconds   2 2
# @name      figure-60
# @for       JOINT in patient_a
# @question  Where the head of a stand-in for patient A rises above its sphere (Figure 60 of the thesis).
# @outputs   png svg pdf
# @name      figure-61
# @for       JOINT in patient_b
# @question  Where the head of a stand-in for patient B rises above its sphere (Figure 61 of the thesis).
# @outputs   png svg pdf
# @name      figure-60-JOINT
# @for       JOINT in JOINTS
# @question  Where the head of JOINT rises above its sphere (Figure 60 of the thesis).
# @outputs   png
"""Figures 60 and 61, where the femoral head of a patient rises above the sphere fitted to it. The third picture of each, a
similar case of another publication, is not made again.
"""

import numpy as np
from matplotlib.patches import Circle

import common
from common import hip, panels, render, sphere_deviation

RING = "#d4006a"


def main(options) -> common.Figure:
    joint = hip.load(options.results, options.joint)
    head = sphere_deviation.load(options.results, joint)
    region = sphere_deviation.excess(head)
    ball = sphere_deviation.coloured(head)
    glass = render.plain_surface(joint.socket, hip.SOCKET, opacity=0.35)
    both = [head.ball, joint.socket]
    with render.screen():
        row = [
            panels.take(f"a) {joint.side} head, superior view", [ball], hip.view("superior", joint, [head.ball])),
            panels.take(f"b) {joint.side} joint, oblique view", [ball, glass], hip.view("oblique", joint, both)),
        ]
    found = (
        f"ring: largest rise of {sphere_deviation.EXCESS:g} mm or more on the head, {region.most:.1f} mm"
        if region
        else f"no rise of {sphere_deviation.EXCESS:g} mm on the head"
    )
    figure, grid = panels.sheet([row], f"{hip.title(joint.name)}\n{found}", legend=0.85)
    if region:
        for axes, panel in zip(grid.flat, row):
            mark(axes, panel, region)
    sphere_deviation.colour_bar(figure)
    return figure


def mark(axes, panel: panels.Panel, region: sphere_deviation.Region) -> None:
    """A ring round the region; dashed where the head hides its middle."""
    pixels = 1.15 * region.reach / panel.view.size * panel.view.pixels / 2
    hidden = region.middle @ panel.view.towards > 0.3 * np.linalg.norm(region.middle)
    axes.add_patch(
        Circle(
            panel.view.place(region.middle),
            pixels,
            fill=False,
            edgecolor=RING,
            linewidth=2,
            linestyle="--" if hidden else "-",
        )
    )


common.run(main, "--joint", "--name")
