# SPDX-License-Identifier: GPL-3.0-or-later
"""The graph of results: programs -> data -> tables, figures -> verdicts -> report and papers.

Which jobs there are follows from the heads of experiments (CMakeLists.txt) and of scripts (../analysis/README.md), and from
the folders of real joints. CMake builds the programs, Ninja decides by the file written here which jobs run, job.py runs
one of them, and run_graph.py calls all of these. Standard library only.
"""

from __future__ import annotations

import collections
import csv
import dataclasses
import json
import os
import re
import shlex
import shutil
import sys
from dataclasses import dataclass
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
EXPERIMENTS = SOURCE / "experiments"
sys.path.insert(0, str(SOURCE / "analysis" / "common"))

import heads  # noqa: E402
from jobs import Job  # noqa: E402

# Of a real joint: the first of these names that is there, as in libcore/joint/joint_folder.hpp.
BALLS = ("ball", "femoral_head", "humeral_head")
SOCKETS = ("socket", "acetabulum_facing", "glenoid_facing", "acetabulum", "glenoid")
WHOLE = ("femur", "pelvis")  # whole bones, as in experiments/17_limit_time/turned_joint.cpp
MESHES = ("ply", "stl", "obj", "off", "vtp", "vtk")
WAYS = "right anterior superior left posterior inferior".split()
PATIENTS = {"patient_a": "right", "patient_b": "left"}  # stand-ins for the thesis' two patients, and the side of their hips
SYSTEMS = ("rsid", "usid")  # of the thesis
# Programs that are not experiments/NAME, in the build folder.
ELSEWHERE = {"impinge_program": "impinge", "joint3d_engine": "analysis/joint3d/wasm/analysis/joint3d/engine/joint3d_engine.js"}
JOINT3D_TOOLS = ("em++", "esbuild", "node")


@dataclass(frozen=True)
class Setup:
    """What experiments/reproduce was asked for."""

    build: Path
    results: Path
    profile: str  # quick or full
    bones: Path | None = None  # folder of real joints

    @property
    def graph(self) -> Path:
        """State of the graph: programs, locks, times."""
        return self.build / "graph"

    def program(self, name: str) -> str:
        """A copy of a program that changes only with its bytes: an edited comment rebuilds but measures nothing again."""
        return str(self.graph / "programs" / name)

    def shorten(self, text: str) -> str:
        """Replaces paths by the names that a reader knows."""
        places = {self.results: "results/", self.build: "build/", SOURCE: "", os.path.relpath(SOURCE, self.build): ""}
        for folder, short in places.items():
            text = text.replace(f"{folder}/", short)
        return text


@dataclass(frozen=True)
class Joint:
    """A real joint: a sub-folder of --bones."""

    name: str
    ball: Path
    socket: Path
    subject: Path | None  # subject.json
    options: list[str]  # of impinge: --side, --axes

    def files(self) -> list[Path]:
        """All that experiments read of it."""
        whole = [self.ball.parent / f"{bone}.ply" for bone in WHOLE]
        return [file for file in (self.ball, self.socket, self.subject, *whole) if file and file.is_file()]


def find_joint(folder: Path) -> Joint | None:
    """The joint in a folder. None if a mesh is missing or there twice, or if its description has no centre, an unknown side, or axes
    that are none of a right-handed frame; programs leave such a folder out, too.
    """

    def only(names: tuple[str, ...]) -> Path | None:
        files = [file for name in names for kind in MESHES if (file := folder / f"{name}.{kind}").is_file()]
        return files[0] if files and all(files[0].stem == f"{file.stem}_facing" for file in files[1:]) else None

    ball, socket, subject = only(BALLS), only(SOCKETS), folder / "subject.json"
    if not ball or not socket:
        return None
    if not subject.is_file():
        return Joint(folder.name, ball, socket, None, [])
    try:
        said = json.loads(subject.read_bytes())
    except ValueError:
        said = None
    said = said if isinstance(said, dict) else {}
    centre = said.get("center_of_rotation_mm", said.get("centre"))
    if said.get("unit", "mm") != "mm" or said.get("units", "mm") != "mm":
        return None
    if not isinstance(centre, list) or [type(x) in (int, float) for x in centre] != [True] * 3:
        return None
    side, axes = said.get("side"), said.get("axes")
    if side not in (None, "left", "right"):
        return None
    options = ["--side", side] if side else []
    if axes is not None:
        code = axis_code(axes) if isinstance(axes, str) else None
        if not code or not right_handed(["RASLPI".index(letter) for letter in code]):
            return None
        options += ["--axes", code]
    return Joint(folder.name, ball, socket, subject, options)


