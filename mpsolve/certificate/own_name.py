"""A name for a certificate that overwrites no other case's."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from mpsolve.certificate.format import digest

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
