# SPDX-License-Identifier: GPL-3.0-or-later
# @data      all_gaps contact contact_agreement motion_frames stability stability_detail stability_families
# @depends   tables/cohort-comparison.csv
"""Numbers of the paper about single experiments, of each a few."""

from pathlib import Path

import pandas as pd

import common
from common import fast, stability

SETTING = "n=291"  # of the cube
TRIANGLES = 12000  # of each model


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    studies = (cohort, all_gaps, touch, replay, stiff)
    return {key: text for study in studies for key, text in study(results).items()}


def cohort(results: Path) -> dict[str, str]:
    """cohort:hips, :found, the published statistics that were to come out of it, and :holds, those that did within its 95 %
    interval; :rotation and :published of controls, degrees; :torsion and :alpha, per cent of the variance of internal rotation.
    """
    table = pd.read_csv(results / "tables" / "cohort-comparison.csv")
    found, ours = table[table.role == "found"], table.set_index("statistic")
    return {
        "cohort:hips": f"{table.hips.iloc[0]:,}",
        "cohort:found": str(len(found)),
        "cohort:holds": str((found.holds == "yes").sum()),
        "cohort:rotation": common.digits(ours.ours["internal rotation at 90, controls"]),
        "cohort:published": common.digits(ours.published["internal rotation at 90, controls"]),
        "cohort:torsion": f"{ours.ours['variance by torsion alone']:.0f}",
        "cohort:alpha": f"{ours.ours['variance by alpha alone']:.0f}",
    }


def all_gaps(results: Path) -> dict[str, str]:
    """By the cube of 291 cells in 16 bits: fast:set the instruction set, fast:ns and :um of the vertices of the socket against
    the ball, fast:ball and fast:socket how many times as fast as Embree's best rays it is against either surface, fast:embree_um their error, fast:floor
    how many times as long as the memory-bound baseline it takes.
    """
    table = fast.load(results)
    rows = fast.plain_rows(table)
    rows = rows[(rows.setting == SETTING) & (rows.storage == "uint16")]
    cube, floor = (
        rows[rows.method == method].set_index("direction") for method in ("cube_gnomonic_mesh_exact", "floor")
    )
    ball, socket = cube.loc["socket->ball"], cube.loc["ball->socket"]
    rays = fast.plain_rows(table)
    rays = rays[rays.method.str.startswith("embree_ray") & (rays.direction == "socket->ball")].nsmallest(1, "ns_vertex").iloc[0]
    values = {
        "ns": ball.ns_vertex,
        "um": ball.error_um,
        "embree_um": rays.error_um,
        "ball": ball.times_embree,
        "socket": socket.times_embree,
        "floor": ball.ns_vertex / floor.ns_vertex["socket->ball"],
    }
    return {"fast:set": fast.set_name(table)} | {f"fast:{key}": common.digits(value, 2) for key, value in values.items()}


def touch(results: Path) -> dict[str, str]:
    """contact:culled:us the longest time of the three gaps at 12,000 triangles, contact:culled:fcl the least ratio of FCL's time
    to it, contact:poses, :wrong, :between and :unexplained of the agreement, contact:impinged the poses with impinged
    surfaces, and contact:missed those of them without an impinged vertex.
    """
    table = fast.contacts(results)
    times = table[table.triangles == TRIANGLES].pivot(index="gap_case", columns="method", values="us_pose")
    agreed = common.load(results, "contact_agreement").iloc[0]
    wrong = agreed.culled_wrong + agreed.least_gap_wrong
    counts = {"poses": agreed.poses, "impinged": agreed.impinged + agreed.missed, "missed": agreed.missed}
    counts |= {"wrong": wrong, "between": agreed.between_vertices, "unexplained": agreed.unexplained}
    return {
        "contact:culled:us": common.digits(times.culled.max(), 2),
        "contact:culled:fcl": common.digits((times.fcl_collide / times.culled).min(), 2),
        **{f"contact:{name}": str(int(count)) for name, count in counts.items()},
    }


def replay(results: Path) -> dict[str, str]:
    """Of the recorded motions: replay:poses, and :overlapping of them."""
    frames = common.load(results, "motion_frames")
    return {"replay:poses": str(len(frames)), "replay:overlapping": str((frames.smallest_gap_mm <= 0).sum())}


def stiff(results: Path) -> dict[str, str]:
    """stability:families, :situations (family and magnitude) and :stiff ones, :cases, :wrong (answers of ours, in words) and :refused; :silent, withheld
    or unbounded answers by class of ours, per cent, and :silent:1 of tables of 1 degree; of bounds :held, :broken, :infinite and :unanswered; :withheld
    look-ups, :unbounded ones; families whose mutation is :noticed; stability:share, the largest error of ours over what its analysis allows, in per cent.
    """
    cases = stability.load(results)
    families = stability.families(results)
    ours = cases[cases.kind == "ours"]
    bounds = stability.bounds(ours)
    silent = ours.groupby("who")[["silent", "asked"]].sum().loc[stability.OURS]
    silent = 100 * silent.silent / silent.asked
    situations = ours.drop_duplicates(["family", "magnitude"])
    in_double = ours[ours.scalar == "double"]
    allowed = in_double.family.map(families.threshold)
    share = (in_double.error_over_condition_u / allowed)[allowed > 0]
    return {
        "stability:families": str(len(families)),
        "stability:cases": f"{len(ours):,}",
        "stability:situations": str(len(situations)),
        "stability:stiff": str(int((ours.groupby(["family", "magnitude"]).condition.max() > stability.STIFF).sum())),
        "stability:silent": ", ".join(f"{common.digits(share, 2)} % ({who})" for who, share in silent.items()),
        "stability:silent:1": common.digits(silent["tables, 1°"], 2),
        "stability:wrong": f"{int(ours.failures.sum())} answers were wrong" if ours.failures.sum() else "no answer was wrong",
        **{f"stability:{what}": f"{(bounds == what).sum():,}" for what in ("held", "broken", "infinite", "unanswered")},
        "stability:withheld": f"{int(ours.withheld.sum()):,}",
        "stability:unbounded": f"{int(ours.unbounded.sum()):,}",
        "stability:noticed": "all" if (families.mutation_noticed > 0).all() else str(int((families.mutation_noticed > 0).sum())),
        "stability:refused": str(int((ours.refused > 0).sum())),
        "stability:share": common.digits(100 * share.max(), 2),
    }
