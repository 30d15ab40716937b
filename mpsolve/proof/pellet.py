"""Pellet's test: if |a_m| h^m > Σ_{k≠m} |a_k| h^k, the disc |z| < h holds exactly m roots of Σ a_k z^k."""

from __future__ import annotations

from typing import Any

from mpsolve.numbers.taylor import SAMPLES, Taylor


def pellet(series: Taylor, m: int, radius: Any) -> bool:
    """True if the disc of this radius about the centre is proved to hold exactly m roots."""
    if not radius > 0:
        return False
    ratio = radius / series.outer
    tail = series.bound * ratio**SAMPLES / (1 - ratio)
    others = sum((abs(a) * radius**k for k, a in enumerate(series.coefficients) if k != m), tail)
    return bool(ratio < 1 and abs(series.coefficients[m]) * radius**m > others)
