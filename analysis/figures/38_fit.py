# SPDX-License-Identifier: GPL-3.0-or-later
# @data      head_maps
# @depends   data/head_maps/JOINT.ply
# @depends   scenes/JOINT/{ball.ply,socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @seconds   3 3
# @name      figure-38
# @for       JOINT in patient_a
# @question  The sphere fitted to the head of a stand-in for patient A (Figure 38 of the thesis).
# @outputs   png svg pdf
# @name      figure-38-JOINT
# @for       JOINT in JOINTS
# @question  The sphere fitted to the head of JOINT (Figure 38 of the thesis).
# @outputs   png
"""Figure 38, the sphere fitted to a ball: the region that was fitted, and the sphere as wires."""

import numpy as np
from matplotlib.patches import Patch

import common
from common import hip, panels, render, sphere_deviation

FITTED, LEFT_OUT, WIRES = (0.55, 0.33, 0.65), hip.BALL, (0.05, 0.05, 0.05)


def main(options) -> common.Figure:
    joint = hip.load(options.results, options.joint)
    head = sphere_deviation.load(options.results, joint)
    fit = head.fit
    shades = render.Shades(np.array([LEFT_OUT, FITTED]), (0.0, 1.0))
    region = render.scalar_surface(head.ball, head.fitted.astype(float), shades)
    bone = render.plain_surface(head.ball, hip.BALL)
    wires = render.rings(hip.sphere_rings(1.01 * fit.radius_mm), WIRES, 1.4)
    front, above = (hip.view(name, joint, [head.ball]) for name in ("anterior", "superior"))
    with render.screen():
        row = [
            panels.take("a) region fitted, anterior view", [region], front),
            panels.take("b) fitted sphere, anterior view", [bone, wires], front),
            panels.take("c) fitted sphere, superior view", [bone, wires], above),
        ]
    heading = (
        f"{hip.title(joint.name)}: sphere fitted to the ball ({joint.side} side)\n"
        f"radius {fit.radius_mm:.2f} mm, residual {common.digits(fit.rms_mm, 2)} mm rms over {int(fit.fitted):,} of "
        f"{int(fit.vertices):,} vertices"
    )
    figure, _ = panels.sheet([row], heading)
    handles = [
        Patch(color=FITTED, label="fitted (chosen by the program)"),
        Patch(color=LEFT_OUT, label="not fitted"),
        Patch(color=WIRES, label="sphere"),
    ]
    figure.legend(handles=handles, loc="lower center", ncol=3, title=hip.WAYS, title_fontsize=common.SMALL)
    return figure


common.run(main, "--joint", "--name")
