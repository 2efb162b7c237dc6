# SPDX-License-Identifier: GPL-3.0-or-later
# @name      fast-targets
# @question  Speed targets, and the speeds measured.
# @data      all_gaps contact
"""What was aimed at in speed, what was measured, and what bounds it: our time, the peer's, the time that the target
asks for, and the floor, which no look-up of ours is below: the memory-bound baseline."""

import math
from dataclasses import dataclass

import pandas as pd

import common
from common import contact, fast

KERNELS = ["rsid", "cube_gnomonic_mesh_exact"]
MIB = 2**20
# Triangles of a model, and what is aimed at there.
EXACT = {12000: 30, 400000: 12}
# All gaps: one thread, and as accurate as what kernels are judged by, decides whether the target is met. Beside it stand
# two threads with the same tables, finer tables whose errors are not centred, and those in 16 bits.
DISTANCE = {
    "all_corners": "all gaps, 7 µm, one thread, against FCL's distance, 12k",
    "all_corners_2_threads": "the same, two threads",
    "all_corners_sampled": "the same, errors not centred, one thread",
    "all_vertices": "the same, in 16 bits, one thread",
    "culled_least_gap": "smallest gap, culled, against FCL's distance, 12k",
}
JUDGED = ["all_corners", "culled_least_gap"]


@dataclass(frozen=True)
class Target:
    """A ratio, of times unless it says bytes: at least `target`, or at most where `most` is set; without a target it
    stands beside the others and is not judged."""

    key: str
    what: str
    target: float
    measured: float
    most: bool = False
    open: bool = False  # not measured in this profile
    unit: str = ""  # of the two times
    ours: float = math.nan
    floor: float = math.nan

    def verdict(self) -> str:
        """yes, no (also where nothing is as accurate and as small as asked), not measured, or nothing to meet."""
        if math.isnan(self.target):
            return "---"
        if self.open:
            return "not measured"
        met = self.measured <= self.target if self.most else self.measured >= self.target
        return "yes" if met else "no"

    def shown(self) -> str:
        """What was measured, in more digits where it is about the target."""
        return common.digits(self.measured, 3 if abs(self.measured / self.target - 1) < 0.02 else 2)

    def times(self) -> tuple[float, float, float, float]:
        """Ours, the peer's, the one that the target asks for, the floor."""
        peer = self.measured * self.ours
        return self.ours, peer, peer / self.target, self.floor

    def aim(self) -> str:
        """The target in words."""
        if math.isnan(self.target):
            return "---"
        return f"{'at most' if self.most else 'at least'} {self.target:g}"


def main(options) -> common.Table:
    targets = measured(fast.load(options.results)) + hips(fast.load(options.results, scenes=fast.HIPS))
    cold = fast.load(options.results, "cold")
    cold = cold[cold.direction == "socket->ball"]
    targets.append(
        timed("cold", "a cold pose, socket to ball, 7 µm, against Embree", 12, cold, kernels(cold, 7, math.inf))
    )
    targets += of_contact(contact.load(options.results), fast.plain_rows(fast.load(options.results)))
    rows = pd.DataFrame(
        {
            "key": [one.key for one in targets],
            "what": [one.what for one in targets],
            "target": [one.aim() for one in targets],
            "measured": [one.shown() for one in targets],
            "met": [one.verdict() for one in targets],
        }
    )
    rows["unit"] = [one.unit for one in targets]
    for name, column in zip(("ours", "peer", "wanted", "floor"), zip(*(one.times() for one in targets))):
        rows[name] = [common.digits(value, 2) for value in column]
    return rows, latex(rows)


