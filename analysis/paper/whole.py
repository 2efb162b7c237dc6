# SPDX-License-Identifier: GPL-3.0-or-later
# @data      limit_time touch_time turns motion_volume
"""What the paper on motion says of time and misses beside other libraries: of real joints with whole bones, or of the generated
hip where a run has none.

whole:scene, of what; :motions, how many limits; :ours, seconds of processor time for all, trees made; :steps and :all, sentences
on steps; :volume, one on all rotations; :touch, one on single poses; turns:said, one on the test set of turns.
"""

from pathlib import Path

import pandas as pd

import common
from common import limit_time, motion_limits, volume

MADE = ("implant", "needle", "normal hip")  # the names of joints that are no real ones begin so
OURS = "turn_limit"
FCL = "fcl_collide"


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    every = limit_time.load(results)
    return limits(every) | {"whole:touch": touch(results), "whole:volume": shares(results), "turns:said": turns(results)}


def of_whole(table: pd.DataFrame) -> pd.DataFrame:
    """The rows of real joints, or of the generated hip."""
    made = table.joint.str.startswith(MADE)
    return table[~made] if (~made).any() else table[table.joint.str.startswith("normal hip")]


def span(values: pd.Series) -> str:
    """From the least to the most, or the only one."""
    return " to ".join(dict.fromkeys(common.digits(value, 2) for value in (values.min(), values.max())))


def limits(every: pd.DataFrame) -> dict[str, str]:
    """Of all motions, and how much longer steps take."""
    table = of_whole(every)
    ours, ranges, fcl = (table[table.method == method] for method in (OURS, f"{OURS}_ranges", FCL))
    coarse, fine = fcl[fcl.step_deg == fcl.step_deg.max()], fcl[fcl.step_deg == fcl.step_deg.min()]
    joints, faces = table.joint.nunique(), " to ".join(dict.fromkeys(f"{size:,}" for size in (table.faces.min(), table.faces.max())))
    made = table.joint.iloc[0].startswith(MADE)
    longer = f"FCL in steps of {fine.step_deg.iloc[0]:g}° takes {span(fine.times_ours)} times as long"
    rough = f"in steps of {coarse.step_deg.iloc[0]:g}° {span(coarse.times_ours)} times"
    lost = f"which miss {coarse.missed.sum() or 'none'} of these {coarse.asked.sum()} contacts"
    return {
        "whole:scene": f"a generated hip of {faces} faces" if made else f"the whole bones of {joints} real joints of {faces} faces",
        "whole:motions": str(ours.motions.max()),
        "whole:ours": f"{span(ours.total_ms / 1e3)} s",
        "whole:steps": f"{longer}, {rough}, {lost}.",
        "whole:all": f"From meshes to limits ours takes {span(ours.total_ms / 1e3)} s, with the interval for every centre {span(ranges.total_ms / 1e3)} s. "
        f"{longer}, {rough}; {missed(fcl)}. {agreed(ours, fine)} "
        f"{of_cropped(every)} "
        f"{of_made(every, 'needle', 'On a needle that passes thin spikes,')} {of_made(every, 'implant', 'On an implant, whose head and cup are close all round,')}",
    }


def missed(rows: pd.DataFrame) -> str:
    """Of the contacts asked for, by step."""
    steps = rows.groupby("step_deg", sort=False)[["missed", "asked"]].sum()
    parts = [f"{row.missed} in steps of {step:g}°" for step, row in steps.iterrows() if row.missed]
    return f"of {steps.asked.max()} contacts it misses {', '.join(parts) or 'none'}"


def agreed(ours: pd.DataFrame, fine: pd.DataFrame) -> str:
    """How far both are from the smallest angle at which CGAL finds a common point."""
    own = ours.largest_error_deg.max()
    words = "no method found a contact before ours" if own == 0 else f"a contact was found up to {common.digits_up(own, 2)}° before ours"
    return f"By CGAL's exact signs {words}; FCL's limits, halved to 0.01°, come at most {common.digits_up(fine.largest_error_deg.max(), 2)}° later."


