"""Certificates as JSON (certs/SPEC2.md, certs/SPEC-ROOTS.md): the equations, the claim and the steps, exactly."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
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


_ABOUT = ("case", "equations")
_MOST = 64_000_000


def own_name(path: Path, content: Mapping[str, Any]) -> Path:
    """`path` if nothing is there, or a certificate of the same case; else one with eight digits of its digest.

    content: that of the certificate that is to be written. What is not a certificate is not overwritten either.
    """
    about = _about(content)
    if not path.exists() or _about(_read(path)) == about:
        return path
    stem, dot, ending = path.name.partition(".")
    return path.with_name(f"{stem}-{digest(about)[:8]}{dot}{ending}")


def _about(content: Mapping[str, Any]) -> dict[str, Any]:
    return {key: content[key] for key in _ABOUT if key in content}


def _read(path: Path) -> dict[str, Any]:
    """What a file holds, nothing where it is no certificate."""
    try:
        if path.stat().st_size > _MOST:
            return {}
        content = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    return content if isinstance(content, dict) else {}
