#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_certificate.py CERTIFICATE BALL SOCKET [--ball-part FILE...] [--socket-part FILE...]: is it true of these meshes (PLY or OBJ)?

Exact, and written from certificate_format.md alone. Exit code 0 where it is proven, 1 where not, with one line either way."""
import math
import struct
import sys
from fractions import Fraction

TYPES = "char uchar short ushort int uint float double int8 uint8 int16 uint16 int32 uint32 float32 float64".split()
ORDERS = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}


def need(condition, reason):
    if not condition:
        raise ValueError(reason)


def number(text):
    """A rational number: of a decimal, a fraction or a binary float."""
    if isinstance(text, str):
        digits, _, power = text.lower().partition("e")
        need(max(len(digits), 15 * len(power)) <= 60 and set(digits) <= set("+-.0123456789/"), f"{text[:60]}: no number")
    return Fraction(text)


def whole(words):
    need(all(set(word) <= set("-0123456789") for word in words), f"{words}: no integers")
    return [number(word).numerator for word in words]


def read_ply(data):
    head, _, body = data.partition(b"\nend_header")
    body, elements, rows, place = body[body.index(b"\n") + 1 :], [], {"vertex": [], "face": []}, 0
    (title, form, _), *lines = [line.split() for line in head.decode("ascii", "replace").split("\n")[1:]]
    for kind, *words in lines:
        if kind == "element":
            elements.append((words[0], int(words[1]), []))
        elif kind == "property":
            elements[-1][2].append(words)
    source = body.decode("ascii", "replace").split() if form == "ascii" else body

    def take(kind, count):
        nonlocal place
        layout = struct.Struct(ORDERS[form] + str(count) + "bBhHiIfd"[TYPES.index(kind) % 8])
        place += count if form == "ascii" else layout.size
        return source[place - count : place] if form == "ascii" else layout.unpack_from(source, place - layout.size)

    for name, count, properties in elements:
        for _ in range(count):
            row = {p[-1]: take(p[2], int(take(p[1], 1)[0])) if p[0] == "list" else take(p[0], 1)[0] for p in properties}
            rows.setdefault(name, []).append(row)
    once = all(len(set(names)) == len(names) for names in [[e[0] for e in elements]] + [[p[-1] for p in e[2]] for e in elements])
    need(title == "format" and place == len(source) and once, "a PLY file is not as its header says")
    corners = (row.get("vertex_indices") or row["vertex_index"] for row in rows["face"])
    return [[row[axis] for axis in "xyz"] for row in rows["vertex"]], [[int(i) for i in f] for f in corners]


def read_side(paths, centre, shift):
    """Vertices of all files about the centre and the shift, in whole numbers of 1 / unit mm; the unit; the faces."""
    rows, triangles = [shift], []
    for path in paths:
        with open(path, "rb") as file:
            data = file.read()
        if path.lower().endswith(".obj"):
            lines = [line.split("#")[0].split() for line in data.decode("utf-8", "replace").split("\n")]
            points = [line[1:4] for line in lines if line[:1] == ["v"]]
            faces = [[int(word.split("/")[0]) - 1 for word in line[1:]] for line in lines if line[:1] == ["f"]]
        else:
            points, faces = read_ply(data)
        there = all(len(f) == 3 and 0 <= min(f) <= max(f) < len(points) for f in faces) and {*map(len, points)} == {3}
        need(faces and there, f"{path}: not all faces are triangles of its vertices")
        triangles += [[i + len(rows) - 1 for i in f] for f in faces]
        rows += [[number(x) - c for x, c in zip(p, centre)] for p in points]
    unit = math.lcm(*(x.denominator for row in rows for x in row))
    shift, *points = [[x.numerator * (unit // x.denominator) for x in row] for row in rows]
    return points, shift, unit, triangles


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def product(a, b):  # of two quaternions
    (s, *u), (t, *v) = a, b
    return [s * t - dot(u, v)] + [s * y + t * x + z for x, y, z in zip(u, v, cross(u, v))]


def posed(head, about, c, s, ball, socket):
    """Of ball and socket: the corners of all faces about a centre, in whole numbers of 1 / unit mm, and the unit."""
    q = product(product(head["outer"], [c] + [s * x for x in head["axis"]]), head["inner"])
    n, bar, own = dot(q, q), [q[0], -q[1], -q[2], -q[3]], {"ball": True, "socket": False}[about]
    images = [product(product(q, unit), bar)[1:] for unit in ([0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1])]  # n times the rotation's columns
    right = all(dot(images[i], images[k]) == (n * n if i == k else 0) for i in range(3) for k in range(3))
    need(n > 0 and right and dot(images[0], cross(*images[1:])) == n**3, "a quaternion is no rotation")
    moved = [[dot(row, p) + (0 if own else n * t) for row, t in zip(zip(*images), ball[1])] for p in ball[0]]
    still = [[x - own * t for x, t in zip(p, socket[1])] for p in socket[0]]
    return [([[points[i] for i in f] for f in faces], unit) for points, faces, unit in ((moved, ball[3], n * ball[2]), (still, socket[3], socket[2]))]


def clipped(face, planes):
    """Corners (m, p, q, w), points (m, p, q) / w, of what the planes leave of a triangle."""
    corners, wide = [(*face[k : k + 3], 1) for k in (0, 3, 6)], face[9]
    for a, i, b, length in planes:
        side = [a * x[0] + b * x[i] + length * wide * x[3] for x in corners]
        left = []
        for k, d in enumerate(side):
            if (d < 0) != (side[k - 1] < 0):
                left.append([abs(side[k - 1]) * u + abs(d) * v for u, v in zip(corners[k], corners[k - 1])])
            if d >= 0:
                left.append(corners[k])
        corners = left
    return corners


def check_node(node, leaves, unit, ball, socket):
    """What is asked of a leaf, or of the four parts of another node."""
    (face, level, i, j), n = node, 2 ** node[1]
    sides = (1, 2 * i - n, 1), (1, 2 * i + 2 - n, -1), (2, 2 * j - n, 1), (2, 2 * j + 2 - n, -1)
    planes = [(-s * low, k, s * n, math.isqrt(n * n + low * low) + 1) for k, low, s in sides]
    for a, k, b, length in planes:  # left out are faces (nine coordinates, widening) with all corners beyond a plane
        ball, socket = (([f for f in faces if a * f[0] + b * f[k] >= (low := -length * f[9])
                          or a * f[3] + b * f[k + 3] >= low or a * f[6] + b * f[k + 6] >= low], size)
                        for faces, size in (ball, socket))
    if node not in leaves:
        return [check_node((face, level + 1, 2 * i + part // 2, 2 * j + part % 2), leaves, unit, ball, socket) for part in range(4)]
    axis = (n, 2 * i + 1 - n, 2 * j + 1 - n)
    most, least = (leaves[node] * ball[1]) ** 2, (leaves[node] * socket[1]) ** 2 * dot(axis, axis)
    for f in ball[0]:
        if max(dot(f[:3], f[:3]), dot(f[3:6], f[3:6]), dot(f[6:9], f[6:9])) * unit**2 > most:  # else all of it is nearer
            near = (dot(x[:3], x[:3]) * unit**2 <= most * x[3] ** 2 for x in clipped(f, planes))
            need(all(near), f"in leaf {node} the ball reaches beyond the radius")
    for f in socket[0]:
        along = ((dot(axis, x), x[3]) for x in clipped(f, planes))
        need(all(a > 0 and (a * unit) ** 2 > least * w * w for a, w in along), f"in leaf {node} the socket is not beyond")


def check_cell(head, cell, slack, leaves, meshes):
    need(all(0 <= f < 6 and 0 <= level <= 40 and 0 <= min(i, j) <= max(i, j) < 2**level for f, level, i, j in leaves), "a leaf is not on the cube")
    inner = {(f, level - k, i >> k, j >> k) for f, level, i, j in leaves for k in range(1, level + 1)}
    areas = sum(Fraction(1, 4 ** leaf[1]) for leaf in leaves)
    need(areas == 6 and not inner & leaves.keys() and min(leaves.values()) >= 0, "the leaves do not cover the cube once")
    sides = posed(head, *cell, *meshes)
    for f in range(6):
        k, sign, seen = f // 2, 1 - f % 2 * 2, []
        for (faces, unit), swept in zip(sides, (slack, 0)):
            widths = [math.ceil(swept * (math.isqrt(max(dot(x, x) for x in g)) + 1)) if swept else 0 for g in faces]
            flat = [[y for x in g for y in (sign * x[k], x[(k + 1) % 3], x[(k + 2) % 3])] for g in faces]
            seen.append(([(*g, width) for g, width in zip(flat, widths)], unit))
        check_node((f, 0, 0, 0), leaves, head["unit"][0], *seen)


def check(certificate, ball, socket, *parts):
    files = {"--ball-part": [ball], "--socket-part": [socket]}
    for k, word in enumerate(parts):
        if word not in files:
            files[next((option for option in parts[k::-1] if option in files), f"{word}: of which side?")].append(word)
    with open(certificate, encoding="ascii") as file:
        (*title, says), *lines = [line.split() for line in file]
    need(title == ["impinge", "certificate", "1"] and lines.pop() == ["end"], "this is no whole certificate")
    bodies = whole(lines.pop(0)[1:]) if lines[0][0] == "bodies" else [1, 1]
    need(bodies == list(map(len, files.values())), f"it is of {bodies} files of ball and socket, parts and all")
    sizes = {"centre": 3, "shift": 3, "outer": 4, "axis": 3, "inner": 4, "unit": 1}
    need([(line[0], len(line) - 1) for line in lines[:6]] == list(sizes.items()), "its head is not that of a certificate")
    head = {name: list(map(number, words)) if name in ("centre", "shift") else whole(words) for name, *words in lines[:6]}
    need(head["unit"][0] > 0 and dot(head["axis"], head["axis"]) == 1, "the unit or the axis is none")
    meshes = [read_side(paths[:1] if says == "blocked" else paths, head["centre"], head["shift"]) for paths in files.values()]
    if says == "blocked":
        found, ((kind, about, c, s, *ray),) = [], [[*words[:2], *whole(words[2:])] for words in lines[6:]]
        for faces, unit in posed(head, about, c, s, *meshes):
            corners = [(dot(a, cross(b, c)), dot(ray, cross(b, c)), dot(ray, cross(c, a)), dot(ray, cross(a, b))) for a, b, c in faces]
            found.append([Fraction(v, sum(p) * unit) for v, *p in corners if v != 0 and any(p) and all(x * v >= 0 for x in p)])
        need(kind == "ray" and len(ray) == 3 and all(found), "the ray does not meet both surfaces")
        need(max(found[0]) >= min(found[1]), "the ball is nearer along the ray")
        return "blocked: along the ray the ball is not nearer than the socket"
    at, place, total = [1, 0], 6, 0
    while place < len(lines) or not total:
        kind, about, *pairs, slack, count = lines[place]
        (c0, s0, c1, s1, c, s), slack, (count,) = whole(pairs), number(slack), whole([count])
        need((says, kind) == ("clear", "cell") and [c0, s0] == at, "a cell is missing")
        for cos, sin in ((c0 * c + s0 * s, c0 * s - s0 * c), (c * c1 + s * s1, c * s1 - s * c1)):
            need(cos > 0 and 0 <= 2 * sin <= slack * cos and not slack * any(head["shift"]), "a cell is wider than proven")
        leaves = {(f, level, i, j): r for f, level, i, j, r in map(whole, lines[place + 1 : place + 1 + count])}
        need(len(leaves) == count > 0, "a leaf is missing or there twice")
        check_cell(head, (about, c, s), slack, leaves, meshes)
        at, place, total = [c1, s1], place + 1 + count, total + count
    need(not any(head["shift"]) or {"ball", "socket"} <= {line[1] for line in lines[6:]}, "cells about a centre are missing")
    return f"clear: ball and socket do not meet, up to {math.degrees(2 * math.atan2(at[1], at[0])):.6f} degrees ({total} leaves)"


if __name__ == "__main__":
    try:
        print(check(*sys.argv[1:]))
    except Exception as error:  # whatever is wrong, nothing is proven
        sys.exit(f"refused: {' '.join(str(error).split())[:300] or type(error).__name__}")
