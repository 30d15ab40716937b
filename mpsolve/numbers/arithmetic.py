"""What a formula needs of an arithmetic, so that it stands once for float64 arrays and balls.

Scalars of an arithmetic add, multiply and divide by the usual operators. `Float64` takes arrays of any shape as its
scalars, and then its matrices are stacks.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, Protocol


class Arithmetic(Protocol):
    """Scalars, and matrices of them; nothing here knows a model."""

    def number(self, x: Fraction) -> Any:
        """The scalar of a rational."""

    def evaluate(self, coefficients: Sequence[Fraction], z: Any) -> Any:
        """Σ c_j z^j, coefficients from the constant term up."""

    def matrix(self, rows: Sequence[Sequence[Any]]) -> Any:
        """A matrix from rows of scalars."""

    def times(self, a: Any, factor: Any) -> Any:
        """A matrix times a scalar."""

    def product(self, a: Any, b: Any) -> Any:
        """The product of two matrices."""

    def exp(self, a: Any) -> Any:
        """The exponential of a matrix."""

    def solve(self, a: Any, b: Any) -> Any:
        """x with a x = b, b a matrix."""

    def entry(self, a: Any, i: int, j: int) -> Any:
        """One entry as a scalar."""

    def det(self, a: Any) -> Any:
        """The determinant."""
