# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the report in which a reader turns a joint: Joint3D itself, joint3d.html beside the page, in a frame once a
button asks for it; turn.js does that. A picture stands there before, and in print.
"""

from __future__ import annotations

import html

LOOK = "cartilage=4&view=free&show=ball,socket,clock,smallest"
# What a reader may choose: a title, and the joint and pose as a link to Joint3D has them.
JOINTS = {
    "Patient A's stand-in, as modelled": "joint=patient_a&side=right",
    "Patient A's stand-in, flexed by 100°": "joint=patient_a&side=right&flexion=100&abduction=-4&internal_rotation=5",
    "Patient B's stand-in, as modelled": "joint=patient_b&side=left",
    "Cam hip, flexed and turned inwards": "joint=cam&side=right&flexion=90&internal_rotation=25",
    "Pincer hip, flexed and turned inwards": "joint=pincer&side=right&flexion=90&internal_rotation=25",
    "Normal hip, in the same pose": "joint=normal&side=right&flexion=90&internal_rotation=25",
}


def section(picture: str) -> str:
    """Explanation, choices and the frame's place; picture: an <img>."""
    options = "".join(
        f'<option value="{state}&amp;{LOOK}">{title}</option>'
        for title, state in ((html.escape(t), html.escape(s)) for t, s in JOINTS.items())
    )
    return (
        "<p>Joint3D, the program of the thesis' Section 3.4, with this library in it: it works out the gap at every vertex as"
        " you watch. Each colour is a range of gaps in mm between ball and socket, given beside the joint: purple where bones"
        " overlap, red to yellow where the gap is below the 4 mm of both cartilage layers, green on the ball and blue on the socket"
        " beyond, grey where no surface is opposite. Numbers are clock positions on the socket's rim, 12 at the top; the dot"
        " marks the smallest gap. All these hips are made from parameters; none is a patient's scan.</p>"
        f'<div class="filters"><label>Joint and pose<select id="turn-joint">{options}</select></label>'
        '<label class="check"><input type="checkbox" id="turn-panels"> all of Joint3D\'s controls</label></div>'
        f'<div id="turn-place">{picture}<button type="button" id="turn-start">Show the joint</button></div>'
        '<p class="soft">Drag with the mouse or a finger to turn, wheel or two fingers to come nearer; or press Tab until the'
        " picture has the frame, then arrow keys, + and −. “Move femur” lets a drag move the bone instead: the gaps follow."
        ' The whole program is <a href="joint3d.html">joint3d.html</a> beside this report.</p>'
    )
