# SPDX-License-Identifier: GPL-3.0-or-later
# @depends   scenes/JOINT/{ball.ply,socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @seconds   3 3
# @name      figure-40
# @for       JOINT in patient_a
# @question  The points of the socket of a stand-in for patient A that RSID samples (Figure 40 of the thesis).
# @data      sample_points_hip
# @options   --data sample_points_hip
# @outputs   png svg pdf
# @name      figure-40-JOINT
# @for       JOINT in JOINTS
# @question  The points of the socket of JOINT that RSID samples (Figure 40 of the thesis).
# @data      sample_points_bones
# @options   --data sample_points_bones
# @outputs   png
"""Figure 40, the points of a socket that RSID samples, alone and on it."""

from matplotlib.patches import Patch

import common
from common import hip, panels, render, sample_points

SCHEME = "rsid"


def main(options) -> common.Figure:
    joint = hip.load(options.results, options.joint)
    table = common.load(options.results, options.data)
    found = sample_points.of_scheme(table[table.subject == options.joint], SCHEME)
    points = hip.to_joint(found, joint.summary)
    camera = hip.view("lateral", joint, [joint.socket])
    dots = sample_points.dots(points, camera, 2.4)
    socket = render.plain_surface(joint.socket, hip.SOCKET)
    with render.screen():
        row = [
            panels.take(f"a) socket, {joint.side} lateral view", [socket], camera),
            panels.take("b) socket and sample points", [socket, dots], camera),
            panels.take("c) sample points", [dots], camera),
        ]
    precision = table.attrs["parameters"]["precision_deg"]
    heading = f"{len(points):,} points of the socket that RSID samples at {precision:g}°\n{hip.title(joint.name)}"
    figure, _ = panels.sheet([row], heading)
    handles = [
        Patch(color=hip.SOCKET, label=f"socket, {len(joint.socket.triangles):,} triangles"),
        common.key("sample point", linestyle="none", marker="o", markersize=4, color=sample_points.GREEN),
    ]
    figure.legend(handles=handles, loc="lower center", ncol=2, title=hip.WAYS, title_fontsize=8, fontsize=9)
    return figure


common.run(main, "--joint", "--name", "--data")
