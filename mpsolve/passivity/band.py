"""The passivity band of a problem: beyond it no passive vehicle on its contacts can have a real root."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb

from mpsolve.characteristic.floats import Receptance
from mpsolve.errors import InputError
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.decimals import proved_digits
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.passivity.box import passive_beyond
from mpsolve.passivity.decay import overtakes
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.subject import Subject
from mpsolve.problem.problem import Problem, require_problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.tracks.at_rest import Status as Rest
from mpsolve.tracks.at_rest import at_rest
from mpsolve.tracks.passive import passivity

_SAMPLES = 400


@dataclass(frozen=True)
class PassivityBand(Result):
    """−Im G(q) is positive definite for all real q > value (rad/s for a problem in SI), G between the contacts.

    value: a real ball; None where no such frequency is proved. least: in floats, without proof, the largest frequency
    at which it was seen not to be so, 0 where none was: what `value` cannot be below.
    """

    value: arb | None
    least: float
    status: Status
    reason: Reason | None = None

    @property
    def sentence(self) -> str:
        """The answer in one sentence."""
        if self.value is None:
            return f"undecided: {self.reason}"
        at = proved_digits(self.value, 6)
        stated = f"at no frequency q > {at} the contacts give energy to a passive vehicle"
        return f"proved, without certificate: {stated}; floats see them give some up to {self.least:.6g}"

    def to_dict(self) -> dict[str, Any]:
        """Decimals of which every digit is proved, for JSON; `least` is a float without proof."""
        return {
            "value": None if self.value is None else proved_digits(self.value, 17),
            "least": self.least,
            "status": self.status.value,
            "reason": None if self.reason is None else self.reason.data(),
            "sentence": self.sentence,
        }


def passivity_band(problem: Problem) -> PassivityBand:
    """The frequency beyond which no passive vehicle on these contacts has a real root, whatever its masses.

    The theorem is about the track, the velocity and the places of the contacts alone. It is as tight as is found
    within a second or so: `least` tells how tight. There is no certificate. InputError for a track that is unstable,
    undamped or active at rest. Source: SPEC2, sections 6.2 and 6.5.

    >>> from mpsolve import tracks, vehicles
    >>> beam = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
    >>> band = passivity_band(Problem(beam, [vehicles.Mass(10), vehicles.Mass(10).at("1.5")], v="0.8"))
    >>> 0.19 < band.least < float(band.value) < 0.4
    True
    """
    require_problem(problem)
    rest = at_rest(problem.track)
    if rest.status is Rest.UNSTABLE:
        raise InputError("track", f"cannot be used: {rest.sentence}: change its parameters")
    if rest.status is Rest.UNDAMPED or not passivity(problem.track).passive or passivity(problem.track).lossless:
        raise InputError("track", "takes up no power, or gives some, at rest: give it some damping")
    reduced = reduce_problem(problem)
    if not problem.v:
        return PassivityBand(rational_ball(Fraction(0)), 0.0, Status.UNVERIFIED)
    X = passive_beyond(Envelope(Subject.of_reduced(reduced), (), ()))
    if X is None:
        fast = overtakes(reduced.guide, reduced.guide.v)
        stated = "the contacts run faster than short waves of the track" if fast else "no frequency is found"
        remedy = "lower the velocity" if fast else "give the track more damping, or the contacts more distance"
        return PassivityBand(None, _least(reduced, 1e3), Status.UNDECIDED, Reason("no-band", stated, {}, remedy))
    with precision(64):
        value = rational_ball(Fraction(X) * reduced.frequency_unit)
    return PassivityBand(value, _least(reduced, X), Status.UNVERIFIED)


def _least(reduced: Reduced, X: float) -> float:
    """In floats: the largest q ≤ X, in the problem's units, at which −Im G has a negative eigenvalue."""
    q = np.geomspace(X * 1e-4, X, _SAMPLES)
    G = Receptance(reduced.guide).between(1j * q, reduced.places)
    values = np.linalg.eigvalsh(-(G - np.swapaxes(G.conj(), 1, 2)) / 2j)
    bad = np.flatnonzero(values[:, 0] < -1e-12 * np.abs(values).max(1))
    return float(q[bad[-1]]) * float(reduced.frequency_unit) if len(bad) else 0.0
