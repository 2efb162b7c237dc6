#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_certificate.py CERTIFICATE BALL SOCKET [--ball-part FILE...] [--socket-part FILE...]: does the certificate hold for these meshes (PLY or OBJ)?

Exact, and written only from certificate_format.md. Exit code 0 if it is proven, with a text of what; 1 if not, with one line."""
import hashlib
import math
import pathlib
import struct
import sys
from fractions import Fraction

TYPES = "char uchar short ushort int uint float double int8 uint8 int16 uint16 int32 uint32 float32 float64".split()
ORDERS = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}


def need(condition, reason):
    if not condition:
        raise ValueError(reason)


def number(text):  # rational: a decimal or a binary float
    if isinstance(text, str):
        digits, _, power = text.lower().partition("e")
        need(max(len(digits), 15 * len(power)) <= 60 and set(digits + power) <= set("+-.0123456789"), f"{text[:60]}: no number")
        return Fraction(text)
    return text


def whole(words):
    need(all(set(word) <= set("-0123456789") for word in words), f"{words}: no integers")
    return [number(word).numerator for word in words]


def read_ply(data):
    head, _, body = data.partition(b"\nend_header")
    body, elements, rows, place = body[body.index(b"\n") + 1 :], [], {}, 0
    (title, form, _), *lines = [line.split() for line in head.decode("ascii", "replace").split("\n")[1:]]
    for kind, *words in lines:
        if kind in ("element", "property"):
            elements.append([words]) if kind == "element" else elements[-1].append(words)
    source = body.decode("ascii", "replace").split() if form == "ascii" else body

    def take(kind, count):
        nonlocal place
        layout = ORDERS[form] + str(count) + "bBhHiIfd"[TYPES.index(kind) % 8]
        place += count if form == "ascii" else struct.calcsize(layout)
        return source[place - count : place] if form == "ascii" else struct.unpack_from(layout, source, place - struct.calcsize(layout))

    for (name, count), *properties in elements:
        columns = {p[-1]: k for k, p in enumerate(properties)}
        need(name not in rows and len(columns) == len(properties), "a PLY file names one thing twice")
        rows[name] = columns, [[take(p[2], int(take(p[1], 1)[0])) if p[0] == "list" else take(p[0], 1)[0] for p in properties] for _ in range(int(count))]
    need(title == "format" and place == len(source) and "tristrips" not in rows, "a PLY file is not as its header says, or has strips")
    (at, points), (corners, faces) = rows["vertex"], rows["face"]
    corner = corners.get("vertex_indices", corners.get("vertex_index"))
    return [[p[at["x"]], p[at["y"]], p[at["z"]]] for p in points], [[int(i) for i in f[corner]] for f in faces]


class Body:
    """All surfaces of a side: points from the centre, in whole numbers of 1 / unit mm, each once; and faces, each by three of them."""

    def __init__(self, paths, centre):
        rows, triangles, self.files = [], [], []  # triangles: of each file
        for path in paths:
            data = pathlib.Path(path).read_bytes()
            self.files.append(f"{path} (sha256 {hashlib.sha256(data).hexdigest()})")
            if path.lower().endswith(".obj"):
                lines = [line.split("#")[0].split() for line in data.decode("utf-8", "replace").split("\n")]
                points = [line[1 : 5 if len(line) == 5 else 4] for line in lines if line[:1] == ["v"]]  # no weights: they are a fourth number
                faces = [[int(word.split("/")[0]) - 1 for word in line[1:]] for line in lines if line[:1] == ["f"]]
            else:
                points, faces = read_ply(data)
            need(faces and all(len(f) == 3 and 0 <= min(f) <= max(f) < len(points) for f in faces) and {*map(len, points)} == {3},
                 f"{path}: not all faces are triangles of its vertices")
            triangles.append([[i + len(rows) for i in f] for f in faces])
            rows += points
        ratios = [[number(x).as_integer_ratio() for x in row] for row in rows]
        self.unit = math.lcm(*{d for row in ratios for _, d in row}, *(c.denominator for c in centre))
        places, at = {}, [c.numerator * (self.unit // c.denominator) for c in centre]
        place = [places.setdefault(tuple(n * (self.unit // d) - c for (n, d), c in zip(row, at)), len(places)) for row in ratios]
        self.points, self.faces, self.closed, self.hollow = list(places), [], [], False
        for faces in ([tuple(place[i] for i in f) for f in file] for file in triangles):  # closed if each edge is of an even number of them
            self.faces += faces
            once, odd = {tuple(sorted(f)): f for f in faces if len({*f}) == 3}, set()
            for a, b, c in once:
                odd ^= {(a, b), (b, c), (a, c)}
            self.closed.append([] if odd else list(once.values()))
        above, self.pieces = list(range(len(places))), {}  # pieces are connected across corners
        def top(i):
            while above[i] != i:
                above[i] = i = above[above[i]]
            return i
        for a, b, c in self.faces:
            above[top(a)] = above[top(b)] = top(c)
        for f in self.faces:
            self.pieces.setdefault(top(f[0]), []).append(f)

    def cut_by_planes(self, faces, planes):
        """Faces with a corner on the near side of one of the planes n x <= d, and faces with a corner on the far side."""
        near, far, corners = set(), set(), {i for f in faces for i in f}
        for n, d in planes:
            scale = math.lcm(*(Fraction(x).denominator for x in n))
            n, low, high = [int(x * scale) for x in n], math.floor(d * scale * self.unit), math.ceil(d * scale * self.unit)
            values = [(i, dot(n, self.points[i])) for i in corners]
            near.update(i for i, v in values if v <= low)
            far.update(i for i, v in values if v >= high)
        return [[f for f in faces if f[0] in side or f[1] in side or f[2] in side] for side in (near, far)]

    def cut_by_sphere(self, faces, radius):
        """Faces that may have a point inside the sphere, and faces that may have one outside."""
        square, sides = (radius * self.unit) ** 2, []
        low, high = math.floor(3 * square), math.ceil(square)
        for a, b, c in ([self.points[i] for i in f] for f in faces):
            aa, bb, cc = dot(a, a), dot(b, b), dot(c, c)
            longest = max(aa + bb - 2 * dot(a, b), bb + cc - 2 * dot(b, c), cc + aa - 2 * dot(c, a))
            sides.append((3 * min(aa, bb, cc) - longest <= low, max(aa, bb, cc) >= high))
        return [[f for f, side in zip(faces, sides) if side[k]] for k in (0, 1)]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

def volume(a, b, c, d):  # six times that between four points
    (x, y, z), (u, v, w), r = ([p - q for p, q in zip(point, d)] for point in (a, b, c))
    return dot((y * w - z * v, z * u - x * w, x * v - y * u), r)

def product(a, b):  # of two quaternions
    (s, x, y, z), (t, u, v, w) = a, b
    return [s * t - x * u - y * v - z * w, s * u + t * x + y * w - z * v, s * v + t * y + z * u - x * w, s * w + t * z + x * v - y * u]

def rotation(q):  # the rows of its matrix
    bar = [q[0], -q[1], -q[2], -q[3]]
    columns = [product(product(q, one), bar)[1:] for one in ([0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1])]
    return [[Fraction(x, product(q, bar)[0]) for x in row] for row in zip(*columns)]

def turned(head, half):
    need(half[1] > 0 or (half[1] == 0 and half[0] > 0), "a half angle is none")
    return product(product(head["outer"], [half[0], *(half[1] * x for x in head["axis"])]), head["inner"])

def images(head, first, last):
    """Matrices that take a point to both ends of its arc, and to the point where the tangents at the ends meet."""
    cosine, sine = first[0] * last[0] + first[1] * last[1], first[0] * last[1] - first[1] * last[0]
    need(cosine > 0, "a plane cuts an arc of half a turn or more")
    a, b = (rotation(turned(head, half)) for half in (first, last))
    axis, out = [dot(row, head["axis"]) for row in rotation(head["outer"])], (1 + Fraction(sine, cosine) ** 2) / 2
    kept = [[x * dot(axis, column) for column in zip(*a)] for x in axis]
    return [a, b, [[k + (x + y - 2 * k) * out for x, y, k in zip(*rows)] for rows in zip(a, b, kept)]] if sine else [a]


def check_cuts(head, ball, socket, lines):
    """Checks the tree of cuts: a node has no faces of one body, or is cut in two."""
    unit, shift, stack = head["unit"][0], head["shift"], [((1, 0), head["last"], ball.faces, socket.faces)]
    for kind, *words in lines:
        need(stack, "there are more cuts than nodes")
        (first, last, mine, yours), (*n, d) = stack.pop(), whole(words) or [0]
        need(len(n) == {"-": 0, "turn": 1, "sphere": 0, "plane": 3}.get(kind), f"{kind}: no cut")
        if kind == "-":
            need(not mine or not yours, f"a part is not clear: it has {len(mine)} faces of the ball and {len(yours)} of the socket")
        elif kind == "turn":
            (c, s), (c0, s0), (c1, s1) = (*n, d), first, last
            need(turned(head, (c, s)) and c0 * s >= s0 * c and c * s1 >= s * c1, "a turn is cut outside of its arc")
            stack += ((c, s), last, mine, yours), (first, (c, s), mine, yours)
        else:
            d = Fraction(d, unit)
            need(kind == "plane" or (d > 0 and not any(shift)), "a sphere is none, or cuts a ball that is shifted")
            if kind == "sphere":
                sides = ball.cut_by_sphere(mine, d), socket.cut_by_sphere(yours, d)
            else:
                planes = [([dot(n, column) for column in zip(*image)], d - dot(n, shift)) for image in images(head, first, last)]
                sides = ball.cut_by_planes(mine, planes), socket.cut_by_planes(yours, [(n, d)])
            stack += [(first, last, a, b) for a, b in zip(*sides)][::-1]
    need(not stack, "a part is missing")


def is_inside(x, points, files, hollow):
    """Is x in one of the files, with an odd number of its faces above? The first may be hollow. None if an edge is above x."""
    low, high, odd = list(map(math.floor, x)), list(map(math.ceil, x)), [hollow] + [False] * (len(files) - 1)
    for k, f in ((k, f) for k, faces in enumerate(files) for f in faces):
        a, b, c = (points[i] for i in f)
        if all(min(a[i], b[i], c[i]) <= high[i] and max(a[i], b[i], c[i]) >= low[i] for i in (0, 1)):
            turns = [(p[0] - x[0]) * (q[1] - x[1]) - (p[1] - x[1]) * (q[0] - x[0]) for p, q in ((a, b), (b, c), (c, a))]
            above = volume(x, c, b, a) * sum(turns)
            if not min(turns) < 0 < max(turns) and (0 in turns or above == 0):
                return None
            odd[k] ^= above > 0 and not min(turns) < 0 < max(turns)
    return any(odd)

def each_inside(of, body, place, is_socket):
    """Is each piece of a body, moved by place(), inside a closed file of the other body? None where that is not known. The direction "above" leans a little."""
    lean = lambda p: (1000 * p[0] + 209 * p[2], 1000 * p[1] + 96 * p[2], p[2])
    points = list(map(lean, body.points))
    body.hollow = is_socket and is_inside((0, 0, 0), points, body.closed[:1], False)
    need(body.hollow is not None, "no line up tells whether the centre is inside")
    tried = lambda f: is_inside(lean([v * body.unit for v in place(of.points[f[0]])]), points, body.closed, body.hollow)
    return [next((inside for inside in map(tried, faces) if inside is not None), None) for faces in of.pieces.values() if any(body.closed)]

def passes(p, q, a, b, c):
    """Does an edge meet a triangle without lying in its plane?"""
    ends, turns = (volume(p, a, b, c), volume(q, a, b, c)), [volume(p, q, *side) for side in ((a, b), (b, c), (c, a))]
    return any(ends) and ends[0] * ends[1] <= 0 and (min(turns) >= 0 or max(turns) <= 0)

def told(head, ball, socket):
    words = lambda vector: " ".join(f"{float(x):.9g}" for x in vector)
    turn = lambda w, *v: words([math.degrees(2 * math.atan2(math.hypot(*v), w))]) + " degrees about " + words(x / (math.hypot(*v) or 1) for x in v)
    yield from (f"{name}: {', '.join(of.files)}; {len(of.faces)} faces, {len(of.pieces)} pieces, {len(of.files) - of.closed.count([])} of {len(of.files)} files closed{', no other has an inside' * ([] in of.closed)}{', the first round the centre: its outside is bone' * of.hollow}"
                for name, of in (("ball", ball), ("socket", socket)))
    yield f"centre: {words(head['centre'])} mm in the frame of the files"
    yield f"pose: the ball turned by {turn(*turned(head, (1, 0)))} from where its files have it, and shifted by {words(head['shift'])} mm"
    if head["last"][1]:
        yield f"motion: from there by every angle from 0 to {turn(head['last'][0], *(head['last'][1] * dot(row, head['axis']) for row in rotation(head['outer'])))}"


def check(certificate, ball, socket, *parts):
    files = {"--ball-part": [ball], "--socket-part": [socket]}
    for k, word in enumerate(parts):
        files.get(word) or files[next((option for option in parts[k::-1] if option in files), f"{word}: of which side?")].append(word)
    (*title, says), *lines = map(str.split, pathlib.Path(certificate).read_text("ascii").splitlines())
    need(title == ["impinge", "certificate", "2"] and says in ("clear", "contact") and lines.pop() == ["end"], "this is no whole certificate")
    evidence, sizes = lines[8:], {"files": 2, "centre": 3, "shift": 3, "outer": 4, "axis": 3, "inner": 4, "last": 2, "unit": 1}
    need([(line[0], len(line) - 1) for line in lines[:8]] == list(sizes.items()), "its head is not that of a certificate")
    head = {name: tuple(map(number, words) if name in ("centre", "shift") else whole(words)) for name, *words in lines[:8]}
    need(list(head["files"]) == list(map(len, files.values())), f"it is of {head['files']} files of ball and socket, parts and all")
    need(head["unit"][0] > 0 and dot(head["axis"], head["axis"]) == 1 and any(head["outer"]) and any(head["inner"]), "the unit or a rotation is none")
    ball, socket, shift = *(Body(paths, head["centre"]) for paths in files.values()), head["shift"]
    rows, is_pose = rotation(turned(head, (1, 0))), turned(head, head["last"]) and head["last"][1] == 0
    in_socket = lambda x: [Fraction(dot(row, x), ball.unit) + t for row, t in zip(rows, shift)]
    in_ball = lambda x: [dot(column, [Fraction(v, socket.unit) - t for v, t in zip(x, shift)]) for column in zip(*rows)]
    if says == "clear":
        check_cuts(head, ball, socket, evidence)
    else:
        kind, *faces = evidence[0][0], *whole(evidence[0][1:])
        need(is_pose and len(evidence) == 1 and {"cross": 2, "inside": 0}.get(kind) == len(faces) and min(faces, default=0) >= 0, "this is no contact of a pose")
    if says == "contact" and faces:
        sides = (ball, in_socket), (socket, lambda x: [Fraction(v, socket.unit) for v in x])
        f, g = ([move(of.points[i]) for i in [f for f in of.faces if len({*f}) == 3][k]] for k, (of, move) in zip(faces, sides))
        need(any(passes(h[k - 1], h[k], *other) for h, other in ((f, g), (g, f)) for k in range(3)), "the two faces do not meet")
        proven = "face {} of the ball and face {} of the socket have a common point".format(*faces)
    else:
        known = each_inside(ball, socket, in_socket, True) + each_inside(socket, ball, in_ball, False)
        need((inside := any(known)) or None not in known, "no line up tells what is inside")
        need(inside == (says == "contact"), proven := f"{'a point' if inside else 'no piece'} of one body is inside a closed file of the other")
    return "\n".join([f"{says}: {'no two faces meet, and ' * (says == 'clear')}{proven}", *told(head, ball, socket)])


if __name__ == "__main__":
    try:
        print(check(*sys.argv[1:]))
    except Exception as error:  # whatever is wrong, nothing is proven
        sys.exit(f"refused: {' '.join(str(error).split())[:300] or type(error).__name__}")
