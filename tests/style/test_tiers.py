# SPDX-License-Identifier: GPL-3.0-or-later
"""Every test of a build has the label of exactly one tier. test_tiers.py BUILD CTEST."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

TIERS = {"short", "gate", "nightly"}


def labels_of(test: dict) -> list[str]:
    return next((one["value"] for one in test["properties"] if one["name"] == "LABELS"), [])


def main() -> None:
    build, ctest = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:  # where ctest leaves the log of the run alone that this test is part of
        (Path(folder) / "CTestTestfile.cmake").write_text(f'subdirs("{build}")\n')
        said = subprocess.run([ctest, "--show-only=json-v1"], cwd=folder, capture_output=True, text=True, check=True)
    tests = json.loads(said.stdout[said.stdout.index("{") :])["tests"]
    # A program that is not built lists no tests yet.
    wrong = [test["name"] for test in tests if len(TIERS & {*labels_of(test)}) != 1 and not test["name"].endswith("_NOT_BUILT")]
    if wrong or not tests:
        sys.exit(f"no label or more than one of {', '.join(sorted(TIERS))}: {', '.join(wrong) or 'there are no tests'}")


if __name__ == "__main__":
    main()
