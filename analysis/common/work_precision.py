# SPDX-License-Identifier: GPL-3.0-or-later
"""Error against run time for all gaps of a pose, both scans, from data/all_gaps.csv: a row per scene, line and setting.

The error is the worst gap of both scans in the poses of a motion (vertices of the ball against the socket, and vertices of the
socket against the ball). The time of n poses is that of building both sides plus n times that of one pose.
"""

from pathlib import Path

import numpy as np
import pandas as pd

import common
from common import fast

# Method and storage of each line; Embree's rays are one line, the fastest of which counts.
LINES = {
    ("rsid_thesis", "double"): "thesis, RSID",
    ("usid_thesis", "double"): "thesis, USID",
    ("conchoid", "double"): "conchoid",
    ("icosahedral_gnomonic_mesh_exact", "double"): "icosahedral",
    ("rsid", "float"): "RSID, vectors",
    ("usid", "float"): "USID, vectors",
    ("cube_gnomonic_mesh_exact", "uint16"): "cube, 16 bits",
    ("cube_cells_exact", "float"): "exact cells",
    ("embree_ray1", "none"): "Embree",
    ("embree_ray8", "none"): "Embree",
    ("embree_ray16", "none"): "Embree",
    ("cgal_first_hit", "none"): "CGAL",
}
THESIS = ["thesis, RSID", "thesis, USID"]
POSES = {"one": 1, "thousand": 1000, "million": 1000000}  # columns of times, ms
# Each step towards the kernel that is used: what, method, storage. The last leaves out what the one before has.
ABLATION = {
    "RSID, vertex by vertex, double": ("rsid_scalar", "double"),
    "+ vector instructions": ("rsid", "double"),
    "+ float": ("rsid", "float"),
    "+ 16 bits": ("rsid", "uint16"),
    "+ layout: cube map": ("cube_gnomonic_mesh_exact", "uint16"),
    "- mask of the rim": ("cube_no_mask", "uint16"),
}
PRECISION = 0.5  # degrees, of the ablation and of what is said in words


def both_scans(results: Path) -> pd.DataFrame:
    """A row per scene, method, setting and storage. Columns: `precision_deg`; the largest errors `error_um` of a gap and
    `anywhere_um` of a radius in any direction; `bound_um`; sums over both scans of `build_ms`, `bytes` and `false_hits`; the
    time `pose_us` of a pose; and the time `single_ns` of a vertex asked alone.
    """
    table = common.load(results, "all_gaps")
    drawn = table[table.state == "alone"].scene.unique()
    table = fast.one_thread(table[table.scene.isin(drawn) & (table.measure == "radial") & (table.method != "floor")])
    table = table.assign(
        anywhere_um=table[["max_over_um", "max_under_um"]].max(axis=1), pose_us=table.ns_vertex * table.vertices / 1e3
    )
    keys = ["scene", "method", "setting", "storage"]
    warm = table[table.state == "warm"].groupby(keys, sort=False)
    rows = warm.agg(
        error_um=("scan_um", "max"),
        anywhere_um=("anywhere_um", "max"),
        bound_um=("bound_um", lambda of: of.max(skipna=False)),
        build_ms=("build_ms", "sum"),
        pose_us=("pose_us", "sum"),
        bytes=("bytes", "sum"),
        false_hits=("false_hits", "sum"),
        directions=("directions", "sum"),
    )
    rows["single_ns"] = table[table.state == "alone"].groupby(keys).ns_vertex.mean()
    rows = rows.reset_index()
    rows["precision_deg"] = rows.setting.map(precision)
    return rows


def precision(setting: str) -> float:
    """Degrees for a setting such as 0.5deg or n=180, else nan."""
    if setting.startswith("n="):
        return 90 / int(setting[2:])
    return float(setting[:-3]) if setting.endswith("deg") else np.nan


def load(results: Path) -> pd.DataFrame:
    """The rows of LINES, with `line`, `step` (what is written at a point), and the times of POSES in ms."""
    rows = both_scans(results)
    rows["line"] = [LINES.get(key) for key in zip(rows.method, rows.storage)]
    rows = rows.dropna(subset="line").copy()
    rows["step"] = [
        f"{row.precision_deg:.2g}°" if np.isfinite(row.precision_deg) else row.setting if row.line == "exact cells" else ""
        for row in rows.itertuples()
    ]
    rows["single"] = rows.single_ns
    for name, poses in POSES.items():
        rows[name] = rows.build_ms + poses * rows.pose_us / 1e3
    return rows[(rows.line != "cube, 16 bits") | rows.precision_deg.isin(degrees(rows))]


def degrees(rows: pd.DataFrame) -> list[float]:
    """The precisions of the thesis' tables; every line has them."""
    return list(rows[rows.line.isin(THESIS)].precision_deg.unique())


def scenes(rows: pd.DataFrame) -> dict[str, str]:
    """The scenes that are shown: the hip, the generated pair, and a real hip if there is one."""
    found = {}
    for scene in rows.scene.unique():
        kind = "hip" if scene.startswith(fast.HIPS) else "generated" if scene.startswith("generated_") else "real"
        found.setdefault(kind, scene)
    return found


def scene_title(scene: str) -> str:
    """What a reader calls a scene: "a synthetic normal hip, 12,000 triangles a bone"."""
    *words, count = scene.removeprefix(fast.HIPS).split("_")
    if scene.startswith(fast.HIPS):
        return f"a synthetic {' '.join(words)} hip, {int(count):,} triangles a bone"
    if scene.startswith("generated_"):
        return f"a generated ball and socket, {int(count):,} triangles each"
    return f"the real joint {scene.replace('_', ' ')}"


