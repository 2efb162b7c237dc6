#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gaps, a picture, limits and the motion volume of two meshes: hip.py BALL SOCKET left|right OUT.png, or only OUT.png for a hip
made from parameters."""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import impinge


def load(words):
    if len(words) == 3:
        return impinge.Joint.read(words[0], words[1], side=words[2])
    return impinge.Joint.from_hip("cam", faces=4000)


def first_touch(joint, poses):
    """The angles of the first pose that touches; none if none does."""
    touching = joint.touch(poses)
    return poses[np.argmax(touching)] if touching.any() else None


def picture(joint, pose, path):
    """Draws the ball in this pose, coloured by its gap."""
    gap, _ = joint.gaps(pose)
    matrix = joint.matrices(pose)[0]
    x, y, z = ((joint.ball.vertices + joint.centre) @ matrix[:3, :3].T + matrix[:3, 3]).T
    axes = plt.figure(figsize=(6, 6)).add_subplot(projection="3d")
    surface = axes.plot_trisurf(x, y, z, triangles=joint.ball.faces, cmap="turbo_r", linewidth=0)
    surface.set_array(gap[0][joint.ball.faces].mean(axis=1))
    surface.set_clim(-1.0, 8.0)
    axes.set_aspect("equal")
    plt.colorbar(surface, label="gap (mm)")
    plt.savefig(path, dpi=120)


def main(words):
    joint = load(words[:-1])
    print(f"centre {joint.centre.round(2)} mm; {len(joint.warnings)} warnings")

    # Internal rotation of 0 to 40 degrees in every flexion of 0 to 120 degrees.
    flexion, rotation = np.meshgrid(np.arange(0.0, 121.0, 10.0), np.arange(0.0, 41.0, 10.0))
    poses = np.stack([flexion.ravel(), np.zeros(flexion.size), rotation.ravel()], axis=1)
    smallest = joint.smallest_gap(poses)
    print(f"smallest gap of {len(poses)} poses: {np.nanmin(smallest['gap_mm']):.2f} mm")

    touched = first_touch(joint, poses)
    picture(joint, poses[0] if touched is None else touched, words[-1])

    for limit in joint.limits("internal_rotation", pose="flexion=90")["limits"]:
        print(f"{limit['motion']} to {limit['threshold_mm']:g} mm about the {limit['centre']}: {limit['state']}, "
              f"free to {limit['low_deg']:.2f} degrees")

    volume = joint.volume(width=0.2)
    print(f"of all rotations {100 * volume['reachable_low']:.1f} to {100 * volume['reachable_high']:.1f} % are reached "
          "without contact")


if __name__ == "__main__":
    main(sys.argv[1:])
