# SPDX-License-Identifier: GPL-3.0-or-later
"""Options that cannot be used: what is typed behind --ball, --socket and --out, and what is said behind
"scene: error: ". {schemes} stands for the names of all schemes.
"""

import shlex

MOTIONS = "there are flexion, extension, abduction, adduction, internal_rotation, external_rotation"
MEANT = {
    "{AXES}": "name where +x, +y and +z point with one letter each of R/L, A/P and S/I, as RAS or LPS",
    "{MOTIONS}": MOTIONS,
    "{LIMITS}": f"{MOTIONS}, internal_rotation_at_45, internal_rotation_at_70, internal_rotation_at_90, external_rotation_at_90, "
    "fadir, faber, all",
    "{THICKNESS}": "is no thickness and no file; give a number of mm, 0 or more, or a CSV of x,y,z,thickness_mm",
}

# By what is said, of which {last} is the last word that is typed and {option} the one before it.
REFUSED = {
    "option --precision: an RSID precision is above 0 and at most 90 degrees": [
        "--precision 0", "--precision -0.5", "--precision 91",
    ],
    "option --precision: an RSID precision divides 180 degrees, as 1, 0.5, 0.25, 0.1 or 0.05 do": ["--precision 0.7"],
    "option --precision: an RSID precision is at least 1.8e-7 degrees": ["--precision 1e-12"],
    "option --precision: '{last}' is no precision; give a number of degrees": [
        "--precision 1e400", "--precision fine", "--precision nan", "--precision 1,5",
    ],
    "--precision: 1 required TEXT missing; see scene --help": ["--precision"],
    "--precision: At Most 1 required but received 2; see scene --help": [
        "--precision 1 --precision 2", "--precision 1 --precision ''",
    ],
    "--precision excludes --max-error; see scene --help": ["--precision 1 --max-error 1"],
    "--scheme excludes --max-error; see scene --help": ["--scheme usid --max-error 1"],
    "option --max-error: '{last}' is no accuracy; give a number of mm above 0": [
        "--max-error 0", "--max-error -1", "--max-error inf", "--max-error small",
    ],
    "option --scheme: unknown scheme '{last}'; there are {schemes}": ["--scheme rside", "--scheme RSID"],
    "option --centre: '{last}' is no centre; give 'fit' or three numbers in mm as X,Y,Z": [
        "--centre 1,2", "--centre 1,2,3,4", "--centre '1;2;3'", "--centre middle",
    ],
    "option --centre: 'nan' is no centre; give 'fit' or three numbers in mm as X,Y,Z": ["--centre 1,2,nan"],
    "option --overlap: '{last}' is no length; give a number of mm, 0 or more": ["--overlap -1", "--overlap deep"],
    "option --certificate: it is about all of the meshes in their files; leave out --overlap and --keep": [
        "--certificate p --overlap 1", "--certificate p --keep largest",
    ],
    "option --keep: '{last}' is no choice of pieces; give all or largest": ["--keep some", "--keep 1"],
    "option --question: '{last}' needs the motion whose limit is wanted; add it, as --motion flexion": ["--question limit"],
    "option --motion: unknown motion '{last}'; {LIMITS}": [
        "--question limit --motion bend", "--question limit --motion flexion=30",
    ],
    "option --motion: 'fadir' begins at a pose of its own; leave --pose out": [
        "--question limit --motion fadir --side left --pose flexion=90",
    ],
    "option --motion: 'all' begins at a pose of its own; leave --pose out": [
        "--question limit --motion all --side left --pose flexion=90",
    ],
    "option --motion: abduction and rotation need to know the side; give left or right with --side": [
        "--question limit --motion all", "--question limit --motion abduction",
    ],
    "option --question: '{last}' need to know the side; give left or right with --side": ["--question measures"],
    "--ball-part: 1 required TEXT missing; see scene --help": ["--ball-part"],
    "option {option}: '' is empty; give it a value or leave it out": [
        "--ball-part ''", "--socket-part ''", "--precision ''", "--max-error ''", "--pose ''", "--side ''", "--cartilage ''",
        "--centre ''", "--keep ''", "--overlap ''", "--axes ''", "--scheme ''", "--question ''", "--surfaces ''", "--outputs ''", "--certificate ''",
    ],
    "--ball excludes --bones; see scene --help": ["--bones ."],
    "option --motion: '{last}' comes with the question limit alone; add --question limit": ["--motion flexion"],
    "option --motion: the pose leaves no room for flexion within 180 degrees; begin with a smaller angle": [
        "--question limit --motion flexion --pose flexion=180",
    ],
    "option --pose: unknown motion 'bend'; {MOTIONS}": ["--pose bend=3"],
    "option --pose: '{last}' is no motion; write NAME=DEGREES, as flexion=90": ["--pose flexion"],
    "option --pose: '181' is no angle of flexion; give degrees from -180 to 180": ["--pose flexion=181"],
    "option --pose: 'much' is no angle of flexion; give degrees from -180 to 180": ["--pose flexion=much"],
    "option --pose: the axis of 'extension' is given twice; give it once": ["--pose flexion=90,extension=10"],
    "option --pose: abduction and rotation need to know the side; give left or right with --side": [
        "--pose abduction=10", "--pose internal_rotation=10",
    ],
    "option --side: side '{last}' is neither left nor right": ["--side up"],
    "option --axes: axis code '{last}' is left-handed and would mirror the patient; {AXES}": ["--axes LAS"],
    "option --axes: axis code '{last}' does not have three letters; {AXES}": ["--axes RA"],
    "option --axes: axis code '{last}' names one direction twice; {AXES}": ["--axes RRS"],
    "option --axes: axis code '{last}' has an unknown letter; {AXES}": ["--axes XYZ"],
    "option --cartilage: '{last}' {THICKNESS}": ["--cartilage -1", "--cartilage thick", "--cartilage inf", "--cartilage 4mm"],
    "The following arguments were not expected: red --colour; see scene --help": ["--colour red"],
    "The following argument was not expected: stray; see scene --help": ["stray"],
    "option --question: '{last}' is no question; ask touch, first-contact, limit, limits, volume, measures, resection, orientation or all-gaps": [
        "--question why",
    ],
    "option --question: '{last}' needs the side of the body; add --side left or --side right": ["--question limits"],
    "option --width: '{last}' is no share; give a number above 0 and below 1, as 0.01": [
        "--question volume --width 1", "--question volume --width 0",
    ],
    "option --question: 'volume' is about all poses; leave out --poses and --path": ["--question volume --path flexion=0..90/1"],
    "option --gap: '{last}' comes with the question volume alone; add --question volume": ["--gap 4"],
    "option --pose: '{last}' is one pose, and the question is about all of them; leave it out": [
        "--question volume --pose flexion=20",
    ],
    "option --gap: '{last}' is no length; give a number of mm, 0 or more": ["--question volume --gap -1"],
    "option --width: '{last}' comes with the question volume alone; add --question volume": ["--width 0.1"],
    "option --surfaces: '{last}' is no choice of surfaces; give ball, socket or both": ["--surfaces none"],
    "option --surfaces: '{last}' leaves out what bounds, distances and verdicts need; add --outputs gaps": [
        "--surfaces ball", "--path flexion=0..9/1 --surfaces ball",
    ],
    "option --outputs: 'pictures' is no output; give some of gaps, bounds, distances and verdicts, with commas between": [
        "--outputs gaps,pictures",
    ],
    "option --outputs: '{last}' come with the question all-gaps alone; leave one of the two options out": [
        "--question touch --outputs gaps",
    ],
    "option --question: '{last}' needs the motions that are to be reached; add them, as --require flexion=90": [
        "--question resection",
    ],
    "option --require: unknown motion 'bend'; {MOTIONS}": ["--question resection --require bend=90"],
    "option --require: '{last}' is no motion; write NAME=DEGREES, as flexion=90": ["--question resection --require flexion"],
    "option --require: '{last}' moves nothing; give an angle other than 0": ["--question resection --require flexion=0"],
    "option --require: abduction and rotation need to know the side; give left or right with --side": [
        "--question resection --require flexion=30 --require abduction=10",
    ],
    "option --clearance: '{last}' is no length; give a number of mm above 0": [
        "--question resection --require flexion=90 --clearance 0",
    ],
    "option --neck: '{last}' is no length; give a number of mm above 0": ["--question resection --require flexion=90 --neck wide"],
    "option --pose: '{last}' has no place here: required motions begin in the pose of the scan": [
        "--question resection --require flexion=90 --pose flexion=10",
    ],
    "option --question: 'resection' is asked of required motions; leave out --path and --poses": [
        "--question resection --require flexion=90 --path flexion=0..9/1",
    ],
    "option --require: '{last}' comes with the questions resection and orientation alone; add one of them": [
        "--require flexion=90",
    ],
    "option --clearance: '{last}' comes with the question resection alone; add --question resection": [
        "--clearance 1", "--question orientation --require flexion=90 --side left --clearance 1",
    ],
    "option --cut: '{last}' comes with the question resection alone; add --question resection": ["--cut socket"],
    "option --cut: '{last}' is no bone that can be cut; give ball or socket": [
        "--question resection --require flexion=90 --cut femur",
    ],
    "option --neck: '{last}' is of a cut of the ball; leave it or --cut socket out": [
        "--question resection --require flexion=90 --cut socket --neck 20",
    ],
    "option --least: is a cut of the ball; leave it or --cut socket out": [
        "--question resection --require flexion=90 --cut socket --least",
    ],
    "option --rim: '{last}' is of a cut of the socket; add --cut socket": ["--question resection --require flexion=90 --rim 3"],
    "option --rim: '{last}' is no length; give a number of mm above 0": [
        "--question resection --require flexion=90 --cut socket --rim 0",
    ],
    "option --least: comes with the question resection alone; add --question resection": ["--least"],
    "option --question: 'orientation' needs to know the side; give left or right with --side": [
        "--question orientation --require flexion=90",
    ],
    "option --tilt: '{last}' is no tilt; give degrees from -90 to 90, backwards positive": [
        "--question orientation --require flexion=90 --side left --tilt 100",
    ],
    "option --tilt: '{last}' comes with the question orientation alone; add --question orientation": [
        "--question resection --require flexion=90 --tilt 5",
    ],
    "option --certificate: it is of one pose or motion; add --question limit --motion NAME": [
        "--certificate proof.txt --question limits --side left",
    ],
    "option --certificate: it is about the meshes as they lie in their files; leave out --landmarks": [
        "--certificate proof.txt --landmarks marks.csv",
    ],
    "--path excludes --certificate; see scene --help": ["--certificate proof.txt --path flexion=0..90/1"],
    "option --path: '{last}' has no step; write NAME=FIRST..LAST/STEP or NAME=ANGLE, as flexion=0..120/1": ["--path flexion=0..90"],
    "option --path: abduction and rotation need to know the side; give left or right with --side": ["--path abduction=0..9/1"],
    "--poses excludes --path; see scene --help": ["--path flexion=0..9/1 --poses poses.csv"],
    "--pose excludes --path; see scene --help": ["--path flexion=0..9/1 --pose flexion=1"],
    "--precision excludes --path; see scene --help": ["--path flexion=0..9/1 --precision 1"],
    "option --path: many poses give touch and the smallest gap of both surfaces only; leave out --question limit or measures, "
    "--surfaces and --everything; --cartilage needs --question all-gaps and a number of mm": [
        "--path flexion=0..9/1 --cartilage 3",
    ],
    # What may ruin a line, or a terminal.
    "option --side: side 'up and [2J away' is neither left nor right": ["--side 'up\nand\x1b[2J away'"],
    "The following argument was not expected: --colour red; see scene --help": ["'--colour\nred'"],
    "option --pose: unknown motion 'bend '; {MOTIONS}": ["--pose 'bend\n=3'"],
}


def said(message: str, words: list[str]) -> str:
    """With what the braces stand for."""
    for name, meant in (MEANT | {"{last}": words[-1], "{option}": words[-2] if len(words) > 1 else ""}).items():
        message = message.replace(name, meant)
    return message


OPTIONS = [(shlex.split(typed), said(message, shlex.split(typed))) for message, lines in REFUSED.items() for typed in lines]
