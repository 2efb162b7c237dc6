# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares published populations of hips with a cohort of ours. By hand, for a cohort that the program of that name merged:
PYTHONPATH=analysis python3 -m common.cohort DIR/cohort.csv writes the comparison as CSV."""

import sys
from pathlib import Path

import numpy as np
import pandas as pd

ROTATION = "internal_rotation_at_90_deg"
HACK = "Hack 2010"
AUDENAERT = "Audenaert 2012"
REICHENBACH = "Reichenbach 2010"
GROUPS = {"controls": 27.9, "controls with features of impingement": 21.1, "patients": 12.3}
CAM = 50.5  # degrees of alpha, above which Hack counts a cam
HIGH = 60.0  # of alpha at 1:30, above which ours stand for patients: our choice
DRAWS = 500  # of the bootstrap, seeded
PREDICTORS = ["alpha_1_30", "lateral_centre_edge", "femoral_torsion"]  # cam, coverage and femoral version
WIDER = ["version", "joint_space", "half_opening", "head_neck_offset", "cam_height", "neck_shaft_angle"]


def limits(hips: pd.DataFrame) -> pd.DataFrame:
    """The same hips, without the angle of those whose rotation meets nothing or cannot begin: it is no limit."""
    state = ROTATION.replace("_deg", "_state")
    return hips.assign(**{ROTATION: hips[ROTATION].where(hips[state] == "limited")}) if state in hips else hips


def explained(hips: pd.DataFrame, columns: list[str]) -> float:
    """Share of the variance of internal rotation that a linear regression on these columns explains."""
    hips = hips[hips[ROTATION].notna()]
    y = hips[ROTATION].to_numpy()
    x = np.column_stack([np.ones(len(hips)), hips[columns].to_numpy()])
    left = y - x @ np.linalg.lstsq(x, y, rcond=None)[0]
    return float(1 - left.var() / y.var())


def share_of_cams(hips: pd.DataFrame, below: float) -> float:
    """P(cam given internal rotation below), where the 24 % of hips with the largest alpha at 1:30 have one."""
    cam = hips.alpha_1_30 > hips.alpha_1_30.quantile(0.76)
    stiff = hips[ROTATION] < below
    return float(cam[stiff].mean()) if stiff.any() else float("nan")


def group(hips: pd.DataFrame, name: str) -> pd.Series:
    """Internal rotation of the hips that stand for a group, chosen by alpha at 1:30."""
    alpha = hips.alpha_1_30
    chosen = {
        "controls": alpha <= CAM,
        "controls with features of impingement": (alpha > CAM) & (alpha <= HIGH),
        "patients": alpha > HIGH,
    }
    return hips[ROTATION][chosen[name]]


def statistics(hips: pd.DataFrame) -> dict[str, float]:
    """All compared numbers of one cohort."""
    rotation = hips[ROTATION]
    found = {
        "alpha at 3:00, mean": hips.alpha_3_00.mean(),
        "alpha at 3:00, sd": hips.alpha_3_00.std(),
        "alpha at 1:30, mean": hips.alpha_1_30.mean(),
        "alpha at 1:30, sd": hips.alpha_1_30.std(),
        "share with alpha at 3:00 above 50.5": 100 * (hips.alpha_3_00 > CAM).mean(),
        "internal rotation at 90, mean": rotation.mean(),
        "internal rotation at 90, sd": rotation.std(),
    }
    for name in GROUPS:
        found[f"internal rotation at 90, {name}"] = group(hips, name).mean()
    found["controls less patients"] = group(hips, "controls").mean() - group(hips, "patients").mean()
    for name, column in zip(("alpha", "coverage", "torsion"), PREDICTORS):
        found[f"variance by {name} alone"] = 100 * explained(hips, [column])
    found["variance by alpha, coverage, torsion"] = 100 * explained(hips, PREDICTORS)
    found["the same with version, joint space, opening, offset, cam height, CCD"] = 100 * explained(hips, PREDICTORS + WIDER)
    found["P(cam), internal rotation below 30"] = 100 * share_of_cams(hips, 30)
    found["P(cam), the stiffest quarter"] = 100 * share_of_cams(hips, rotation.quantile(0.25))
    return found


# What is published of each, where and whether it went into the study.
PUBLISHED = {
    "alpha at 3:00, mean": (40.9, HACK, True),
    "alpha at 3:00, sd": (7.0, HACK, True),
    "alpha at 1:30, mean": (50.2, HACK, True),
    "alpha at 1:30, sd": (8.0, HACK, True),
    **{f"internal rotation at 90, {name}": (value, AUDENAERT, False) for name, value in GROUPS.items()},
    "controls less patients": (15.6, AUDENAERT, False),
    "variance by alpha, coverage, torsion": (75.0, AUDENAERT, False),
    "P(cam), internal rotation below 30": (48.0, REICHENBACH, False),
}


def comparison(hips: pd.DataFrame) -> pd.DataFrame:
    """A row per statistic: published, ours with its 95 % interval by a bootstrap over the hips, and whether it holds the former."""
    hips = limits(hips)
    ours = statistics(hips)
    random = np.random.default_rng(27)
    draws = DRAWS if len(hips) <= 3000 else DRAWS // 5
    again = pd.DataFrame([statistics(hips.iloc[random.integers(0, len(hips), len(hips))]) for _ in range(draws)])
    rows = []
    for name, value in ours.items():
        published, source, given = PUBLISHED.get(name, (float("nan"), "", False))
        low, high = again[name].quantile([0.025, 0.975])
        inside = "" if np.isnan(published) else "yes" if low <= published <= high else "no"
        rows.append(
            {
                "statistic": name,
                "published": published,
                "source": source,
                "role": "" if not source else "given" if given else "found",
                "ours": value,
                "low": low,
                "high": high,
                "holds": inside,
                "hips": len(hips),
            }
        )
    return pd.DataFrame(rows).round(2)


if __name__ == "__main__":
    print(comparison(pd.read_csv(Path(sys.argv[1]))).to_csv(index=False, lineterminator="\n"), end="")