def axis_code(text: str) -> str | None:
    """Three letters, given as such or in words as libcore/joint/joint_folder.hpp reads them."""
    end = rf"\s*([+-])([xyz])\s*=\s*(?:patient\s+)?({'|'.join(WAYS)})\s*"
    found = re.fullmatch(rf"{end},{end},{end}(?:\(.*\)\s*)?", text)
    if not found:
        return text if re.fullmatch("[RASLPI]{3}", text) else None
    ends = {found[k + 1]: WAYS[(WAYS.index(found[k + 2]) + 3 * (found[k] == "-")) % 6] for k in (1, 4, 7)}
    return "".join(ends[axis][0].upper() for axis in "xyz") if len(ends) == 3 else None


def right_handed(ways: list[int]) -> bool:
    """Are these three directions, given as indices of WAYS, the axes of a right-handed frame?"""
    axes = [way % 3 for way in ways]
    if sorted(axes) != [0, 1, 2]:
        return False
    swaps = sum(axes[i] > axes[j] for i in range(3) for j in range(i + 1, 3))
    return (swaps + sum(way >= 3 for way in ways)) % 2 == 0


def find_joints(bones: Path | None) -> list[Joint]:
    """All joints in the folder, by name. Refuses a folder without joints, and a name that our files cannot have."""
    folders = sorted(path for path in bones.iterdir() if path.is_dir()) if bones else []
    found = {folder.name: find_joint(folder) for folder in folders}
    joints = [joint for joint in found.values() if joint]
    if joints and (left_out := [name for name, joint in found.items() if not joint]):
        print(f"reproduce: of --bones {bones} left out: {', '.join(left_out)}", file=sys.stderr)
    if bones and not joints:
        refuse(f"--bones {bones}: no sub-folder holds a ball ({', '.join(BALLS)}) and a socket ({', '.join(SOCKETS)})")
    for joint in joints:
        if not re.fullmatch(r"[A-Za-z0-9_.+@-]+", joint.name):
            refuse(f"--bones {bones}: name the folder '{joint.name}' with letters, digits and _.+@- only")
    return joints


def refuse(message: str) -> None:
    """Ends with exit code 2 and one line about the user's mistake."""
    print(f"reproduce: {message}", file=sys.stderr)
    sys.exit(2)


def experiment_jobs(setup: Setup, joints: list[Joint]) -> list[Job]:
    """A job for each experiment, from the head of its source."""
    sources = [*EXPERIMENTS.glob("[0-9][0-9]_*.cpp"), *EXPERIMENTS.glob("[0-9][0-9]_*/main.cpp")]
    return [experiment_job(setup, joints, source) for source in sorted(sources, key=str)]


