#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits of ten joints at once, in several processes. Joints can be pickled, so a pool of dask.distributed works as well, here
(many_joints.py dask) or on other machines."""
import sys
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import impinge


def internal_rotation(joint):
    """Degrees of internal rotation that are certainly free at 90 degrees of flexion."""
    return joint.limits("internal_rotation", pose="flexion=90")["limits"][0]["low_deg"]


def pool(words):
    if words != ["dask"]:
        return ProcessPoolExecutor(mp_context=get_context("spawn"))
    from distributed import Client

    return Client().get_executor()


def main(words):
    joints = {name: impinge.Joint.from_hip(name, faces=2000) for name in impinge.hip_presets()}
    joints |= {f"cam of {height} mm": impinge.Joint.from_hip("cam", faces=2000, cam_height=height) for height in (1, 2, 3)}
    with pool(words) as workers:
        for name, limit in zip(joints, workers.map(internal_rotation, joints.values())):
            print(f"{name}: internal rotation free to {limit:.2f} degrees")


if __name__ == "__main__":
    main(sys.argv[1:])
