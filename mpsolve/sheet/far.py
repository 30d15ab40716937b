"""No root at infinity: an explicit ρ such that Δ has no zero with |q − iη_b| ≥ ρ, for any number of masses.

With 2r = w², 0 ≤ arg w ≤ π/2 (the half Im r ≥ 0; the other half follows from D(p; −r) = D(−p; r)) and
u = 1/w, the p-roots are w P_k, where P_k, near c = i^k, are the roots of

    Q(P) = P⁴ − 4A u² P² + 4αu P − 1 + 4β² u⁴,

and 1/D_p = C_k/w³ with C_k = 1/Q'(P_k). Both are enclosed for all |w| ≥ W at once, to second order in u:
P_k = c − c²αu + …, C_k = (c/4)(1 + 2cαu + …). Then 1 − κ η K(0) = 1 + η w X with X near (1 − i)/4 has a
positive real part and at least the modulus η |w| |X|, and what is left of Δ is a determinant
det(I + off-diagonal) that is kept from 0 in one of two ways:

    two masses    the product of the two off-diagonal entries is below 1 in modulus;
    more masses   the waves between the masses are scattered by nearly passive obstacles, whose reflections
                  bound the determinant from below; evanescent waves perturb it by less.

certs/SPEC.md has the proofs.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import flint

from mpsolve.errors import PrecisionError
from mpsolve.model.branch import Track
from mpsolve.outcome import Reason

acb, arb = flint.acb, flint.arb

_STEPS = 44  # W = 2, 2√2, 4, … up to 2^22: beyond that the track is far outside of any use


def far_radius(track: Track) -> float:
    """The radius ρ, a dyadic float, beyond which Δ is proved to have no zero on the physical sheet.

    Raises `PrecisionError` when no W = √(2ρ) up to 2^22 gives the proof.
    """
    for step in range(2, _STEPS + 1):
        W = float(int(2.0 ** (step / 2) * 8)) / 8
        try:
            prove_far(track, W)
        except PrecisionError:
            continue
        return W * W / 2
    raise PrecisionError(
        Reason(
            "far-radius",
            "no radius free of roots could be proved below |w| = 2^22: masses are too close together, or too many",
            {},
            "merge them, or ask for a rectangle",
        )
    )


def prove_far(track: Track, W: float) -> None:
    """Proves that Δ has no zero for |r| ≥ W²/2; raises `PrecisionError` when this W is too small."""
    at = asymptotics(track, W)
    resultant = (at.P[0] - at.P[2]) * (at.P[0] - at.P[3]) * (at.P[1] - at.P[2]) * (at.P[1] - at.P[3]) / -8
    require(resultant.real > 0, "the resultant")
    require(at.X.real > 0 and at.X.imag < 0, "the diagonal")
    if len(track.eta_m) == 2:
        require(_two_mass_product(track, at) < 1, "the off-diagonal product")
    elif len(track.eta_m) > 2:
        _prove_scattering(track, at)


def require(condition: bool, what: str) -> None:
    if not condition:
        raise PrecisionError(f"{what} is not under control yet at this radius: take a larger one")


@dataclass(frozen=True)
class Asymptotics:
    """Enclosures for all |w| ≥ W: P_k; C_k = (c/4)(1 + 2cαu + E_k); X; q² = (w⁴/4) gain; |P_k − c| ≤ spread.

    drift: bounds of |P_k − c + c²αu|, analytic in u and 0 to first order.
    """

    W: Any
    P: tuple[Any, ...]
    C: tuple[Any, ...]
    E: tuple[Any, ...]
    tilt: Any  # the ball of 2αu
    gain: Any
    X: Any
    spread: Any
    drift: tuple[Any, ...]


_UNITS = (acb(1), acb(0, 1), acb(-1), acb(0, -1))


def asymptotics(track: Track, W: float) -> Asymptotics:
    """Encloses P_k and C_k for every |u| ≤ 1/W by interval Newton about c − c²αu."""
    alpha, A, reach = track.alpha, track.A, (1 / arb(W)).upper()
    u = acb(arb(0, reach), arb(0, reach))
    P, C, E, drift = [], [], [], []
    for c in _UNITS:
        slope = -alpha * c * c
        # Q(c + slope u): the terms of order 0 and 1 cancel
        second = 6 * c * c * slope * slope - 4 * A * c * c + 4 * alpha * slope
        third = 4 * c * slope**3 - 8 * A * c * slope
        fourth = slope**4 - 4 * A * slope * slope + 4 * track.beta2
        value = u * u * (second + u * (third + u * fourth))
        size = arb(0, (value.abs_upper() / 2 + reach * arb(2) ** -40).upper())
        start = c + slope * u
        ball = start + acb(size, size)
        image = start - value / _quartic_slope(track, u, ball)
        correction = -value / _quartic_slope(track, u, ball)
        require(correction.is_finite() and bool(acb(size, size).contains_interior(correction)), "the p-roots")
        P.append(image)
        drift.append(arb(abs(correction).upper()))
        # Q'(P) = 4c³ (1 − x), x = 2cαu − y, with y of second order
        rest = slope * u
        cubic = 4 * (3 * c * c * correction + 3 * c * (rest + correction) ** 2 + (rest + correction) ** 3)
        y = (cubic - 8 * A * u * u * image) * c / 4
        x = 2 * alpha * c * u - y
        require(abs(x) < 1, "the residues")
        error = -y + x * x / (1 - x)
        E.append(error)
        C.append(c / 4 * (1 + 2 * alpha * c * u + error))
    gain = (1 + 2 * acb(0, 1) * track.eta_b * u * u) ** 2
    X = -acb(0, 1) * gain * (acb(1, 1) + E[0] + acb(0, 1) * E[1]) / 4  # 2αu (c₀² + c₁²) = 0
    spread = _largest([abs(p - c) for p, c in zip(P, _UNITS, strict=True)])
    return Asymptotics(arb(W), tuple(P), tuple(C), tuple(E), 2 * alpha * u, gain, X, spread, tuple(drift))


def _quartic_slope(track: Track, u: Any, P: Any) -> Any:
    return 4 * P**3 - 8 * track.A * u * u * P + 4 * track.alpha * u


def _largest(values: list[Any]) -> Any:
    best = arb(0)
    for value in values:
        best = best.max(arb(value.upper()))
    return best


def _decay(at: Asymptotics, gap: Any) -> Any:
    """At any arg w one of the two upper p-roots, and one of the two lower, has |Im p| ≥ |w|(1/√2 − spread)."""
    rate = at.W * (1 / arb(2).sqrt() - at.spread)
    require(rate > 0, "the evanescent wave")
    return (-rate * gap).exp()


def _travelling(at: Asymptotics, k: int) -> tuple[Any, Any]:
    """(F, B) = 4C_k/c ahead and 4C_{k+2}/(−c) behind: 1 ± 2cαu + …"""
    tilt = at.tilt * _UNITS[k]
    return 1 + tilt + at.E[k], 1 - tilt + at.E[(k + 2) % 4]


def product(at: Asymptotics, k: int) -> Any:
    """F B, where the first order cancels."""
    tilt, ahead, behind = at.tilt * _UNITS[k], at.E[k], at.E[(k + 2) % 4]
    return 1 - tilt * tilt + ahead * (1 - tilt) + behind * (1 + tilt) + ahead * behind


def _two_mass_product(track: Track, at: Asymptotics) -> Any:
    """A bound of |κ² η₁ η₂ K(d) K(−d)| / |(1 − κη₁K(0)) (1 − κη₂K(0))|."""
    decay = _decay(at, track.positions[1] - track.positions[0])
    main = _largest([abs(product(at, k)) for k in (0, 1)])
    size = _largest([4 * abs(c) for c in at.C])
    waves = main + 2 * size * size * decay + main * decay * decay
    return (abs(at.gain) / (4 * abs(at.X))) ** 2 * waves


def _prove_scattering(track: Track, at: Asymptotics) -> None:
    """|det(I + main waves)| ≥ Π(1 − |g| Γ_j) exceeds what the evanescent waves can change, in both sectors."""
    n, root2 = len(track.eta_m), arb(2).sqrt()
    gaps = [track.positions[k + 1] - track.positions[k] for k in range(n - 1)]
    evanescent = _largest([_decay(at, gap) for gap in gaps])
    shift = abs(at.gain * (acb(1, 1) + at.E[0] + acb(0, 1) * at.E[1]) - acb(1, 1)) / root2
    require(shift < 1, "the diagonal")
    for k in (0, 1):
        ahead, behind = _travelling(at, k)
        mean = product(at, k).sqrt()
        deviation = (abs(at.gain * mean - 1) + shift) / (1 - shift)  # |g − ĝ| ≤ deviation |ĝ|, |ĝ| ≤ 1/√2
        skew = abs((2 + at.E[k] + at.E[k + 2]) / mean - 2)  # τ + 1/τ − 2 with τ² = F/B
        g, change = (1 + deviation) / root2, deviation / root2
        reflection, floor = arb(1), arb(1)
        for _ in range(n - 1):
            require(g * reflection < 1, "the reflection")
            floor = floor * (1 - g * reflection)
            reflection = _next_reflection(reflection, g, change, skew)
        largest = _largest([abs(ahead), abs(behind), *(4 * abs(c) for c in at.C)])
        coupling = abs(at.gain) * largest / (root2 * (1 - shift))  # every main entry, at most
        error = coupling * evanescent
        row = (1 + (n - 1) * (coupling + error) ** 2).sqrt()
        require(n * arb(n - 1).sqrt() * error * row ** (n - 1) < floor, "the scattering matrix")


def _next_reflection(z: Any, g: Any, change: Any, skew: Any) -> Any:
    """A bound ≥ 1 of |Γ| for one more obstacle before an array that reflects |z| ≤ `z`, z ≥ 1.

    For a passive obstacle ĝ = 1/d, Re d ≥ 1, Im d ≥ 1: |Γ|² ≤ 1 + (z² − 1)/(√2 − z)².
    """
    root2 = arb(2).sqrt()
    require(z < root2, "the reflection")
    passive = (1 + (z * z - 1) / (root2 - z) ** 2).sqrt()
    return _largest([arb(1), deviating(passive, z, g, change, skew)])


def deviating(passive: Any, z: Any, g: Any, change: Any, skew: Any) -> Any:
    """A bound of |Γ| from that of the passive obstacle ĝ, for |g| ≤ `g`, |g − ĝ| ≤ `change`, τ + 1/τ − 2 = `skew`."""
    return passive + (z * (2 * change + g * skew) + change + passive * z * change) / (1 - g * z)
