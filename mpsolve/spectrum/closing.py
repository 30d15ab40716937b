"""The argument at which a count from the real axis closes: pivots of an accretive matrix (SPEC, closing).

M(σ) = [[S/σ, −B], [Bᵀ, σ(G + h)]] has a positive semidefinite Hermitian part wherever V = σG has a positive definite
one, Re σ ≥ 0 and the vehicle is passive. All its pivots then have Re ≥ 0, under any symmetric order, so the sum of
their principal arguments is a continuous argument of det M.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from flint import acb, arb

from mpsolve.characteristic.bordering import distances_of
from mpsolve.characteristic.discs import split
from mpsolve.characteristic.proved import ProvedSplitting
from mpsolve.characteristic.roots import root_balls
from mpsolve.characteristic.symbol import Symbols
from mpsolve.characteristic.table import Table
from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.jets import UP, U
from mpsolve.problem.reduced import Reduced


def closing_argument(reduced: Reduced, rho: float, middle: Any, radius: Reals) -> arb:
    """Σ Arg(pivots of M) at q̂ = ρ from G = middle ± radius between the places; PrecisionError where it stays open.

    M is accretive where V is passive at ρ, as the caller has proved; that M₀, made of the middle, is so too is proved
    here. Accretive matrices are a convex set, so their arguments differ by arg det(I + M₀⁻¹(M − M₀)) as taken along
    the segment, at most n ‖M₀⁻¹(M − M₀)‖/(1 − ‖…‖). For regular accretive matrices the sum of the arguments of
    pivots is that of the eigenvalues (both are continuous, and the same for I), so a pivot that is 0 on the way does
    no harm.
    The pivots of M₀ are free of the error of G, and are followed with as many bits as elimination loses.
    """
    spread = _spread(reduced, rho, middle, radius)
    if not _passive(rho, middle):
        raise PrecisionError("the mobility at the corner of the contour is not passive to within its error")
    for bits in (128, 512, 2048):
        with precision(bits):
            total = _pivot_arguments(_accretive(reduced, acb(0, rho), middle))
            if total is not None:
                return total + arb(0, spread)
    raise PrecisionError("the mobility at the corner of the contour is singular to within its error")


def _passive(rho: float, middle: Any) -> bool:
    """Whether iρG with the middle of G has a positive definite Hermitian part: its pivots are positive."""
    for bits in (128, 512, 2048):
        with precision(bits):
            G = [[acb(complex(x)) for x in row] for row in middle]
            n = len(G)
            H = [[acb(0, rho) * G[i][j] + acb(0, -rho) * G[j][i].conjugate() for j in range(n)] for i in range(n)]
            if _pivots_positive(H):
                return True
    return False


def _pivots_positive(H: list[list[acb]]) -> bool:
    """Whether elimination of a Hermitian matrix meets pivots that are proved positive only."""
    while H:
        if not H[0][0].real > 0:
            return False
        first, rows = H[0], H[1:]
        H = [[row[j] - row[0] / first[0].real * first[j] for j in range(1, len(first))] for row in rows]
    return True


def _pivot_arguments(M: list[list[acb]]) -> arb | None:
    """The sum of the principal arguments of the pivots, largest diagonal entry first; None where one may be 0."""
    total = arb(0)
    while M:
        k = max(range(len(M)), key=lambda i: float(abs(M[i][i]).mid()))
        pivot, row, column = M[k][k], M[k], [M[i][k] for i in range(len(M))]
        if pivot.contains(0):
            return None
        total += pivot.arg()
        rest = [i for i in range(len(M)) if i != k]
        M = [
            [M[i][j] - column[i] / pivot * row[j] for j in rest] if column[i] != 0 else [M[i][j] for j in rest]
            for i in rest
        ]
    return total


def _spread(reduced: Reduced, rho: float, middle: Any, radius: Reals) -> float:
    """A bound of how far the arguments of M and M₀ differ."""
    with precision(64):
        exact = _accretive(reduced, acb(0, rho), middle)
    M0 = np.array(exact, complex)
    n, m = len(M0), reduced.bodies
    index = np.array(reduced.index)
    error = np.zeros((n, n))
    error[m:, m:] = rho * radius[np.ix_(index, index)] * UP
    with np.errstate(all="ignore"):
        try:
            R = np.linalg.inv(M0)
        except np.linalg.LinAlgError:
            R = np.full((n, n), np.nan)  # proves nothing below
        size, lost = np.abs(R), 64 * (n + 4) * U  # of the product, and of the rounding of M₀ to floats
        defect = np.abs(R @ M0 - np.eye(n)) + lost * (size @ np.abs(M0) + 1)
        x = np.ones(n)
        for _ in range(12):
            y = (defect + size @ error) @ x
            x = y / y.max() + 1e-4
        eta = np.max(defect @ x / x) * UP
        e = np.max(size @ error @ x / x) * UP / (1 - eta)
    if not (eta < 0.5 and e < 0.1):
        raise PrecisionError("the mobility at the corner of the contour is singular to within its error")
    return float(n * e / (1 - e) * UP)


def _accretive(reduced: Reduced, sigma: acb, middle: Any) -> list[list[acb]]:
    """M(σ) with G as given."""
    n, contacts = reduced.bodies, reduced.contacts
    kept = n - reduced.neutral
    out = [[acb(0)] * (n + contacts) for _ in range(n + contacts)]
    for i in range(n):
        for j in range(n):
            entry = acb(0)
            for k in (2, 1, 0):
                entry = entry * sigma + rational_ball(reduced.S[k][i][j])
            out[i][j] = entry / sigma if i < kept else entry  # the row of a neutral mode has been divided by σ
        for j in range(contacts):
            out[i][n + j] = -acb(rational_ball(reduced.B[i][j]))
            out[n + j][i] = acb(rational_ball(reduced.B[i][j]))
    for i, a in enumerate(reduced.index):
        for j, b in enumerate(reduced.index):
            g = middle[a, b]
            out[n + i][n + j] = sigma * (g if isinstance(g, acb) else acb(complex(g)))
        out[n + i][n + i] += sigma * rational_ball(reduced.h[i])
    return out


def edge_splitting(reduced: Reduced, up: int, q: float) -> ProvedSplitting:
    """The p-roots at the real q̂ on the edge of a cut, at the precision that is set, told apart as in `split`."""
    nodes = split(Table.of(reduced.guide.D), np.array([1j * q]), np.zeros(1), up).z[0]
    symbols, sigma = Symbols.of(reduced.guide), acb(0, q)
    return ProvedSplitting(symbols, sigma, up, tuple(root_balls(symbols.D, sigma, nodes)), None, False)


def pivot_sum(reduced: Reduced, up: int, q: float) -> arb:
    """Σ Arg(pivots of M) at the real q̂ from G in balls, where M is known to be accretive; PrecisionError if open."""
    distances, which = distances_of(reduced.places)
    for bits in (64, 256, 1024):
        with precision(bits):
            try:
                values = edge_splitting(reduced, up, q).receptances(distances, False)[0]
            except PrecisionError:
                continue
            G = {(i, j): values[k] for i, row in enumerate(which) for j, k in enumerate(row)}
            total = _pivot_arguments(_accretive(reduced, acb(0, q), G))
            if total is not None and total.rad() < 0.1:
                return total
    raise PrecisionError("a root lies on the line of the cuts where the count closes")
