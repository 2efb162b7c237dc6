# SPDX-License-Identifier: GPL-3.0-or-later
"""What the figures of the conchoid share: the curve from data/conchoid_curve.csv, drawn with its axis upright and
its apex at the bottom, as the thesis' claims about "bottom" and "top" read."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common

RIM_DEG = 90  # the cap of the hip ends here
CURVE, SECOND = common.COLOURS[0], common.COLOURS[1]
ADJUSTED = {
    "thesis_deg": "Eq. 16 with 3.03 and 4.29",
    "closed_form_deg": "Eq. 16 unrounded",
    "exact_deg": "exact length",
}
LOOKS = dict(zip(ADJUSTED, list(common.look(["original", *ADJUSTED]).values())[1:]))


def load(results: Path) -> pd.DataFrame:
    """The meridian from apex to 180 degrees; the column `down` is the height in a drawing, with the apex lowest."""
    curve = common.load(results, "conchoid_curve")
    return curve.assign(up_mm=-curve.z_mm)


def cap(curve: pd.DataFrame) -> pd.DataFrame:
    """The part of the curve from apex to rim."""
    return curve[curve.phi_deg <= RIM_DEG]


def at(curve: pd.DataFrame, phi_deg: np.ndarray, column: str) -> np.ndarray:
    """The values of a column at any polar angles."""
    return np.interp(phi_deg, curve.phi_deg, curve[column])


def point(curve: pd.DataFrame, phi_deg: float) -> np.ndarray:
    """Where a ray from the conchoid's origin meets the curve, in a drawing."""
    return np.array([at(curve, phi_deg, "x_mm"), at(curve, phi_deg, "up_mm")])


def plane(axes: plt.Axes) -> None:
    """Axes with equal scales in mm and little frame."""
    axes.set_aspect("equal")
    axes.set(xlabel="distance from the axis, mm", ylabel="along the axis, mm")


def draw_axis(axes: plt.Axes, low: float, high: float) -> None:
    """Draws the rotation axis."""
    axes.plot([0, 0], [low, high], color="#555555", linestyle="-.", linewidth=0.9)


def draw_both_sides(axes: plt.Axes, curve: pd.DataFrame, **look) -> None:
    """Draws the meridian and its mirror image as one line."""
    x = np.concatenate([-curve.x_mm[::-1], curve.x_mm])
    axes.plot(x, np.concatenate([curve.up_mm[::-1], curve.up_mm]), **look)


def rays(axes: plt.Axes, curve: pd.DataFrame, angles_deg: np.ndarray, **look) -> None:
    """Draws rays from the conchoid's origin to the curve, with one label for all."""
    for k, phi in enumerate(angles_deg):
        axes.plot(
            *np.array([[0, 0], point(curve, phi)]).T, **{**look, "label": look.get("label") if k == 0 else None}
        )


def space(figure: plt.Figure, place: tuple[int, int, int], reach: float) -> plt.Axes:
    """Three-dimensional axes without a frame, with equal scales."""
    axes = figure.add_subplot(*place, projection="3d")
    axes.set_box_aspect((1, 1, 1), zoom=1.5)
    axes.view_init(elev=20, azim=-62)
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach), zlim=(-reach * 1.5, reach * 0.5))
    axes.set_axis_off()
    return axes


def turned(curve: pd.DataFrame, theta_deg: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The meridian in the half plane of theta. The apex, on +z, is drawn lowest, so +y is drawn towards -y: the frame stays
    right-handed.
    """
    theta = np.radians(theta_deg)
    x = curve.x_mm.to_numpy()
    return x * np.cos(theta), -x * np.sin(theta), curve.up_mm.to_numpy()


def finest_rays(results: Path) -> pd.DataFrame:
    """The rows with most rays in data/conchoid_angles.csv, with their three adjustments."""
    angles = common.load(results, "conchoid_angles")
    return angles[angles.rays == angles.rays.max()].set_index("i")


def adjusted(column: str) -> dict:
    """Colour and dashes for an adjustment."""
    return {key: LOOKS[column][key] for key in ("color", "linestyle")}
