# SPDX-License-Identifier: GPL-3.0-or-later
"""Options that cannot be used, of each command those of one kind once: what is typed behind `impinge` (two meshes come behind
the command), and what is said between "impinge: error: " and "; see impinge COMMAND --help". {schemes} stands for their names.
"""

import shlex

MOTIONS = "there are flexion, extension, abduction, adduction, internal_rotation, external_rotation"

# By what is said, of which {last} is the last word that is typed and {option} the one before it.
REFUSED = {
    # Values.
    "{option}: '{last}' is out of range; give one that is above 0": ["gaps --precision -0.5", "limits --largest 0"],
    "{option}: '{last}' is no number; give one that is above 0": ["gaps --precision 1,5", "gaps --max-error inf", "resect --clearance 1e400"],
    "{option}: '{last}' is out of range; give one that is 0 or more": ["touch --overlap -1", "volume --gap -1", "volume --play -1"],
    "--width: '{last}' is out of range; give one that is above 0, up to 1": ["volume --width 1.1"],
    "--tilt: '{last}' is out of range; give one that is from -90 to 90": ["orient --require flexion=90 --tilt 100"],
    "--threads: '{last}' is no whole number; give one that is from 1 to 1024": ["poses --threads 1.5"],
    "--precision: an RSID precision divides 180 degrees, as 1, 0.5, 0.25, 0.1 or 0.05 do": ["gaps --precision 0.7"],
    "--precision: 1 required DEG missing": ["gaps --precision"],
    "--precision: At Most 1 required but received 2": ["gaps --precision 1 --precision 2"],
    "--scheme: unknown scheme '{last}'; there are {schemes}": ["gaps --scheme RSID"],
    "--outputs: there is no 'pictures'; there are gaps, bounds, distances, verdicts": ["gaps --outputs gaps,pictures"],
    "--outputs: there is no '{last}'; did you mean gap? There are touch, gap, areas": ["poses --outputs gaps"],
    "{option}: there is no '{last}'; there are ball, socket": ["resect --cut femur"],
    "--keep: there is no '{last}'; there are all, largest": ["touch --keep some"],
    "--side: there is no '{last}'; there are left, right": ["measure --side up"],
    "{option}: '{last}' is no place; give three numbers in mm as X,Y,Z": ["touch --centre middle", "touch --centre 1,2,nan", "limits --translation 1,2"],
    "--axes: axis code '{last}' is left-handed and would mirror the patient; name where +x, +y and +z point with one letter each of "
    "R/L, A/P and S/I, as RAS or LPS": ["touch --axes LAS"],
    "--cartilage: '{last}' is no thickness and no file; give a number of mm, 0 or more, scan, or a CSV of x,y,z,thickness_mm": [
        "gaps --cartilage -1", "limits --cartilage 4mm",
    ],
    f"{{option}}: unknown motion 'bend'; {MOTIONS}": [
        "touch --pose bend=3", "certify --motion bend", "resect --require bend=90",
    ],
    f"{{option}}: unknown motion 'bend'; {MOTIONS}, tx, ty, tz, plane_of_elevation, elevation, axial_rotation, rot_x, rot_y, rot_z, "
    "trans_x, trans_y, trans_z": ["poses --path bend=0..9/1"],
    f"--motions: unknown motion '{{last}}'; {MOTIONS}, internal_rotation_at_45, internal_rotation_at_70, internal_rotation_at_90, "
    "external_rotation_at_90, fadir, faber": ["limits --motions flexion=30"],
    "{option}: 'flexion' is no motion; write NAME=DEGREES, as flexion=90": ["touch --pose flexion", "orient --require flexion"],
    "--pose: '181' is no angle of flexion; give degrees from -180 to 180": ["touch --pose flexion=181"],
    "--pose: the axis of 'extension' is given twice; give it once": ["touch --pose flexion=90,extension=10"],
    "--path: '{last}' has no step; write NAME=FIRST..LAST/STEP or NAME=NUMBER, as flexion=0..120/1": ["poses --path flexion=0..90"],
    # What does not go together, or is missing.
    "--max-error: is of gaps of the faces, and a scheme or precision asks for tables; leave one out": ["gaps --scheme usid --max-error 1"],
    "--surfaces: one alone has neither bounds, distances nor verdicts; ask for the outputs gaps alone": ["gaps --surfaces ball"],
    "--cartilage: is one thickness here, and no map; give a number of mm": ["limits --cartilage /dev/null"],
    "--motions: fadir begins at a pose of its own; leave the pose out": ["limits --motions fadir --side left --pose flexion=90"],
    "--pose: it leaves no room for flexion within 180 degrees; begin with a smaller angle": ["certify --motion flexion --pose flexion=180"],
    "--poses: they are asked for by a file, or by a path of angles; give one of poses and path": ["poses", "poses --path flexion=0 --poses f.csv"],
    "--require: a required motion turns something; give one, as flexion=90,internal_rotation=30": ["orient", "resect --require flexion=0"],
    "--rim: applies only to a cut of the socket; cut the socket, or leave it out": ["resect --require flexion=90 --rim 3"],
    "--neck: applies only to a cut of the ball; cut the ball, or leave it out": ["resect --require flexion=90 --cut socket --neck 20"],
    "--side: abduction and rotation need to know it; give left or right": [
        "touch --pose abduction=10", "gaps --pose internal_rotation=10", "limits --cartilage 0", "poses --path abduction=0..9/1",
        "certify --motion abduction", "resect --require abduction=10",
    ],
    "--side: measures need to know it; give left or right": ["measure"],
    "--side: an orientation needs to know it; give left or right": ["orient --require flexion=30"],
    "BALL excludes --joints": ["touch --joints ."],
    "--set: changes a hip, and the pair is none; leave it out": ["hip pair --set cam_height=1"],
    "--set: 'cam' sets no parameter; write NAME=VALUE, as cam_height=3": ["hip cam --set cam"],
    "a surface of a hip needs 500 faces or more, not {last}": ["hip normal --faces 100"],
    # What nothing expects, or is empty, as a script types what is not set; what may ruin a line, or a terminal.
    "'stray' was not expected": ["touch stray"],
    "--precison: is no option of impinge gaps; did you mean --precision?": ["gaps --precison=1"],
    "--width: is no option of impinge touch, but of impinge volume and impinge report": ["touch --width 0.1"],
    "{option}: is empty; give it a value or leave it out": [f"gaps {option} ''" for option in ("--ball-part", "--side", "--precision", "--outputs")],
    "--side: there is no 'up and [2J away'; there are left, right": ["touch --side 'up\nand\x1b[2J away'"],
    "--cartilage: is no option of impinge {command}, but of impinge gaps and impinge poses and impinge limits and impinge report": [
        f"{command} --cartilage 2" for command in ("touch", "volume", "resect", "orient", "measure", "certify")
    ],
    "--colour red: is no option of impinge touch": ["touch '--colour\nred'"],
}


def said(message: str, words: list[str]) -> str:
    """With what the braces stand for."""
    message = message.replace("{command}", words[0]).replace("{last}", words[-1]).replace("{option}", words[-2] if len(words) > 1 else "")
    return message + (" See" if message.endswith("?") else "; see") + f" impinge {words[0]} --help"


OPTIONS = [(shlex.split(typed), said(message, shlex.split(typed))) for message, lines in REFUSED.items() for typed in lines]
