# SPDX-License-Identifier: GPL-3.0-or-later
"""Gaps, contact and limits of ball-and-socket joints. Lengths in mm, angles in degrees; radial gaps along directions
from the centre of rotation, negative where bones overlap. Research software: not for the treatment of a patient."""
from impinge._impinge import (
    FileError,
    Joint,
    Scheme,
    Surface,
    __version__ as __version__,
    hip_parameter_ranges,
    hip_parameters,
    hip_presets,
    schemes,
)

__all__ = [
    "FileError",
    "Joint",
    "Scheme",
    "Surface",
    "hip_parameter_ranges",
    "hip_parameters",
    "hip_presets",
    "schemes",
]
