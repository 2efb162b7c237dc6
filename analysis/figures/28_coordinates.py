# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-28
# @question  A vertex of a socket in spherical coordinates (Figure 28).
# @data      diagram_corners
"""Figure 28: the spherical coordinates of a point of a socket."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import diagram, sphere_view

EYE = diagram.Eye(sphere_view.view(20, 60))
FACE, CORNER = "plain", 2


def main(options) -> common.Figure:
    corners = common.load(options.results, "diagram_corners")
    corner = corners[(corners.name == FACE) & (corners.corner == CORNER)].iloc[0]
    figure, (axes, words) = plt.subplots(1, 2, figsize=(7.4, 3.9), width_ratios=[1.25, 1])
    draw_sphere(axes, corner)
    draw_angles(axes, corner)
    write_equations(words, corner)
    figure.suptitle(f"A vertex of a socket in spherical coordinates ({diagram.HIP})", fontsize=10.5)
    figure.subplots_adjust(left=0.01, right=0.99, top=0.92, bottom=0.01, wspace=0.0)
    return figure


def arc(phi: tuple[float, float], theta: tuple[float, float], radius: float) -> np.ndarray:
    """Points of a curve with angles between two pairs, degrees."""
    share = np.linspace(0, 1, 60)
    return radius * diagram.direction(phi[0] + share * (phi[1] - phi[0]), theta[0] + share * (theta[1] - theta[0]))


def draw_sphere(axes: plt.Axes, corner: pd.Series) -> None:
    """The sphere of the vertex, its equator and meridians, and the three axes."""
    radius = corner.radius_mm
    for theta in np.arange(0, 360, 30):
        axes.plot(*EYE.see(arc((0, 180), (theta, theta), radius)).T, color=common.THESIS_GREY, linewidth=0.4, zorder=1)
    for phi in np.arange(30, 180, 30):
        look = {"color": "#707070", "linewidth": 1.0} if phi == 90 else {"color": common.THESIS_GREY, "linewidth": 0.4}
        axes.plot(*EYE.see(arc((phi, phi), (0, 360), radius)).T, zorder=1, **look)
    for axis, name in zip(np.eye(3), ("x", "y", "z, φ = 0°")):
        diagram.arrow(axes, (0, 0), EYE.see(1.32 * radius * axis), name)
    circle = np.linspace(0, 2 * np.pi, 9)[:, None]
    diagram.frame(axes, 1.36 * radius * np.hstack([np.cos(circle), np.sin(circle)]), room=0.0)


def draw_angles(axes: plt.Axes, corner: pd.Series) -> None:
    """The vertex, its shadow on the plane z = 0, both angles and the distance."""
    phi, theta, radius = corner.phi_deg, corner.theta_deg, corner.radius_mm
    point = np.array([corner.x, corner.y, corner.z])
    shadow = point * [1, 1, 0]
    at, below = EYE.see(point), EYE.see(shadow)
    for tail, tip in (((0, 0), below), (below, at)):
        axes.plot(*np.array([tail, tip]).T, color="#707070", linewidth=1.0, linestyle="--", zorder=3)
    diagram.arrow(axes, (0, 0), at, color=diagram.POLE, linewidth=2)
    diagram.dots(axes, at[None], color=diagram.POLE, markersize=7)
    diagram.dots(axes, np.zeros((1, 2)), marker="s", markersize=7)
    for curve, word, colour, away in (
        (arc((0, phi), (theta, theta), 0.5 * radius), "φ", common.COLOURS[0], 1.22),
        (arc((90, 90), (0, theta), 0.42 * radius), "θ", common.COLOURS[2], 1.3),
    ):
        seen = EYE.see(curve)
        axes.plot(*seen.T, color=colour, linewidth=1.8, zorder=4)
        diagram.arrow(axes, seen[-4], seen[-1], color=colour, linewidth=1.8)
        diagram.note(axes, away * seen[30], word, fontsize=13, color=colour)
    diagram.note(axes, 0.62 * at, "d", (10, -6), fontsize=13, color=diagram.POLE)
    diagram.note(axes, at, "v = (x, y, z)", (12, 12), fontsize=10)
    diagram.note(axes, (0, 0), "centre of\nrotation", (-34, 8), fontsize=8.5)


def write_equations(axes: plt.Axes, corner: pd.Series) -> None:
    """Both ways of Eq. 5 and 6, with the numbers of this vertex."""
    axes.axis("off")
    lines = [
        ("Cartesian, mm", "bold"),
        (f"x = d sin φ cos θ = {corner.x:.2f}", "normal"),
        (f"y = d sin φ sin θ = {corner.y:.2f}", "normal"),
        (f"z = d cos φ = {corner.z:.2f}", "normal"),
        ("", "normal"),
        ("Spherical", "bold"),
        (f"d = √(x² + y² + z²) = {corner.radius_mm:.2f} mm", "normal"),
        (f"θ = atan2(y, x) = {corner.theta_deg:.2f}°", "normal"),
        (f"φ = arccos(z / d) = {corner.phi_deg:.2f}°", "normal"),
        ("", "normal"),
        ("In the table", "bold"),
        ("LUT[row][column], at 1°", "normal"),
        (f"row φ / 1° = {corner.phi_deg:.2f}", "normal"),
        (f"column θ / 1° = {corner.theta_deg:.2f}", "normal"),
        ("so it lies between four entries", "normal"),
    ]
    for k, (text, weight) in enumerate(lines):
        axes.text(
            0.06,
            0.96 - 0.065 * k,
            text.replace("-", "−"),
            transform=axes.transAxes,
            fontsize=9.5,
            weight=weight,
            va="top",
        )


common.run(main)
