# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   scenes/JOINT/{ball.ply,socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @seconds   3 3
# @name      figure-44
# @for       JOINT in patient_a
# @question  The gaps of a stand-in for patient A, drawn in three ways from three sides (Figure 44 of the thesis).
# @outputs   png svg pdf
# @name      figure-44-JOINT
# @for       JOINT in JOINTS
# @question  The gaps of JOINT, drawn in three ways from three sides (Figure 44 of the thesis).
# @outputs   png
"""Figure 44, three ways to draw a joint from three sides: filled, as lines, and blended."""

import common
from common import gap_colours, hip, panels, render

VIEWS = {"anterior": "anterior", "medial": "medial", "oblique": "oblique"}


# Not from Joint3D, which draws in perspective and without a scale, with bytes that depend on the machine's graphics.
def main(options) -> common.Figure:
    joint = hip.load(options.results, options.joint)
    filled = gap_colours.both(joint)
    lines = gap_colours.both(joint)
    for actor in lines:
        actor.GetProperty().SetRepresentationToWireframe()
        actor.GetProperty().LightingOff()
    blended = [gap_colours.of_part(joint, "ball"), gap_colours.of_part(joint, "socket", opacity=0.4)]
    rows = []
    with render.screen():
        for name in VIEWS:
            camera = hip.view(name, joint, [joint.ball, joint.socket], pixels=420)
            rows.append(
                [
                    panels.take(f"{name} view, {way}", actors, camera)
                    for way, actors in (("filled", filled), ("lines", lines), ("blended", blended))
                ]
            )
    heading = f"{hip.title(joint.name)}, {joint.side} side: {hip.pose(joint)}"
    figure, _ = panels.sheet(rows, heading, legend=0.95)
    gap_colours.add_legend(figure, joint.summary)
    return figure


common.run(main, "--joint", "--name")
