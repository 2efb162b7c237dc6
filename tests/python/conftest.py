# SPDX-License-Identifier: GPL-3.0-or-later
"""A hip of parameters, and one as two files."""
import os
from pathlib import Path

import impinge
import pytest


@pytest.fixture(name="hip", scope="module")
def made_hip():
    return impinge.Joint.from_hip("cam", faces=900)


@pytest.fixture(name="files", scope="module")
def made_files():
    folder = Path(os.environ["HIP"])
    return folder / "ball.ply", folder / "socket.ply"
