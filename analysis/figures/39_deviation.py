# SPDX-License-Identifier: GPL-3.0-or-later
# @data      head_maps
# @depends   data/head_maps/JOINT.ply
# @depends   scenes/JOINT/{ball.ply,socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @seconds   2 2
# @name      figure-39
# @for       JOINT in patient_a
# @question  How far the head of a stand-in for patient A is from the sphere fitted to it (Figure 39 of the thesis).
# @outputs   png svg pdf
# @name      figure-39-JOINT
# @for       JOINT in JOINTS
# @question  How far the head of JOINT is from the sphere fitted to it (Figure 39 of the thesis).
# @outputs   png
"""Figure 39, how far the surface of a ball is from the sphere fitted to it, in colours."""

import common
from common import hip, panels, render, sphere_deviation

WIRES = (1.0, 1.0, 1.0)


def main(options) -> common.Figure:
    joint = hip.load(options.results, options.joint)
    head = sphere_deviation.load(options.results, joint)
    radius = head.fit.radius_mm
    ball = sphere_deviation.coloured(head)
    wires = render.rings(hip.sphere_rings(radius), WIRES, 1.6)
    front, above = (hip.view(name, joint, [head.ball]) for name in ("anterior", "superior"))
    with render.screen():
        row = [
            panels.take("a) with the sphere as wires, anterior view", [ball, wires], front),
            panels.take("b) superior view", [ball], above),
        ]
    heading = f"{hip.title(joint.name)}\nball beyond the sphere of {radius:.2f} mm fitted to it ({joint.side} side)"
    figure, _ = panels.sheet([row], heading, legend=0.85)
    sphere_deviation.colour_bar(figure)
    return figure


common.run(main, "--joint", "--name")
