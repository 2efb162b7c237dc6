# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command without memory, on a disk that fills, and with files that change while it reads them.

The faults are those of faults.cpp, which FAULTS names. A run either gives what an undisturbed one gives, or ends with
exit code 1 and one line, and then the files of an older answer are as they were. The words are how many places of each
kind are tried in each command, and a seed: test_faults.py 8 1. IMPINGE names the program, HIP a folder with a joint.
"""

from __future__ import annotations

import collections
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

IMPINGE = os.environ["IMPINGE"]
HIP = Path(os.environ["HIP"])
PLACES, SEED = (int(word) for word in (sys.argv[1:3] if len(sys.argv) > 2 else ("8", "1")))
COMMANDS = {
    "hip": ["hip", "cam", "--set", "shaft_length=0", "--set", "aiis_height=10", "--faces", "600"],
    **{words.split()[0] + (" " + more if (more := words.partition(" ")[2]) else ""): words.split() for words in (
        "touch", "touch --json", "gaps", "gaps --precision 2", "gaps --mesh-format vtp", "poses --path flexion=0..20/10",
        "limits --motions flexion", "measure", "certify", "resect --require flexion=100",
        "orient --require flexion=60 --resolution 12", "volume --width 0.9", "report --without volume,measures")},
}
FILES = HIP / "ball.ply", HIP / "socket.ply"
ERROR = re.compile(r"(impinge: warning: [^\n]+\n)*impinge: error: [^\n]+; [^\n]+\n")
KEPT = re.compile(r"(poses|volume)-[0-9a-f]+\.part")  # what a later run goes on from


def words_of(command: str, out: Path, files=FILES) -> list:
    words = COMMANDS[command]
    if words[0] != "hip":
        words = [words[0], *files, "--side", "right", "--threads", "1", "--quiet", *words[1:]]
    return [IMPINGE, *map(str, words), "--out", str(out)]


def run(words: list, fault: str = "", **more) -> subprocess.CompletedProcess:
    environment = {**os.environ, "LD_PRELOAD": os.environ["FAULTS"], **more}
    if fault:
        environment["IMPINGE_FAULT"] = fault
    return subprocess.run(words, capture_output=True, text=True, check=False, env=environment, timeout=300)


def without_times(text: str) -> str:
    return re.sub(r'"times_ms": \{[^}]*\}', "", text)


def files_in(folder: Path) -> dict[str, str]:
    return {file.name: without_times(file.read_text(errors="replace")) for file in folder.iterdir()} if folder.exists() else {}


class Faults(unittest.TestCase):
    def setUp(self):
        self.root = Path(tempfile.mkdtemp(prefix="impinge-faults-"))
        self.addCleanup(shutil.rmtree, self.root)
        self.out = self.root / "out"
        self.random = random.Random(SEED)
        self.done: collections.Counter[tuple[str, int]] = collections.Counter()
        self.addCleanup(lambda: print(f"{self.id()}: {dict(self.done)}"))

    def undisturbed(self, command: str):
        """Its screen and files, and the numbers of what may fail."""
        shutil.rmtree(self.out, ignore_errors=True)
        counts = self.root / "counts"
        done = run(words_of(command, self.out), IMPINGE_COUNTS=str(counts))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("is left from an earlier", done.stderr)
        numbers = dict(zip(("memory", "bytes", "change", "look"), map(int, counts.read_text().split())))
        return without_times(done.stdout), files_in(self.out), numbers | {"memories": numbers["memory"]}

    def places(self, number: int) -> list[int]:
        return sorted(self.random.sample(range(1, number + 1), min(number, PLACES)))

    def one(self, command: str, fault: str, screen: str, files: dict[str, str], older: bool):
        shutil.rmtree(self.out, ignore_errors=True)
        if older:
            self.out.mkdir()
            for name in files:
                (self.out / name).write_text(f"an older {name}")
        before = files_in(self.out)
        done = run(words_of(command, self.out), fault)
        self.done[fault.split()[0], done.returncode] += 1
        after = files_in(self.out)
        if done.returncode == 0:
            self.assertEqual((without_times(done.stdout), after), (screen, files))
            return
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, rf"\A{ERROR.pattern}\Z")
        after = {name: text for name, text in after.items() if not KEPT.fullmatch(name)}
        self.assertEqual(after, before)
        if command != "hip" and fault.split()[0] in ("bytes", "change"):
            self.assertIn(str(self.out), done.stderr)

    def sweep(self, *kinds: str):
        for command in COMMANDS:
            screen, files, numbers = self.undisturbed(command)
            for kind in kinds:
                for n in self.places(numbers[kind]):
                    older = self.random.random() < 0.5
                    with self.subTest(command, fault=f"{kind} {n}", older=older):
                        self.one(command, f"{kind} {n}", screen, files, older)

    def test_memory(self):
        """One request, or all from one on."""
        self.sweep("memory", "memories")

    def test_a_small_machine(self):
        """Before the kernel kills the program it says that memory is short."""
        command = "limits --motions flexion"
        screen, files, _ = self.undisturbed(command)
        for mib in (16, 32, 64, 128, 256, 512, 1024):
            with self.subTest(mib=mib):
                self.one(command, f"machine {mib}", screen, files, older=mib > 64)
        self.assertGreater(self.done["machine", 0], 0)
        self.assertGreater(self.done["machine", 1], 0)

    def test_disk(self):
        """It takes n bytes, or not the n-th change."""
        self.sweep("bytes", "change")

    def test_inputs_that_change_while_they_are_read(self):
        """Whole as it was, or one line that names it."""
        screen, files, numbers = self.undisturbed("touch")
        for deed in ("removed", "a folder", "halved", "emptied", "doubled"):
            for n in range(1, min(numbers["look"], 3 * PLACES) + 1):
                with self.subTest(deed, look=n):
                    pair = [self.root / file.name for file in FILES]
                    for file, copy in zip(FILES, pair):
                        if copy.is_dir():
                            copy.rmdir()
                        shutil.copy(file, copy)
                    shutil.rmtree(self.out, ignore_errors=True)
                    done = run(words_of("touch", self.out, pair), f"look {n}", IMPINGE_VICTIM=str(pair[0]), IMPINGE_DEED=deed)
                    self.done[deed, done.returncode] += 1
                    if done.returncode == 0:
                        self.assertEqual(sorted(files_in(self.out)), sorted(files))
                        self.assertEqual(done.stdout.splitlines()[-2:-1], screen.splitlines()[-2:-1])
                        continue
                    self.assertRegex(done.stderr, rf"\Aimpinge: error: {re.escape(str(pair[0]))}: [^\n]+; [^\n]+\n\Z")
                    self.assertNotRegex(done.stderr, "Success|filesystem error")
                    self.assertEqual((done.returncode, files_in(self.out)), (1, {}))

    def test_a_screen_that_takes_nothing(self):
        """A full one is an error; nothing that is said goes into a file where the streams are closed."""
        words = words_of("touch", self.out)
        with open("/dev/full", "w") as full:
            done = subprocess.run(words, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, rf"\A{ERROR.pattern}\Z")
        for command in ("gaps", "poses --path flexion=0..20/10", "volume --width 0.9"):
            _, files, _ = self.undisturbed(command)
            shutil.rmtree(self.out)
            done = subprocess.run(["sh", "-c", '"$@" <&- >&- 2>&-', "sh", *words_of(command, self.out)], check=False)
            self.assertEqual((done.returncode, files_in(self.out)), (0, files))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
