# SPDX-License-Identifier: GPL-3.0-or-later
# @options   --joint JOINT --name NAME
# @depends   scenes/JOINT-{MOTIONS}/{ball.ply,socket.ply,summary.json}
# @outputs   png svg pdf
# @seconds   4 4
# @name      table-12-pictures
# @for       JOINT in patient_a
# @question  The socket of a stand-in for patient A at the ends of the recorded motions (Table 12).
# @name      table-13-pictures
# @for       JOINT in patient_b
# @question  The socket of a stand-in for patient B at the ends of the recorded motions (Table 13).
"""The pictures of Tables 12 and 13: the socket at the end of each recorded motion, from medial with its clock, and below
unrolled.
"""

import common
from common import dial_plot, gap_colours, hip, panels, render, replay, socket_map

PIXELS = 440


def main(options) -> common.Figure:
    joints = [hip.load(options.results, f"{options.joint}-{motion}") for motion in replay.MOTIONS]
    with render.screen():
        taken = [picture(joint, name) for joint, name in zip(joints, replay.MOTIONS.values())]
    heading = (
        f"{hip.title(options.joint)}\nsocket of the {joints[0].side} hip at the ends of the recorded motions:\n"
        "smallest gap, medial view, and unrolled with hours and degrees"
    )
    rows = [taken[:3], taken[:3], taken[3:], taken[3:]]
    figure, grid = panels.sheet(rows, heading, legend=1.0, titles=2, width=4.6)
    unrolled = socket_map.unroll(joints[0], PIXELS)
    shades = gap_colours.shades(gap_colours.colours_of(joints[0].summary, "socket"))
    for k, joint in enumerate(joints):
        line, column = 2 * (k // 3), k % 3
        dial_plot.draw(grid[line][column], taken[k], joint, fontsize=common.SMALL)
        below = grid[line + 1][column]
        below.clear()
        box = below.get_position()
        below.set_position([box.x0, box.y0 + 0.55 * (grid[line][column].get_position().y0 - box.y1), *box.size])
        socket_map.draw(below, unrolled.image(joint.socket.properties["gap"], shades), joint)
    gap_colours.add_legend(figure, joints[0].summary, ("socket",))
    return figure


def picture(joint: hip.Hip, name: str) -> panels.Panel:
    """The socket from medial, under what happens there."""
    angle = float(joint.summary["pose"].partition("=")[2])
    gap = joint.summary["smallest_gap"]
    title = f"{name} {angle:g}°\n{gap['gap_mm']:.2f} mm at {gap['clock']}"
    return panels.take(title, [gap_colours.of_part(joint, "socket")], dial_plot.camera(joint, PIXELS))


common.run(main, "--joint", "--name")
