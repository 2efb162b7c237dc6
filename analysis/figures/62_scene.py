# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   scenes/JOINT/{ball.ply,socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @seconds   2 2
# @name      figure-62
# @for       JOINT in patient_a
# @question  Camera, joint and clock of a stand-in for patient A (Figure 62 of the thesis).
# @outputs   png svg pdf
# @name      figure-63
# @for       JOINT in patient_b
# @question  Camera, joint and clock of a stand-in for patient B (Figure 63 of the thesis).
# @outputs   png svg pdf
# @name      figure-62-JOINT
# @for       JOINT in JOINTS
# @question  Camera, joint and clock of JOINT (Figure 62 of the thesis).
# @outputs   png
"""Figures 62 and 63, the scene of Tables 12 and 13: where the camera stands, the joint from the front, and the socket with
its clock as the camera sees it.
"""

import numpy as np
from matplotlib.patches import Patch

import common
from common import dial_plot, hip, panels, render

EYE = "#d4006a"


def main(options) -> common.Figure:
    joint = hip.load(options.results, options.joint)
    ball, socket = (render.plain_surface(*part) for part in ((joint.ball, hip.BALL), (joint.socket, hip.SOCKET)))
    both = [joint.ball, joint.socket]
    with render.screen():
        above = hip.view("superior", joint, both)
        row = [
            panels.take(
                "a) setup, superior view",
                [ball, socket],
                render.View(
                    above.focus - 0.5 * above.size * joint.outwards * np.array([1, 0, 0]),
                    above.towards,
                    above.up,
                    1.35 * above.size,
                    above.pixels,
                ),
            ),
            panels.take("b) joint, anterior view", [ball, socket], hip.view("anterior", joint, both)),
            panels.take(f"c) socket and clock, {sight(joint)}", [socket], dial_plot.camera(joint)),
        ]
    heading = f"The scene of Tables 12 and 13 for a {joint.side} joint\n{hip.title(joint.name)}"
    figure, grid = panels.sheet([row], heading)
    camera(grid[0][0], row[0], joint)
    dial_plot.draw(grid[0][2], row[2], joint)
    handles = [Patch(color=hip.BALL, label="ball"), Patch(color=hip.SOCKET, label="socket")]
    figure.legend(handles=handles, loc="lower center", ncol=2, title=hip.WAYS, title_fontsize=8, fontsize=9)
    return figure


def sight(joint: hip.Hip) -> str:
    """How the thesis calls the view of the camera: from the patient's other side."""
    return f"{'left' if joint.side == 'right' else 'right'} medial view"


def camera(axes, panel: panels.Panel, joint: hip.Hip) -> None:
    """An arrow from the camera, medial of the joint, to the socket."""
    towards, _ = hip.towards("medial", joint)
    edge = np.abs(joint.socket.vertices @ towards).max()
    tip, tail = (panel.view.place(-(edge + mm) * towards) for mm in (2.0, 22.0))
    axes.annotate("", tip, tail, arrowprops={"arrowstyle": "-|>", "color": EYE, "linewidth": 2})
    common.note(axes, "camera", tail, (0, 8), ha="center", fontsize=9, color=EYE)


common.run(main, "--joint", "--name")
