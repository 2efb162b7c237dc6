# SPDX-License-Identifier: GPL-3.0-or-later
"""The colours of a gap, as in the scene (libcore/hip/gap_levels.hpp): the thesis' five, darker towards contact, so that a
picture reads in grey and with every common colour vision.
"""

from dataclasses import dataclass

import numpy as np
from matplotlib.patches import Patch
from vtkmodules.vtkRenderingCore import vtkActor

import common
from common import hip, panels, ply, render

SHADES = 4096  # entries of a colour table: so finely are thresholds resolved


@dataclass(frozen=True)
class Colours:
    """Upper ends of the levels in mm, the last one infinite; the colour of each level and of no gap, from 0 to 1."""

    upper: np.ndarray
    rgb: np.ndarray
    nothing: np.ndarray


def colours_of(summary: dict, part: str) -> Colours:
    """The levels that the scene used for the ball or the socket."""
    levels = summary["colours"][part]
    upper = [np.inf if level["up_to"] is None else level["up_to"] for level in levels]
    return Colours(
        np.array(upper),
        np.array([level["rgb"] for level in levels]) / 255,
        np.array(summary["colours"]["no_gap_rgb"]) / 255,
    )


def shades(colours: Colours) -> render.Shades:
    """The colours in steps so fine that thresholds appear where they are."""
    limits = (-1.0, float(colours.upper[-2]) + 1.0)
    level = np.searchsorted(colours.upper, np.linspace(*limits, SHADES))
    return render.Shades(colours.rgb[level], limits, tuple(colours.nothing))


def coloured(mesh: ply.Mesh, colours: Colours, opacity: float = 1.0) -> vtkActor:
    """The mesh with the colours of its gap."""
    return render.scalar_surface(mesh, mesh.properties["gap"], shades(colours), opacity)


def of_part(joint, part: str, opacity: float = 1.0) -> vtkActor:
    """The ball or the socket of a hip.Hip in the colours of its scene."""
    return coloured(getattr(joint, part), colours_of(joint.summary, part), opacity)


def both(joint) -> list[vtkActor]:
    """Ball and socket, each in its colours."""
    return [of_part(joint, part) for part in ("ball", "socket")]


def legend(summary: dict, parts: tuple[str, ...] = ("ball", "socket")) -> list[Patch]:
    """The legend, from contact outwards; the last colour differs between ball and socket."""
    first = colours_of(summary, parts[0])
    patches = [Patch(color=first.rgb[0], label="bones touch or overlap")]
    for low, high, colour in zip(first.upper, first.upper[1:-1], first.rgb[1:-1]):
        patches.append(Patch(color=colour, label=f"{low:.2g} to {high:.2g} mm"))
    for part in parts:
        colours = colours_of(summary, part)
        patches.append(Patch(color=colours.rgb[-1], label=f"{part}, over {colours.upper[-2]:.2g} mm"))
    return [*patches, Patch(color=first.nothing, label="no surface opposite")]


def add_legend(figure, summary: dict, parts: tuple[str, ...] = ("ball", "socket")) -> None:
    """Adds the legend at the foot of a sheet of panels.py, with the meaning of the letters in the panels."""
    box = figure.legend(
        handles=legend(summary, parts),
        loc="lower center",
        ncol=3 if figure.get_figwidth() > 6 else 2,
        title=panels.wrapped(figure, f"gap, mm (radial)      {hip.WAYS}"),
        title_fontsize=common.SMALL,
        fontsize=common.SMALL,
    )
    box.get_title().set_multialignment("center")
