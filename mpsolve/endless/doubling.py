"""Finite trains of any length in float64: pieces of a train are joined as scatterers, so that 2N costs what N did.

Joining A (rear) and B (front): a_B = (1 − r_A r'_B)⁻¹(t_A a + r_A t'_B b), r_A what A sends ahead of a wave from
ahead, r'_B what B sends back of a wave from behind; and Δ_{A+B} = Δ_A Δ_B det(1 − r_A r'_B). No entry grows with N.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.characteristic.floats import Floats
from mpsolve.endless.bloch import Bloch
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.float64 import refined

_POINTS = 800
_STEP = 0.5  # of each part of the argument: larger ones make a count unsafe
_EACH = 60  # more for each vehicle
_ROUNDS = 14
_FIRST = 1e-9


@dataclass(frozen=True)
class Piece:
    """S of a piece of a train, and its determinant: the modulus as a logarithm, the argument in parts; over σ.

    turns: (arguments in (−π, π], how many times they count) of one vehicle and of each kind of joint. A train of 16
    turns 16 times as fast as one vehicle at a resonance of that vehicle: only the parts tell by how much.
    """

    S: Complexes
    size: Reals
    turns: tuple[tuple[Reals, int], ...]

    @property
    def turn(self) -> Any:
        """The argument, up to whole turns."""
        return sum(times * part for part, times in self.turns)


def train_piece(bloch: Bloch, count: int, sigma: Any) -> Piece:
    """The train of `count` vehicles at the scaled σ; log|Δ̂| and arg Δ̂ up to a constant of each vehicle."""
    sigma = np.atleast_1d(np.asarray(sigma, complex))
    value = Floats(bloch.row.reduced).delta(sigma)[0]
    one = Piece(bloch.scatterer(sigma), np.log(np.abs(value)), ((np.angle(value), 1),))
    whole: Piece | None = None
    while count:
        if count % 2:
            whole = one if whole is None else _joined(whole, one, bloch.upper)
        count //= 2
        one = _joined(one, one, bloch.upper) if count else one
    if whole is None:
        raise ValueError("a train has at least one vehicle")
    return whole


def _joined(A: Piece, B: Piece, up: int) -> Piece:
    n = A.S.shape[-1]
    (tA, rA, bA, uA), (tB, rB, bB, uB) = (
        (S[:, :up, :up], S[:, :up, up:], S[:, up:, :up], S[:, up:, up:]) for S in (A.S, B.S)
    )
    back = np.eye(up) - rA @ bB
    to_B = np.linalg.solve(back, np.concatenate([tA, rA @ uB], 2))  # a_B from (a, b)
    to_A = bB @ to_B
    to_A[:, :, up:] += uB  # b_A from (a, b)
    S = np.empty((len(A.S), n, n), complex)
    S[:, :up] = tB @ to_B
    S[:, :up, up:] += rB
    S[:, up:] = uA @ to_A
    S[:, up:, :up] += bA
    more = np.linalg.det(back)
    both = tuple((part, 2 * times) for part, times in A.turns) if A is B else A.turns + B.turns
    return Piece(S, A.size + B.size + np.log(np.abs(more)), (*both, (np.angle(more), 1)))


def growing_in_floats(bloch: Bloch, count: int, reach: float, depth: float) -> int:
    """How many frequencies of the train lie in |Re q| < reach, −depth < Im q < 0 (scaled): by the argument, sampled.

    A finite train has none elsewhere below the real axis if the rectangle is that of `close`. Not a proof.
    """
    corner, points = complex(reach, -depth), _POINTS + _EACH * count
    path = np.concatenate(
        [
            np.linspace(_FIRST * reach, reach, points) + 0j,
            np.linspace(reach, corner, points // 4)[1:],
            np.linspace(corner, complex(0, -depth), points // 4)[1:],
        ]
    )
    times = np.array([k for _, k in train_piece(bloch, count, 1j * path[:1]).turns])

    def parts(at: Any) -> Any:
        return np.array([part for part, _ in train_piece(bloch, count, 1j * at).turns])

    found = refined(parts, path, lambda turns: (np.abs(_steps(turns)) > _STEP).any(0), _ROUNDS)[1]
    return round(-float(times @ _steps(found).sum(1)) / np.pi)


def _steps(parts: Reals) -> Any:
    return np.angle(np.exp(1j * np.diff(parts, axis=1)))
