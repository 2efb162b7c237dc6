# SPDX-License-Identifier: GPL-3.0-or-later
# @options   --joint JOINT --name NAME
# @depends   scenes/JOINT-{MOTIONS}/{ball.ply,socket.ply,summary.json}
# @outputs   png svg pdf
# @seconds   4 4
# @name      table-12-pictures
# @for       JOINT in patient_a
# @question  How close do the bones of a stand-in for patient A come at the ends of the recorded motions, and where (Table 12)?
# @name      table-13-pictures
# @for       JOINT in patient_b
# @question  How close do the bones of a stand-in for patient B come at the ends of the recorded motions, and where (Table 13)?
"""The pictures of Tables 12 and 13: the socket at the end of each recorded motion, unrolled, with its clock."""

import matplotlib.pyplot as plt

import common
from common import gap_colours, hip, replay, socket_map

PIXELS = 700


def main(options) -> common.Figure:
    joints = [hip.load(options.results, f"{options.joint}-{motion}") for motion in replay.MOTIONS]
    unrolled = socket_map.unroll(joints[0], PIXELS)
    shades = gap_colours.shades(gap_colours.colours_of(joints[0].summary, "socket"))
    figure, grid = plt.subplots(2, 3, figsize=(7.0, 6.4))
    for axes, joint, name in zip(grid.flat, joints, replay.MOTIONS.values()):
        socket_map.draw(axes, unrolled.image(joint.socket.properties["gap"], shades), joint, words(joint, name))
    figure.suptitle(
        f"{hip.title(options.joint)}\n{joints[0].side} socket at the ends of the recorded motions, unrolled from its middle to the rim:\n"
        "the hours of its clock, seen from medial, and rings of 30°, 60° and 90°",
        fontsize=9.5,
    )
    figure.legend(
        handles=gap_colours.legend(joints[0].summary, ("socket",)), loc="lower center", ncol=3, title="radial gap", fontsize=common.SMALL
    )
    figure.subplots_adjust(left=0.01, right=0.99, top=0.83, bottom=0.13, wspace=0.03, hspace=0.2)
    return figure


def words(joint: hip.Hip, name: str) -> str:
    """What happens there."""
    angle = float(joint.summary["pose"].partition("=")[2])
    gap = joint.summary["smallest_gap"]
    return f"{name} {angle:g}°: smallest gap\n{gap['gap_mm']:.2f} mm at {gap['clock']} o'clock"


common.run(main, "--joint", "--name")
