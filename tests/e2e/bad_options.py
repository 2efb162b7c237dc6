# SPDX-License-Identifier: GPL-3.0-or-later
"""Options that cannot be used: what is typed behind --ball, --socket and --out, and what is said behind
"scene: error: ". {schemes} stands for the names of all schemes.
"""

AXES = "name where +x, +y and +z point with one letter each of R/L, A/P and S/I, as RAS or LPS"
MOTIONS = "there are flexion, extension, abduction, adduction, internal_rotation, external_rotation"
LIMITS = (
    f"{MOTIONS}, internal_rotation_at_45, internal_rotation_at_70, internal_rotation_at_90, external_rotation_at_90, fadir, "
    "faber, all"
)
THICKNESS = "is no thickness and no file; give a number of mm, 0 or more, or a CSV of x,y,z,thickness_mm"

OPTIONS = [
    (["--precision", "0"], "option --precision: an RSID precision is above 0 and at most 90 degrees"),
    (["--precision", "-0.5"], "option --precision: an RSID precision is above 0 and at most 90 degrees"),
    (
        ["--precision", "0.7"],
        "option --precision: an RSID precision divides 180 degrees, as 1, 0.5, 0.25, 0.1 or 0.05 do",
    ),
    (["--precision", "91"], "option --precision: an RSID precision is above 0 and at most 90 degrees"),
    (["--precision", "1e-12"], "option --precision: an RSID precision is at least 1.8e-7 degrees"),
    (["--precision", "1e400"], "option --precision: '1e400' is no precision; give a number of degrees"),
    (["--precision", "fine"], "option --precision: 'fine' is no precision; give a number of degrees"),
    (["--precision", "nan"], "option --precision: 'nan' is no precision; give a number of degrees"),
    (["--precision", "1,5"], "option --precision: '1,5' is no precision; give a number of degrees"),
    (["--precision"], "--precision: 1 required TEXT missing; see scene --help"),
    (
        ["--precision", "1", "--precision", "2"],
        "--precision: At Most 1 required but received 2; see scene --help",
    ),
    (["--precision", "1", "--max-error", "1"], "--precision excludes --max-error; see scene --help"),
    (["--scheme", "usid", "--max-error", "1"], "--scheme excludes --max-error; see scene --help"),
    (["--max-error", "0"], "option --max-error: '0' is no accuracy; give a number of mm above 0"),
    (["--max-error", "-1"], "option --max-error: '-1' is no accuracy; give a number of mm above 0"),
    (["--max-error", "inf"], "option --max-error: 'inf' is no accuracy; give a number of mm above 0"),
    (["--max-error", "small"], "option --max-error: 'small' is no accuracy; give a number of mm above 0"),
    (
        ["--scheme", "rside"],
        "option --scheme: unknown scheme 'rside'; there are {schemes}",
    ),
    (
        ["--scheme", "RSID"],
        "option --scheme: unknown scheme 'RSID'; there are {schemes}",
    ),
    (["--centre", "1,2"], "option --centre: '1,2' is no centre; give 'fit' or three numbers in mm as X,Y,Z"),
    (
        ["--centre", "1,2,3,4"],
        "option --centre: '1,2,3,4' is no centre; give 'fit' or three numbers in mm as X,Y,Z",
    ),
    (
        ["--centre", "1,2,nan"],
        "option --centre: 'nan' is no centre; give 'fit' or three numbers in mm as X,Y,Z",
    ),
    (
        ["--centre", "1;2;3"],
        "option --centre: '1;2;3' is no centre; give 'fit' or three numbers in mm as X,Y,Z",
    ),
    (
        ["--centre", "middle"],
        "option --centre: 'middle' is no centre; give 'fit' or three numbers in mm as X,Y,Z",
    ),
    (
        ["--question", "limit"],
        "option --question: 'limit' needs the motion whose limit is wanted; add it, as --motion flexion",
    ),
    (
        ["--question", "limit", "--motion", "bend"],
        f"option --motion: unknown motion 'bend'; {LIMITS}",
    ),
    (
        ["--question", "limit", "--motion", "flexion=30"],
        f"option --motion: unknown motion 'flexion=30'; {LIMITS}",
    ),
    (
        ["--question", "limit", "--motion", "fadir", "--side", "left", "--pose", "flexion=90"],
        "option --motion: 'fadir' begins at a pose of its own; leave --pose out",
    ),
    (
        ["--question", "limit", "--motion", "all", "--side", "left", "--pose", "flexion=90"],
        "option --motion: 'all' begins at a pose of its own; leave --pose out",
    ),
    (
        ["--question", "limit", "--motion", "all"],
        "option --motion: abduction and rotation need to know the side; give left or right with --side",
    ),
    (
        ["--question", "measures"],
        "option --question: 'measures' need to know the side; give left or right with --side",
    ),
    (["--ball-part"], "--ball-part: 1 required TEXT missing; see scene --help"),
    (["--ball-part", ""], "option --ball-part: '' is empty; give it a value or leave it out"),
    (["--socket-part", ""], "option --socket-part: '' is empty; give it a value or leave it out"),
    (["--bones", "."], "--ball excludes --bones; see scene --help"),
    (
        ["--motion", "flexion"],
        "option --motion: 'flexion' comes with the question limit alone; add --question limit",
    ),
    (
        ["--question", "limit", "--motion", "abduction"],
        "option --motion: abduction and rotation need to know the side; give left or right with --side",
    ),
    (
        ["--question", "limit", "--motion", "flexion", "--pose", "flexion=180"],
        "option --motion: the pose leaves no room for flexion within 180 degrees; begin with a smaller angle",
    ),
    (
        ["--pose", "bend=3"],
        f"option --pose: unknown motion 'bend'; {MOTIONS}",
    ),
    (["--pose", "flexion"], "option --pose: 'flexion' is no motion; write NAME=DEGREES, as flexion=90"),
    (["--pose", "flexion=181"], "option --pose: '181' is no angle of flexion; give degrees from -180 to 180"),
    (
        ["--pose", "flexion=much"],
        "option --pose: 'much' is no angle of flexion; give degrees from -180 to 180",
    ),
    (
        ["--pose", "flexion=90,extension=10"],
        "option --pose: the axis of 'extension' is given twice; give it once",
    ),
    (
        ["--pose", "abduction=10"],
        "option --pose: abduction and rotation need to know the side; give left or right with --side",
    ),
    (
        ["--pose", "internal_rotation=10"],
        "option --pose: abduction and rotation need to know the side; give left or right with --side",
    ),
    (["--side", "up"], "option --side: side 'up' is neither left nor right"),
    (["--side", "up\nand\x1b[2J away"], "option --side: side 'up and [2J away' is neither left nor right"),
    (
        ["--axes", "LAS"],
        f"option --axes: axis code 'LAS' is left-handed and would mirror the patient; {AXES}",
    ),
    (
        ["--axes", "RA"],
        f"option --axes: axis code 'RA' does not have three letters; {AXES}",
    ),
    (
        ["--axes", "RRS"],
        f"option --axes: axis code 'RRS' names one direction twice; {AXES}",
    ),
    (
        ["--axes", "XYZ"],
        f"option --axes: axis code 'XYZ' has an unknown letter; {AXES}",
    ),
    (["--cartilage", "-1"], f"option --cartilage: '-1' {THICKNESS}"),
    (["--cartilage", "thick"], f"option --cartilage: 'thick' {THICKNESS}"),
    (["--cartilage", "inf"], f"option --cartilage: 'inf' {THICKNESS}"),
    (["--cartilage", "4mm"], f"option --cartilage: '4mm' {THICKNESS}"),
    (["--colour", "red"], "The following arguments were not expected: red --colour; see scene --help"),
    (["--colour\nred"], "The following argument was not expected: --colour red; see scene --help"),
    (["stray"], "The following argument was not expected: stray; see scene --help"),
    (
        ["--pose", "bend\n=3"],
        f"option --pose: unknown motion 'bend '; {MOTIONS}",
    ),
    (
        ["--precision", "1", "--precision", ""],
        "--precision: At Most 1 required but received 2; see scene --help",
    ),
    (["--precision", ""], "option --precision: '' is empty; give it a value or leave it out"),
    (["--max-error", ""], "option --max-error: '' is empty; give it a value or leave it out"),
    (["--pose", ""], "option --pose: '' is empty; give it a value or leave it out"),
    (["--side", ""], "option --side: '' is empty; give it a value or leave it out"),
    (["--cartilage", ""], "option --cartilage: '' is empty; give it a value or leave it out"),
    (["--centre", ""], "option --centre: '' is empty; give it a value or leave it out"),
    (["--axes", ""], "option --axes: '' is empty; give it a value or leave it out"),
    (["--scheme", ""], "option --scheme: '' is empty; give it a value or leave it out"),
    (
        ["--question", "why"],
        "option --question: 'why' is no question; ask touch, first-contact, limit, limits, volume, measures, resection, orientation or all-gaps",
    ),
    (
        ["--question", "limits"],
        "option --question: 'limits' needs the side of the body; add --side left or --side right",
    ),
    (
        ["--question", "volume", "--width", "1"],
        "option --width: '1' is no share; give a number above 0 and below 1, as 0.01",
    ),
    (
        ["--question", "volume", "--width", "0"],
        "option --width: '0' is no share; give a number above 0 and below 1, as 0.01",
    ),
    (
        ["--question", "volume", "--path", "flexion=0..90/1"],
        "option --question: 'volume' is about all poses; leave out --poses and --path",
    ),
    (["--gap", "4"], "option --gap: '4' comes with the question volume alone; add --question volume"),
    (
        ["--question", "volume", "--pose", "flexion=20"],
        "option --pose: 'flexion=20' is one pose, and the question is about all of them; leave it out",
    ),
    (
        ["--question", "volume", "--gap", "-1"],
        "option --gap: '-1' is no length; give a number of mm, 0 or more",
    ),
    (["--width", "0.1"], "option --width: '0.1' comes with the question volume alone; add --question volume"),
    (
        ["--surfaces", "none"],
        "option --surfaces: 'none' is no choice of surfaces; give ball, socket or both",
    ),
    (
        ["--surfaces", "ball"],
        "option --surfaces: 'ball' leaves out what bounds, distances and verdicts need; add --outputs gaps",
    ),
    (
        ["--outputs", "gaps,pictures"],
        "option --outputs: 'pictures' is no output; give some of gaps, bounds, distances and verdicts, "
        "with commas between",
    ),
    (
        ["--question", "touch", "--outputs", "gaps"],
        "option --outputs: 'gaps' come with the question all-gaps alone; leave one of the two options out",
    ),
    (
        ["--question", "resection"],
        "option --question: 'resection' needs the motions that are to be reached; add them, as --require flexion=90",
    ),
    (["--question", "resection", "--require", "bend=90"], f"option --require: unknown motion 'bend'; {MOTIONS}"),
    (
        ["--question", "resection", "--require", "flexion"],
        "option --require: 'flexion' is no motion; write NAME=DEGREES, as flexion=90",
    ),
    (
        ["--question", "resection", "--require", "flexion=0"],
        "option --require: 'flexion=0' moves nothing; give an angle other than 0",
    ),
    (
        ["--question", "resection", "--require", "flexion=30", "--require", "abduction=10"],
        "option --require: abduction and rotation need to know the side; give left or right with --side",
    ),
    (
        ["--question", "resection", "--require", "flexion=90", "--clearance", "0"],
        "option --clearance: '0' is no length; give a number of mm above 0",
    ),
    (
        ["--question", "resection", "--require", "flexion=90", "--neck", "wide"],
        "option --neck: 'wide' is no length; give a number of mm above 0",
    ),
    (
        ["--question", "resection", "--require", "flexion=90", "--pose", "flexion=10"],
        "option --pose: 'flexion=10' has no place here: required motions begin in the pose of the scan",
    ),
    (
        ["--question", "resection", "--require", "flexion=90", "--path", "flexion=0..9/1"],
        "option --question: 'resection' is asked of required motions; leave out --path and --poses",
    ),
    (
        ["--require", "flexion=90"],
        "option --require: 'flexion=90' comes with the questions resection and orientation alone; add one of them",
    ),
    (
        ["--clearance", "1"],
        "option --clearance: '1' comes with the question resection alone; add --question resection",
    ),
    (
        ["--cut", "socket"],
        "option --cut: 'socket' comes with the question resection alone; add --question resection",
    ),
    (
        ["--question", "resection", "--require", "flexion=90", "--cut", "femur"],
        "option --cut: 'femur' is no bone that can be cut; give ball or socket",
    ),
    (
        ["--question", "resection", "--require", "flexion=90", "--cut", "socket", "--neck", "20"],
        "option --neck: '20' is of a cut of the ball; leave it or --cut socket out",
    ),
    (
        ["--question", "resection", "--require", "flexion=90", "--cut", "socket", "--least"],
        "option --least: is a cut of the ball; leave it or --cut socket out",
    ),
    (
        ["--question", "resection", "--require", "flexion=90", "--rim", "3"],
        "option --rim: '3' is of a cut of the socket; add --cut socket",
    ),
    (
        ["--question", "resection", "--require", "flexion=90", "--cut", "socket", "--rim", "0"],
        "option --rim: '0' is no length; give a number of mm above 0",
    ),
    (["--least"], "option --least: comes with the question resection alone; add --question resection"),
    (
        ["--question", "orientation", "--require", "flexion=90"],
        "option --question: 'orientation' needs to know the side; give left or right with --side",
    ),
    (
        ["--question", "orientation", "--require", "flexion=90", "--side", "left", "--tilt", "100"],
        "option --tilt: '100' is no tilt; give degrees from -90 to 90, backwards positive",
    ),
    (
        ["--question", "orientation", "--require", "flexion=90", "--side", "left", "--clearance", "1"],
        "option --clearance: '1' comes with the question resection alone; add --question resection",
    ),
    (
        ["--question", "resection", "--require", "flexion=90", "--tilt", "5"],
        "option --tilt: '5' comes with the question orientation alone; add --question orientation",
    ),
    (["--question", ""], "option --question: '' is empty; give it a value or leave it out"),
    (["--surfaces", ""], "option --surfaces: '' is empty; give it a value or leave it out"),
    (["--outputs", ""], "option --outputs: '' is empty; give it a value or leave it out"),
    (
        ["--certificate", "proof.txt", "--question", "limits", "--side", "left"],
        "option --certificate: it is of one pose or motion; add --question limit --motion NAME",
    ),
    (
        ["--certificate", "proof.txt", "--landmarks", "marks.csv"],
        "option --certificate: it is about the meshes as they lie in their files; leave out --landmarks",
    ),
    (["--certificate", ""], "option --certificate: '' is empty; give it a value or leave it out"),
    (
        ["--certificate", "proof.txt", "--path", "flexion=0..90/1"],
        "--path excludes --certificate; see scene --help",
    ),
    (
        ["--path", "flexion=0..90"],
        "option --path: 'flexion=0..90' has no step; write NAME=FIRST..LAST/STEP or NAME=ANGLE, as flexion=0..120/1",
    ),
    (
        ["--path", "abduction=0..9/1"],
        "option --path: abduction and rotation need to know the side; give left or right with --side",
    ),
    (["--path", "flexion=0..9/1", "--poses", "poses.csv"], "--poses excludes --path; see scene --help"),
    (["--path", "flexion=0..9/1", "--pose", "flexion=1"], "--pose excludes --path; see scene --help"),
    (["--path", "flexion=0..9/1", "--precision", "1"], "--precision excludes --path; see scene --help"),
    (
        ["--path", "flexion=0..9/1", "--surfaces", "ball"],
        "option --surfaces: 'ball' leaves out what bounds, distances and verdicts need; add --outputs gaps",
    ),
    (
        ["--path", "flexion=0..9/1", "--cartilage", "3"],
        "option --path: many poses give touch and the smallest gap of both surfaces only; leave out --question limit or measures, "
        "--surfaces and --everything; --cartilage needs --question all-gaps and a number of mm",
    ),
]
