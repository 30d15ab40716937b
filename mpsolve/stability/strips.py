"""Undecided strips as text: their ends rounded outward, and their widths."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from mpsolve.numbers.decimals import outward
from mpsolve.numbers.exact import Exact
from mpsolve.problem.specs import label
from mpsolve.stability.search import Strip

UNIT = (Exact.parse(0), Exact.parse(1))
_PLACES = 8
_FEW = 3


def ends(strip: Strip, limits: tuple[Exact, Exact]) -> tuple[str, str, str]:
    """Start and end, outward but not beyond the limits of the range that was searched, and width."""
    low, high = limits
    start = label(low) if strip.start <= float(low) else outward(strip.start, _PLACES, up=False)
    end = label(high) if strip.end >= float(high) else outward(strip.end, _PLACES, up=True)
    return start, end, f"{strip.end - strip.start:.2g}"


def lines(symbol: str, strips: Iterable[Strip], limits: tuple[Exact, Exact], remedy: str) -> tuple[str, ...]:
    """A line for each strip with its width and reason, and the remedy."""
    said = []
    for strip in strips:
        start, end, width = ends(strip, limits)
        said.append(f"{start} ≤ {symbol} ≤ {end} ({width} wide): {strip.reason}")
    return (*said, remedy)


def remark(name: str, strips: tuple[Strip, ...], limits: tuple[Exact, Exact]) -> str:
    """What a reason ends with, such as " (open: alpha in [0.93, 0.95], 0.02 wide)"; at most three strips of them."""
    if not strips:
        return ""
    parts = ["[{}, {}], {} wide".format(*ends(strip, limits)) for strip in strips[:_FEW]]
    more = f"; {len(strips) - _FEW} more" if len(strips) > _FEW else ""
    return f" (open: {name} in {'; '.join(parts)}{more})"


def data(strips: Iterable[Strip]) -> list[dict[str, Any]]:
    """For machines: float64 ends, outward."""
    return [{"start": strip.start, "end": strip.end, "reason": strip.reason} for strip in strips]
