"""Certificates as JSON (certs/SPEC2.md, certs/SPEC-ROOTS.md): the equations, the claim and the steps, exactly."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from typing import Any

from mpsolve.files import write_whole
from mpsolve.frozen import frozen

FORMAT = "mpsolve certificate"


@frozen
class Certificate:
    """A certificate's content; `text` is what stands in the file."""

    content: dict[str, Any]

    @property
    def text(self) -> str:
        """JSON with one line a number or root, so that two certificates can be compared by eye."""
        entries = ",\n".join(f"{json.dumps(key)}: {_lines(value)}" for key, value in self.content.items())
        return "{\n" + entries + "\n}\n"

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Writes the file whole or not at all; CertificateError if it cannot be written."""
        return write_whole(Path(path), self.text)


def _lines(value: Any) -> str:
    if isinstance(value, dict):
        return "{\n" + ",\n".join(f" {json.dumps(k)}: {_lines(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list) and any(isinstance(v, (list, dict)) for v in value):
        return "[\n" + ",\n".join("  " + json.dumps(v, allow_nan=False) for v in value) + "]"
    return json.dumps(value, allow_nan=False)


def digest(content: dict[str, Any]) -> str:
    """SHA-256 of the content in canonical JSON: sorted keys, no spaces, ASCII."""
    canonical = json.dumps(content, sort_keys=True, separators=(",", ":"), ensure_ascii=True, allow_nan=False)
    return hashlib.sha256(canonical.encode("ascii")).hexdigest()
