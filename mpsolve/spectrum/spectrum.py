"""What is known of the induced frequencies of a problem in a region."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING, Any

from flint import acb, arb

from mpsolve.display import card
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import precision
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.result import Cost, Result
from mpsolve.numbers.rootball import RootBall, Symmetry
from mpsolve.outcome import Reason, Status
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.warned import warned
from mpsolve.spectrum.regions import Answered, Below, HalfPlane, Rectangle, Sheet

if TYPE_CHECKING:
    from mpsolve.certificate.format import Certificate
    from mpsolve.spectrum.shape import Shape

_GUARD = 32


@frozen
class Root(Portable):
    """One induced frequency q, or a cluster, in the problem's units: e^{iqt} grows where Im q < 0.

    q: a ball (flint.acb) that holds exactly `multiplicity` roots. symmetry: the axis on which it is proved to lie.
    """

    q: Any
    multiplicity: int
    symmetry: Symmetry
    problem: Given = field(repr=False)

    @property
    def frequency(self) -> Any:
        """|Re q|/2π, in Hz for a problem in SI; a real ball."""
        with precision(self._bits):
            return abs(self.q.real) / (2 * arb.pi())

    @property
    def growth(self) -> Any:
        """−Im q, the rate of growth in 1/s for a problem in SI; below 0 where the vibration decays."""
        return -self.q.imag

    @property
    def doubling_time(self) -> Any:
        """ln 2/|Im q|: the time in which the vibration doubles, or halves where it decays; infinite for Im q = 0."""
        with precision(self._bits):
            return arb(2).log() / abs(self.q.imag) if not self.q.imag.is_zero() else arb.pos_inf()

    @property
    def shape(self) -> Shape:
        """The motion of the rail under the contacts and of every body in this root."""
        from mpsolve.spectrum.shape import root_shape

        return root_shape(as_problem(self.problem), self.q, self.multiplicity)

    @property
    def _bits(self) -> int:
        return int(max(self.q.bits(), 53)) + _GUARD


@frozen
class Spectrum(Result):
    """The induced frequencies of a problem in `region`; a region may be smaller than the one that was asked for.

    problem: what was given; q is in its units (rad/s in SI, the paper's for a `Case`).
    roots: disjoint balls, sorted by (Re q, Im q), whose multiplicities add up to `count` where this is proved.
    unstable: how many of them have Im q < 0. neutral: how often q = 0 is a root by construction (bodies on dampers
    alone); unfelt: frequencies of the vehicle that no contact feels. Both are left out of `roots`.
    When undecided, `reason` says why and what helps, and `known` what is proved all the same: "count"; "growth", a
    rate with no root in Im q ≤ −growth; "outside", a Rectangle that holds all roots with Im q < 0; "strips", pairs of
    a Rectangle and its number of roots; "open", the rectangles that are left.
    note: why the region is not all that was asked for. closing: what proves that the count misses nothing.
    verified: what the standalone verifier has confirmed, in its own words; if it came to no end, why.
    """

    problem: Given
    region: Answered
    digits: int
    status: Status
    reason: Reason | None = None
    count: int | None = None
    unstable: int | None = None
    roots: tuple[Root, ...] = ()
    neutral: int = 0
    unfelt: tuple[acb, ...] = ()
    note: str = ""
    closing: str = ""
    verified: str = ""
    known: Mapping[str, Any] = field(default_factory=dict)
    certificate: Certificate | None = field(default=None, repr=False)
    cost: Cost = field(default_factory=lambda: Cost(0.0))

    @property
    def stable(self) -> bool | None:
        """True if proved that no root has Im q < 0, False if proved that one has, None where that is open.

        True needs the whole half-plane: a region with a radius or a rectangle cannot prove stability.
        """
        if self.unstable:
            return False
        whole = isinstance(self.region, Sheet) or (
            isinstance(self.region, (HalfPlane, Below)) and self.region.radius is None
        )
        return True if self.proved and whole and self.unstable == 0 else None

    @property
    def warnings(self) -> tuple[Reason, ...]:
        """What is likely to be a mistake in the problem, a sentence each; no part of any proof."""
        return warned(self.problem, [float(root.frequency.mid()) for root in self.roots])

    def records(self) -> Iterator[Mapping[str, Any]]:
        """A row for each root: q, its frequency and growth rate as floats, in the problem's units."""
        for root in self.roots:
            told = {"Re q": root.q.real, "Im q": root.q.imag, "frequency": root.frequency, "growth": root.growth}
            yield {name: float(ball.mid()) for name, ball in told.items()} | {"multiplicity": root.multiplicity}

    def _headline(self) -> str:
        found = (
            "roots"
            if self.count is None
            else f"{self.count} root{'s' * (self.count != 1)}, {self.unstable} with Im q < 0"
        )
        return f"Spectrum, {found}, in {self.region}: {self.trust}"

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        return card(self)


def sorted_roots(problem: Given, balls: Sequence[RootBall]) -> tuple[Root, ...]:
    """The balls as roots, by (Re q, Im q) of their middles."""
    roots = [Root(ball.q, ball.multiplicity, ball.symmetry, problem) for ball in balls]
    return tuple(sorted(roots, key=lambda root: (float(root.q.real.mid()), float(root.q.imag.mid()))))


def disjoint(balls: Sequence[RootBall | Root]) -> bool:
    """Whether no two of the balls overlap."""
    return not any(a.q.overlaps(b.q) for k, a in enumerate(balls) for b in balls[:k])


__all__ = ["Below", "Rectangle", "Cost", "HalfPlane", "Root", "Sheet", "Spectrum", "disjoint", "sorted_roots"]
