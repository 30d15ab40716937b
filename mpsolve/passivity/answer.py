"""What is known of a track's passivity for one contact over a range of velocities."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from typing import Any

from flint import arb

from mpsolve.numbers.decimals import proved_digits
from mpsolve.numbers.model import shown
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status


class Kind(Enum):
    """How the range of velocities ends for passivity."""

    LOST = "lost at the velocity"  # first where q → 0; on a string for all q, at the speed of its waves
    WHOLE = "passive over the whole range"
    FROM_START = "not passive at the lower end of the range"
    UNDECIDED = "undecided"


@dataclass(frozen=True)
class PassivityVelocity(Result):
    """What is known of −Im G(0, q) > 0 for all real q > 0 over a range of velocities, in the track's units.

    value: the first velocity at which it fails, a ball (flint.arb); None where there is none in the range.
    passive_to: it is proved for lower ≤ v < passive_to (v ≤ passive_to where `kind` is WHOLE, or UNDECIDED); None:
    nowhere.
    wave_speeds: those in the range, where a p-root of the track runs to infinity, as balls.
    """

    kind: Kind
    value: arb | None
    lower: Fraction
    upper: Fraction
    passive_to: arb | None
    wave_speeds: tuple[arb, ...]
    status: Status
    reason: Reason | None = None

    @property
    def sentence(self) -> str:
        """The answer in one sentence."""
        whole = f"{shown(self.lower)} ≤ v ≤ {shown(self.upper)}"
        safe = "no passive vehicle with one contact is unstable"
        if self.kind is Kind.WHOLE:
            return f"proved, without certificate: {safe} at any velocity in {whole}"
        if self.kind is Kind.LOST:
            return (
                f"proved, without certificate: {safe} from {shown(self.lower)} to v = {proved_digits(self.value, 17)}"
            )
        if self.kind is Kind.FROM_START:
            return f"proved, without certificate: the track is not passive for one contact at v = {shown(self.lower)}"
        known = "" if self.passive_to is None else f"; {safe} up to v = {proved_digits(self.passive_to, 6)}"
        return f"undecided: {self.reason}{known}"

    def to_dict(self) -> dict[str, Any]:
        """Decimals of which every digit is proved, for JSON."""
        return {
            "kind": self.kind.name.lower(),
            "value": _decimal(self.value),
            "range": [str(self.lower), str(self.upper)],
            "passive_to": _decimal(self.passive_to),
            "wave_speeds": [_decimal(x) for x in self.wave_speeds],
            "status": self.status.value,
            "reason": None if self.reason is None else self.reason.data(),
            "sentence": self.sentence,
        }


def _decimal(x: arb | None) -> str | None:
    return None if x is None else proved_digits(x, 30)
