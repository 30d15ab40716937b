"""The paper's dimensionless case, held exactly: `Case`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields, replace
from typing import Any

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.exact import Exact, Number
from mpsolve.problem.checked import BUCKLED, above_zero, at_least_zero, check_ascending, parsed


@frozen
class Case:
    """A dimensionless case (10)–(12) that is admissible: every bound below has been decided exactly.

    alpha ≥ 0: velocity ratio; eta_b ≥ 0: damping ratio; eta_m > 0: mass ratios; positions: ξ of the masses,
    ascending, equal for masses that move as one; eta_n: axial force ratio, compression positive; eta_s ≥ 0:
    Pasternak modulus ratio; eta_n − eta_s < 1. InputError names the argument that breaks a bound.

    >>> Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5")).positions
    (Exact('0'), Exact('3/2'))
    """

    alpha: Exact
    eta_b: Exact
    eta_m: tuple[Exact, ...]
    positions: tuple[Exact, ...]
    eta_n: Exact
    eta_s: Exact

    def __init__(
        self,
        *,
        alpha: Number,
        eta_b: Number,
        eta_m: Number | Iterable[Number],
        positions: Number | Iterable[Number] | None = None,
        eta_n: Number = 0,
        eta_s: Number = 0,
    ) -> None:
        """Parse and check every value; one mass may be given bare, and sits at 0 if no position is given."""
        ratios = parsed(eta_m, "eta_m")
        if positions is None and len(ratios) == 1:
            positions = 0
        vars(self).update(
            alpha=at_least_zero(alpha, "alpha", "velocity ratio"),
            eta_b=at_least_zero(eta_b, "eta_b", "damping ratio"),
            eta_m=tuple(above_zero(ratio, f"eta_m[{j}]", "mass ratio") for j, ratio in enumerate(ratios, 1)),
            positions=() if positions is None else parsed(positions, "positions"),
            eta_n=Exact.parse(eta_n, "eta_n"),
            eta_s=at_least_zero(eta_s, "eta_s", "Pasternak modulus"),
        )
        if not ratios:
            raise InputError("eta_m", "is empty: give at least one mass ratio")
        if len(self.positions) != len(ratios):
            stated = f"has {len(self.positions)} values for {len(ratios)} masses"
            raise InputError("positions", f"{stated}: give one for each mass")
        check_ascending(self.positions, "positions[{j}]")
        if self.axial >= 1:
            stated = f"eta_n − eta_s is {self.axial.beside(1)}, not below 1"
            raise InputError("eta_n", f"{stated}, {BUCKLED} eta_n or raise eta_s")

    @property
    def count(self) -> int:
        """The number of masses, equal positions counted apart."""
        return len(self.eta_m)

    @property
    def axial(self) -> Exact:
        """N = η_N − η_S of (18), exactly; InputError where no single fourth root expresses it."""
        try:
            return self.eta_n - self.eta_s
        except ValueError:
            message = "has no rational ratio to eta_s, so eta_n − eta_s is not exact: give one as 0"
            raise InputError("eta_n", message) from None

    @property
    def merged(self) -> Case:
        """The same case with every group of masses at one position summed into a single mass.

        InputError under eta_m where such masses have no rational ratio.
        """
        total: dict[Exact, Exact] = {}
        for ratio, place in zip(self.eta_m, self.positions, strict=True):
            try:
                total[place] = total.get(place, Exact(0)) + ratio
            except ValueError:
                message = f"has no rational ratio between the masses at {place.short()}: give their sum"
                raise InputError("eta_m", message) from None
        return replace(self, eta_m=tuple(total.values()), positions=tuple(total))

    @property
    def overdamped(self) -> bool:
        """True if and only if η_b ≥ 1, decided exactly."""
        return self.eta_b >= 1

    @property
    def cuts_on_line(self) -> bool:
        """True if and only if η_b < 1 and N < β = √(1 − η_b²): the cuts lie on Im q = η_b. Decided exactly.

        For N > 0 this is √x + √y < 1 with x = N⁴ and y = η_b⁴, both rational.
        """
        if self.overdamped or self.axial.sign <= 0:
            return not self.overdamped
        x, y = self.axial.fourth_power, self.eta_b.fourth_power
        rest = 1 - x - y
        return rest > 0 and 4 * x * y < rest**2

    def as_dict(self) -> dict[str, str | list[str]]:
        """Return the case in canonical text, from which `from_dict` gives it back."""
        return {k: list(map(str, v)) if isinstance(v, tuple) else str(v) for k, v in vars(self).items()}

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Case:
        """Return the case with these values; InputError names a key that is unknown, missing or wrong."""
        known = [field.name for field in fields(cls)]
        for name in values:
            if name not in known:
                raise InputError(str(name), f"is unknown: the keys are {', '.join(known)}")
        for name in known[:4]:
            if name not in values:
                raise InputError(name, "is missing: give its value")
        return cls(**values)
