"""The SI unit of a dimension in words that engineers use."""

from __future__ import annotations

Dimension = tuple[int, int, int]
"""Powers of kg, m and s."""

_DERIVED = (
    ("N", (1, 1, -2)), ("m/s", (0, 1, -1)), ("N/m", (1, 0, -2)), ("N/m²", (1, -1, -2)), ("N m²", (1, 3, -2)),
    ("N m", (1, 2, -2)), ("N s/m", (1, 0, -1)), ("N s/m²", (1, -1, -1)), ("N s/m³", (1, -2, -1)),
)  # fmt: skip
_POWERS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def unit_of(dimension: Dimension) -> str:
    """The SI unit of a dimension in words that engineers use, "" for a bare number."""
    named = next((name for name, powers in _DERIVED if powers == dimension), None)
    if named:
        return named
    above = [_power(name, power) for name, power in zip(("kg", "m", "s"), dimension, strict=True) if power > 0]
    below = [_power(name, -power) for name, power in zip(("kg", "m", "s"), dimension, strict=True) if power < 0]
    under = f"({' '.join(below)})" if len(below) > 1 else "".join(below)
    return (" ".join(above) or ("1" if below else "")) + (f"/{under}" if below else "")


def _power(name: str, power: int) -> str:
    return name if power == 1 else name + str(power).translate(_POWERS)
