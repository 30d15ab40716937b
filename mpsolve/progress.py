"""How long work tells how far it has come."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

Progress: TypeAlias = Callable[[str, float], None]
"""Called with the name of a stage and the part of it that is done, from 0 to 1."""


def silent(stage: str, fraction: float) -> None:
    """A progress that nobody hears."""