def of_made(every: pd.DataFrame, begins: str, words: str) -> str:
    """Steps of FCL on a scene that is made for it."""
    rows = every[every.joint.str.startswith(begins) & (every.method == FCL)]
    takes = f"it takes {span(rows.times_ours)} times as long as ours"
    return f"{words} {missed(rows) if rows.missed.any() else takes}."


def of_cropped(every: pd.DataFrame) -> str:
    """The coarsest steps on the generated hip, which is small."""
    rows = every[every.joint.str.startswith("normal hip")]
    coarse = rows[rows.step_deg == rows.step_deg.max()]
    ways = [f"{row.line.split(',')[0]} {common.digits(row.times_ours, 2)} times as long as ours, missing {int(row.missed) or 'none'}" for row in coarse.itertuples()]
    return f"On the cropped generated hip, of {int(rows.faces.iloc[0]):,} faces, such steps take: {'; '.join(ways)}." if ways else ""


WIDTH = 0.05  # of all rotations, that may stay open


def shares(results: Path) -> str:
    """All rotations of real joints."""
    table = volume.load(results)
    real = table[~table.joint.isin(motion_limits.GENERATED) & (table.width == WIDTH)]
    rows = real[real.proven <= WIDTH]
    if not len(rows):
        return "All rotations of real joints are bounded to that width in a full run alone."
    ends = f"{common.rounded_down(100 * rows.low.min(), 1)} and {common.rounded_up(100 * rows.high.max(), 1)} %"
    joints = real.joint.str.removesuffix(" whole")
    few = f" (of {joints.nunique()}; those of the others stay wider)" if joints[rows.index].nunique() < joints.nunique() else ""
    return (
        f"The free share of all rotations of {joints[rows.index].nunique()} real joints{few}, cropped or whole, is between {ends}, and known to within"
        f" {100 * WIDTH:g} % after {span(rows.time_s)} s on two threads."
    )


def touch(results: Path) -> str:
    """Poses a second, over FCL's."""
    every = common.load(results, "touch_time")
    table = of_whole(every)
    rows = table[table.method == "body_pairs"].sort_values("rate_over_fcl")
    hip = every[(every.method == "body_pairs") & every.joint.str.startswith("normal hip")].sort_values("rate_over_fcl")
    ends, small = ([f"{common.digits(row.rate_over_fcl, 2)} ({row.state}, {row.poses})" for row in (of.iloc[0], of.iloc[-1])] for of in (rows, hip))
    wrong = int(table.otherwise.sum())
    same = "All answers are those of CGAL's exact signs" if wrong == 0 else f"{wrong} answers are not those of CGAL's exact signs"
    return (
        f"Ours decides between {ends[0]} and {ends[1]} times as many a second as FCL's trees of boxes, in the median {common.digits(rows.rate_over_fcl.median(), 2)} times as "
        f"many; on the cropped generated hip between {small[0]} and {small[1]} times. Trees are made before; {rows['count'].min()} poses of each kind. {same}."
    )


def turns(results: Path) -> str:
    """Ours, and the range of the others."""
    table = common.load(results, "turns")
    table["setting"] = table.setting.fillna("")
    sums = table.groupby(["method", "setting"])[["queries", "meet", "missed", "false_hits", "early"]].sum()
    ours = sums[sums.index.get_level_values(0).str.startswith("turn_")]
    others = sums.drop(ours.index)
    shares = 100 * others.missed / others.meet
    own = ours.iloc[ours.queries.argmax()]
    return (
        f"Of {own.queries:,} queries {own.meet:,} meet; ours misses {ours.missed.max()} and finds {ours.false_hits.max()} false ones. At {own.early} grazes it is early, "
        f"since what is within rounding counts as touching. The {len(others)} other ways, by continuous collision detection and in steps, miss {span(shares)} % of what they were asked."
    )
