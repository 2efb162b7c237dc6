# SPDX-License-Identifier: GPL-3.0-or-later
# @name      figure-29
# @question  Spherical, near-spherical and star-shaped bodies, and one that is none of them (Figure 29).
# @data      diagram_sections diagram_rays diagram_bodies
"""Figure 29: spherical, near-spherical and star-shaped bodies, and one that is none of them."""

import matplotlib.pyplot as plt
import numpy as np

import common
from common import diagram, diagram_section

BODIES = {
    "sphere": ("a) sphere", (-30, -30, 30, 30)),
    "near_spherical": ("b) near-spherical:\na head with a cam of 3 mm", (-30, -30, 30, 30)),
    "star_shape": ("c) star-shaped:\nhead and neck of a hip", (-30, -58, 62, 34)),
    "femur": ("d) not star-shaped:\nthe same with its shaft", (-30, -96, 62, 34)),
}
SPAN = 0.05  # mm: rays whose first and last crossing are farther apart meet the surface twice


def main(options) -> common.Figure:
    sections, rays, bodies = (
        common.load(options.results, f"diagram_{name}") for name in ("sections", "rays", "bodies")
    )
    bodies = bodies.set_index("name")
    figure, panels = plt.subplots(1, 4, figsize=(9.2, 3.7))
    for axes, (name, (title, window)) in zip(panels, BODIES.items()):
        draw(axes, sections, rays, name)
        left, bottom, right, top = window
        diagram.frame(axes, np.array([(-right, bottom), (-left, top)]), room=0.0)
        diagram.title(axes, title)
        facts = bodies.loc[name]
        low, high = (f"{mm:.1f}" for mm in (facts.smallest_mm, facts.largest_mm))
        span = f"d = {low} mm" if low == high else f"d from {low} to {high} mm"
        met = (
            "by all rays met once"
            if facts.star_shaped
            else f"{100 * facts.violating:.1f} % of all rays meet it again"
        )
        axes.text(0.5, -0.02, f"{span}\n{met}", transform=axes.transAxes, ha="center", va="top", fontsize=8.5)
    handles = [
        common.key("sample point", color=diagram.POINT, marker="o", markersize=4, linestyle="none"),
        common.key(
            "last of several crossings: no single distance",
            color=diagram.POLE,
            marker="D",
            markersize=5,
            linestyle="none",
        ),
        common.key("centre", color=diagram.INK, marker="s", linestyle="none"),
    ]
    figure.legend(handles=handles, loc="lower center", ncol=3, fontsize=8.5)
    figure.suptitle("Which surfaces have one distance in every direction? (sections of meshes)", fontsize=10.5)
    figure.subplots_adjust(left=0.005, right=0.995, top=0.80, bottom=0.22, wspace=0.04)
    return figure


def draw(axes: plt.Axes, sections, rays, name: str) -> None:
    """Section, rays and their crossings."""
    diagram_section.section(axes, sections, name, fill=diagram.FILL["ball"], colors=diagram.BALL)
    nearest, farthest = (diagram_section.in_section(rays, name, column) for column in ("nearest_mm", "farthest_mm"))
    for first, last in zip(nearest, farthest):
        axes.plot(*np.array([(0, 0), last]).T, color="#8a8a8a", linewidth=0.5, zorder=2)
    twice = np.linalg.norm(farthest - nearest, axis=1) > SPAN
    diagram.dots(axes, nearest, markersize=2.6)
    diagram.dots(axes, farthest[twice], marker="D", markersize=4.5, color=diagram.POLE)
    diagram.dots(axes, np.zeros((1, 2)), marker="s", markersize=5)


common.run(main)
