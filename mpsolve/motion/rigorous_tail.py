"""Far out on the sheet that continues the lower side of the cut: no zero of Δ, and a bound of |W̃|.

With 2r = w² and the notation of sheet/far.py the upper p-roots are there w P₁ ≈ iw and w P₂ ≈ −w, the lower ones
w P₀ ≈ w and w P₃ ≈ −iw, wherever 0 ≤ Im w ≤ δ, Re w > 0: they are for Im w < 0, on the physical sheet, and none of
them meets another on the way. Then 1 − κη K(0) = 1 + ηwX' with X' near (1 + i)/4, and

    |K(ξ)| ≤ (2π/|w|³) k(ξ),   k(ξ) = |C| e^{(δ + ε)|ξ|} + |C'| e^{−λ|ξ|}:

the travelling wave grows with |ξ| at most at the rate of the height δ (and ε, from the terms in 1/w), so that for two
masses the product of the off-diagonal entries of I − κηK over that of the diagonal ones is near e^{2δd}/2 < 1. For
more masses see rigorous_scatter.py.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import flint
import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.model.branch import Track
from mpsolve.motion.forcing import Tone
from mpsolve.motion.rigorous_path import Route
from mpsolve.motion.rigorous_scatter import inverse_bound, least
from mpsolve.sheet.far import Asymptotics, asymptotics

acb, arb = flint.acb, flint.arb

_STEPS = range(4, 24)  # W = 2^{k/2}
_ROOM = 0.97  # the off-diagonal product is kept below


@dataclass(frozen=True)
class Far:
    """What holds for |w| ≥ W, 0 ≤ Im w ≤ δ. C: |C_k|; rates: growth of the travelling waves behind and ahead."""

    track: Track
    W: Any
    X: Any  # a lower bound of |X'|
    gain: Any  # an upper bound of |gain|, q² = (w⁴/4) gain
    C: tuple[Any, ...]
    rates: tuple[Any, Any]
    decay: Any
    product: Any  # of two masses' off-diagonal entries over the diagonal ones; below 1
    inverse: Any = None  # for three and more masses, a bound of the entries of (B/diag B)⁻¹

    def k(self, sign: int, distance: Any) -> Any:
        """k(ξ), ξ = sign · distance."""
        travelling, other, rate = (0, 3, self.rates[0]) if sign < 0 else (2, 1, self.rates[1])
        return self.C[travelling] * (rate * distance).exp() + self.C[other] * (-self.decay * distance).exp()

    def image(self, tones: Sequence[Tone], gaps: Sequence[tuple[int, Any]]) -> Any:
        """T with |W̃(ξ)| ≤ T/|w|⁶, for the gaps (sign, ξ − x_j); infinite where W is too small for the forces."""
        track = self.track
        force = [arb(0)] * len(track.eta_m)
        for tone in tones:
            # |q ± ω| ≥ |w|²/2 − η_b − ω
            room = 1 - 2 * (track.eta_b + tone.frequency) / self.W**2
            if not room > 0:
                return arb("inf")
            force = [f + 8 * abs(a) / room for f, a in zip(force, tone.amplitudes, strict=True)]
        lone = [f / (eta * self.X) for f, eta in zip(force, track.eta_m, strict=True)]  # |S| ≤ lone/|w|³
        S = lone
        if len(lone) == 2:
            distance, turn = track.positions[1] - track.positions[0], self.gain / self.X
            # |B₁₂|/|B₁₁| ≤ turn · k(−d), |B₂₁|/|B₂₂| ≤ turn · k(d)
            S = [lone[0] + lone[1] * turn * self.k(-1, distance), lone[1] + lone[0] * turn * self.k(1, distance)]
        elif len(lone) > 2:
            S = [self.inverse * sum(lone, arb(0))] * len(lone)
        total = sum((s * self.k(sign, abs(xi)) for s, (sign, xi) in zip(S, gaps, strict=True)), arb(0))
        return 2 * total / (1 - self.product)


def far(track: Track, delta: float, W: float) -> Far:
    """Proves that Δ has no zero for |w| ≥ W, 0 ≤ Im w ≤ δ; PrecisionError where W is too small or δ too large."""
    at = asymptotics(track, W)
    sine = arb(delta) / at.W
    if not sine < 1:
        raise PrecisionError("the far field begins within the strip: take a larger radius")
    cosine = (1 - sine * sine).sqrt()
    X = -acb(0, 1) * at.gain * (at.C[1] + at.C[2])
    # |1 + ηwX'| ≥ η|w||X'| where Re wX' ≥ 0
    if not (X * acb(cosine.union(arb(1)), arb(0).union(sine))).real > 0:
        raise PrecisionError("the diagonal is not under control yet at this radius: take a larger one")
    decay = at.W * (cosine - at.spread)
    if not (decay > 0 and at.spread < 0.5):  # the enclosures of the P_k are apart
        raise PrecisionError("the evanescent wave is not under control yet at this radius: take a larger one")
    # by Schwarz's lemma |P − c + c²αu| ≤ drift |u|² W², and αu w is real
    rates = tuple(delta + at.drift[k] * at.W for k in (0, 2))
    C = tuple(arb(abs(c).upper()) for c in at.C)
    found = Far(track, at.W, arb(abs(X).lower()), arb(abs(at.gain).upper()), C, (rates[0], rates[1]), decay, arb(0))
    if len(track.eta_m) == 1:
        return found
    if len(track.eta_m) > 2:
        return replace(found, inverse=_scattered(found, at, delta))
    distance = track.positions[1] - track.positions[0]
    product = (found.gain / found.X) ** 2 * found.k(1, distance) * found.k(-1, distance)
    if not product < _ROOM:
        raise PrecisionError("the off-diagonal product is not under control yet at this radius: take a larger one")
    return replace(found, product=product)


def _scattered(found: Far, at: Asymptotics, delta: float) -> Any:
    """The bound of rigorous_scatter.py, with |B_ij/B_ii| ≤ (gain/|X'|) k(x_i − x_j)."""
    x, turn = found.track.positions, found.gain / found.X
    span, nearest = x[-1] - x[0], least([b - a for a, b in pairwise(x)])
    waves = [found.C[k] * (rate * span).exp() for k, rate in zip((0, 2), found.rates, strict=True)]
    fading = [found.C[k] * (-found.decay * nearest).exp() for k in (1, 3)]
    largest = (turn * waves[0].max(waves[1]), turn * fading[0].max(fading[1]))
    return inverse_bound(found.track, at, delta, found.rates[0] + found.rates[1], *largest)


def far_start(track: Track, way: Route) -> tuple[float, Far]:
    """The Re v beyond which no zero lies on the path or below it, by `far`. Raises PrecisionError."""
    for step in _STEPS:
        W = float(int(2.0 ** (step / 2) * 8)) / 8
        try:
            found = far(track, way.delta, W)
        except PrecisionError:
            continue
        # |w|² = |v² + 2x| ≥ (Re v)² − δ² + 2x
        return float(np.sqrt(W * W + way.delta**2)) * (1 + 2.0**-40), found
    raise PrecisionError("the far field on the continued sheet is out of reach: the masses are too close together")


def tail(
    track: Track, way: Route, tones: Sequence[Tone], gaps: Sequence[Sequence[tuple[int, Any]]], end: float
) -> Any:
    """Bounds of (1/π) ∫ |W̃ dq| e^{τ η_b} beyond Re v = end but for e^{−τδ end}, one for each row of gaps.

    |dq| = |v| dv, |w| ≥ |v| ≥ Re v and ∫ v⁻⁵ dv = end⁻⁴/4. Needs |w| ≥ |v|, which holds for x ≥ 0, Re v ≥ δ.
    """
    W = (arb(end) ** 2 - arb(way.delta) ** 2 + 2 * arb(way.centre)).sqrt()
    at = far(track, way.delta, float(W.lower()) * (1 - 2.0**-40))
    reach = arb(end) ** -4 / (4 * track.field.pi)
    return [at.image(tones, row) * reach for row in gaps]
