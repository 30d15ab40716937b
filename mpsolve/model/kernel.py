"""The kernel K(ξ, q) = ∫ e^{ipξ}/D(p, q) dp, eqs. (21), (37), and K_q, eq. (38): one formula for both sides.

    K(±x) = 2πi e^{isx/2} [ i (y ∓ h) sin(δx)/δ − 2 s cos(δx) ] / R,   x ≥ 0,

with δ² the upper (+) or lower (−) discriminant. cos and sin(δx)/δ are entire in δ², so that a collision of
two p-roots on one side of the real axis is no singularity.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from mpsolve.model.branch import Pairing, PairingRate, Track

AHEAD, BEHIND = 1, -1


def kernel_at_contact(track: Track, pair: Pairing) -> Any:
    """K(0, q) = −4πi s/R."""
    return -4 * track.field.pi * track.field.i * pair.s / pair.R


def kernel(track: Track, pair: Pairing, side: int, distance: Any) -> Any:
    """K(side·distance, q), distance ≥ 0, side +1 (ahead of the load) or −1 (behind it)."""
    i = track.field.i
    cos, sin, _ = track.field.waves(pair.s / 2, pair.discriminant(side), distance)
    return 2 * track.field.pi * i * (i * (pair.y - side * pair.h) * sin - 2 * pair.s * cos) / pair.R


def kernel_at_contact_rate(track: Track, pair: Pairing, rate: PairingRate) -> tuple[Any, Any]:
    """K(0, q) and K_q(0, q)."""
    value = kernel_at_contact(track, pair)
    return value, value * (rate.s / pair.s - rate.R / pair.R)


def kernel_rates(
    track: Track, pair: Pairing, rates: Sequence[tuple[PairingRate, Any]], side: int, distance: Any
) -> tuple[Any, list[Any]]:
    """K at ξ = side·distance and its derivatives along motions, each given as (pairing rate, distance rate)."""
    i, delta2 = track.field.i, pair.discriminant(side)
    cos, sin, third = track.field.waves(pair.s / 2, delta2, distance)
    width = pair.y - side * pair.h
    wave, scale = i * width * sin - 2 * pair.s * cos, 2 * track.field.pi * i / pair.R
    slopes = []
    for rate, speed in rates:
        carrier_rate, delta2_rate = i * distance * rate.s / 2, rate.discriminant(side)
        cos_rate = carrier_rate * cos - distance * sin * delta2_rate / 2
        sin_rate = carrier_rate * sin + third * delta2_rate
        if speed:
            cos_rate += (i * pair.s / 2 * cos - delta2 * sin) * speed
            sin_rate += (i * pair.s / 2 * sin + cos) * speed
        width_rate = rate.y - side * rate.h
        wave_rate = i * (width_rate * sin + width * sin_rate) - 2 * (rate.s * cos + pair.s * cos_rate)
        slopes.append(scale * (wave_rate - wave * rate.R / pair.R))
    return scale * wave, slopes
