"""Exact polynomials in several named variables, which a formula takes as numbers where parameters are left free.

Exponents may be negative (a stiffness whose compliance enters). Two of them are ordered as their values at the
ring's own point are, which tells nothing about other points.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import total_ordering
from operator import add
from typing import Any, TypeVar

from mpsolve.frozen import frozen

Exponents = tuple[int, ...]
K = TypeVar("K", bound=Exponents)


@frozen
class Ring:
    """The variables, and a point that orders what is made of them."""

    names: tuple[str, ...]
    point: tuple[Fraction, ...]

    @property
    def variables(self) -> tuple[Several, ...]:
        """Each variable as a polynomial."""
        n = len(self.names)
        return tuple(Several(self, {tuple(int(i == k) for i in range(n)): Fraction(1)}) for k in range(n))

    def constant(self, value: Any) -> Several:
        """A number, or a polynomial of this ring as it is."""
        if isinstance(value, Several):
            return value
        number = Fraction(value)
        return Several(self, {(0,) * len(self.names): number} if number else {})


def plus(*polynomials: Mapping[K, Any]) -> dict[K, Any]:
    """The sum of polynomials as exponents with coefficients, whatever those are."""
    out: dict[K, Any] = {}
    for terms in polynomials:
        for e, c in terms.items():
            out[e] = out[e] + c if e in out else c
    return {e: c for e, c in out.items() if c}


def multiply(a: Mapping[K, Any], b: Mapping[K, Any]) -> dict[K, Any]:
    """The product of two of them."""
    out: dict[Any, Any] = {}
    for d, x in a.items():
        for e, y in b.items():
            key = tuple(map(add, d, e))
            out[key] = out[key] + x * y if key in out else x * y
    return {e: c for e, c in out.items() if c}


def evaluated(terms: Iterable[tuple[Exponents, Any]], point: Sequence[Any], number: Any = None) -> Any:
    """Σ c x₁^e₁ x₂^e₂ … at a point; number: what turns a coefficient into one of its kind, such as balls."""
    total = Fraction(0) if number is None else number(Fraction(0))
    for exponents, c in terms:
        term = c if number is None else number(c)
        for x, e in zip(point, exponents, strict=True):
            if e:
                term = term * x**e
        total = total + term
    return total


@total_ordering
class Several:
    """Σ c x₁^e₁ x₂^e₂ … with c ≠ 0; immutable."""

    __slots__ = ("ring", "terms")

    def __init__(self, ring: Ring, terms: Mapping[Exponents, Fraction]) -> None:
        self.ring, self.terms = ring, dict(terms)

    def at(self, values: Sequence[Fraction]) -> Fraction:
        """The value at a point; ZeroDivisionError where a negative power meets 0."""
        return Fraction(evaluated(self, values))

    def __iter__(self) -> Iterator[tuple[Exponents, Fraction]]:
        return iter(self.terms.items())

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, (int, Fraction, Several)):
            return self.terms == self.ring.constant(other).terms
        return NotImplemented

    def __hash__(self) -> int:
        return hash(frozenset(self.terms.items()))

    def __lt__(self, other: Any) -> bool:
        here, there = self.at(self.ring.point), self.ring.constant(other).at(self.ring.point)
        return bool(here < there)

    def __neg__(self) -> Several:
        return Several(self.ring, {e: -c for e, c in self.terms.items()})

    def __add__(self, other: Any) -> Several:
        return Several(self.ring, plus(self.terms, self.ring.constant(other).terms))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Several:
        return self + -self.ring.constant(other)

    def __rsub__(self, other: Fraction) -> Several:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> Several:
        return Several(self.ring, multiply(self.terms, self.ring.constant(other).terms))

    __rmul__ = __mul__

    def __pow__(self, n: int) -> Several:
        out = self.ring.constant(1)
        for _ in range(n):
            out = out * self
        return out

    def __truediv__(self, other: Any) -> Several:
        """By a number, or by a single term."""
        divisor = self.ring.constant(other)
        if len(divisor.terms) != 1:
            raise ZeroDivisionError("a polynomial is divided by one that is not a single term")
        ((exponents, c),) = divisor.terms.items()
        return self * Several(self.ring, {tuple(-e for e in exponents): 1 / c})

    def __rtruediv__(self, other: int) -> Several:
        quotient: Several = self.ring.constant(other).__truediv__(self)
        return quotient

    def __repr__(self) -> str:
        return f"Several({' + '.join(f'{c}·{e}' for e, c in self.terms.items()) or '0'})"
