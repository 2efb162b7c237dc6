# SPDX-License-Identifier: GPL-3.0-or-later
"""The modules for 3D Slicer (experiments/slicer): their descriptions by the rules of Slicer's execution model, and what
they do when they are called as Slicer calls them. IMPINGE names the program, SOURCE the project."""

from __future__ import annotations

import csv
import os
import re
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from generated_pair import IMPINGE, GeneratedPair, run  # noqa: E402

ALWAYS_GIVEN = ("double", "string-enumeration")  # other tags are left out where their value is empty
SCENE = ("geometry", "table", "pointfile")
TAGS = (*ALWAYS_GIVEN, *SCENE, "boolean", "file", "directory", "string")
# The order that the schema of CTK asks for; either a flag or a place in the command.
ORDER = re.compile(r"name (longflag|index) description label (default )?(channel )?(element )*$")


class Slicer(GeneratedPair):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        install = Path(os.environ["SOURCE"]) / "experiments/slicer/install"
        cls.done = run(install, cls.root / "modules", IMPINGE)
        cls.modules = sorted((cls.root / "modules").iterdir())

    def parameters(self, module) -> list[ElementTree.Element]:
        said = run(module, "--xml")
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        return [one for panel in ElementTree.fromstring(said.stdout).findall("parameters") for one in list(panel)[2:]]

    def words(self, module, **given) -> list[str]:
        """As Slicer makes a command: flags in their order, then what has a place; what is not chosen is empty."""
        flags, places = [], []
        for one in self.parameters(module):
            value = given.pop(one.findtext("name"), one.findtext("default") or "")
            if one.find("index") is not None:
                places.append(value)
            elif one.tag == "boolean":
                flags += [f"--{one.findtext('longflag')}"] * (value == "true")
            elif value or one.tag in ALWAYS_GIVEN:
                flags += [f"--{one.findtext('longflag')}", value]
        self.assertFalse(given, "no such parameter")
        return [*flags, *places]

    def call(self, name: str, **given):
        module = self.root / "modules" / name
        done = run(module, *self.words(module, BALL=self.ball, SOCKET=self.socket, **given))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_descriptions_keep_the_rules(self):
        self.assertEqual((self.done.returncode, len(self.modules)), (0, 9))
        for module in self.modules:
            root = ElementTree.fromstring(run(module, "--xml").stdout)
            head = ["category", "title", "description", "version", "documentation-url", "license", "contributor"]
            self.assertEqual([one.tag for one in root if one.tag != "parameters"], head)
            names = []
            for panel in root.findall("parameters"):
                self.assertEqual([one.tag for one in panel][:2], ["label", "description"])
                for one in list(panel)[2:]:
                    with self.subTest(module=module.name, parameter=one.findtext("name")):
                        self.assertIn(one.tag, TAGS)
                        self.assertRegex("".join(f"{part.tag} " for part in one), ORDER)
                        self.assertRegex(one.findtext("longflag") or one.findtext("name"), r"^[A-Za-z_]\w*$")
                        if one.tag == "string-enumeration":
                            self.assertIn(one.findtext("default") or "", [of.text or "" for of in one.findall("element")])
                        if one.tag in SCENE:
                            self.assertIn(one.findtext("channel"), ("input", "output"))
                    names.append(one.findtext("name"))
            self.assertEqual(len(names), len(set(names)))
            self.assertEqual(names[:2], ["BALL", "SOCKET"])

    def test_options_of_the_command_are_those_of_its_help(self):
        for module in self.modules:
            told = run(IMPINGE, module.name.removeprefix("Impinge").lower(), "--help").stdout
            flags = {(one.findtext("longflag") or "").replace("_", "-") for one in self.parameters(module)}
            ours = set(re.findall(r"^  --([a-z-]+)", told, re.M)) - {"json", "schema", "xml", "quiet", "joints", "mesh-format"}
            self.assertLessEqual(ours, flags)

    def test_answers_come_into_the_scene(self):
        """The same as the program writes; nothing is left in between."""
        bones, table = self.root / "gaps.vtp", self.root / "limits.csv"
        self.call("ImpingeGaps", ball_gaps=bones, centre="fit", pose="flexion=10")
        self.call("ImpingeLimits", side="right", cartilage="3", motions="flexion,extension", limits=table, centre="-0.5,0,0.25")
        run(IMPINGE, "gaps", self.ball, self.socket, "--pose", "flexion=10", "--mesh-format", "vtp", "--out", self.root / "own")
        run(IMPINGE, "limits", self.ball, self.socket, "--side", "right", "--cartilage", "3", "--motions", "flexion,extension",
            "--centre=-0.5,0,0.25", "--out", self.root / "own")
        self.assertEqual(bones.read_bytes(), (self.root / "own/ball.vtp").read_bytes())
        self.assertEqual(table.read_bytes(), (self.root / "own/limits.csv").read_bytes())
        rows = csv.DictReader(table.read_text().splitlines())
        self.assertEqual({row["motion"] for row in rows}, {"flexion", "extension"})

    def test_all_modules_run_with_what_a_window_shows_at_first(self):
        for name, given in {"ImpingeTouch": {}, "ImpingeMeasure": {"side": "right", "measures": self.root / "measures.csv"},
                            "ImpingePoses": {"path": "flexion=0..2/1", "contacts": self.root / "poses.csv"},
                            "ImpingeCertify": {"out": self.root / "proof"}}.items():
            with self.subTest(name):
                self.call(name, **given)
                for file in given.values():
                    self.assertTrue(isinstance(file, str) or file.exists(), file)

    def test_what_the_program_refuses_fails(self):
        done = run(self.root / "modules/ImpingeLimits", "--motions", "somersault", self.ball, self.socket)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertRegex(done.stderr, "somersault")


if __name__ == "__main__":
    unittest.main()
