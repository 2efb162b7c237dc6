# SPDX-License-Identifier: GPL-3.0-or-later
"""When two features first meet while one turns about an axis through the origin, in integers alone.

The axis is w, integers; s = tan(angle / 2) / |w|. With W = w . w, a point x that has turned is
    R x = ((1 - W s^2) x + 2 s (w x x) + 2 s^2 (w . x) w) / (1 + W s^2),
so every condition on turned and fixed points that is linear in R is a quadratic in s with integer coefficients. Its roots
are (p + q sqrt(d)) / r, and the sign of another quadratic there is that of u + v sqrt(d): no digit is ever rounded.
Features are closed: a point, an edge or a triangle, as tuples of points. Angles are below half a turn.
"""
from decimal import Decimal, localcontext
from math import isqrt
from typing import NamedTuple

UNITS = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def add(a, b, times=1):
    return (a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def sign(a):
    return (a > 0) - (a < 0)


def sign_with_root(a, b, d):
    """Of a + b sqrt(d)."""
    first, second = sign(a), sign(b) if d else 0
    if first * second >= 0:
        return first or second
    return first * sign(a * a - b * b * d)


class Root(NamedTuple):
    """(p + q sqrt(d)) / r, r > 0."""
    p: int
    q: int = 0
    d: int = 0
    r: int = 1

    def __lt__(self, other):
        a = self.p * other.r - other.p * self.r
        b, c = self.q * other.r, -other.q * self.r
        first, second = sign_with_root(a, b, self.d), sign(c) if other.d else 0
        if first * second < 0:  # the larger square decides
            first *= sign_with_root(a * a + b * b * self.d - c * c * other.d, 2 * a * b, self.d)
            return first < 0
        return (first or second) < 0


ZERO = Root(0)


def angle(w, s):
    """2 atan(|w| s) to 25 digits behind the point."""
    with localcontext() as context:
        context.prec = 100
        t = (Decimal(s.p) + s.q * Decimal(s.d).sqrt()) / s.r * Decimal(dot(w, w)).sqrt()
        halvings = 8
        for _ in range(halvings):
            t = t / (1 + (1 + t * t).sqrt())
        total, power, k = Decimal(0), t, 1
        while power and abs(power) > Decimal(10) ** -45:
            total += power / k if k % 4 == 1 else -power / k
            power, k = power * t * t, k + 2
        return (total * 2 ** (halvings + 1)).quantize(Decimal(10) ** -25)


class Quadratics:
    """Quadratics (c0, c1, c2) in s, of a turn about w, all times 1 + W s^2."""

    def __init__(self, w):
        self.w, self.square = w, dot(w, w)

    def turned(self, x, b, constant=0):
        """R x . b + constant."""
        k, along = dot(x, b), 2 * dot(self.w, x) * dot(self.w, b)
        return (k + constant, 2 * dot(b, cross(self.w, x)), along - self.square * (k - constant))


def roots(f):
    """Those that are not negative."""
    c, b, a = f
    if a == 0:
        found = [Root(-c if b > 0 else c, 0, 0, abs(b))] if b else []
    else:
        p, r, d = (-b, 2 * a, b * b - 4 * a * c) if a > 0 else (b, -2 * a, b * b - 4 * a * c)
        if d < 0:
            return []
        e = isqrt(d)
        found = [Root(p - e, 0, 0, r), Root(p + e, 0, 0, r)] if e * e == d else [Root(p, -1, d, r), Root(p, 1, d, r)]
    return [s for s in found if sign_with_root(s.p, s.q, s.d) >= 0]


def sign_at(f, s):
    c, b, a = f
    return sign_with_root(c * s.r * s.r + b * s.r * s.p + a * (s.p * s.p + s.q * s.q * s.d),
                          b * s.r * s.q + 2 * a * s.p * s.q, s.d)


def vertex_face(x, face, w):
    """The first s at which the point, which turns about w, is in the triangle; or None."""
    of = Quadratics(w)
    n = cross(sub(face[1], face[0]), sub(face[2], face[0]))
    f = of.turned(x, n, -dot(n, face[0]))
    sides = []
    for k in range(3):
        inwards = cross(n, sub(face[(k + 1) % 3], face[k]))
        sides.append(of.turned(x, inwards, -dot(inwards, face[k])))
    # A point that stays in the plane comes into the triangle across a side.
    tried = roots(f) if any(f) else [ZERO] + [s for side in sides for s in roots(side)]
    for s in sorted(tried):
        if all(sign_at(side, s) >= 0 for side in sides):
            return s
    return None


def edge_edge(x, y, w):
    """The first s at which the edge x, which turns about w, has a point of y; or None."""
    of = Quadratics(w)
    d, e = sub(x[1], x[0]), sub(y[1], y[0])
    f = tuple(map(sum, zip(of.turned(d, cross(y[0], e)), of.turned(cross(x[0], d), e))))
    across, first, second = [], [], []  # R d x e; of the crossing on x and on y, times it
    for k, unit in enumerate(UNITS):
        across.append(of.turned(d, cross(e, unit)))
        first.append(tuple(-c for c in of.turned(x[0], cross(e, unit), -cross(y[0], e)[k])))
        second.append(tuple(a - b for a, b in zip(of.turned(d, cross(unit, y[0])), of.turned(cross(x[0], d), unit))))

    def meets(s):
        for k in range(3):
            side = sign_at(across[k], s)
            if side:
                rest = [tuple(a - b for a, b in zip(across[k], share[k])) for share in (first, second)]
                return all(side * sign_at(g, s) >= 0 for g in (first[k], second[k], *rest))
        if any(sign_at(g, s) for g in first):
            return False  # parallel, apart
        low, high = ([sign_at(of.turned(p, e, -dot(end, e)), s) for p in x] for end in y)
        return max(low) >= 0 and min(high) <= 0

    if any(f):
        tried = roots(f)
    else:  # in one plane all the time: an end of one comes into the other
        ends = [tuple(a - b for a, b in zip(across[k], share[k])) for share in (first, second) for k in range(3)]
        tried = [ZERO] + [s for g in (*across, *first, *second, *ends) if any(g) for s in roots(g)]
    for s in sorted(tried):
        if meets(s):
            return s
    return None


def side_of(a, b, c, x):
    return sign(dot(cross(sub(b, a), sub(c, a)), sub(x, a)))


def pierces(p, q, face):
    """Does the edge p q cross the triangle, its ends on either side of it?"""
    if side_of(*face, p) * side_of(*face, q) >= 0:
        return False
    around = {side_of(p, q, face[k], face[(k + 1) % 3]) for k in range(3)}
    return not {1, -1} <= around


def edges_of(points):
    return [(points[0], points[1]), (points[1], points[2]), (points[2], points[0])] if len(points) == 3 else [points]


def least(a, b):
    return b if a is None or (b is not None and b < a) else a


def first_meeting(turning, resting, w):
    """The first s at which two features have a common point: two triangles, two edges, or a point and a triangle."""
    back = tuple(-c for c in w)
    if len(turning) == 1:
        return vertex_face(turning[0], resting, w)
    if len(resting) == 1:
        return vertex_face(resting[0], turning, back)
    if len(turning) == 2:
        return edge_edge(turning, resting, w)
    if any(pierces(*edge, b) for a, b in ((turning, resting), (resting, turning)) for edge in edges_of(a)):
        return ZERO
    found = None
    for x in turning:
        found = least(found, vertex_face(x, resting, w))
    for y in resting:
        found = least(found, vertex_face(y, turning, back))
    for x in edges_of(turning):
        for y in edges_of(resting):
            found = least(found, edge_edge(x, y, w))
    return found
