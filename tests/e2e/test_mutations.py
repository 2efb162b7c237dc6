# SPDX-License-Identifier: GPL-3.0-or-later
"""test_mutations.py NUMBER: both checkers of certificates on so many changed ones, and what they accept against CGAL.

Both must say the same of each, and what they accept must hold of the meshes in exact arithmetic: in the pose, or at the start, the end and
random angles of the motion (certificate_oracle.cpp). IMPINGE, CHECK_CERTIFICATE and CERTIFICATE_ORACLE name the programs."""

from __future__ import annotations

import itertools
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parent), str(Path(__file__).resolve().parents[2] / "experiments")]
import check_certificate  # noqa: E402
from generated_pair import IMPINGE, run  # noqa: E402
from test_certificate import read_mesh, write_obj  # noqa: E402

FAST, ORACLE = os.environ["CHECK_CERTIFICATE"], os.environ["CERTIFICATE_ORACLE"]
HEAD = 9  # lines


def octahedron(file: Path, *sizes: float, x=0.0, lost=0, more=()) -> Path:
    """Layers, x mm beside the centre."""
    corners = [(0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1)]
    faces = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1), (5, 2, 1), (5, 3, 2), (5, 4, 3), (5, 1, 4)]
    points = [[size * p[0] + x, size * p[1], size * p[2]] for size in sizes for p in corners]
    return write_obj(file, points, [*[[i + 6 * k for i in f] for k in range(len(sizes)) for f in faces][lost:], *more])


def bases(root: Path):
    """(lines, files of the ball, files of the socket) of certificates that impinge writes."""
    bone = ["greater_trochanter_width=30", "lesser_trochanter_height=8", "aiis_height=10"]
    for name, words in {"pair": ["pair"], "cam": ["cam", "--set", "shaft_length=0"], "with": ["normal", *(w for one in bone for w in ("--set", one))]}.items():
        assert run(IMPINGE, "hip", *words, "--faces", "500", "--out", root / name).returncode == 0
    hips = {name: ([root / name / "ball.ply"], [root / name / "socket.ply"]) for name in ("pair", "cam", "with")}
    hips["parts"] = tuple([*files, *(root / "with" / f"{part}.ply" for part in parts)] for files, parts in zip(hips["with"], (("greater_trochanter", "lesser_trochanter"), ("aiis",))))
    points, faces = read_mesh(root / "pair/ball.ply")  # with a face twice and one that is a line
    hips["double"] = ([write_obj(root / "double.obj", points, [faces[5], *faces, [0, 0, 1], faces[9][::-1]])], hips["pair"][1])
    shapes = {name: [octahedron(root / f"{name}.obj", *sizes, **more)] for name, sizes, more in (
        ("small", [20.0], {}), ("large", [30.0], {}), ("shell", [25.0, 30.0], {}), ("opened", [30.0], {"lost": 1}), ("beyond", [20.0, 40.0], {}),
        ("core", [5.0], {"x": 9.0}), ("bead", [0.5], {"x": 27.5}), ("far", [5.0], {"x": 90.0}), ("thick", [30.0], {"more": [(0, 1, 2), (3, 3, 4)]}))}
    asked = [(hips[name], words) for name in hips for words in (["--pose", "flexion=60,internal_rotation=20"], ["--pose", "flexion=120,internal_rotation=40"],
             ["--motion", "flexion"], ["--motion", "internal_rotation", "--pose", "flexion=70"])]
    asked += [((shapes[a], shapes[b]), ["--centre", "0,0,0"]) for a, b in ("small large,beyond large,large core,shell core,shell bead,small shell,shell far,opened far,thick core"
              .replace(",", " ").split()[k : k + 2] for k in range(0, 18, 2))]
    for (ball, socket), words in asked:
        parts = [w for option, files in (("--ball-part", ball[1:]), ("--socket-part", socket[1:])) for file in files for w in (option, file)]
        done = run(IMPINGE, "certify", ball[0], socket[0], *parts, "--side", "right", "--quiet", *words, "--out", root / "made")
        if done.returncode == 0:
            yield (root / "made/certificate.txt").read_text().splitlines(), ball, socket


def changed_number(dice: random.Random, lines: list[str], change) -> list[str]:
    k = dice.choice([k for k, line in enumerate(lines) if any(c.isdigit() for c in line) and k > 0])
    words = lines[k].split()
    at = dice.choice([i for i, word in enumerate(words) if word[-1].isdigit()])
    words[at] = change(words[at])
    return [*lines[:k], " ".join(words), *lines[k + 1 :]]