def experiment_job(setup: Setup, joints: list[Joint], source: Path) -> Job:
    """The job of an experiment; experiments/CMakeLists.txt explains the head."""
    said = heads.head(source)[0]
    name = source.parent.name if source.name == "main.cpp" else source.stem
    for key in ("question", "writes", "seconds"):
        if key not in said:
            sys.exit(f"reproduce: {source} has no line '// @{key} ...': see experiments/CMakeLists.txt")
    words = collections.defaultdict(list, {key: text.split() for key, text in said.items()})
    tables, files = words["writes"], words["files"]
    depends = [f"programs/{name}", *(f"experiments/{file}" for file in words["reads"])]
    command = [setup.program(name), "--out", "data", "--profile", setup.profile]
    if joints and (words["writes-with-bones"] or said.get("bones") == "yes"):
        tables = tables + words["writes-with-bones"]
        files = files + [file.replace("JOINT", joint.name) for joint in joints for file in words["files-with-bones"]]
        depends += [str(file) for joint in joints for file in joint.files()]
        command += ["--bones", str(setup.bones)]
    outputs = [f"data/{table}.{kind}" for table in tables for kind in ("csv", "json")] + [f"data/{file}" for file in files]
    budget, timing = [float(text) for text in words["seconds"]], said.get("timing") == "yes"
    return Job(name, "data", said["question"], str(source.relative_to(SOURCE)), outputs, depends, command, budget, timing)


def pair_job(setup: Setup, name: str, scene: str, question: str, *options: str) -> Job:
    """Meshes that `impinge hip` generates."""
    folder = f"scenes/{scene}/input"
    outputs = [f"{folder}/ball.ply", f"{folder}/socket.ply"]
    command = [setup.program("impinge_program"), "hip", *options, "--out", folder]
    return Job(name, "data", question, "libcore/command/hip.cpp", outputs, ["programs/impinge_program"], command, [1, 1])


def scene_job(setup: Setup, name: str, meshes: tuple, *options: str) -> Job:
    """`impinge gaps` of one joint, into scenes/NAME; its meshes are a real joint's or in the results folder."""
    folder, gaps_alone = f"scenes/{name}", "--outputs" in options
    files = ["ball.ply", "socket.ply", "gaps.csv", *["distances.csv"] * (not gaps_alone), "summary.json"]
    outputs = [f"{folder}/{file}" for file in files]
    ball, socket = (str(setup.results / mesh) for mesh in meshes)
    command = [setup.program("impinge_program"), "gaps", ball, socket, *options, "--out", folder]
    question, depends = f"Where is the joint {name} impinged?", ["programs/impinge_program", *map(str, meshes)]
    budget = [1, 1] if gaps_alone else [2, 2]
    return Job(f"scene-{name}", "data", question, "libcore/command/gaps.cpp", outputs, depends, command, budget)


def scene_jobs(setup: Setup, joints: list[Joint], motions: dict[str, dict[str, str]]) -> list[Job]:
    """The scenes of every joint: for its picture, and by both systems of the thesis at 1 degree (Figures 49 and 50). Of the
    thesis' patients also the modelled pose and the end of each motion of Table 11, in the colours of Tables 12 and 13.
    """

    def meshes(scene: str) -> tuple[str, str]:
        return f"scenes/{scene}/input/ball.ply", f"scenes/{scene}/input/socket.ply"

    pair = "What does the generated ball-and-socket pair look like?"
    jobs = [pair_job(setup, "generated-pair", "generated", pair, "pair", "--faces", "12000")]
    # In this pose the bump of the ball is under the socket. Elsewhere the gap is 4 mm, which must not be where colours change:
    # chords of the two meshes would put the ball below and the socket above.
    scenes = {"generated": (meshes("generated"), ["--side", "right", "--pose", "abduction=80", "--cartilage", "3"])}
    scenes |= {joint.name: ((joint.ball, joint.socket), ["--cartilage", "4", *joint.options]) for joint in joints}
    for name, (files, options) in scenes.items():
        jobs.append(scene_job(setup, name, files, *options, "--precision", "0.5"))
        for scheme in SYSTEMS:
            jobs.append(scene_job(setup, f"{name}-{scheme}", files, *options, "--precision", "1", "--scheme", scheme))
    for patient, side in PATIENTS.items():
        hip = f"What does the stand-in for the thesis' {patient} look like?"
        jobs.append(pair_job(setup, f"hip-{patient}", patient, hip, patient))
        options = ["--outputs", "gaps", "--side", side, "--cartilage"]
        jobs.append(scene_job(setup, patient, meshes(patient), *options, "4"))
        for motion, degrees in motions[patient].items():  # red within 2 mm, blue beyond 6
            pose = ["6", "--pose", f"{motion}={degrees}"]
            jobs.append(scene_job(setup, f"{patient}-{motion}", meshes(patient), *options, *pose))
    return jobs


