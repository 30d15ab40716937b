"""Arrays of complex float64 as scalars, stacks of matrices as matrices."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Reals

AT_A_ZERO = complex(1e300)
"""So large a slope of a logarithm that Newton's step is 0."""
_TERMS = 18
_NORM = 0.5


class Float64:
    """Scalars are numpy arrays of one shape (or numbers); matrices have that shape and two more axes."""

    def number(self, x: Fraction) -> float:
        return float(x)

    def evaluate(self, coefficients: Sequence[Fraction], z: Any) -> Any:
        total = np.zeros_like(np.asarray(z, complex))
        for c in reversed(coefficients):
            total = total * z + float(c)
        return total

    def matrix(self, rows: Sequence[Sequence[Any]]) -> Complexes:
        shape = np.broadcast_shapes(*(np.shape(x) for row in rows for x in row))
        columns = len(rows[0]) if len(rows) else 0
        out = np.empty((*shape, len(rows), columns), complex)
        for i, row in enumerate(rows):
            for j, x in enumerate(row):
                out[..., i, j] = x
        return out

    def times(self, a: Any, factor: Any) -> Any:
        return a * np.asarray(factor)[..., None, None]

    def product(self, a: Any, b: Complexes) -> Any:
        return a @ b

    def exp(self, a: Any) -> Complexes:
        """By scaling and squaring of the Taylor series, one scale for the whole stack."""
        size = float(np.abs(a).sum(-2).max()) if a.size else 0.0
        halvings = max(0, int(np.ceil(np.log2(size / _NORM)))) if size > _NORM else 0
        a = a / 2.0**halvings
        total = np.broadcast_to(np.eye(a.shape[-1], dtype=complex), a.shape)
        for k in range(_TERMS, 0, -1):
            total = np.eye(a.shape[-1]) + a @ total / k
        for _ in range(halvings):
            total = total @ total
        return total

    def solve(self, a: Any, b: Complexes) -> Any:
        return np.linalg.solve(a, b)

    def entry(self, a: Any, i: int, j: int) -> Any:
        return a[..., i, j]

    def det(self, a: Any) -> Any:
        return np.linalg.det(a)


def log_slope(A: Any, A_slope: Any) -> Any:
    """tr(A⁻¹A′), the slope of log det A, of many matrices: nan where one is not finite, huge where A is singular."""
    fine = np.isfinite(A).all((1, 2)) & np.isfinite(A_slope).all((1, 2))
    A, A_slope = np.where(fine[:, None, None], A, np.eye(A.shape[1])), np.where(fine[:, None, None], A_slope, 0)
    try:
        trace = np.einsum("kii->k", np.linalg.solve(A, A_slope))
    except np.linalg.LinAlgError:  # at a zero itself
        trace = np.array([_log_slope(a, b) for a, b in zip(A, A_slope, strict=True)])
    return np.where(fine, trace, np.nan)


def _log_slope(a: Any, b: Any) -> complex:
    try:
        return complex(np.trace(np.linalg.solve(a, b)))
    except np.linalg.LinAlgError:
        return AT_A_ZERO


def short(x: float) -> float:
    """A float with few digits, so that files are short."""
    return float(np.float32(x))


def distinct(x: Any) -> Any:
    """The different entries of an array, ascending: np.unique, which would load masked arrays with it."""
    ordered = np.sort(np.ravel(x))
    new = np.ones(len(ordered), bool)
    new[1:] = ordered[1:] != ordered[:-1]
    return ordered[new]


def lowest(f: Callable[[Any], Any], x: Reals, size: int, times: int) -> tuple[float, float]:
    """(x, f) where f is least on this grid, then on one of `size` between the neighbours, so many times in all."""
    for _ in range(times):
        values = f(x)
        k = int(np.nanargmin(values))
        least = float(x[k]), float(values[k])
        x = np.linspace(x[max(k - 1, 0)], x[min(k + 1, len(x) - 1)], size)
    return least


def value_at(x: Any, y: Any, c: Reals) -> Any:
    """Σ c[i, j] x^i y^j at arrays of one shape, by Horner's rule in x and then in y: numpy.polynomial's polyval2d."""
    table = np.reshape(c, (*np.shape(c), *(1,) * np.ndim(x)))
    rows = table[-1] + 0 * x
    for row in table[-2::-1]:
        rows = row + rows * x
    total = rows[-1] + 0 * y
    for entry in rows[-2::-1]:
        total = entry + total * y
    return total


def companions(D: Any) -> Any:
    """Of each polynomial Σ D[:, i] z^i the matrix whose eigenvalues are its roots, shape (rows, degree, degree)."""
    n = D.shape[1] - 1
    C = np.zeros((len(D), n, n), D.dtype)
    C[:, range(n - 1), range(1, n)] = 1
    with np.errstate(all="ignore"):
        C[:, -1] = -D[:, :-1] / D[:, -1:]
    return C


def balanced(D: Reals) -> tuple[Reals, Complexes, Reals]:
    """(the same polynomials, monic, in a unit that balances their ends; their roots near there; the units)."""
    n = D.shape[1] - 1
    low = (np.abs(D) > 0).argmax(1)
    ends = np.abs(D[np.arange(len(D)), low])
    unit = ((ends / np.abs(D[:, n])) ** (1 / np.maximum(n - low, 1)))[:, None]
    scaled = D * unit ** np.arange(n + 1)
    scaled = scaled / scaled[:, n:]
    return scaled, np.linalg.eigvals(companions(scaled)).astype(complex), unit


def gaps(z: Any, own: float = np.inf) -> Any:
    """The distances of the numbers of each row from each other; `own`: of each from itself."""
    gap = np.abs(z[:, :, None] - z[:, None, :])
    gap[:, range(z.shape[1]), range(z.shape[1])] = own
    return gap


def polynomial_and_slope(D: Any, z: Complexes) -> tuple[Complexes, Complexes]:
    """Values and slopes in z at several z for each polynomial Σ D[:, i] z^i; z of shape (rows, …)."""
    value, slope = np.broadcast_to(D[:, -1:], z.shape), np.zeros_like(z)
    for i in range(D.shape[1] - 2, -1, -1):
        slope = slope * z + value
        value = value * z + D[:, i : i + 1]
    return value, slope


def refined(f: Callable[[Any], Any], points: Any, wide: Callable[[Any], Any], rounds: int) -> tuple[Any, Any, bool]:
    """(points, f there along the last axis, whether no step is wide any more): steps that are so often halved.

    wide: of the values, which steps between neighbours are too long.
    """
    values = f(points)
    for _ in range(rounds):
        at = np.flatnonzero(wide(values))
        if not len(at):
            return points, values, True
        between = (points[at] + points[at + 1]) / 2
        points, values = np.insert(points, at + 1, between), np.insert(values, at + 1, f(between), axis=-1)
    return points, values, not wide(values).any()