def measured(table: pd.DataFrame) -> list[Target]:
    """Those of all gaps of a pose on the generated pair."""
    shown = fast.plain_rows(table)
    every = table[(table.triangles == fast.TRIANGLES) & (table.threads == 1)]
    ball, socket = (shown[shown.direction == name] for name in fast.DIRECTIONS)
    every_ball = every[every.direction == "socket->ball"]
    return [
        timed("ball", "socket to ball, 7 µm, 1 MiB, against Embree", 80, ball, kernels(ball, 7, MIB)),
        timed("socket", "ball to socket, the same, rim masked", 30, socket, kernels(socket, 7, MIB)),
        timed("avx2", "socket to ball with AVX2", 40, *of_set(every_ball, ["AVX2"])),
        timed("scalar", "socket to ball without vectors", 12, *of_set(every_ball, ["SCALAR", "EMU128"])),
        timed("fine", "socket to ball, 2 µm, against Embree", 35, ball, kernels(ball, 2, math.inf)),
        Target("floor", "time over the memory-bound baseline of its size, 7 µm", 1.5, over_floor(ball), most=True),
        Target("thesis", "against scalar RSID in double, half the memory", 15, over_thesis(ball)),
        Target("usid", "USID with polynomials against USID with libm", 7, over_libm(ball)),
        bytes_target(table),
        *(exact(table, triangles) for triangles in EXACT),
    ]


def hips(table: pd.DataFrame) -> list[Target]:
    """At 7 um and exact (0.05 um), each the least over the hips of that many triangles. Of their sockets: a femur is met in several layers, so that the largest
    error of its directions is that of a step between two of them."""
    shown = table[(table.direction == "ball->socket") & table.scene.str.endswith(str(fast.TRIANGLES))]
    scenes = [rows for _, rows in shown.groupby("scene")]
    what = "all gaps on hips, ball to socket, {}, against Embree, the least"
    fine = [timed("hips", what.format("7 µm"), 50, rows, kernels(rows, 7, math.inf)) for rows in scenes]
    same = [timed("hips-exact", what.format("exact (0.05 µm)"), 20, rows, exact_rows(rows)) for rows in scenes]
    return [min(targets, key=lambda one: one.measured) for targets in (fine, same)]


def exact_rows(rows: pd.DataFrame) -> pd.Series:
    """Gaps of the mesh itself, the least accurate of them still 0.05 µm, by one thread."""
    return (rows.method == "cube_cells_exact") & (rows.error_um <= 0.05) & (rows.threads == 1)


def over_libm(rows: pd.DataFrame) -> float:
    """The fastest kernel of USID whose error is that of the scalar look-up, up to 1 %."""
    helix = rows[(rows.method == "usid_scalar") & (rows.setting == "0.5deg")].iloc[0]
    kept = (rows.method == "usid") & (rows.setting == "0.5deg") & (rows.error_um <= 1.01 * helix.error_um)
    return helix.ns_vertex / rows[kept].ns_vertex.min()


def bytes_target(table: pd.DataFrame) -> Target:
    """RSID at 0.1 degrees in double over the least that is as accurate, both surfaces together; in a full run."""
    rows = fast.plain_rows(table)
    grid = rows[(rows.method == "rsid_scalar") & (rows.setting == "0.1deg")].set_index("direction")
    what = "bytes of RSID at 0.1 degrees in double over the least as accurate"
    if grid.empty:
        return Target("bytes", what, 16, math.nan, open=True)
    kept = rows.method.isin([*KERNELS, "usid", "cube_cells_exact"])
    kept &= rows.error_um <= rows.direction.map(grid.error_um)
    least = rows[kept].groupby("direction").bytes.min()
    return Target("bytes", what, 16, grid.bytes.sum() / least.sum())


def exact(table: pd.DataFrame, triangles: int) -> Target:
    """Few sizes are in a quick run."""
    rows = table[(table.triangles == triangles) & (table.direction == "socket->ball")]
    what = f"socket to ball, exact (0.05 µm), {triangles // 1000}k triangles"
    if rows.empty:
        return Target(f"exact{triangles}", what, EXACT[triangles], math.nan, open=True)
    return timed(f"exact{triangles}", what, EXACT[triangles], rows, exact_rows(rows))


