"""Forged certificates: what committed files hold, changes of it, and files whose digest is made anew."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

Content = dict[str, Any]
Change = Callable[[Content], Any]
CERTS = Path(__file__).parents[1] / "certs"


@cache
def raw(name: str) -> bytes:
    """A committed file, as "single_mass", "ranges/chart_over_damping" or "roots/sine"."""
    return (CERTS / f"{name}.json").read_bytes()


def stored(name: str) -> Content:
    """What stands in it, to be changed."""
    return dict(json.loads(raw(name)))


def sealed(content: Content) -> Content:
    """With the digest that fits, which is computed here once more."""
    rest = {key: value for key, value in content.items() if key != "sha256"}
    canonical = json.dumps(rest, sort_keys=True, separators=(",", ":"), ensure_ascii=True)
    return rest | {"sha256": hashlib.sha256(canonical.encode("ascii")).hexdigest()}


def as_file(content: Content) -> bytes:
    """The same as the bytes of a file."""
    return json.dumps(sealed(content)).encode("ascii")


def put(*path: Any) -> Change:
    """The change that puts the last of the arguments where the others lead to."""
    *where, last, value = path

    def change(content: Content) -> None:
        place: Any = content
        for key in where:
            place = place[key]
        place[last] = value

    return change
