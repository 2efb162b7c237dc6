# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   scenes/JOINT/{ball.ply,socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @seconds   2 2
# @name      figure-36
# @for       JOINT in patient_a
# @question  The joint of a stand-in for patient A, anterior view (Figure 36 of the thesis).
# @outputs   png svg pdf
# @name      figure-36-JOINT
# @for       JOINT in JOINTS
# @question  The joint of JOINT, anterior view (Figure 36 of the thesis).
# @outputs   png
"""Figure 36, a hip joint from the front: ball and socket, and the socket as glass."""

from matplotlib.patches import Patch

import common
from common import hip, panels, render


# Not from Joint3D, which draws in perspective and without a scale, with bytes that depend on the machine's graphics.
def main(options) -> common.Figure:
    joint = hip.load(options.results, options.joint)
    front = hip.view("anterior", joint, [joint.ball, joint.socket])
    ball = render.plain_surface(joint.ball, hip.BALL)
    with render.screen():
        row = [
            panels.take("anterior view", [ball, render.plain_surface(joint.socket, hip.SOCKET)], front),
            panels.take(
                "anterior view, socket as glass",
                [ball, render.plain_surface(joint.socket, hip.SOCKET, opacity=0.35)],
                front,
            ),
        ]
    figure, _ = panels.sheet([row], f"A ball-and-socket joint, {joint.side} side\n{hip.title(joint.name)}")
    handles = [Patch(color=hip.BALL, label="ball"), Patch(color=hip.SOCKET, label="socket")]
    figure.legend(handles=handles, loc="lower center", ncol=2, title=hip.WAYS, title_fontsize=8, fontsize=9)
    return figure


common.run(main, "--joint", "--name")