def fastest(rows: pd.DataFrame, column: str) -> pd.DataFrame:
    """One point per line and setting; of Embree's rays only the fastest."""
    embree = rows.line == "Embree"
    return pd.concat([rows[~embree], rows[embree].nsmallest(1, column)])


def pays_from(table: pd.Series, tree: pd.Series) -> float:
    """The number of poses from which the table is faster than the tree, building included; infinite if it never is."""
    gain = (tree.pose_us - table.pose_us) / 1e3
    lead = table.build_ms - tree.build_ms
    if gain <= 0:
        return np.inf
    return max(1.0, np.ceil(lead / gain))


def ablation(results: Path) -> pd.DataFrame:
    """The hip at half a degree: each step with its time, its speed relative to the step before, its error and its memory."""
    rows = both_scans(results)
    rows = rows[(rows.scene == scenes(rows)["hip"]) & (rows.precision_deg == PRECISION)].set_index(["method", "storage"])
    found = rows.loc[list(ABLATION.values())].reset_index()
    found.insert(0, "step", list(ABLATION))
    found["times"] = found.pose_us.shift() / found.pose_us
    found["beyond_rim_percent"] = 100 * found.false_hits / found.directions
    found["KiB"] = found.bytes / 1024
    return found[["scene", "step", "pose_us", "times", "error_um", "KiB", "beyond_rim_percent"]]


def sentences(results: Path) -> dict[str, str]:
    """What the diagram of the hip shows, in words, and how a real joint differs."""
    rows = load(results)
    own = rows[rows.scene == scenes(rows)["hip"]]
    return {"embree": against_embree(own), "pays": paying(own), "real": on_real(rows), "ablation": bringing(ablation(results))}


def on_real(rows: pd.DataFrame) -> str:
    """Errors on the real joint, and from how many poses a table pays there."""
    scene = scenes(rows).get("real")
    if not scene:
        return "Real joints have other errors; a run with them tells."
    own = rows[rows.scene == scene]
    thesis, cells = own[own.line.isin(THESIS)], own[own.line == "exact cells"]
    ends = " to ".join(dict.fromkeys(common.digits(error, 2) for error in (thesis.error_um.min(), thesis.error_um.max())))
    return (
        f"On {scene_title(scene)} the thesis' tables err by {ends} µm, exact cells by {common.digits(cells.error_um.max(), 2)} µm. "
        + paying(own).replace("Building included, a table", "A table")
    )


def against_embree(own: pd.DataFrame) -> str:
    """Where Embree beats the thesis' tables in both error and time."""
    thesis = own[own.line.isin(THESIS)]
    parts = []
    for column, words in {
        "single": "for a single query",
        "one": "for one pose",
        "thousand": "for 1,000 poses",
        "million": "for 1,000,000 poses",
    }.items():
        tree = own[own.line == "Embree"].nsmallest(1, column).iloc[0]
        beaten = (thesis[column] > tree[column]) & (thesis.error_um > tree.error_um)
        parts.append(f"{beaten.sum()} {words}")
    rays = own[own.line == "Embree"]
    ends = dict.fromkeys(common.digits(error, 2) for error in (thesis.error_um.min(), thesis.error_um.max()))
    return (
        f"In the poses of this motion Embree errs by at most {common.digits(rays.error_um.max(), 2)} µm (along other rays, beside rims, by up to "
        f"{common.digits(rays.anywhere_um.max() / 1000, 2)} mm), the thesis' tables of {max(degrees(own)):g}° to "
        f"{min(degrees(own)):g}° by {' to '.join(ends)} µm. Of these {len(thesis)} tables it is both faster "
        f"and more exact than {', '.join(parts)} (building included, but for a single query)."
    )


def paying(own: pd.DataFrame) -> str:
    """The number of poses from which a table pays."""
    tree = own[own.line == "Embree"].nsmallest(1, "thousand").iloc[0]
    parts = []
    for line in ("thesis, RSID", "RSID, vectors", "cube, 16 bits", "exact cells"):
        rows = own[(own.line == line) & ((own.precision_deg == PRECISION) | own.precision_deg.isna())]
        row = rows.loc[rows.pose_us.idxmin()]
        poses = pays_from(row, tree)
        name = line + (f" at {row.step}" if row.step else "")
        parts.append(f"{name}: {'never' if np.isinf(poses) else f'{poses:,.0f}'}")
    return f"Building included, a table is done sooner than Embree from so many poses on: {'; '.join(parts)}."


def bringing(steps: pd.DataFrame) -> str:
    """The gain of each step."""
    brought = [f"{row.step.removeprefix('+ ')} {common.digits(row.times, 2)}" for row in steps[1:-1].itertuples()]
    whole, last = steps.pose_us.iloc[0] / steps.pose_us.iloc[-2], steps.iloc[-1]
    return (
        f"At {PRECISION:g}° the kernel is {common.digits(whole, 2)} times as fast as the scalar scan in double. Factors of time, "
        f"each on top of the one before: {', '.join(brought)}. Without the mask of the rim it would be "
        f"{common.digits(last.times, 3)} times as fast, and {common.digits(last.beyond_rim_percent, 2)} % of the directions looked "
        f"at would get a gap where there is no surface."
    )
