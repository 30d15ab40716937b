"""What is known of the zeros of a function in a region, or on an interval."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from flint import arb

from mpsolve.numbers.packed import Portable
from mpsolve.numbers.result import Cost, Result
from mpsolve.outcome import Reason, Status

if TYPE_CHECKING:
    from mpsolve.certificate.format import Certificate


@dataclass(frozen=True)
class Zero(Portable):
    """A zero, or a cluster that balls do not tell apart.

    q: a ball (flint.acb; flint.arb for a zero on an interval) that holds exactly `multiplicity` zeros of f, counted
    with multiplicity. real: it is proved to lie on the real axis.
    """

    q: Any
    multiplicity: int
    real: bool = False


@dataclass(frozen=True)
class Zeros(Result):
    """The zeros of f in `region`, which may be another than was asked for: `note` says why.

    roots: disjoint balls, sorted by (Re, Im), whose multiplicities add up to `count` where this is proved.
    When undecided, `reason` says why and what helps, and `known` what is proved all the same.
    function: f as it was read; for a fraction its zeros are those of the numerator where the denominator is not 0.
    assumed: what the proof takes on the user's word, one sentence each. verified: what the verifier has confirmed,
    or why it came to no end.
    certificate: None for a Python function that could not be read as an expression: nobody else can check that.
    """

    function: str
    region: Any
    digits: int
    status: Status
    reason: Reason | None = None
    count: int | None = None
    roots: tuple[Zero, ...] = ()
    note: str = ""
    assumed: tuple[str, ...] = ()
    known: Mapping[str, Any] = field(default_factory=dict)
    certificate: Certificate | None = field(default=None, repr=False)
    verified: str = ""
    cost: Cost = field(default_factory=lambda: Cost(0.0))

    @property
    def where(self) -> str:
        """The region in words, in terms of z."""
        if isinstance(self.region, tuple):
            return f"[{float(self.region[0]):.8g}, {float(self.region[1]):.8g}]"
        return str(self.region).replace(" q ", " z ")

    def records(self) -> Iterator[Mapping[str, Any]]:
        """A row for each zero, as floats."""
        for root in self.roots:
            places = {"z": root.q} if isinstance(root.q, arb) else {"Re z": root.q.real, "Im z": root.q.imag}
            yield {name: float(x.mid()) for name, x in places.items()} | {"multiplicity": root.multiplicity}

    def _headline(self) -> str:
        found = "zeros" if self.count is None else f"{self.count} zero{'s' * (self.count != 1)}"
        return f"Zeros: {found} of {self.function} in {self.where}: {self.trust}"
