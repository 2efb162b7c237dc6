# SPDX-License-Identifier: GPL-3.0-or-later
"""A joint for tests of `scene`, and a folder for what they make. MAKE_PAIR names the program."""

from __future__ import annotations

import os
import subprocess
import tempfile
import unittest
from pathlib import Path


class GeneratedPair(unittest.TestCase):
    """`root` is a folder of its own, gone at the end; `ball` and `socket` are files in it."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="impinge-scene-")
        cls.root = Path(cls.folder.name)
        pair = cls.root / "pair"
        words = [os.environ["MAKE_PAIR"], "--faces", "1000", "--out", str(pair)]
        made = subprocess.run(words, capture_output=True, text=True, check=False)
        assert made.returncode == 0, made.stderr
        cls.ball = pair / "ball.ply"
        cls.socket = pair / "socket.ply"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()
