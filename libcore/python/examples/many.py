#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits of many joints, one process a core: many.py FOLDER..., each with ball.ply and socket.ply, of right hips; without folders ten
hips made from parameters. On a cluster with dask.distributed `client.map` takes the place of `pool.map`: joints are pickled as how
they were made, so that files are read again where the work is."""
import sys
from concurrent.futures import ProcessPoolExecutor

import pandas

import impinge


def limits(joint):
    return pandas.DataFrame(joint.limits()["limits"])[["motion", "centre", "low_deg", "centre_low_deg", "centre_high_deg", "meets"]]


def main(folders):
    joints = {folder: impinge.Joint.read(f"{folder}/ball.ply", f"{folder}/socket.ply", side="right") for folder in folders}
    if not joints:
        joints = {f"cam of {height} mm": impinge.Joint.from_hip("cam", faces=4000, cam_height=height) for height in range(10)}
    with ProcessPoolExecutor() as pool:
        table = pandas.concat(dict(zip(joints, pool.map(limits, joints.values()))), names=["joint"])
    print(table.query("motion == 'internal_rotation_at_90' and centre == 'ball'").to_string())


if __name__ == "__main__":
    main(sys.argv[1:])
