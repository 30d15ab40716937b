"""No root of tight masses on the beam far out: below the line of the cuts, for all |z| ≥ ρ (SPEC2, the whole sheet).

With τ = c₀λ², u = 1/λ, the p-roots are λP̂, P̂ near e^{±iπ/4}, e^{±3iπ/4}, analytic in |u| ≤ 1/W: one splitting on a
disc of u. Each mass reflects the waves between the masses nearly as a pinned point does, |Γ| < 1, and Γ of more and
more masses is bounded one after the other; evanescent waves change the determinant by less than it is from 0.
Masses of any size are allowed, so that the theorem is about the track, the gaps and the number of masses.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from mpsolve.characteristic.discs import split, waves
from mpsolve.characteristic.table import Table
from mpsolve.errors import PrecisionError
from mpsolve.numbers.jets import UP, Jet
from mpsolve.problem.line import Line

_ROOT_HALF = math.sqrt(0.5)
_STEPS, _GUESS = 61, 21  # W = 1, 2^¼, … up to 2^15; where the search begins
_SLACK = 1e-9  # far above the rounding of the few operations on bounds below


@dataclass(frozen=True)
class FarLine:
    """No root has |z| ≥ reach (scaled) on the closed lower half of the sheet; W = 1/|u|."""

    W: float
    reach: float


def prove_far(line: Line) -> FarLine:
    """The smallest reach on a ladder; PrecisionError where there is none."""
    EI, _, _, m = line.beam
    scale = math.sqrt(float(EI / m))
    low, high = 0, _STEPS  # W = 2^(step/4)
    while high - low > 1:
        step = (low + high) // 2 if high < _STEPS or low >= _GUESS else _GUESS
        low, high = (low, step) if is_free(line, 2 ** (step / 4)) else (step, high)
    if high == _STEPS:
        raise PrecisionError(
            "no frequency is found beyond which the masses have no root: they are too close together"
        )
    W = 2 ** (high / 4)
    return FarLine(W, float(np.float32(scale * W * W * (1 + 2.0**-20))))


def is_free(line: Line, W: float) -> bool:
    """Whether Δ ≠ 0 is proved for all |λ| ≥ W, 0 ≤ arg λ ≤ π/4."""
    waves = _waves(line, 1 / W)
    if waves is None:
        return False
    ahead, behind, near_ahead, near_behind, decay = waves
    masses = len(line.lower.places)
    EI, _, _, m = line.beam
    active = float(line.height) / math.sqrt(float(EI / m)) / W**2 * (1 + _SLACK)  # |η/(c₀λ²)|
    if active >= 0.5:
        return False
    # Re 1 over the compliance of a mass departs by (1 − active)^−2 − 1
    shift = 2 * math.sqrt(2) * _departs(ahead + near_ahead, _ROOT_HALF / 2) + 1 / (1 - active) ** 2 - 1
    product = _departs(ahead * behind * (-16j), 1)
    skewed = _departs((ahead + behind) * (4 * np.exp(-0.25j * np.pi)), 2)
    if not (shift < 0.5 and product < 0.5):
        return False
    if masses == 1:
        return True
    change = (product + shift) / (1 - shift) * _ROOT_HALF * (1 + _SLACK)  # of g against a passive obstacle
    skew = (skewed + 2 * product) / (1 - product) * (1 + _SLACK)
    floor = _floor(masses, _ROOT_HALF + change, change, skew)
    largest = max(float(x.size[0]) for x in (ahead, behind, near_ahead, near_behind))
    gap = float(line.lower.smallest_gap or 0)
    rate = W * (_ROOT_HALF - decay) * gap * (1 - _SLACK)
    if floor is None or rate <= 0:
        return False
    coupling = largest * 2 * math.sqrt(2) / (1 - shift) * (1 + _SLACK)
    lost = coupling * math.exp(-rate) * (1 + _SLACK)
    n = masses - 1
    changed = masses * math.sqrt(n) * lost * (1 + n * (coupling + lost) ** 2) ** (n / 2)
    return bool(changed * (1 + _SLACK) < floor)


def _waves(line: Line, r: float) -> tuple[Jet, Jet, Jet, Jet, float] | None:
    """N/D_P of the travelling waves ahead and behind (−) and of the evanescent ones, times EI λ³; their departure."""
    EI, T, k, m = (float(x) for x in line.beam)
    v = float(line.lower.guide.v) / math.sqrt(EI / m)
    d = np.zeros((5, 5))
    d[4, 0] = d[0, 0] = 1
    d[2, 2] = T / EI + v * v
    d[1, 1] = -2 * v
    d[0, 4] = k / EI
    D = Table(d)
    s = split(D, np.zeros(1, complex), np.array([r]), 2)
    with np.errstate(all="ignore"):
        weight, p, alone = waves(Table(np.ones((1, 1))), D, s)
    if not (s.good[0] and alone[0]):
        return None
    ahead, near_ahead = sorted((0, 1), key=lambda j: s.z[0, j].imag)
    near_behind, behind = sorted((2, 3), key=lambda j: s.z[0, j].imag)
    decay = max(
        _departs(p[:, j], value)
        for j, value in ((near_ahead, np.exp(0.75j * np.pi)), (near_behind, np.exp(-0.25j * np.pi)))
    )
    return weight[:, ahead], -weight[:, behind], weight[:, near_ahead], -weight[:, near_behind], decay


def _departs(f: Jet, value: complex) -> float:
    """A bound of |f − value| over the disc."""
    return float((np.abs(f.a[0] - value) + 1e-15 + np.abs(f.b[0]) * f.r[0] + f.e[0]) * UP)


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
            passive = math.sqrt(1 - (1 - Z * Z) / (2 + Z) ** 2)
        else:
            passive = math.sqrt(1 + (Z * Z - 1) / (math.sqrt(2) - Z) ** 2)
        reflection = passive + (Z * (2 * change + g * skew) + change + passive * Z * change) / (1 - g * Z)
    return floor
