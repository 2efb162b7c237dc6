# SPDX-License-Identifier: GPL-3.0-or-later
"""The record beside a CSV vouches for its bytes. Standard library only."""

import hashlib
import io
import json
from pathlib import Path


class Refused(Exception):
    """A result is missing or cannot be trusted; the message says which file and what to do."""


def digest(content: bytes | Path) -> str:
    """SHA-256 of a file or of bytes."""
    with io.BytesIO(content) if isinstance(content, bytes) else content.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def sidecar(csv: Path) -> dict:
    """The record beside a CSV. Refused unless it has the SHA-256 of the CSV's bytes."""
    path = csv.with_suffix(".json")
    remedy = f"remove {csv.name} and run experiments/reproduce again"
    if not csv.is_file():
        raise Refused(f"{csv} is not there: run experiments/reproduce")
    if not path.is_file():
        raise Refused(f"{csv} has no sidecar {path.name}: {remedy}")
    try:
        record = json.loads(path.read_text())
        expected = record["csv_sha256"]
    except (ValueError, KeyError, TypeError):
        raise Refused(f"{path} is no sidecar with a csv_sha256: {remedy}") from None
    if digest(csv) != expected:
        raise Refused(f"{csv} does not have the bytes that {path.name} vouches for: {remedy}")
    return record
