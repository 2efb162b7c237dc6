# SPDX-License-Identifier: GPL-3.0-or-later
"""A joint for its pictures: the meshes of scenes/NAME in the joint frame (x right, y anterior, z superior, mm, the
centre of rotation as origin), the anatomical views, and what a reader must be told about the joint.
"""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import common
from common import ply, render, summaries

WAYS = "A anterior, P posterior, S superior, I inferior, R and L the patient's right and left"
PIXELS = 560  # a side of one view
DIRECTIONS = {
    "R": (1, 0, 0),
    "L": (-1, 0, 0),
    "A": (0, 1, 0),
    "P": (0, -1, 0),
    "S": (0, 0, 1),
    "I": (0, 0, -1),
}

NEAR = 46.0  # mm: head and neck, but not the shaft

# Bone of the ball and of the socket where no gap is shown.
BALL = (0.93, 0.87, 0.74)
SOCKET = (0.62, 0.76, 0.90)

# What stands for the patients of the thesis: said in each picture.
STAND_INS = {"patient_a": "patient A", "patient_b": "patient B"}


@dataclass(frozen=True)
class Hip:
    """Meshes with their gaps, and the summary of the scene that made them."""

    name: str
    side: str  # right or left
    ball: ply.Mesh
    socket: ply.Mesh
    summary: dict

    @property
    def outwards(self) -> float:
        """The direction of x that is lateral."""
        return 1.0 if self.side == "right" else -1.0


def to_joint(points: np.ndarray, summary: dict) -> np.ndarray:
    """Points (n, 3) of the input frame of a scene."""
    centre = np.array([summary["centre"][axis] for axis in "xyz"])
    turn = np.array([DIRECTIONS[letter] for letter in summary["axes"]], dtype=float)
    return (points - centre) @ turn


def load(results: Path, scene: str) -> Hip:
    """Loads scenes/SCENE. A scene that does not know its side is shown as a right joint."""
    folder = results / "scenes" / scene
    summary = summaries.read(folder)

    def seen(part: str) -> ply.Mesh:
        mesh = ply.read(folder / f"{part}.ply")
        return replace(mesh, vertices=to_joint(mesh.vertices, summary))

    return Hip(scene, summary["side"] or "right", seen("ball"), seen("socket"), summary)


def title(name: str) -> str:
    """The name of the joint NAME for a reader, or of its scene NAME-MOTION."""
    joint = name.split("-")[0]
    if joint in STAND_INS:
        return f"Generated stand-in for {STAND_INS[joint]}, whose scan is not public"
    return f"Real joint {joint.replace('_', ' ')}"


def pose(joint: Hip) -> str:
    """The pose of a scene, in words."""
    text = joint.summary["pose"].replace("=", " ").replace("_", " ").replace(",", "°, ")
    if "=" in joint.summary["pose"]:
        return f"{text}°"
    return "as modelled" if joint.name.split("-")[0] in STAND_INS else "as scanned"


def close_zones(summary: dict) -> str:
    """The hours at which the socket's gaps are within the cartilage, in words."""
    level = summary["impingement"][-1]
    found = level["socket"]["clock_zones"]
    if found is None:
        return "no clock positions"
    places = ", ".join("any hour" if zone["clock_from"] == zone["clock_to"] else f"{zone['clock_from']}-{zone['clock_to']}" for zone in found)
    return (
        f"socket within {level['gap_up_to_mm']:g} mm at {places}"
        if places
        else (f"nowhere within {level['gap_up_to_mm']:g} mm")
    )


# Views. Right is the right of the picture.


def looks(outwards: float) -> dict[str, tuple[float, float, float]]:
    """The direction in which the camera of each view looks; `outwards` is the lateral direction of x, 1 for a right hip."""
    return {
        "superior": (0, 0, -1),
        "inferior": (0, 0, 1),
        "anterior": (0, -1, 0),
        "posterior": (0, 1, 0),
        "lateral": (-outwards, 0, 0),
        "medial": (outwards, 0, 0),
        "oblique": (-0.55 * outwards, -0.7, -0.45),
    }


def towards(view: str, joint: Hip) -> tuple[np.ndarray, np.ndarray]:
    """The direction in which the camera of a view looks, and the direction that is up in its picture."""
    look = np.array(looks(joint.outwards)[view], dtype=float)
    look /= np.linalg.norm(look)
    up = np.array([0.0, 1.0, 0.0] if abs(look[2]) == 1.0 else [0.0, 0.0, 1.0])
    return look, up - (up @ look) * look


def view(name: str, joint: Hip, meshes: list[ply.Mesh], pixels: int = PIXELS) -> render.View:
    """The camera of a view, which shows the meshes up to NEAR from the centre."""
    look, up = towards(name, joint)
    up = up / np.linalg.norm(up)
    points = np.vstack([mesh.vertices for mesh in meshes])
    return render.framed(points[np.linalg.norm(points, axis=1) < NEAR], look, up, 0.56, pixels)


def letters(seen: render.View) -> dict[str, str]:
    """The direction of the body to which each side of a picture points: left, right, top, bottom -> letter; none for an
    oblique direction.
    """
    right = np.cross(seen.towards, seen.up)
    ways = {"right": right, "left": -right, "top": seen.up, "bottom": -seen.up}
    return {
        where: letter
        for where, way in ways.items()
        for letter, direction in DIRECTIONS.items()
        if way @ np.array(direction) > 0.9 * np.linalg.norm(way)
    }


# The fitted sphere and the dial.


def sphere_rings(radius: float, count: int = 9) -> list[np.ndarray]:
    """Circles of latitude and longitude about the superior axis."""
    angle = np.linspace(0, 2 * np.pi, 91)[:-1]
    curves = []
    for polar in np.linspace(0, np.pi, count + 2)[1:-1]:
        ring = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
        curves.append(radius * (np.sin(polar) * ring + np.array([0, 0, np.cos(polar)])))
    for turn in np.linspace(0, np.pi, count + 1)[:-1]:
        across = np.array([np.cos(turn), np.sin(turn), 0])
        curves.append(radius * (np.outer(np.cos(angle), across) + np.outer(np.sin(angle), [0, 0, 1])))
    return curves


@dataclass(frozen=True)
class Dial:
    """Clock of the socket in the joint frame, about `middle`, mm."""

    twelve: np.ndarray
    three: np.ndarray
    middle: np.ndarray

    def at(self, hours: float | np.ndarray, radius: float) -> np.ndarray:
        """Points (..., 3) on the dial."""
        angle = np.asarray(hours) * np.pi / 6
        return self.middle + radius * (np.cos(angle)[..., None] * self.twelve + np.sin(angle)[..., None] * self.three)


def dial(joint: Hip) -> Dial:
    """The dial where the socket's rim is widest."""
    found = joint.summary["dial"]
    if found is None:
        raise common.Refused(
            f"scenes/{joint.name}: the socket looks straight up, down, forward or back and has no dial"
        )
    twelve, three = np.array(found["twelve"]), np.array(found["three"])
    axis = np.cross(twelve, three)
    along = joint.socket.vertices @ axis
    towards_rim = along.max() if abs(along.max()) < abs(along.min()) else along.min()
    return Dial(twelve, three, towards_rim * axis)
