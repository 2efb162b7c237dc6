# SPDX-License-Identifier: GPL-3.0-or-later
"""A joint for tests of the program `impinge`, and a folder for what they make. IMPINGE names the program."""

from __future__ import annotations

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

IMPINGE = os.environ["IMPINGE"]


def run(*words, **keywords) -> subprocess.CompletedProcess:
    """A program to its end; words may be names of any bytes."""
    words = [word if isinstance(word, bytes) else str(word) for word in words]
    return subprocess.run(words, capture_output=True, text=True, errors="surrogateescape", check=False, **keywords)


class GeneratedPair(unittest.TestCase):
    """`root` is a folder of its own, gone at the end; `ball` and `socket` are files in it."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="impinge-pair-")
        cls.root = Path(cls.folder.name)
        pair = cls.root / "pair"
        made = run(IMPINGE, "hip", "pair", "--faces", "1000", "--out", pair)
        assert made.returncode == 0, made.stderr
        cls.ball = pair / "ball.ply"
        cls.socket = pair / "socket.ply"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()