def mutated(dice: random.Random, all_bases: list) -> tuple[str, list[str], list[Path], list[Path]]:
    lines, ball, socket = dice.choice(all_bases)
    other = dice.choice(all_bases)
    digits = [c for c in "0123456789"]

    def digit(word):
        at = dice.choice([i for i, c in enumerate(word) if c.isdigit()])
        return word[:at] + dice.choice(digits) + word[at + 1 :]

    def swapped(items, i, j):
        items = list(items)
        items[i], items[j] = items[j], items[i]
        return items

    kind = dice.choice("digit digit least sign length order words drop double subtree mesh pose part says proof twice".split())
    k, j = dice.randrange(len(lines)), dice.randrange(len(lines))
    tree = dice.randrange(min(HEAD, len(lines) - 1), len(lines))
    if kind == "digit":
        lines = changed_number(dice, lines, digit)
    elif kind == "least":
        lines = changed_number(dice, lines, lambda word: word if "." in word else str(int(word) + dice.choice((-2, -1, 1, 2, 40))))
    elif kind == "sign":
        lines = changed_number(dice, lines, lambda word: word[1:] if word[0] == "-" else "-" + word)
    elif kind == "length":
        lines = changed_number(dice, lines, lambda word: dice.choice((word + "0", word[:-1] or "0", "0" + word, "+" + word, word + "e0", word + ".", "1/1")))
    elif kind == "order":
        lines = swapped(lines, k, j if dice.random() < 0.5 else min(k + 1, len(lines) - 1))
    elif kind == "words":
        words = lines[k].split()
        lines = [*lines[:k], dice.choice((" ", "  ", "\t")).join(swapped(words, dice.randrange(len(words)), dice.randrange(len(words)))), *lines[k + 1 :]]
    elif kind == "drop":
        lines = lines[:tree] + lines[tree + 1 :]
    elif kind == "double":
        lines = lines[: tree + 1] + lines[tree:]
    elif kind == "subtree":  # a cut that cuts nothing, before a part and for its empty other half
        cut = dice.choice(("plane 0 0 0 0", "plane 0 0 0 1", "plane 1 0 0 -1000000000", "sphere 1000000000", "turn 1 0", "turn 1000000 1"))
        lines = [*lines[:tree], cut, *(["-"] if dice.random() < 0.5 else []), *lines[tree:], *(["-", "end"] if dice.random() < 0.1 else [])]
    elif kind == "mesh":
        ball, socket = dice.choice(((other[1], socket), (ball, other[2]), (socket, ball), (ball, ball)))
    elif kind == "pose":  # or another motion, centre, unit
        for at in dice.sample(range(2, HEAD), dice.choice((1, 1, 2, 4))):
            lines = [*lines[:at], other[0][at], *lines[at + 1 :]]
    elif kind == "part":
        ball, socket = dice.choice(((ball + other[1], socket), (ball[:1], socket), (ball, socket[::-1]), (ball + ball[:1], socket)))
        if dice.random() < 0.7:
            lines = [lines[0], f"files {len(ball)} {len(socket)}", *lines[2:]]
    elif kind == "says":
        says, proof = dice.choice((("contact", ["inside"]), ("clear", ["-"]), ("contact", [f"cross {dice.randrange(300)} {dice.randrange(300)}"]), ("clear", ["plane 0 0 0 0", "-", "-"])))
        lines = [f"impinge certificate 2 {says}", *lines[1:HEAD], *proof, "end"]
        if dice.random() < 0.5:
            lines[7] = "last 1 0"
    elif kind == "proof":
        lines = [other[0][0], *lines[1:HEAD], *other[0][HEAD:]]
    elif kind == "twice" and len(lines) > 2:  # two digits
        lines = changed_number(dice, changed_number(dice, lines, digit), digit)
    return kind, lines, list(ball), list(socket)


def python_says(file: Path, ball: list[Path], socket: list[Path]) -> bool:
    try:
        check_certificate.check(*map(str, (file, ball[0], socket[0], "--ball-part", *ball[1:], "--socket-part", *socket[1:])))
        return True
    except Exception:  # as its own main does
        return False


def fast_says(files: list[Path], ball: list[Path], socket: list[Path]) -> list[str]:
    done = run(FAST, *files, ball[0], socket[0], "--ball-part", *ball[1:], "--socket-part", *socket[1:])
    assert done.returncode in (0, 1) and done.stderr == "", done.stderr
    lines = done.stdout.splitlines()
    assert len(lines) == len(files) and (done.returncode == 0) == (not any(line.startswith("not proven") for line in lines)), done.stdout
    return lines


def product(a, b):
    (s, x, y, z), (t, u, v, w) = a, b
    return (s * t - x * u - y * v - z * w, s * u + t * x + y * w - z * v, s * v + t * y + z * u - x * w, s * w + t * z + x * v - y * u)


