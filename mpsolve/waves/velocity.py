"""What critical velocities are: one with its wave, and all of a range with what is proved about it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from typing import Any

from flint import arb

from mpsolve.numbers.decimals import proved_digits
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status


class Kind(Enum):
    """What happens at a critical velocity."""

    MINIMUM = "two waves of a branch merge at its least phase velocity, where it is the group velocity"  # ω = 0
    MAXIMUM = "two waves of a branch merge at its greatest phase velocity, where it is the group velocity"  # ω = 0
    STATIONARY = (
        "waves of a branch merge where phase and group velocity are equal, at neither a minimum nor a maximum"
    )
    TOUCHING = "the group velocity of a wave"  # ω ≠ 0
    MEETING = "two branches meet on the line of the force"
    LONG_WAVES = "speed of infinitely long waves"  # a multiple root at p = 0
    WAVE_SPEED = "wave speed: a p-root runs to infinity"
    EVERY = "wave speed of every wavelength"  # D is 0 on the whole line


@dataclass(frozen=True)
class CriticalVelocity(Portable):
    """One critical velocity: `value` is a ball (flint.arb) that holds it.

    wavenumber: the real p of the wave that runs with the force, a ball; None where it is infinite or any. For ω = 0
    −p is another. frequency: Ω = ω − vp, that of the wave at rest. name: of a wave speed, as far as one is known.
    exact: the velocity as an `Exact`, where its square or its fourth power is rational.
    """

    value: arb
    wavenumber: arb | None
    frequency: arb | None
    kind: Kind
    name: str = ""
    exact: Exact | None = None


@dataclass(frozen=True)
class CriticalVelocities(Result):
    """All critical velocities in lower ≤ v ≤ upper, in ascending order; it iterates over them.

    status: UNVERIFIED where the list is proved to be complete (there is no certificate), UNDECIDED where velocities
    are left in `undecided`. always: what holds at every velocity, in sentences.
    """

    velocities: tuple[CriticalVelocity, ...]
    omega: Fraction
    lower: Fraction
    upper: Fraction
    status: Status
    undecided: tuple[arb, ...] = ()
    always: tuple[str, ...] = ()
    reason: Reason | None = None

    def __iter__(self) -> Iterator[CriticalVelocity]:
        return iter(self.velocities)

    def __len__(self) -> int:
        return len(self.velocities)

    @property
    def sentence(self) -> str:
        """What is proved about the whole range."""
        return self.said()

    def said(self, unit: str = "") -> str:
        """The same with a unit of velocities."""
        whole = f"{float(self.lower):g} ≤ v ≤ {float(self.upper):g} {unit}".strip()
        rest = "no two real wavenumbers of the undamped track merge, and for v > 0 none runs to infinity"
        rest += ", but for what holds always" if self.always else ""
        if not self.undecided:
            return f"proved, without certificate: the list is complete for {whole}; at every other v {rest}"
        where = ", ".join(f"{proved_digits(ball, 8)} {unit}".strip() for ball in self.undecided)
        return f"undecided at v = {where}; at every other v in {whole} that is not listed {rest}"

    def records(self) -> Iterator[Mapping[str, Any]]:
        """A row for each velocity, as floats."""
        for one in self.velocities:
            p = None if one.wavenumber is None else float(one.wavenumber.mid())
            yield {"v": float(one.value.mid()), "wavenumber": p, "kind": one.kind.value, "name": one.name}

    def to_dict(self) -> dict[str, Any]:
        """Decimals of which every digit is proved, for JSON."""
        return {
            "omega": str(self.omega),
            "range": [str(self.lower), str(self.upper)],
            "status": self.status.value,
            "sentence": self.sentence,
            "always": list(self.always),
            "undecided": [proved_digits(ball, 17) for ball in self.undecided],
            "velocities": [
                {
                    "v": proved_digits(one.value, 17),
                    "exact": None if one.exact is None else str(one.exact),
                    "wavenumber": None if one.wavenumber is None else proved_digits(one.wavenumber, 17),
                    "kind": one.kind.name.lower(),
                    "name": one.name,
                }
                for one in self.velocities
            ],
        }
