# SPDX-License-Identifier: GPL-3.0-or-later
"""What figures, hips and tables of limits show, on small made-up data."""

from __future__ import annotations

import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "analysis"))

import numpy as np  # noqa: E402
import pandas as pd  # noqa: E402

import common  # noqa: E402
from common import diagram_chart, diagram_section, hip, motion_limits, ply, render, replay, socket_map  # noqa: E402
from common.drawing import plt  # noqa: E402
from paper import limits as paper_limits  # noqa: E402
from paper import theorems, whole  # noqa: E402
from verdicts import hip as verdicts_hip  # noqa: E402


class View(unittest.TestCase):
    """Where a point is seen in a picture."""

    def test_place(self):
        x, y, z = np.eye(3)
        view = render.View(focus=z, towards=z, up=y, size=2.0, pixels=101)
        self.assertEqual(view.place(5 * z).tolist(), [50, 50])
        self.assertEqual(view.place(2 * y).tolist(), [50, -0.5])  # the border above
        self.assertEqual(view.place(-2 * x).tolist(), [100.5, 50])  # z away, y above: x to the left


class Hips(unittest.TestCase):
    """Anatomical views, and zones by the clock."""

    def hip(self, side: str) -> hip.Hip:
        corners = np.array([[30.0, 0, 0], [-30, 10, 0], [0, -10, 30]])
        mesh = ply.Mesh(corners, np.array([[0, 1, 2]]), {})
        return hip.Hip("h", side, mesh, mesh, {})

    def test_sides_of_a_picture(self):
        """A picture from the front has the patient's right on its left; from above, anterior is up."""
        expected = {
            ("anterior", "right"): "RLSI",
            ("anterior", "left"): "RLSI",
            ("medial", "right"): "APSI",
            ("medial", "left"): "PASI",
            ("lateral", "right"): "PASI",
            ("superior", "left"): "LRAP",
        }
        for (name, side), letters in expected.items():
            joint = self.hip(side)
            found = hip.letters(hip.view(name, joint, [joint.ball]))
            ways = "".join(found[where] for where in ("left", "right", "top", "bottom"))
            self.assertEqual(ways, letters, (name, side))

    def test_map_is_seen_from_medial(self):
        """3 o'clock is anterior: left on a right hip; 12 is up."""
        self.assertLess(socket_map.place(3, 90, self.hip("right"))[0], 0)
        self.assertGreater(socket_map.place(3, 90, self.hip("left"))[0], 0)
        self.assertGreater(socket_map.place(12, 90, self.hip("left"))[1], 0)

    def zones(self, *rows: tuple[float, float, float]) -> pd.DataFrame:
        return pd.DataFrame(rows, columns=["from_hours", "to_hours", "area_mm2"])

    def test_union_of_zones(self):
        self.assertEqual(
            replay.union(self.zones((11.5, 1, 1), (0.5, 2.25, 1), (7, 7.25, 1))), "7:00-7:15, 11:30-2:15"
        )
        self.assertEqual(replay.union(self.zones((0, 0, 1))), "12:00-12:00")
        self.assertEqual(replay.union(self.zones()), "none")

    def test_zones_against_print(self):
        self.assertEqual(verdicts_hip.stretches("1-3 and 7"), [(1, 3), (6.5, 7.5)])
        zone = next(self.zones((11.75, 4.25, 1)).itertuples())
        self.assertTrue(verdicts_hip.inside(zone, (12, 4)))
        self.assertFalse(verdicts_hip.inside(zone, (1, 4)))
        self.assertFalse(verdicts_hip.inside(zone, (12, 3)))


class Limits(unittest.TestCase):
    """What is proven of a limit is told with its ends rounded outward, and a bracket is of what has one."""

    def setUp(self):
        columns = ["centre", "gap_mm", "state", "limit_low_deg", "limit_high_deg", "centre_low_deg", "centre_high_deg"]
        rows = [
            ("head", np.nan, "limited", 53.56, 53.56000005, 40.06, 60.04),
            ("head", np.nan, "limited", 20.06, 21.06, 0.0, np.nan),
            ("head", np.nan, "unknown", 70.06, 180.0, 0.0, np.nan),
            ("head", np.nan, "free", 180.0, 180.0, 90.0, np.nan),
            ("socket", np.nan, "limited", 53.5, 53.50000005, 40.0, 60.0),
            ("head", 0.5, "blocked", 0.0, 0.0, 0.0, np.nan),
        ]
        self.table = pd.DataFrame(rows, columns=columns).assign(
            joint="normal", motion=["flexion", "faber", "fadir", "extension", "flexion", "flexion"], clock="1:20",
            surface_deg=1.0, hangs_on_less=False, shift_mm=0.0, quantity="gap", error=0.0, bound=1.0,
        )  # fmt: skip

    def test_words(self):
        rows = list(self.table.itertuples())
        self.assertEqual(
            [motion_limits.text(row) for row in rows],
            ["53.5", "20.0 to 21.1", "unknown beyond 70.0", "free", "53.5", "blocked"],
        )

    def test_facts(self):
        with mock.patch.object(common, "load", return_value=self.table):
            facts = paper_limits.facts(Path())
        centre = "in generated hips 20° wide in the median and 20° at most (1 of 2 limits have a proven upper end)"
        wanted = {"count": "3", "widest": "1", "centre": centre, "unbounded": "1"}
        self.assertEqual({name: facts[f"limits:{name}"] for name in wanted}, wanted)


