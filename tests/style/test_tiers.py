# SPDX-License-Identifier: GPL-3.0-or-later
"""Every test of a build has the label of exactly one tier. test_tiers.py BUILD CTEST."""

import json
import subprocess
import sys

TIERS = {"short", "gate", "nightly"}


def labels_of(test: dict) -> list[str]:
    return next((one["value"] for one in test["properties"] if one["name"] == "LABELS"), [])


def main() -> None:
    build, ctest = sys.argv[1:]
    said = subprocess.run([ctest, "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    tests = json.loads(said.stdout[said.stdout.index("{") :])["tests"]
    # A program that is not built lists no tests yet.
    wrong = [test["name"] for test in tests if len(TIERS & {*labels_of(test)}) != 1 and not test["name"].endswith("_NOT_BUILT")]
    if wrong or not tests:
        sys.exit(f"no label or more than one of {', '.join(sorted(TIERS))}: {', '.join(wrong) or 'there are no tests'}")


if __name__ == "__main__":
    main()
