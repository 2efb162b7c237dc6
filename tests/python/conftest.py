# SPDX-License-Identifier: GPL-3.0-or-later
"""A hip of parameters, and one as two files."""
import os
import re
from pathlib import Path

import impinge
import numpy as np
import pytest


@pytest.fixture(name="hip", scope="module")
def made_hip():
    return impinge.Joint.from_hip("cam", faces=900)


@pytest.fixture(name="files", scope="module")
def made_files():
    folder = Path(os.environ["HIP"])
    return folder / "ball.ply", folder / "socket.ply"


@pytest.fixture(name="floats", scope="module")
def made_floats(files, tmp_path_factory):
    """The two files in floats, which the page's reader keeps."""
    folder = tmp_path_factory.mktemp("floats")
    for file in files:
        head, body = file.read_bytes().split(b"end_header\n", 1)
        numbers = 3 * int(re.search(rb"element vertex (\d+)", head)[1])
        assert head.count(b"property double") == 3
        points = np.frombuffer(body, "<f8", numbers).astype("<f4").tobytes()
        (folder / file.name).write_bytes(head.replace(b"double", b"float") + b"end_header\n" + points + body[8 * numbers:])
    return [folder / file.name for file in files]