def claims(dice: random.Random, lines: list[str]):
    """Poses (words for the oracle) of what a certificate says, and what it says of each: 'clear', 'apart' (surfaces do not meet) or 'contact'."""
    head = {words[0]: words[1:] for words in (line.split() for line in lines[:HEAD])}
    outer, axis, inner, (c, s) = (tuple(map(int, head[name])) for name in ("outer", "axis", "inner", "last"))
    halves = [(1, 0)]
    if s:
        halves.append((c, s))
        for _ in range(3):  # between: a mean of two directions that are less than half a turn apart is one, and has an angle between theirs
            low, high = dice.choice((((1, 0), (0, 1)), ((0, 1), (c, s)))) if c < 0 else ((1, 0), (c, s))
            share = dice.randrange(1, 1000)
            scale = max(map(abs, high)) if max(map(abs, high)) > 1 else 1
            halves.append(tuple((1000 - share) * p * scale + share * q for p, q in zip(low, high)))
    says = head["impinge"][-1]
    for k, (cosine, sine) in enumerate(halves):
        q = product(product(outer, (cosine, *(sine * e for e in axis))), inner)
        yield " ".join([*(str(Fraction(x)) for x in head["centre"] + head["shift"]), *map(str, q)]), says if says == "contact" or k == 0 else "apart"


def text_of(files: list[Path]) -> str:
    text = [str(len(files))]
    for file in files:
        if file.suffix == ".obj":
            rows = [line.split() for line in file.read_text().splitlines()]
            points = [row[1:] for row in rows if row[0] == "v"]
            faces = [[int(i) - 1 for i in row[1:]] for row in rows if row[0] == "f"]
        else:
            points, faces = read_mesh(file)
        text += [f"{len(points)} {len(faces)}", *(" ".join(str(Fraction(x)) for x in p) for p in points), *(" ".join(map(str, f)) for f in faces)]
    return "\n".join(text)


def main(number: int) -> None:
    dice = random.Random(number)
    accepted, refused, poses, wrong = {}, {}, {}, []
    with tempfile.TemporaryDirectory(prefix="impinge-mutations-") as folder:
        root = Path(folder)
        all_bases = list(bases(root))
        ends = [(lines[0].split()[-1], lines[HEAD].split()[0]) for lines, _, _ in all_bases]
        assert len(ends) > 20 and {("contact", "cross"), ("contact", "inside")} < {*ends} and {end[0] for end in ends} == {"clear", "contact"}, ends
        (first, _, *rest), ball, socket = next(base for base in all_bases if (base[1][0].stem, base[2][0].stem) == ("beyond", "large"))
        beside = [first, "files 2 1", *rest], ball + socket, socket  # one piece lies on the socket's surface, another is inside
        cases = [("none", *base) for base in (*all_bases, beside)] + [mutated(dice, all_bases) for _ in range(number)]
        by_files = itertools.groupby(sorted(cases, key=lambda case: case[2:]), key=lambda case: case[2:])
        for (ball, socket), group in by_files:
            group = list(group)
            files = [root / f"{k}.txt" for k in range(len(group))]
            for file, case in zip(files, group):
                file.write_text("\n".join(case[1]) + "\n")
            for file, (kind, lines, _, _), said in zip(files, group, fast_says(files, ball, socket)):
                yes = not said.startswith("not proven")
                (accepted if yes else refused)[kind] = (accepted if yes else refused).get(kind, 0) + 1
                if yes != python_says(file, ball, socket):
                    wrong.append((f"the fast checker says: {said}", kind, lines, ball, socket))
                elif kind == "none" and not yes:
                    wrong.append((said, kind, lines, ball, socket))
                for pose, says in claims(dice, lines) if yes else ():
                    poses.setdefault((tuple(ball), tuple(socket)), {}).setdefault((pose, says), lines)
        for (ball, socket), asked in poses.items():
            given = "\n".join([text_of(ball), text_of(socket), *(f"{says} {pose}" for pose, says in asked)])
            done = subprocess.run([ORACLE], input=given, capture_output=True, text=True, check=True)
            for ((pose, says), lines), answer in zip(asked.items(), done.stdout.splitlines(), strict=True):
                meet, inside = (word == "1" for word in answer.split())
                if not {"clear": not meet and not inside, "apart": not meet, "contact": meet or inside}[says]:
                    wrong.append((f"CGAL: surfaces meet {meet}, a point is inside {inside}, not {says}, in {pose}", "accepted", lines, ball, socket))
    for what, kind, lines, ball, socket in wrong[:10]:
        print(f"{what}\n  changed: {kind}; ball {[f.name for f in ball]}; socket {[f.name for f in socket]}\n  " + "\n  ".join(lines[:14]))
    print(f"{len(cases)} certificates, {sum(accepted.values())} accepted, {sum(map(len, poses.values()))} poses by CGAL; accepted {accepted}, refused {refused}")
    assert not wrong, f"{len(wrong)} wrong"
    assert number < 200 or (len(accepted) > 8 and len(refused) > 12), "changes that do nothing"


if __name__ == "__main__":
    main(int(sys.argv[1]))
