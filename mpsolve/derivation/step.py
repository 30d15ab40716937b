"""One step of a derivation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeAlias

Expr: TypeAlias = Any
"""An expression of sympy."""


@dataclass(frozen=True)
class Step:
    """One statement: its number, what it is, the sympy equation (or a tuple of them), and how it follows."""

    number: str
    title: str
    statement: Expr
    note: str
