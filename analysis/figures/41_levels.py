# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-41
# @question  The five colours of a gap, on a stand-in for patient A whose ball is moved forward (Figure 41 of the thesis).
# @data      motion_frames
# @depends   data/motion_frames/forward-{ball,socket}.ply
# @depends   scenes/patient_a/{ball.ply,socket.ply,summary.json}
# @options   --joint patient_a --name NAME
# @outputs   png svg pdf
# @seconds   3 3
"""Figure 41, the colours of a gap, on a joint whose ball is moved forward into the socket."""

from dataclasses import replace

import numpy as np

import common
from common import gap_colours, hip, panels, ply, render


def main(options) -> common.Figure:
    folder = options.results / "data" / "motion_frames"
    moved = {part: ply.read(folder / f"forward-{part}.ply") for part in ("ball", "socket")}
    joint = replace(hip.load(options.results, options.joint), **moved)
    ball, socket = gap_colours.both(joint)
    glass = gap_colours.of_part(joint, "socket", opacity=0.35)
    together = hip.view("anterior", joint, [joint.ball, joint.socket])
    with render.screen():
        row = [
            panels.take("a) joint, anterior view, socket as glass", [ball, glass], together),
            panels.take("b) socket, lateral view", [socket], hip.view("lateral", joint, [joint.socket])),
            panels.take("c) ball, medial view", [ball], hip.view("medial", joint, [joint.ball])),
        ]
    forward = common.load(options.results, "motion_frames").attrs["parameters"]["forward_mm"]
    smallest = min(np.nanmin(mesh.properties["gap"]) for mesh in moved.values())
    heading = (
        f"Ball moved forward by {forward:g} mm to show the five colours, smallest gap {smallest:.2f} mm\n"
        f"{hip.title(options.joint)}"
    ).replace("gap -", "gap −")
    figure, _ = panels.sheet([row], heading, legend=0.95)
    gap_colours.add_legend(figure, joint.summary)
    return figure


common.run(main, "--joint", "--name")
