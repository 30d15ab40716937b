"""All vehicles as one system under contact forces; coordinates that have no mass are taken out exactly.

M ÿ + C ẏ + K y = g(t) − B f, with f the compressions. In a basis [T₂, T₁, T₀], T₀ spanning the kernel of M and C and
T₁ the rest of that of M, the coordinates of T₀ follow at once (they are eliminated and leave a compliance in the
contacts), those of T₁ have one derivative in time, the others two. So Bᵀy − w = H f with
H = diag(h) + B₀ᵀK₀₀⁻¹B₀.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.linear import completed, congruent, image, kernel, units
from mpsolve.vehicles.vehicle import Pencil


@dataclass(frozen=True)
class Carriage:
    """M₂₂ and C₁₁ are regular; the first `second` of the kept coordinates have mass. Float64 of exact numbers.

    M, C, K (r, r), B (r, n), H (n, n). motion (size, r) and give (size, n): y = motion · kept − give · f.
    fixed (size, …): the directions of the coordinates that were eliminated.
    """

    M: Reals
    C: Reals
    K: Reals
    B: Any
    H: Reals
    second: int
    motion: Reals
    give: Reals
    fixed: Reals

    @property
    def first(self) -> int:
        """How many coordinates have no mass but damping."""
        return len(self.M) - self.second

    def force(self, g: Reals) -> Reals:
        """The force g on y as one on the kept coordinates; InputError where it meets neither mass nor damper."""
        if np.any(self.fixed.T @ g):
            stated = "act on a coordinate without mass and damping, which would jump"
            raise InputError("loads", f"{stated}: give the coordinate a mass, or load another one")
        return self.motion.T @ g


def carriage(pencil: Pencil) -> Carriage:
    """The vehicle's equations, reduced; every step of the reduction is exact."""
    size = pencil.size
    massless = kernel(pencil.M, size)
    at_once = kernel((*pencil.M, *pencil.C), size) if massless else []
    damped = completed(at_once, massless)
    heavy = completed([*at_once, *damped], units(size)) if massless else units(size)
    kept = [*heavy, *damped]
    M, C, K = (congruent(rows, kept, kept) for rows in (pencil.M, pencil.C, pencil.K))
    columns = list(zip(*pencil.B, strict=True))
    B = [image(columns, vector) for vector in kept]
    T = np.array(kept, float).reshape(-1, size).T
    fixed = np.array(at_once, float).reshape(-1, size).T
    H = np.diag(np.array(pencil.h, float))
    Kf, Bf = _floats(K), _floats(B)
    motion, give = T, np.zeros((size, pencil.contacts))
    if at_once:
        inner = np.linalg.inv(_floats(congruent(pencil.K, at_once, at_once)))
        across, touch = (
            _floats(congruent(pencil.K, at_once, kept)),
            _floats([image(columns, vector) for vector in at_once]),
        )
        Kf = Kf - across.T @ inner @ across
        Bf = Bf - across.T @ inner @ touch
        H = H + touch.T @ inner @ touch
        motion, give = T - fixed @ inner @ across, fixed @ inner @ touch
    return Carriage(_floats(M), _floats(C), Kf, Bf, H, len(heavy), motion, give, fixed)


def _floats(rows: Sequence[Sequence[Fraction]]) -> Reals:
    return np.array([[float(x) for x in row] for row in rows], float).reshape(len(rows), -1)
