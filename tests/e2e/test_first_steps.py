# SPDX-License-Identifier: GPL-3.0-or-later
"""What experiments/reproduce says on a machine where something is missing yet: packages, or the scripts of the pages.

It runs in a copy of its scripts, with stand-ins for the commands that would change the machine.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = (
    "experiments/reproduce",
    "experiments/packages",
    "experiments/packages.sh",
    "analysis/package-lock.json",
)
TOOLS = "bash cat cmp comm cp dirname echo env flock mkdir mktemp nproc realpath rm rmdir sed sort tr xargs".split()
LISTS = {
    text.split("]")[0]: [line.split()[0] for line in text.strip().splitlines()[1:]]
    for text in (ROOT / "experiments/packages").read_text().split("\n[")[1:]
}
PACKAGES = LISTS["reproduce"]
# What apt-get says before it begins, and does not.
FOREWORD = r"""
echo '0 upgraded, 40 newly installed, 0 to remove and 0 not upgraded.'
echo 'Need to get 1,500 MB of archives.'
echo 'After this operation, 2,100 MB of additional disk space will be used.'
"""


class FirstSteps(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="impinge-first-steps-")
        self.addCleanup(holder.cleanup)
        self.project = Path(holder.name) / "project"
        self.bin = Path(holder.name) / "bin"
        self.calls = Path(holder.name) / "calls"
        self.bin.mkdir()
        for file in SCRIPTS:
            (self.project / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / file, self.project / file)
        for tool in TOOLS:
            (self.bin / tool).symlink_to(shutil.which(tool))
        self.stand_in("npm", f"mkdir -p {self.project}/analysis/node_modules")
        (self.project / "experiments" / "run_graph.py").write_text("import sys\nprint(*sys.argv[1:])\n")

    def stand_in(self, name: str, script: str = "") -> None:
        """A command that notes its name and arguments, and then does as the script says."""
        (self.bin / name).write_text(f'#!/bin/bash\necho "{name} $*" >>{self.calls}\n{script}\n')
        (self.bin / name).chmod(0o755)

    def installed(self, packages: list[str]) -> None:
        """What dpkg-query tells."""
        self.stand_in("dpkg-query", "".join(f"echo installed {name}\n" for name in packages))

    def reproduce(self, *options: str) -> subprocess.CompletedProcess:
        program = self.project / "experiments" / "reproduce"
        environment = {"PATH": str(self.bin), "HOME": os.environ.get("HOME", "/")}
        return subprocess.run(
            [program, *options], env=environment, capture_output=True, text=True, check=False
        )

    def test_a_question_names_the_line_that_installs_what_is_missing(self):
        """And installs nothing. apt-get knows no package before its first update."""
        self.installed([name for name in PACKAGES if name not in ("cmake", "git")])
        line = "apt-get update && {}apt-get install -y --no-install-recommends cmake git"
        without = self.reproduce("--list")
        self.stand_in("sudo")
        for done, said, sudo in (
            (without, ", as root,", ""),
            (self.reproduce("--why", "table-1"), "", "sudo "),
        ):
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertEqual(
                done.stderr, f"Packages are missing. Install them{said} with:\n  {sudo}{line.format(sudo)}\n"
            )
        self.assertNotIn("apt-get", self.calls.read_text())
        self.stand_in("apt-get")  # which installs without a question where it needs no more than what is named
        self.assertEqual(self.reproduce("--list").returncode, 1)
        asked = [call for call in self.calls.read_text().splitlines() if call.startswith("apt-get")]
        self.assertEqual([call.split()[:3] for call in asked], [["apt-get", "install", "--print-uris"]])

    def test_what_is_installed_is_what_the_command_needs(self):
        """Its size and time are said before. Scripts of the pages are fetched once, for what needs them."""
        self.stand_in("apt-get", f'[[ "$*" != *--print-uris* ]] || {{ {FOREWORD} exit 1; }}')
        self.stand_in("sudo", 'shift; exec "$@"')
        cases = (
            (["--only", "figure-50"], PACKAGES[1:], PACKAGES[:1], 0),
            (["--only", "joint3d"], PACKAGES, LISTS["joint3d"], 1),
            ([], PACKAGES[1:], PACKAGES[:1], 1),
        )
        for options, there, missing, fetched in cases:
            self.installed(there)
            done = self.reproduce(*options)
            self.assertIn(f"Installing: {' '.join(sorted(missing))}\n", done.stdout)
            self.assertIn("40 packages, 1,500 MB to download, 2,100 MB on the disk: about 6 min\n", done.stdout)
            calls = self.calls.read_text()
            self.assertIn(f"--no-install-recommends {' '.join(sorted(missing))}\n", calls)
            self.assertEqual(calls.count("npm ci --prefix"), fetched)

    def test_a_question_installs_nothing(self):
        """And needs neither Joint3D's packages nor the scripts of the pages."""
        self.installed(PACKAGES)
        self.assertRegex(self.reproduce("--list").stdout, "^list --build .*/build/release --results .*/results --profile quick")
        self.assertNotIn("npm", self.calls.read_text())

    def test_scripts_that_cannot_be_had_are_said_so_and_tried_again(self):
        """Nothing is made without them."""
        self.installed(PACKAGES)
        self.stand_in("npm", "echo 'npm ERR! code ENOTFOUND' >&2; exit 1")
        for _ in range(2):
            done = self.reproduce()
            self.assertEqual((done.returncode, done.stdout.split(" ")[0]), (1, "Installing"))
            self.assertRegex(done.stderr.splitlines()[-1], "^npm could not install them.* takes a connection")
        self.assertEqual(self.calls.read_text().count("npm ci"), 2)


if __name__ == "__main__":
    unittest.main(verbosity=2)
