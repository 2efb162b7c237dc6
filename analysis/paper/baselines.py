# SPDX-License-Identifier: GPL-3.0-or-later
# @data      baselines slices_to_surface claims
"""Numbers of the paper about the comparison of Section 3.6, slices of a scan, and claims that were never shown.

baseline:METHOD:SIZE:COLUMN for the generated pair (shares in per cent, rms in micrometres); slices:SLICE:STAGE:rms
and :added in micrometres, :largest in mm; claim:NAME for what the text says of the claims.
"""

from pathlib import Path

import pandas as pd

import common


def facts(results: Path) -> dict[str, str]:
    """All of them."""
    return baselines(results) | slices(results) | claims(results)


def baselines(results: Path) -> dict[str, str]:
    """Every method at every size."""
    table = common.load(results, "baselines")
    table = table[table.joint == table.joint.iloc[0]]
    found = {"baseline:poses": f"{table.poses.iloc[0]:,}", "baseline:faces": f"{table.faces.iloc[0]:,}"}
    for row in table.itertuples():
        key = f"baseline:{row.method}:{row.size:g}"
        values = {
            "kB": row.bytes / 1e3,
            "build_ms": row.build_ms,
            "pose_us": row.pose_us,
            "triangles_missed": 100 * row.faces_missed / row.faces,
            "vertices_missed": 100 * row.points_missed / row.points,
            "rms_um": 1e3 * row.rms_error_mm,
            "false": 100 * row.false_touches / row.poses,
            "missed": 100 * row.missed_touches / row.poses,
        }
        found |= {
            f"{key}:{name}": common.digits(value, 2) for name, value in values.items() if not pd.isna(value)
        }
        found[f"{key}:within"] = f"{row.wrong_within_mm:g}"
    return found


def slices(results: Path) -> dict[str, str]:
    """Every stage at every distance of the slices."""
    table = common.load(results, "slices_to_surface")
    found = {}
    for row in table.itertuples():
        key = f"slices:{row.slice_mm:g}:{row.stage}"
        found |= {
            f"{key}:rms": common.digits(1e3 * row.rms_mm, 2),
            f"{key}:added": common.digits(1e3 * row.added_rms_mm, 2),
            f"{key}:largest": common.digits(row.largest_mm, 2),
        }
    return found


def claims(results: Path) -> dict[str, str]:
    """What the text says of each claim."""
    table = common.load(results, "claims")
    value = table.set_index(["setting", "quantity"]).value.to_dict()
    caps = [setting for setting, quantity in value if quantity == "time in place"]
    gains = {cap: value[cap, "time anew"] / value[cap, "time in place"] for cap in caps}
    collisions = table[table.quantity == "crossing pairs found"]
    within = {
        text: collisions[collisions.setting.str.endswith(f"within {text} mm")].value
        for text in ("0.01", "0.1")
    }
    false = table[table.quantity == "pairs found that do not cross"].value
    most = max(int(setting.split(", ")[1].split()[0]) for setting, quantity in value if quantity == "memory")
    memory = {scheme: value[f"{scheme}, {most} joints", "memory"] for scheme in ("rsid", "usid")}
    return {
        "claim:refill:narrow": common.digits(gains[caps[0]], 2),
        "claim:refill:wide": common.digits(gains[caps[-1]], 2),
        "claim:refill:narrow-cap": caps[0].split()[2],
        "claim:refill:wide-cap": caps[-1].split()[2],
        "claim:collision:pairs": f"{int(value['exact', 'pairs crossing']):,}",
        "claim:collision:tight": common.digits(within["0.01"].min(), 2),
        "claim:collision:tight-most": common.digits(within["0.01"].max(), 2),
        "claim:collision:wide": common.digits(within["0.1"].min(), 2),
        "claim:collision:false": f"{int(false.max()):,}",
        "claim:layers:facing": common.digits(
            1e3 * value["normal hip, under the socket", "distance added, rms error"], 2
        ),
        "claim:layers:neck": common.digits(
            value["normal hip, whole ball", "distance added, largest error"], 2
        ),
        "claim:pairs:joints": str(most),
        "claim:pairs:rsid": common.digits(memory["rsid"] / 1e6, 2),
        "claim:pairs:saved": common.digits(100 * (1 - memory["usid"] / memory["rsid"]), 2),
    }