class Papers(unittest.TestCase):
    """Facts that the papers print."""

    def test_theorems(self):
        """Numbers are those of proofs.tex; each has headers and tests."""
        facts = theorems.facts(Path())
        labels = re.findall(r"\\begin\{theorem\}\[.*?\]\\label\{thm:(.*?)\}", (ROOT / "paper" / "proofs.tex").read_text())
        self.assertEqual([facts[f"theorem:{label}"] for label in labels], [str(k + 1) for k in range(len(labels))])
        for label in labels:
            self.assertRegex(facts[f"where:thm:{label}"], r"^In [\w/]+\.hpp.*\. Tests: Theorem\w+\.\.\. \([1-9]\d*\)\.$")

    def test_whole_bones(self):
        """Of real joints where there are any, and else of the generated hip; misses by step."""
        columns = ["joint", "faces", "method", "step_deg", "motions", "asked", "missed", "largest_error_deg", "times_ours", "total_ms"]
        rows = []
        for joint, faces, ms in (("normal hip, cropped", 6000, 40.0), ("needle past spikes", 6000, 40.0), ("implant", 8000, 20.0), ("a_hip", 60000, 110.0), ("b_hip", 120000, 270.0)):
            missed = 9 if joint.startswith("needle") else 0
            rows += [(joint, faces, "turn_limit", np.nan, 12, 12, 0, 0.0, 1.0, ms), (joint, faces, "turn_limit_ranges", np.nan, 12, 12, 0, 0.0, 2.0, 2 * ms)]
            rows += [(joint, faces, "fcl_collide", step, 12, 12, missed, 0.002, 10 / step, ms * 10 / step) for step in (5, 0.1)]
        table = pd.DataFrame(rows, columns=columns).assign(line="FCL")
        facts = whole.limits(table)
        self.assertEqual(facts["whole:scene"], "the whole bones of 2 real joints of 60,000 to 120,000 faces")
        steps = "FCL in steps of 0.1° takes 100 times as long, in steps of 5° 2.0 times, which miss none of these 24 contacts."
        self.assertEqual((facts["whole:ours"], facts["whole:steps"]), ("0.11 to 0.27 s", steps))
        self.assertIn("On the cropped generated hip, of 6,000 faces, such steps take: FCL 2.0 times as long as ours, missing none.", facts["whole:all"])
        self.assertIn("of 12 contacts it misses 9 in steps of 5°, 9 in steps of 0.1°", facts["whole:all"])
        self.assertEqual(whole.limits(table[~table.joint.str.endswith("_hip")])["whole:scene"], "a generated hip of 6,000 faces")


class GapDifference(unittest.TestCase):
    """Two scenes of one joint, compared vertex by vertex."""

    def test_table(self):
        levels = [{"up_to": 0.0}, {"up_to": 2.0}, {"up_to": None}]
        document = {"joint": {"centre": {"position": [0, 0, 0]}, "axes": "RAS", "side": "right"}, "request": {"pose": {}},
                    "answer": {"colours": {"ball": levels}}}
        gaps = {"rsid": ["-1", "1.5", "", "3"], "usid": ["0.5", "1.75", "1", "3"]}
        with tempfile.TemporaryDirectory() as folder:
            for scheme, values in gaps.items():
                scene = Path(folder) / "scenes" / f"hip-{scheme}"
                scene.mkdir(parents=True)
                rows = [f"ball,{i},0,0,0,{gap}" for i, gap in enumerate(values)]
                (scene / "gaps.csv").write_text("\n".join(["surface,vertex,x,y,z,gap_mm", *rows]) + "\n")
                (scene / "summary.json").write_text(json.dumps(document))
            words = ["--results", folder, "--out", folder, "--joints", "hip"]
            script = ROOT / "analysis" / "tables" / "gap_difference.py"
            environment = {**os.environ, "PYTHONPATH": str(ROOT / "analysis")}
            subprocess.run([sys.executable, "-B", str(script), *words], check=True, env=environment)
            table = pd.read_csv(Path(folder) / "tables" / "figure-50-difference.csv")
        self.assertEqual(table.threshold_mm.tolist(), [0, 2])
        self.assertEqual(table[["vertices", "met_by_both", "met_by_one"]].iloc[0].tolist(), [4, 3, 1])
        self.assertEqual(table.largest_difference_mm.iloc[0], 1.5)
        self.assertAlmostEqual(table.rms_difference_mm.iloc[0], ((1.5**2 + 0.25**2) / 3) ** 0.5)
        self.assertEqual(table.impinged_rsid.tolist(), [1, 2])
        self.assertEqual(table.impinged_usid.tolist(), [0, 2])
        self.assertEqual(table.changed.tolist(), [1, 0])


