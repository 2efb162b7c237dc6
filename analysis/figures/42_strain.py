# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   scenes/JOINT/{ball.ply,socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @seconds   3 3
# @name      figure-42
# @for       JOINT in patient_a
# @question  The gaps of a stand-in for patient A in the colours of the thesis (Figure 42 of the thesis).
# @outputs   png svg pdf
# @name      figure-42-JOINT
# @for       JOINT in JOINTS
# @question  The gaps of JOINT in the colours of the thesis (Figure 42 of the thesis).
# @outputs   png
"""Figure 42, the gaps of a joint in colours: both surfaces from the front, the socket from lateral, the ball from medial.
"""

import common
from common import gap_colours, hip, panels, render


def main(options) -> common.Figure:
    joint = hip.load(options.results, options.joint)
    ball, socket = gap_colours.both(joint)
    with render.screen():
        row = [
            panels.take(
                f"a) {joint.side} joint, anterior view",
                [ball, socket],
                hip.view("anterior", joint, [joint.ball, joint.socket]),
            ),
            panels.take(
                f"b) socket, {joint.side} lateral view", [socket], hip.view("lateral", joint, [joint.socket])
            ),
            panels.take("c) ball, medial view", [ball], hip.view("medial", joint, [joint.ball])),
        ]
    smallest = joint.summary["smallest_gap"]
    gap = f"smallest gap {smallest['gap_mm']:.2f} mm at {smallest['clock']} o'clock" if smallest else "no gap"
    heading = f"{hip.title(joint.name)}\n{hip.pose(joint)}: {gap}; {hip.close_zones(joint.summary)}"
    figure, _ = panels.sheet([row], heading, legend=0.95)
    gap_colours.add_legend(figure, joint.summary)
    return figure


common.run(main, "--joint", "--name")