def recorded_motions() -> dict[str, dict[str, str]]:
    """The degrees at the end of each motion of Table 11, by patient."""
    found: dict[str, dict[str, str]] = {patient: {} for patient in PATIENTS}
    with (SOURCE / "analysis" / "common" / "thesis_values.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            if row["artefact"] == "table-11" and row["column"] in PATIENTS:
                found[row["column"]][row["row"]] = row["value"]
    return found


def joint3d_jobs(setup: Setup) -> list[Job]:
    """The page that moves a joint, and the speed of the library in it, if the tools for both are installed."""
    if not all(map(shutil.which, JOINT3D_TOOLS)):
        return []
    folder, engine, made = "analysis/joint3d", "programs/joint3d_engine", setup.program("joint3d_engine")
    speed, table = f"{folder}/engine_speed.js", "tables/joint3d-speed.csv"
    measure = ["node", str(SOURCE / speed), made, table]
    question = (
        "How long the library takes in WebAssembly, on one thread: to fill the tables of a hip of 12,000 faces a surface, and"
        " to find all gaps of a pose."
    )
    build = f"{folder}/build.py"
    sources = heads.expanded(f"{folder}/{{src/*.js,index.html,style.css}}") + ["analysis/node_modules/three/package.json"]
    bundle = [sys.executable, "-B", str(SOURCE / build), "--engine", made, "--out", "joint3d.html"]
    about = (
        "A page that moves a joint and shows its gaps as one watches, with the library in it (Joint3D, Section 3.4 of the"
        " thesis)."
    )
    return [
        Job("joint3d-speed", "table", question, speed, [table], [engine, speed], measure, [11, 11], timing=True),
        Job("joint3d", "page", about, build, ["joint3d.html"], [engine, build, *sources], bundle, [2, 2]),
    ]


PAPERS = {
    "paper-reproduction": "The paper on the thesis: what came out again, error against time, extreme cases, what is left out.",
    "paper-motion": "The paper on motion: certified contact, limits, all rotations, cuts, with proofs.",
}


def paper_jobs(setup: Setup, made: list[str]) -> list[Job]:
    """LaTeX around generated tables, figures and facts. No date and no path goes into a PDF."""
    shown = re.compile(r"tables/.*tex|figures/.*pdf|paper/.*tex")
    depends = [file for file in made if shown.fullmatch(file)] + heads.expanded("paper/*.{tex,bib}")
    folders = f"{SOURCE}/paper:{setup.results}/figures:{setup.results}/tables:{setup.results}/paper:"
    reproducible = ["SOURCE_DATE_EPOCH=0", "FORCE_SOURCE_DATE=1", f"TEXINPUTS={folders}", f"BIBINPUTS={folders}"]
    latex = ["env", *reproducible, "latexmk", "-pdf", "-silent", "-halt-on-error", "-file-line-error"]
    return [
        Job(name, "paper", question, f"paper/{name}.tex", [f"{name}.pdf"], depends, [*latex, f"{SOURCE}/paper/{name}.tex"], [2, 2])
        for name, question in PAPERS.items()
    ]


def all_jobs(setup: Setup) -> dict[str, Job]:
    """All jobs by name, in the order in which the report shows them. Report and papers show what is declared before them."""
    joints, motions = find_joints(setup.bones), recorded_motions()
    names = [joint.name for joint in joints]
    words = {
        "JOINTS": names,
        "SCENES": ["generated", *names],
        "MOTIONS": dict.fromkeys(motion for patient in motions.values() for motion in patient),
        "GRAPH": [str(setup.graph / "jobs.json")],
    }
    lists = {word: ",".join(texts) for word, texts in words.items()}
    jobs = experiment_jobs(setup, joints) + scene_jobs(setup, joints, motions)
    for room in ("tables", "figures", "verdicts", "findings", "paper"):
        jobs += [Job(**fields) for fields in heads.script_jobs(room, lists, setup.results)]
    jobs += joint3d_jobs(setup)
    made = [output for job in jobs for output in job.outputs]
    shown = re.compile(r"data/.*|tables/.*csv|figures/.*(svg|png)|verdicts\.csv|joint3d\.html")
    lists["SHOWN"] = " ".join(file for file in made if shown.fullmatch(file))
    jobs += [Job(**fields) for fields in heads.script_jobs("report", lists, setup.results)]
    jobs += paper_jobs(setup, made)
    if unused := heads.unused():
        sys.exit(f"{unused[0]} has no @name, and no script imports it: see analysis/README.md")
    counts = collections.Counter(artefact for job in jobs for artefact in job.artefacts)
    if twice := [name for name, count in counts.items() if count > 1]:
        sys.exit(f"reproduce: two jobs make '{twice[0]}', which --only takes: name one of them otherwise")
    return {job.name: job for job in jobs}


def ninja_file(setup: Setup, jobs: dict[str, Job]) -> str:
    """The graph for Ninja. If an output did not change, what depends on it is not made again (restat)."""
    made = {output for job in jobs.values() for output in job.outputs}
    lines = ["rule job", "  command = $words", "  description = job $name", "  restat = 1"]

    def files(names: list[str]) -> str:
        return " ".join(re.sub(r"([$ :])", r"$\1", str(located(setup, made, name))) for name in names)

    for job in jobs.values():
        asked = {"name": job.name, "command": job.command, "outputs": job.outputs, "results": str(setup.results)}
        asked |= {"graph": str(setup.graph), "profile": setup.profile, "alone": job.timing, "talks": job.kind == "data"}
        words = shlex.join([sys.executable, str(EXPERIMENTS / "job.py"), json.dumps(asked)])
        lines.append(f"build {files(job.outputs)}: job {files(job.depends)}")
        lines += [f"  words = {words.replace('$', '$$')}", f"  name = {job.name}"]
    return "\n".join(lines) + "\n"


def record(setup: Setup, jobs: dict[str, Job]) -> str:
    """Writes the jobs and their run to jobs.json, for the report and keep_reference.py."""
    fields = [dataclasses.asdict(dataclasses.replace(job, seconds=0)) for job in jobs.values()]
    return json.dumps({"results": str(setup.results), "profile": setup.profile, "jobs": fields}, indent=1)


def located(setup: Setup, made: set[str], file: str) -> Path:
    """The path of a file that a job names."""
    return (setup.results if file in made else setup.graph if file.startswith("programs/") else SOURCE) / file


def behind(jobs: dict[str, Job], wanted: list[Job]) -> list[Job]:
    """These jobs and all jobs that they depend on."""
    makers = {output: job for job in jobs.values() for output in job.outputs}
    found = {job.name: job for job in wanted}
    left = [*wanted]
    while left:
        more = {makers[file].name: makers[file] for file in left.pop().depends if file in makers}
        left += [job for name, job in more.items() if name not in found]
        found |= more
    return [*found.values()]


def programs_behind(jobs: dict[str, Job], wanted: list[Job]) -> list[str]:
    """CMake targets that these jobs depend on."""
    files = {file for job in behind(jobs, wanted) for file in job.depends}
    return sorted(file.removeprefix("programs/") for file in files if file.startswith("programs/"))
