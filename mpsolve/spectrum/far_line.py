"""No root of tight masses on the beam far out: below the line of the cuts, for all |z| ≥ ρ (SPEC2, the whole sheet).

With τ = c₀λ², u = 1/λ, the p-roots are λP̂, P̂ near e^{±iπ/4}, e^{±3iπ/4}, analytic in |u| ≤ 1/W, where none meet: what
is bounded on the circle is bounded inside. Each mass reflects the waves between the masses nearly as a pinned point
does, |Γ| < 1, and Γ of more and more masses is bounded one after the other; evanescent waves change the determinant
by less than it is from 0. Masses of any size are allowed, so that the theorem is about the track, the gaps and the
number of masses.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from mpsolve.characteristic.discs import near_roots, split
from mpsolve.characteristic.residues import waves
from mpsolve.characteristic.table import Table
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.jets import UP, Jet
from mpsolve.problem.line import Line, discriminant

_ROOT_HALF = math.sqrt(0.5)
ARCS = 24
"""Of the circle |u| = 1/W on which the waves are bounded; those of the first quarter tell the others."""
_NEEDED = ARCS // 4 + 1
_HALF_WAY = 2.002 * math.sin(math.pi / (2 * ARCS))  # to the next one, on the circle
_BEYOND = 2.0  # how far, at least, beyond the last frequency at which p-roots meet
_LADDER = 2.0 ** (np.arange(24) / 8)  # of W, tried at once
_ROUNDS = 6
_SLACK = 1e-9  # far above the rounding of the few operations on bounds below
_MARGIN = 1.02  # of the bounds, for a checker with wider ones


@frozen
class FarLine:
    """No root has |z| ≥ reach (scaled) on the closed lower half of the sheet; W = 1/|u|."""

    W: float
    reach: float


def prove_far(line: Line) -> FarLine:
    """The smallest reach on a ladder; PrecisionError where there is none."""
    EI, _, _, m = line.beam
    scale = math.sqrt(float(EI / m))
    squares = discriminant(line.lower.guide.D).coeffs()
    last = math.sqrt(np.abs(np.roots([float(x) for x in reversed(squares)])).max())  # where p-roots meet
    W = max(1.0, float(np.float32(math.sqrt(_BEYOND * last / scale)))) * _LADDER
    for _ in range(_ROUNDS):
        for one, told in zip(W.tolist(), _waves(line, W), strict=True):
            if told is not None and is_free(line, one, told):
                return FarLine(one, float(np.float32(scale * one**2 * (1 + 2.0**-20))))
        W = W * (_LADDER[-1] * _LADDER[1])
    raise PrecisionError("no frequency is found beyond which the masses have no root: they are too close together")


def is_free(line: Line, W: float, waves: Waves) -> bool:
    """Whether Δ ≠ 0 is proved for all |λ| ≥ W, 0 ≤ arg λ ≤ π/4."""
    EI, _, _, m = line.beam
    active = float(line.height) / math.sqrt(float(EI / m)) / W**2 * (1 + _SLACK)
    return free_beyond(len(line.lower.places), active, float(line.lower.smallest_gap or 0), W, waves)


def free_beyond(masses: int, active: float, gap: float, W: float, waves: Waves) -> bool:
    """The same of so many masses, `gap` apart at least; active: a bound of |η/(c₀W²)|."""
    if active >= 0.5:
        return False
    # 1 over the compliance of a mass departs from that of a passive one by (1 − active)^−2 − 1
    shift = 2 * math.sqrt(2) * waves.at_contact + 1 / (1 - active) ** 2 - 1
    product = waves.product
    if not (shift < 0.5 and product < 0.5):
        return False
    if masses == 1:
        return True
    change = (product + shift) / (1 - shift) * _ROOT_HALF * (1 + _SLACK)  # of g against a passive obstacle
    skew = (waves.skew + 2 * product) / (1 - product) * (1 + _SLACK)
    floor = _floor(masses, _ROOT_HALF + change, change, skew)
    rate = W * (_ROOT_HALF - waves.decay) * gap * (1 - _SLACK)
    if floor is None or rate <= 0:
        return False
    coupling = waves.largest * 2 * math.sqrt(2) / (1 - shift) * (1 + _SLACK)
    lost = coupling * math.exp(-rate) * (1 + _SLACK)
    n = masses - 1
    changed = masses * math.sqrt(n) * lost * (1 + n * (coupling + lost) ** 2) ** (n / 2)
    return bool(changed * (1 + _SLACK) < floor)


@frozen
class Waves:
    """Bounds over |u| ≤ 1/W of how the weights N/D_P, times EI λ³, depart from what they are at u = 0."""

    at_contact: float
    product: float
    skew: float
    decay: float
    largest: float


def _waves(line: Line, W: Reals) -> list[Waves | None]:
    """For each W, by the maximum principle from arcs of the circle |u| = 1/W; None where roots are not told apart.

    u → ū takes the waves a, e, f, c to the conjugates of e, a, c, f, and u → −u takes their weights to those of
    c, f, e, a: so a quarter of the circle is enough where each bound is taken of all that it may become.
    """
    EI, T, k, m = (float(x) for x in line.beam)
    v = float(line.lower.guide.v) / math.sqrt(EI / m)
    d = np.zeros((5, 5))
    d[4, 0] = d[0, 0] = 1
    d[2, 2] = T / EI + v * v
    d[1, 1] = -2 * v
    d[0, 4] = k / EI
    D = Table(d)
    corners = np.exp(0.25j * np.pi * np.array([-3, 3, -1, 1]))  # U: travelling, evanescent; L: the other way round
    around = (np.exp(2j * np.pi * np.arange(_NEEDED) / ARCS) / W[:, None]).ravel()
    s = split(D, around, _HALF_WAY * np.abs(around), 2, _near(D, around, corners))
    with np.errstate(all="ignore"):
        weight, p, alone = waves(Table(np.ones((1, 1))), D, s)
        a, e, f, c = weight[:, 0], weight[:, 1], -weight[:, 2], -weight[:, 3]
        turn = np.exp(0.25j * np.pi)
        bounds = (
            np.maximum(_departs(a + e, _ROOT_HALF / 2), _departs(c + f, _ROOT_HALF / 2)),
            np.maximum(_departs(a * c * (-16j), 1), _departs(e * f * 16j, 1)),
            np.maximum(_departs((a + c) * (4 / turn), 2), _departs((e + f) * (4 * turn), 2)),
            np.max([_departs(p[:, k], corners[k]) for k in range(4)], axis=0),
            np.max([_departs(x, 0) for x in (a, e, f, c)], axis=0),
        )
    good = (s.good & alone).reshape(len(W), _NEEDED).all(1)
    return [
        Waves(*map(float, row)) if fine else None for fine, row in zip(good, zip(*bounds, strict=True), strict=True)
    ]


def _near(D: Table, u: Complexes, corners: Complexes) -> Complexes:
    """Floats near the roots at each u, in the order of the roots at u = 0 that they come from."""
    z = near_roots(D.in_time(u)[0][:, 0, :])
    order = np.abs(z[:, None, :] - corners[None, :, None]).argmin(2)
    return np.take_along_axis(z, order, 1)


def _departs(f: Jet, value: complex) -> Any:
    """For each W a bound of |f − value| over its arcs."""
    each = (np.abs(f.a - value) + 1e-15 + np.abs(f.b) * f.r + f.e) * (UP * _MARGIN)
    return each.reshape(-1, _NEEDED).max(1)


def _floor(masses: int, g: float, change: float, skew: float) -> float | None:
    """A lower bound of |det(I + T)| = Π|1 + g z|, from the last mass to the first; None where there is none."""
    floor, reflection = 1.0, g
    for k in range(masses - 1):
        Z = reflection * (1 + _SLACK)
        if g * Z >= 1:
            return None
        floor *= (1 - g * Z) * (1 - _SLACK)
        if k == masses - 2:
            return floor
        if Z <= 1:
            passive = math.sqrt(1 - (3 - math.sqrt(5)) * (1 - Z * Z) / (math.sqrt(2) + Z) ** 2)
        else:
            passive = math.sqrt(1 + (Z * Z - 1) / (math.sqrt(2) - Z) ** 2)
        reflection = passive + (Z * (2 * change + g * skew) + change + passive * Z * change) / (1 - g * Z)
    return floor
