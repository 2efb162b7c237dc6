# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of closed meshes, one of which turns. None begins inside the other, so that bodies touch where surfaces meet.

The first meeting of two surfaces that are apart is that of a corner and a face or of two edges. Which of them may be first is
found in doubles, with a slack far above their rounding; these are asked for exactly (exact.py), the earliest first, until
none that is left can be earlier.
"""
import numpy as np

from exact import ZERO, add, angle, cross, dot, edge_edge, edges_of, least, pierces, vertex_face
from pairs import CLEAR, LARGEST, axis, fits, times, turned_back, vector

SLACK = 1e-9  # of lengths; doubles err by 1e-13 here


def mesh(vertices, faces):
    return {"vertices": [tuple(x) for x in vertices], "faces": [tuple(f) for f in faces]}


def joined(*meshes):
    out = mesh([], [])
    for one in meshes:
        first = len(out["vertices"])
        out["vertices"] += one["vertices"]
        out["faces"] += [tuple(first + v for v in f) for f in one["faces"]]
    return out


def box(corner, x, y, z):
    """A parallelepiped, its faces outwards if x, y, z are right-handed."""
    at = [add(add(add(corner, x, k & 1), y, k >> 1 & 1), z, k >> 2) for k in range(8)]
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    return mesh(at, [f for a, b, c, d in quads for f in ((a, b, c), (a, c, d))])


def prism(outline, low, high):
    """Of a polygon in x and y that is star-shaped about its first point's opposite: its caps are fans about the mean."""
    n = len(outline)
    middle = tuple(sum(p[k] for p in outline) // n for k in (0, 1))
    at = [(*p, z) for z in (low, high) for p in (*outline, middle)]
    faces = []
    for k in range(n):
        j = (k + 1) % n
        faces += [(k, j, n + 1 + j), (k, n + 1 + j, n + 1 + k), (j, k, n), (n + 1 + k, n + 1 + j, 2 * n + 1)]
    return mesh(at, faces)


def sphere(radius, levels, radius_of=None):
    """An octahedron whose faces are divided, in integers; radius_of(direction): a factor."""
    at = [(1.0, 0, 0), (-1.0, 0, 0), (0, 1.0, 0), (0, -1.0, 0), (0, 0, 1.0), (0, 0, -1.0)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(levels):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                x = np.add(at[a], at[b])
                middles[key] = len(at)
                at.append(tuple(x / np.sqrt(x @ x)))
            return middles[key]

        for a, b, c in faces:
            d, e, f = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
        faces = finer
    return mesh([tuple(round(float(c) * radius * (radius_of(u) if radius_of else 1)) for c in u) for u in at], faces)


def shell(radius, thickness, levels, rim):
    """A cup: the part of a sphere below a height, and a larger one round it, joined at the rim."""
    inner, outer = sphere(radius, levels), sphere(radius + thickness, levels)
    n = len(inner["vertices"])
    kept = [f for f in inner["faces"] if sum(inner["vertices"][v][2] for v in f) < 3 * rim]
    sides = {(f[k], f[(k + 1) % 3]) for f in kept for k in range(3)}
    faces = [(c, b, a) for a, b, c in kept] + [tuple(n + v for v in f) for f in kept]
    for a, b in sorted(sides):
        if (b, a) not in sides:
            faces += [(a, b, n + b), (a, n + b, n + a)]
    return tidy(mesh(inner["vertices"] + outer["vertices"], faces))


def tidy(of):
    """Without vertices of no face."""
    used = sorted({v for f in of["faces"] for v in f})
    place = {v: k for k, v in enumerate(used)}
    return mesh([of["vertices"][v] for v in used], [tuple(place[v] for v in f) for f in of["faces"]])


def spike(base, tip, width):
    """A thin pyramid from a base to a tip."""
    along = add(tip, base, -1)
    u = cross(along, (1, 2, 5))
    v = cross(along, u)
    sized = [tuple(round(width * c / np.sqrt(float(dot(x, x)))) for c in x) for x in (u, v)]
    at = [add(base, sized[0]), add(base, sized[1]), add(base, add(sized[0], sized[1]), -1), tip]
    return mesh(at, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])


def moved(of, shift=(0, 0, 0), k=1):
    return mesh([add(shift, x, k) for x in of["vertices"]], of["faces"])


def aimed(random, radius):
    """A place about so far from the origin."""
    v = vector(random, 100)
    return times(max(1, round(radius / np.sqrt(float(dot(v, v))))), v)


# The families: the turning mesh, the resting one, axis, and the m and n of the contact pose in which they are drawn.

def ball_in_cup(random):
    """A bumpy head on a neck in a cup."""
    bump = np.array(vector(random)) / 12.0
    head = sphere(22 << 14, 3, lambda u: 1 + 0.12 * max(0.0, float(np.dot(u, bump))) ** 2)
    neck = box((-(6 << 14), -(6 << 14), 10 << 14), (12 << 14, random.randint(-999, 999), 0), (0, 12 << 14, 0), (0, 0, 50 << 14))
    return joined(head, neck), shell(26 << 14, 4 << 14, 3, random.randint(0, 12) << 14), axis(random), 0, 1


def gears(random):
    """Prisms about an axis along their edges: edges stay parallel, and caps in one plane."""
    def wheel(inner, outer, teeth):
        turn = random.random()
        out = []
        for k in range(4 * teeth):
            r = outer if k % 4 in (1, 2) else inner
            out.append((round(r * np.cos(turn + np.pi * k / (2 * teeth))), round(r * np.sin(turn + np.pi * k / (2 * teeth)))))
        return out
    resting = moved(prism(wheel(300, 420, 8), 0, 100), (850, 0, random.choice((0, 0, 50, 99, 100))))
    return prism(wheel(400, random.choice((431, 445, 470)), random.randint(5, 11)), 0, 100), resting, (0, 0, 1), 0, 1


def door(random):
    """A wing that lands flat on a wall: many corners at once."""
    w = axis(random)
    u, v = vector(random), times(random.randint(1, 3), w)
    n = cross(w, u)
    if not any(n):
        return door(random)
    start = add(times(random.randint(1, 3), u), w, random.randint(-3, 3))
    wing = box(start, times(3, u), v, n)
    wall = box(add(add(start, u, random.randint(-1, 2)), w, random.randint(-1, 1)), v, times(3, u), times(-1, n))
    return wing, wall, w, random.randint(1, 3), random.randint(2, 5)


def bump_under_a_wedge(random, gap=0):
    """A corner passes a face, or an edge an edge, and just touches it; or by `gap` of it not, or too much."""
    w = axis(random)
    p = aimed(random, 60)
    if not any(cross(w, p)):
        return bump_under_a_wedge(random, gap)
    back = cross(w, p)           # where p moves
    out = cross(back, vector(random))  # across the face that holds back
    if dot(out, p) < 0:
        out = times(-1, out)
    other = cross(out, back)
    if not any(out) or not any(other):
        return bump_under_a_wedge(random, gap)
    reach = [max(1, round(20 / np.sqrt(float(dot(x, x))))) for x in (back, other)]
    face = [add(p, back, -reach[0]), add(p, other, reach[1]), add(add(p, back, reach[0]), other, -reach[1])]
    peak = add(add(p, out, 1), p, random.randint(0, 1))
    wedge = mesh([*face, peak], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
    ball = spike(tuple(c // 2 for c in p), p, 8)
    if random.random() < 0.4:  # a roof whose ridge holds p
        ridge = add(back, other, random.choice((-1, 1, 2)))
        low = add(p, out, -1)
        ball = mesh([add(p, ridge, -1), add(p, ridge, 1), add(low, back), add(low, other)],
                    [(0, 1, 2), (1, 0, 3), (0, 2, 3), (2, 1, 3)])
    return joined(ball, sphere(10, 2)), wedge, w, random.randint(1, 3), random.randint(2, 5), times(gap, out)


def past_a_wedge(random):
    return bump_under_a_wedge(random, random.choice((1, -1)))


def tiny_teeth(random):
    """Teeth of a millionth of the radius, on a head and in a cup that are apart otherwise."""
    w = axis(random)
    p = aimed(random, 1 << 25)
    if not any(cross(w, p)):
        return tiny_teeth(random)
    inner = sphere(1 << 24, 2)
    tooth = spike(add(p, vector(random), 20), add(p, vector(random, 40), 1), 20)
    other = spike(add(p, vector(random), 50), add(p, vector(random, 40), 1), 20)
    return joined(inner, tooth), joined(shell(1 << 27, 1 << 24, 2, 0), other), w, random.randint(1, 3), random.randint(2, 5)


def at_start(random):
    """Boxes that share a corner, a part of an edge or of a face, or that pierce one another."""
    x, y, z = (random.randint(2, 6), 0, 0), (0, random.randint(2, 6), 0), (0, 0, random.randint(2, 6))
    corner = vector(random, 12)
    shift = (random.choice((x[0], 1)), random.choice((y[1], 1, -2)), random.choice((z[2], 1)))
    return box(corner, x, y, z), box(add(corner, shift), x, y, z), axis(random), 0, 1


def never(random):
    """A head that turns about a centre within a cage of plates, close to some."""
    head = sphere(1000, 2, lambda u: 1 + 0.3 * random.random())
    far = max(dot(x, x) for x in head["vertices"])
    r = int(np.sqrt(float(far))) + random.choice((1, 2, 20))
    plates = [box((-2000, -2000, r), (4000, 0, 0), (0, 4000, 0), (0, 0, 50)),
              box((r, -2000, -2000), (50, 0, 0), (0, 4000, 0), (0, 0, 4000))]
    return head, joined(*plates), axis(random), 0, 1


def needles(random):
    """A needle that passes thin spikes in a fraction of a degree, some of which are a little nearer than its tip."""
    w = axis(random)
    p = aimed(random, 1 << 20)
    if not any(cross(w, p)):
        return needles(random)
    needle = spike(tuple(c // 2 for c in p), p, 2000)
    spikes = []
    for _ in range(6):
        at = rounded_turn(p, w, random.uniform(0.1, 2.8))
        nearer = 1 + random.choice((1, 1, -1)) * 10 ** random.uniform(-4, -2)
        spikes.append(spike(tuple(2 * c for c in at), tuple(round(nearer * c) for c in at), 2000))
    return needle, joined(*spikes), w, 0, 1


def rounded_turn(x, w, t):
    """x turned about w by t radians."""
    z = np.array(w, float) / np.sqrt(float(dot(w, w)))
    x = np.array(x, float)
    return tuple(round(float(c)) for c in x * np.cos(t) + np.cross(z, x) * np.sin(t) + z * (z @ x) * (1 - np.cos(t)))


FAMILIES = (ball_in_cup, gears, door, bump_under_a_wedge, past_a_wedge, tiny_teeth, at_start, never, needles)
FINE = 30  # past_a_wedge: bits of what is drawn, of which the gap is 1 to 2^FINE


class Doubles:
    """A mesh in doubles in the frame whose +z is the axis, its largest radius about 1."""

    def __init__(self, of, w, scale):
        z = np.array(w, float) / np.sqrt(float(dot(w, w)))
        x = np.cross(z, [1.0, 0, 0] if abs(z[0]) < 0.7 else [0, 1.0, 0])
        x /= np.sqrt(x @ x)
        self.frame = np.stack([x, np.cross(z, x), z])
        self.x = np.array(of["vertices"], float) / scale @ self.frame.T
        self.edges = sorted({(min(f[k], f[k - 1]), max(f[k], f[k - 1])) for f in of["faces"] for k in range(3)})
        ends = np.array(self.edges)
        self.start, self.along = self.x[ends[:, 0]], self.x[ends[:, 1]] - self.x[ends[:, 0]]
        faces = np.array(of["faces"])
        self.corner = self.x[faces[:, 0]]
        self.normal = np.cross(self.x[faces[:, 1]] - self.corner, self.x[faces[:, 2]] - self.corner)
        self.middle = self.x[faces].mean(axis=1)
        self.radius = np.sqrt(((self.x[faces] - self.middle[:, None]) ** 2).sum(axis=2)).max(axis=1)


def turned_dot(a, b):
    """cosine, sine and constant of R a . b, for all a and all b."""
    flat = a[:, :2] @ b[:, :2].T
    return flat, a[:, :1] @ b[:, 1:2].T - a[:, 1:2] @ b[:, :1].T, a[:, 2:] @ b[:, 2:].T


def earliest(f, size, turning, turning_radius, resting, resting_radius):
    """A bound below the first angle at which f is 0 and the spheres round both parts come together; infinite if never."""
    cosine, sine, constant = f
    bound = SLACK * size
    height = np.hypot(cosine, sine)
    with np.errstate(all="ignore"):
        high = np.where(height > bound, (bound - constant) / height, 1.0)
        low = np.where(height > bound, (-bound - constant) / height, -1.0)
        never_zero = np.abs(constant) > height + bound
        first, last = np.arccos(np.clip(high, -1, 1)), np.arccos(np.clip(low, -1, 1))
    phase = np.arctan2(sine, cosine)
    arm, other = np.hypot(turning[:, 0], turning[:, 1])[:, None], np.hypot(resting[:, 0], resting[:, 1])[None]
    azimuth = np.arctan2(resting[:, 1], resting[:, 0])[None] - np.arctan2(turning[:, 1], turning[:, 0])[:, None]
    reach = turning_radius[:, None] + resting_radius[None] + SLACK
    apart = (turning[:, 2:] - resting[:, 2][None]) ** 2 + (arm - other) ** 2
    with np.errstate(all="ignore"):
        share = (reach ** 2 - apart) / (4 * arm * other)
        half = np.where(arm * other > 1e-12, 2 * np.arcsin(np.sqrt(np.clip(share, 0, 1))) + 1e-7, np.pi)
    never_near = reach ** 2 < apart
    best = np.full(cosine.shape, np.inf)
    for begin, end in ((phase + first, phase + last), (phase - last, phase - first)):
        # Angles from begin to end, of these what is within `half` of the azimuth.
        middle, width = (begin + end) / 2, (end - begin) / 2 + 1e-8
        off = np.remainder(azimuth - middle + np.pi, 2 * np.pi) - np.pi
        start = np.maximum(-width, np.where(width + half >= np.pi, -width, off - half))
        stop = np.minimum(width, np.where(width + half >= np.pi, width, off + half))
        at = np.remainder(middle + start, 2 * np.pi)
        at = np.where(at + (stop - start) >= 2 * np.pi, 0.0, at)
        best = np.minimum(best, np.where(start <= stop, at, np.inf))
    return np.where(never_zero | never_near, np.inf, best)


def candidates(a, b, w):
    """(bound, function that asks exactly) of all that may meet, the earliest first."""
    scale = max(float(max(map(abs, x))) for one in (a, b) for x in one["vertices"])
    p, q = Doubles(a, w, scale), Doubles(b, w, scale)
    back = tuple(-c for c in w)
    found = []

    def keep(bounds, ask):
        for i, j in np.argwhere(bounds <= LARGEST + 0.2):
            found.append((float(bounds[i, j]), ask, int(i), int(j)))

    def corners(of, at, mirrored):  # vertices of one that turn against faces of the other; mirrored: all turn backwards
        f = turned_dot(of.x * mirrored, at.normal * mirrored)
        f = (f[0], f[1], f[2] - (at.normal * at.corner).sum(axis=1)[None])
        size = np.sqrt((at.normal ** 2).sum(axis=1))[None]
        return earliest(f, size, of.x * mirrored, np.zeros(len(of.x)), at.middle * mirrored, at.radius)

    def face(of, j):
        return tuple(of["vertices"][v] for v in of["faces"][j])

    def edge(of, doubles, j):
        return tuple(of["vertices"][v] for v in doubles.edges[j])

    keep(corners(p, q, 1), lambda i, j: vertex_face(a["vertices"][i], face(b, j), w))
    flip = np.array([1.0, -1.0, 1.0])  # a mirror in which the other turns forwards
    keep(corners(q, p, flip), lambda i, j: vertex_face(b["vertices"][i], face(a, j), back))
    f, g = turned_dot(p.along, np.cross(q.start, q.along)), turned_dot(np.cross(p.start, p.along), q.along)
    lengths = [np.sqrt((one.along ** 2).sum(axis=1)) for one in (p, q)]
    keep(earliest(tuple(x + y for x, y in zip(f, g)), lengths[0][:, None] * lengths[1][None],
                  p.start + p.along / 2, lengths[0] / 2, q.start + q.along / 2, lengths[1] / 2),
         lambda i, j: edge_edge(edge(a, p, i), edge(b, q, j), w))
    return sorted(found, key=lambda one: one[0])


def pierced_at_start(a, b):
    for one, other in ((a, b), (b, a)):
        at = np.array(other["vertices"], float)[np.array(other["faces"])]
        low, high = at.min(axis=1) * (1 - 1e-12) - 1e-9, at.max(axis=1)
        for f in one["faces"]:
            own = [one["vertices"][v] for v in f]
            near = np.flatnonzero((low <= np.max(own, axis=0)).all(axis=1) & (high >= np.min(own, axis=0)).all(axis=1))
            for j in near:
                face = tuple(other["vertices"][v] for v in other["faces"][j])
                if any(pierces(*side, face) for side in edges_of(own)):
                    return True
    return False


def first_meeting(a, b, w):
    if pierced_at_start(a, b):
        return ZERO
    best, until = None, float("inf")
    for bound, ask, i, j in candidates(a, b, w):
        if bound > until + 1e-6:
            break
        s = ask(i, j)
        if s is not None and (best is None or s < best):
            best, until = s, float(angle(w, s))
    return best


def drawn(random, family):
    while True:
        a, b, w, m, n, *gap = family(random)
        fine = FINE if gap and any(gap[0]) else 0
        fine = random.randint(8, fine) if fine else 0
        k = (n * n + m * m * dot(w, w)) << fine
        a = mesh(scaled_back(a["vertices"], w, m, n, fine), a["faces"])
        b = moved(b, gap[0] if fine else (0, 0, 0), k)
        if not fits(a["vertices"] + b["vertices"]):
            continue
        s = first_meeting(a, b, w)
        if s is not None and angle(w, s) > CLEAR or (s is not None and not ZERO < s) != (family is at_start):
            continue
        if (family is never) != (s is None) and family in (never, door, bump_under_a_wedge):
            continue
        return {"family": family.__name__, "axis": w, "a": a, "b": b, "first": s}


def scaled_back(points, w, m, n, fine):
    return [times(1 << fine, x) for x in turned_back(points, w, m, n)]


def meshes(random, count):
    for k in range(count):
        yield drawn(random, FAMILIES[k % len(FAMILIES)])
