"""What a certificate of a range says of high frequencies: the theorem at large q, and the cells up to it."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.certificate.spectrum_file import dyadic, tail_entry
from mpsolve.numbers.float64 import short
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.far import FarNumbers
from mpsolve.ranges.scope import Scope

_RATIO = 1.25  # of one end to the next of the cells between X and where the tail theorem begins
_POWERS = (0, 1, 2, 3)  # of 2: wavenumbers from which on short waves may be bounded
_SHARPER = 0.5  # of a bound from a smaller wavenumber on: what makes one worth its proof
_WORTH = 2**14  # times the bound far out: larger ones tell nothing, and with little damping they are hard to prove


def far_entry(scope: Scope, far: FarNumbers, Q: Fraction) -> dict[str, Any]:
    """The theorem at large q in the problem's units, with bounds of short waves from several wavenumbers on."""
    guide, envelope = scope.family.base.guide, scope.envelope
    entry, factor = tail_entry(guide, scope.family.frequency_unit, far)
    p = Fraction(2) ** -guide.length
    bounds = {far.X / envelope.fastest * (1 - 2.0**-20): far.constant}
    bounds |= {p0: C for p0, C in _bounds(envelope).items() if _WORTH * far.constant > C}
    each = ((Fraction(short(p0)), Fraction(short(C))) for p0, C in sorted(bounds.items()))
    return {"Q": dyadic(Q), **entry, "bounds": [[dyadic(p0 * p), dyadic(C * factor)] for p0, C in each]}


def _bounds(envelope: Envelope) -> dict[float, float]:
    """{p₀: C}, from the least p₀ on with which there is one; others where they say more."""
    out: dict[float, float] = {}
    for k in _POWERS:
        C = envelope.constant(k)
        if np.isfinite(C) and _SHARPER * min(out.values(), default=np.inf) > C:
            out[2.0**k] = C
    return {p: C * 1.1 for p, C in out.items()}


def beyond(X: Fraction, Q: Fraction) -> list[Fraction]:
    """Ends of the cells between X and Q."""
    out = []
    x = float(X) * _RATIO
    while x < float(Q) / 1.05:
        out.append(Fraction(short(x)))
        x *= _RATIO
    return [x for x in out if X < x < Q]
