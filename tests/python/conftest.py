# SPDX-License-Identifier: GPL-3.0-or-later
"""A hip of parameters, and one as two files."""
import impinge
import pytest
from shared import program


@pytest.fixture(name="hip", scope="module")
def made_hip():
    return impinge.Joint.from_hip("cam", faces=900)


@pytest.fixture(name="files", scope="module")
def made_files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("hip")
    program("MAKE_PAIR", "--hip", "cam", "--set", "side=left", "--faces", 1500, "--out", folder)
    return folder / "ball.ply", folder / "socket.ply"
