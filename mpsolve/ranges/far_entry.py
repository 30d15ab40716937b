"""What a certificate of a range says of high frequencies: the theorem at large q, and the cells up to it."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.certificate.spectrum_file import dyadic
from mpsolve.errors import CertificateError
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.far import FarNumbers
from mpsolve.ranges.scope import Scope

_RATIO = 1.25  # of one end to the next of the cells between X and where the tail theorem begins
_POWERS = (0, 1, 2, 3)  # of 2: wavenumbers from which on short waves may be bounded
_SHARPER = 0.5  # of a bound from a smaller wavenumber on: what makes one worth its proof
_WORTH = 2**14  # times the bound far out: larger ones tell nothing, and with little damping they are hard to prove
_OMEGA = 4.0  # where the charts of the envelope meet


def tail_entry(scope: Scope, far: FarNumbers, Q: Fraction) -> dict[str, Any]:
    """The theorem at large q, in the problem's units: p = p̂/L, q = q̂/T, N/D = 2^n N̂/D̂."""
    family = scope.family
    guide = family.base.guide
    L, T = guide.length, guide.time
    order = guide.g.numerator.bit_length() - guide.g.denominator.bit_length() + L
    z = Fraction(2) ** _whole(T * far.gamma - L)
    kappa = Fraction(2) ** _whole(order - T * far.e)
    envelope, p = Fraction(2) ** (order - L * far.alpha), Fraction(2) ** -L
    fastest = scope.envelope.fastest
    bounds = {far.X / fastest * (1 - 2.0**-20): far.constant}
    bounds |= {p: C for p, C in _bounds(scope.envelope).items() if _WORTH * far.constant > C}
    return {
        "Q": dyadic(Q),
        "gamma": [far.gamma.numerator, far.gamma.denominator],
        "blocks": [
            [dyadic(_short(a) * z), dyadic(_short(b) * z), dyadic(_short(k) * kappa)] for a, b, k in far.blocks
        ],
        "alpha": far.alpha,
        "omega": dyadic(Fraction(_OMEGA) * family.frequency_unit),
        "bounds": [[dyadic(_short(p0) * p), dyadic(_short(C) * envelope)] for p0, C in sorted(bounds.items())],
    }


def _bounds(envelope: Envelope) -> dict[float, float]:
    """{p₀: C}, from the least p₀ on with which there is one; others where they say more."""
    out: dict[float, float] = {}
    for k in _POWERS:
        C = envelope.constant(k)
        if np.isfinite(C) and _SHARPER * min(out.values(), default=np.inf) > C:
            out[2.0**k] = C
    return {p: C * 1.1 for p, C in out.items()}


def _short(x: float) -> Fraction:
    """With few digits."""
    return Fraction(float(np.float32(x)))


def _whole(x: Fraction) -> int:
    if x.denominator != 1:
        raise CertificateError("the scaling of the tail theorem is no power of two")
    return int(x)


def beyond(X: Fraction, Q: Fraction) -> list[Fraction]:
    """Ends of the cells between X and Q."""
    out = []
    x = float(X) * _RATIO
    while x < float(Q) / 1.05:
        out.append(_short(x))
        x *= _RATIO
    return [x for x in out if X < x < Q]
