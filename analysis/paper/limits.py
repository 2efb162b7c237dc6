# SPDX-License-Identifier: GPL-3.0-or-later
# @data      motion_limit_details phantoms
"""Numbers of the paper about limits of motion and phantoms.

limit:JOINT:MOTION and limit:JOINT:MOTION:clock of first contact; limits:count (with a bracket), :widest (of these, degrees),
:uncertainty:least and :most (degrees, to first order, of half a millimetre of a surface; 5 % and 95 % of the
contacts), :centre, how wide the interval for every centre within half a millimetre is, generated hips and real joints apart; :unbounded (limits without a proven upper end), :hanging (limits that are sensitive to less than that); joints:said, how many real ones; limits:panels, what the figure shows;
phantoms:limits:count, :error (largest, degrees), phantoms:gaps:count and :share (largest error of its bound, per cent).
"""

from pathlib import Path

import pandas as pd

import common
from common import motion_limits


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    return limits(results) | phantoms(results)


def limits(results: Path) -> dict[str, str]:
    """Of every joint about the centre of its head, and how much they depend on the input."""
    table = motion_limits.contacts(results)
    found = {}
    for row in table.itertuples():
        found[f"limit:{row.joint}:{row.motion}"] = motion_limits.text(row)
        found[f"limit:{row.joint}:{row.motion}:clock"] = str(row.clock)
    every = common.load(results, "motion_limit_details")
    brackets = every[every.state == "limited"]
    width = (brackets.limit_high_deg - brackets.limit_low_deg).max()
    limited = table[table.state == "limited"]
    real = table[~table.joint.isin(motion_limits.GENERATED)].joint.nunique()
    interval = limited.centre_high_deg - limited.centre_low_deg
    return found | {
        "joints:said": f"with {real} real joints" if real else "without real joints",
        "limits:panels": f"Left: generated hips; right: real joints.{odd(table)}" if real else "",
        "limits:count": str(len(brackets)),
        "limits:widest": common.rounded_up(width, 7).rstrip("0").rstrip("."),
        "limits:uncertainty:least": common.digits(limited.surface_deg.quantile(0.05), 2),
        "limits:uncertainty:most": common.digits(limited.surface_deg.quantile(0.95), 2),
        "limits:centre": motion_limits.over_centres(results),
        "limits:unbounded": str(int(interval.isna().sum())),
        "limits:hanging": str(int(limited.hangs_on_less.sum())),
    }


def odd(table: pd.DataFrame) -> str:
    """What a reader of the figure must know of real joints: which are no hips, and which touch in no motion."""
    shoulders = [motion_limits.label(joint) for joint in table.joint.unique() if "shoulder" in joint]
    free = [motion_limits.label(joint) for joint, rows in table.groupby("joint") if (rows.state == "free").all()]
    said = f" {', '.join(shoulders)}: a shoulder, turned by a hip's motions." if shoulders else ""
    return said + (f" Without contact in any motion: {', '.join(free)}." if free else "")


def phantoms(results: Path) -> dict[str, str]:
    """How far measured is from closed form."""
    table = common.load(results, "phantoms")
    limit = table.quantity.str.startswith("limit")
    gaps = table[~limit]
    return {
        "phantoms:limits:count": str(int(limit.sum())),
        "phantoms:limits:error": common.digits(table[limit].error.abs().max(), 2),
        "phantoms:gaps:count": str(len(gaps)),
        "phantoms:gaps:share": common.digits(100 * (gaps.error.abs() / gaps.bound).max(), 2),
    }