class Figures(unittest.TestCase):
    """The same figure gives the same bytes."""

    def test_same_bytes(self):
        texts = []
        kept = []  # what the first run left in memory, so that addresses differ
        with tempfile.TemporaryDirectory() as folder:
            for run in range(2):
                common.style()
                figure, axes = plt.subplots()
                line = axes.plot([0, 1])[0]
                circle = plt.Circle((0.5, 0.5), 0.3, transform=axes.transData)
                line.set_clip_path(circle)
                kept.append(circle)
                common.save_figure(figure, Path(folder) / str(run), "x")
                texts.append((Path(folder) / str(run) / "figures" / "x.svg").read_text())
        self.assertEqual(*texts)
        self.assertIn('<clipPath id="clip0"', texts[0])
        self.assertIn("url(#clip0)", texts[0])


class Ply(unittest.TestCase):
    """Text and binary give the same mesh."""

    HEADER = (
        "ply\nformat {}\ncomment units mm\n"
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property double gap\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    )
    POINTS = [(0, 0, 0, 1.5), (1, 0, 0, float("nan")), (0, 1, 0, -2)]

    def check(self, body: bytes, style: str):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "m.ply"
            path.write_bytes(self.HEADER.format(style).encode() + body)
            mesh = ply.read(path)
        self.assertEqual(mesh.vertices.tolist(), [[0, 0, 0], [1, 0, 0], [0, 1, 0]])
        self.assertEqual(mesh.triangles.tolist(), [[0, 1, 2]])
        self.assertEqual(mesh.properties["gap"][2], -2)
        self.assertTrue(mesh.properties["gap"][1] != mesh.properties["gap"][1])

    def test_text(self):
        lines = [" ".join(map(str, point)) for point in self.POINTS]
        self.check(("\n".join([*lines, "3 0 1 2"]) + "\n").encode(), "ascii 1.0")

    def test_binary(self):
        for order, style in (("<", "binary_little_endian 1.0"), (">", "binary_big_endian 1.0")):
            body = b"".join(struct.pack(order + "fffd", *point) for point in self.POINTS)
            self.check(body + struct.pack(order + "Biii", 3, 0, 1, 2), style)


class Diagrams(unittest.TestCase):
    """Sections are closed before they are filled, and a table's image gives its radii back."""

    def test_loops(self):
        square = [(0, 0), (2, 0), (2, 1), (0, 1)]
        away = [(5, 5), (6, 5), (5, 6)]
        segments = [(loop[k - 1], loop[k]) for loop in (square, away) for k in range(len(loop))]
        segments += [((2, 0), (2, 0))]  # of no length: a face that touches the plane with a corner
        shuffled = [segments[k][:: 1 - 2 * (k % 2)] for k in (6, 0, 3, 5, 1, 7, 4, 2)]
        loops = diagram_section.loops(np.array(shuffled, float))
        self.assertEqual(sorted(map(len, loops)), [3, 4])
        for loop in loops:
            corners = square if len(loop) == 4 else away
            at = [corners.index(tuple(map(int, point))) for point in loop]
            steps = {(b - a) % len(at) for a, b in zip(at, at[1:])}
            self.assertIn(steps, ({1}, {len(at) - 1}))

    def test_image(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "t.pgm"
            path.write_bytes(b"P5\n3 2\n255\n" + bytes([0, 1, 255, 128, 10, 0]))
            radii = diagram_chart.read_image(path, (20.0, 30.0))
            self.assertTrue(np.isnan([radii[0, 0], radii[1, 2]]).all())
            np.testing.assert_allclose(radii[0, 1:], [20.0, 30.0])
            self.assertAlmostEqual(radii[1, 0], 25.0)
            path.write_bytes(path.read_bytes()[:-1])
            with self.assertRaisesRegex(common.Refused, "t.pgm"):
                diagram_chart.read_image(path, (20.0, 30.0))


if __name__ == "__main__":
    unittest.main(verbosity=2)
