# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of features, from easy to degenerate. Each family draws two features of small integers in the pose in which they
are to meet, and turns the first one back: a rotation by s = m / n about an integer axis is an integer matrix over
n^2 + m^2 W, by which all is multiplied. So degenerate contacts are exact. What is drawn is asked for its first meeting
(exact.py), and drawn again where it is not what the family is for.
"""
from exact import ZERO, add, angle, cross, dot, first_meeting, Root

KINDS = ("vertex_face", "edge_edge", "face_face")
LARGEST = 3.0  # radians that a query asks for
CLEAR = 2.9    # no first meeting is later


def axis(random):
    if random.random() < 0.4:
        w = [0, 0, 0]
        w[random.randrange(3)] = random.choice((1, -1))
        return tuple(w)
    w = tuple(random.randint(-3, 3) for _ in range(3))
    return w if any(w) else axis(random)


def vector(random, size=9):
    v = tuple(random.randint(-size, size) for _ in range(3))
    return v if any(v) else vector(random, size)


def across(random, w, size=3):
    """A vector at right angles to w."""
    v = cross(w, vector(random, size))
    return v if any(v) else across(random, w, size)


def times(k, v):
    return (k * v[0], k * v[1], k * v[2])


def turned_back(points, w, m, n):
    """R^T x (n^2 + m^2 W)."""
    W = dot(w, w)
    out = []
    for x in points:
        y = add(times(n * n - m * m * W, x), cross(w, x), -2 * m * n)
        out.append(add(y, w, 2 * m * m * dot(w, x)))
    return tuple(out)


class Draw:
    """Two features in their contact pose, about a point p and along directions u and v."""

    def __init__(self, random, w, kind):
        self.random, self.w, self.kind = random, w, kind
        self.p = vector(random, 12)
        self.u, self.v, self.t = (vector(random) for _ in range(3))
        self.end = False  # is p a corner or on a side?
        self.flat = False  # are both faces in the plane of u and v?
        self.on_axis = None  # a point there that is to be a corner
        self.whole = (0, 0, 0)  # shift of the resting feature, after all is scaled by 2^fine
        self.fine = 0

    def count(self):
        return self.random.randint(1, 4)

    def face_about(self, u, v):
        """A triangle that holds p: inside, or, at an end, on a side or in a corner."""
        corner = self.end and self.random.random() < 0.5
        first = self.p if corner else add(self.p, u, -self.count())
        if not self.end:
            first = add(first, v, -1)
        return (first, add(add(self.p, u, self.count()), v, 0 if self.end else -1), add(self.p, v, self.count()))

    def edge_about(self, u):
        start = self.p if self.end and self.random.random() < 0.5 else add(self.p, u, -self.count())
        return (start, add(self.p, u, self.count()))

    def features(self):
        """u and v span the face; the edges are along u and v, and t is apart."""
        if self.kind == "vertex_face":
            a, b = (self.p,), self.face_about(self.u, self.v)
        elif self.kind == "edge_edge":
            a, b = self.edge_about(self.u), self.edge_about(self.v)
        elif self.flat:
            a = self.face_about(self.u, self.v)
            b = self.face_about(self.t, add(self.v, self.u, self.random.choice((-1, 1))))
        elif self.random.random() < 0.5:
            a, b = (self.edge_about(w) + (add(self.p, self.t, side * self.count()),)
                    for w, side in ((self.u, 1), (self.v, -1)))
        else:
            tip = [add(self.p, self.t, self.count()), add(self.p, vector(self.random), self.count())]
            a, b = (self.p, *tip), self.face_about(self.u, self.v)
        return (a, b) if self.random.random() < 0.5 else (b, a)


def scaled(points, k, shift=(0, 0, 0)):
    return tuple(add(shift, x, k) for x in points)


def with_area(points):
    """No edge without length, no triangle without area."""
    if len(points) == 3:
        return any(cross(add(points[1], points[0], -1), add(points[2], points[0], -1)))
    return len(set(points)) == len(points)


def before(s, other):
    return s is not None and s < other


# What a family makes of a draw. It returns True if what it draws is to be the first contact, False if there is to be
# none, None if there may be any or none.

def plain(draw):
    return None


def never(draw):
    draw.whole = vector(draw.random, 3 if draw.random.random() < 0.5 else 20)
    return False


def graze(draw):
    """The velocity w x p of what touches is in the plane of contact: a double root."""
    draw.v = cross(draw.w, draw.p)
    if draw.random.random() < 0.5:
        draw.v = add(draw.v, draw.u)
    return True


def near_graze(draw):
    """Past a graze by 2^-10 to 2^-36 of what is drawn, or into it by as much."""
    graze(draw)
    n = cross(draw.u, draw.v)
    draw.fine = draw.random.randint(10, 36)
    draw.whole = times(draw.random.choice((1, -1)), n)
    return None


def parallel(draw):
    """Edges that are parallel when they touch, or nearly; a face with a side along the axis."""
    if draw.random.random() < 0.25:
        draw.u = times(draw.count(), draw.w)  # parallel all the time
    if draw.kind == "vertex_face":
        draw.u = draw.w
        return True
    draw.t = draw.v
    draw.v = times(draw.random.choice((1, -1, 2)), draw.u)
    if draw.random.random() < 0.3:
        draw.fine = draw.random.randint(8, 24)
        draw.whole = vector(draw.random, 2)
        return None
    return True


def coplanar(draw):
    """In one plane all the time, across the axis."""
    draw.u, draw.v, draw.t = (across(draw.random, draw.w) for _ in range(3))
    draw.flat = True
    return None


def landing(draw):
    """A plane through the axis lands flat on one at rest."""
    draw.p = add(times(draw.count(), draw.w), vector(draw.random), draw.count())
    draw.u, draw.v = draw.p, add(times(draw.count(), draw.w), draw.p, draw.random.randint(-2, 2))
    draw.t = add(draw.v, draw.u, draw.random.randint(-2, 2))
    draw.flat = True
    return True


def corner(draw):
    draw.end = True
    return True


def start(draw):
    draw.end = draw.random.random() < 0.5
    if draw.random.random() < 0.3:
        graze(draw)
    elif draw.random.random() < 0.2:
        parallel(draw)
        draw.fine, draw.whole = 0, (0, 0, 0)
    return True


def tiny(draw):
    """A millionth of the radius."""
    draw.p = times(draw.random.randint(100_000, 200_000), draw.p)
    if draw.random.random() < 0.5:
        draw.p = add(draw.p, vector(draw.random))
    if draw.random.random() < 0.3:
        draw.end = True
    draw.u, draw.v, draw.t = (vector(draw.random, 3) for _ in range(3))
    return None


def sliver(draw):
    """Long and thin, edges nearly parallel."""
    draw.v = add(vector(draw.random, 2), draw.u, 10 ** draw.random.randint(2, 5))
    draw.p = times(10 ** 5, draw.p)
    return None


def on_axis(draw):
    """A corner, or an end, is on the axis."""
    draw.p = add(times(draw.random.randint(-4, 4), draw.w), vector(draw.random), draw.count())
    k = draw.random.randint(-3, 3)
    draw.u = add(draw.p, draw.w, -k)
    draw.on_axis = times(k, draw.w)
    return None


FAMILIES = (plain, never, graze, near_graze, parallel, coplanar, landing, corner, start, tiny, sliver, on_axis)
AT_START = (start, coplanar, on_axis)  # may touch at angle 0


def attempt(random, kind, family):
    w = axis(random)
    draw = Draw(random, w, kind)
    wanted = family(draw)
    a, b = draw.features()
    if draw.on_axis and len(a) > 1:
        a = (draw.on_axis, *a[1:])
    m, n = (0, 1) if family is start else (random.randint(1, 4), random.randint(1, 6))
    k = (n * n + m * m * dot(w, w)) << draw.fine
    if family is never:
        draw.whole = times(k, draw.whole)
    a, unmoved = scaled(turned_back(a, w, m, n), 1 << draw.fine), scaled(b, k)
    b = scaled(b, k, draw.whole)
    if not (with_area(a) and with_area(b)):
        return None
    if family is near_graze and before(first_meeting(a, unmoved, w), Root(m, 0, 0, n)):
        return None
    s = first_meeting(a, b, w)
    if wanted is False and s is not None:
        return None
    if wanted is True and (s is None or before(s, Root(m, 0, 0, n))):
        return None
    if s is not None and (angle(w, s) > CLEAR or (family not in AT_START and not ZERO < s)):
        return None
    return {"kind": kind, "family": family.__name__, "axis": w, "a": a, "b": b, "first": s}


def pair(random, kind, family):
    while True:
        drawn = attempt(random, kind, family)
        if drawn and fits(drawn["a"] + drawn["b"]):
            return drawn


def fits(points):
    """Are all coordinates doubles?"""
    return all(c == int(float(c)) for x in points for c in x)


def pairs(random, count):
    groups = [(kind, family) for family in FAMILIES for kind in KINDS]
    for k in range(count):
        yield pair(random, *groups[k % len(groups)])