def of_contact(table: pd.DataFrame, gaps: pd.DataFrame) -> list[Target]:
    """Those of a pose: of touch the least ratio of the three gaps, at every size that was measured; of
    distances the median, see contact.over_distance(). What of all gaps is memory alone, `gaps` of a vertex say."""
    targets = []
    for triangles, least in contact.TOUCH.items():
        if triangles not in set(table.triangles):
            continue
        for method, how in {"culled": "any pose", "coherent": "along a motion"}.items():
            for library, name in contact.LIBRARIES.items():
                if library not in set(table.method):
                    continue
                judged = library == "fcl_collide"
                ratio = contact.ratios(table, method, triangles, library).min()
                key = f"{method}{triangles}" + ("" if judged else f"-{name.lower()}")
                what = f"touch against {name}, {triangles // 1000}k, {how}"
                targets.append(Target(key, what, least if judged else math.nan, ratio))
    for method, what in DISTANCE.items():
        aim = contact.DISTANCE if method in JUDGED else math.nan
        ours = table[(table.method == method) & (table.triangles == contact.TRIANGLES)].us_pose.median()
        floor = ours * floor_share(gaps) if method == "all_corners" else math.nan
        ratio = contact.over_distance(table, method)
        targets.append(Target(method, what, aim, ratio, unit="µs a pose", ours=ours, floor=floor))
    return targets


def floor_share(gaps: pd.DataFrame) -> float:
    """What the memory-bound baseline takes of the time of the fastest corners, both directions together."""
    corners = gaps[(gaps.storage == "corners") & kernels(gaps, 7, math.inf)]
    floor = gaps[gaps.method == "floor"]
    return sum(least(floor).groupby("direction").ns_vertex.min()) / sum(corners.groupby("direction").ns_vertex.min())


def least(floor: pd.DataFrame) -> pd.DataFrame:
    """The baseline's rows with its smallest table."""
    return floor[floor.bytes == floor.bytes.min()]


def timed(key: str, what: str, target: float, rows: pd.DataFrame, kept: pd.Series) -> Target:
    """How many times faster than Embree the fastest of the rows that are kept is; nan where none are."""
    if not kept.any():
        return Target(key, what, target, math.nan)
    floor = least(rows[rows.method == "floor"]).ns_vertex.min()
    best = rows[kept].sort_values("times_embree").iloc[-1]
    return Target(key, what, target, best.times_embree, unit="ns a vertex", ours=best.ns_vertex, floor=floor)


def kernels(rows: pd.DataFrame, error_um: float, most_bytes: float) -> pd.Series:
    """Those that are as accurate and as small."""
    return rows.method.isin(KERNELS) & (rows.error_um <= error_um) & (rows.bytes <= most_bytes)


def of_set(rows: pd.DataFrame, sets: list[str]) -> tuple[pd.DataFrame, pd.Series]:
    """Rows of one instruction set, and which of them are as accurate and as small."""
    own = rows[rows.instruction_set.isin(sets)]
    return own, kernels(own, 7, MIB)


def over_floor(rows: pd.DataFrame) -> float:
    """The fastest cube that is as accurate as the others over a floor whose table is as large, up to 3 %."""
    cubes = rows[(rows.method == KERNELS[1]) & (rows.error_um <= 7)]
    pairs = cubes.merge(rows[rows.method == "floor"], how="cross")
    alike = (pairs.bytes_x / pairs.bytes_y - 1).abs() <= 0.03
    return (pairs.ns_vertex_x / pairs.ns_vertex_y)[alike].min()


def over_thesis(rows: pd.DataFrame) -> float:
    """The fastest kernel that is no worse in half the memory than the scalar grid at half a degree."""
    grid = rows[(rows.method == "rsid_scalar") & (rows.setting == "0.5deg")].iloc[0]
    kept = rows.method.isin(KERNELS) & (rows.error_um <= grid.error_um) & (rows.bytes <= grid.bytes / 2)
    return grid.ns_vertex / rows[kept].ns_vertex.min()


def latex(rows: pd.DataFrame) -> str:
    """What, target, measured, met."""
    lines = []
    for row in rows.itertuples():
        cells = (row.what, row.target, row.measured or "---", row.met)
        lines.append([common.tex(cell) for cell in cells])
    return common.tabular("@{}lrrl@{}", [r"ratio & target & measured & met \\"], lines)


common.run(main)
