"""The passivity velocity of a track: below it no passive vehicle with one contact can be unstable.

While −Im G(0, q) > 0 for all real q > 0, σG is positive real in Re σ > 0, so that 1 + G·Y has no zero there for any
passive vehicle Y, of whatever kind and mass (SPEC, section 6.6). The first velocity at which this fails is proved.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb, fmpq_poly

from mpsolve.characteristic.floats import Receptance
from mpsolve.characteristic.splitting import upper_count
from mpsolve.characteristic.symbol import Symbol
from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import acb, precision, rational_ball
from mpsolve.numbers.decimals import working_bits
from mpsolve.numbers.model import velocities, whole
from mpsolve.numbers.plain import float_beside, outward
from mpsolve.numbers.realroots import as_fmpq, positive_roots
from mpsolve.outcome import Reason, Status
from mpsolve.passivity.answer import Kind, PassivityVelocity
from mpsolve.passivity.corner import corner, unscaled, velocity_of_loss
from mpsolve.passivity.cover import Moving, Strip, cover
from mpsolve.passivity.decay import vanishes
from mpsolve.problem.reduced import Guide, track_guide
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import MORE_EFFORT, Effort, begun
from mpsolve.tracks.at_rest import Status as Rest
from mpsolve.tracks.at_rest import at_rest
from mpsolve.tracks.passive import passivity
from mpsolve.tracks.string import String
from mpsolve.tracks.waveguide import Track, Waveguide, moving

_EVALUATIONS = 60_000
_GRID = 32  # velocities at which floats look for a loss
_BELOW_WAVES = Fraction(999, 1000)  # of the least wave speed in the range: how far the proof is tried
_MOST_DIGITS = 10_000


def passivity_velocity(
    track: Track | Waveguide,
    *,
    over: Mapping[str, Any],
    digits: int = 30,
    effort: Effort | None = None,
    progress: Progress | None = None,
) -> PassivityVelocity:
    """The first velocity in a range at which −Im G(0, q) > 0 for all real q > 0 fails; G(0, ·) in m/N at the force.

    over: {"v": (lower, upper)} in m/s, exact, 0 ≤ lower < upper. digits: of `value`. While it holds no passive
    vehicle with one contact is unstable, of whatever kind and mass. There is no certificate. InputError for a track
    that is unstable, undamped or active at rest. Source: SPEC2, section 6.6.

    For EulerBernoulli(EI="1/4", m=1, k=1, c=1), the paper's beam with η_b = 0.5, `value` is 1.1899209702954530 to 16
    digits, after 1 s.
    """
    low, high = velocities(over, '{"v": (0, 500)}')
    digits = whole(digits, "digits", 1, _MOST_DIGITS)
    guide = _checked(track)
    if isinstance(track, String):
        return velocity_of_string(track, low, high, working_bits(digits))
    budget = begun(effort, _EVALUATIONS)
    return _Search(guide, low, high, working_bits(digits), budget, progress or silent).answer()


def _checked(track: Track | Waveguide) -> Guide:
    """The track at rest, scaled; InputError where it cannot be asked for passivity."""
    if not isinstance(track, (Track, Waveguide)):
        raise InputError("track", f"is of type {type(track).__name__}: give a track of mpsolve.tracks or a Waveguide")
    rest = at_rest(track)
    if rest.status is Rest.UNSTABLE:
        raise InputError("track", f"cannot be used: {rest.sentence}: change its parameters")
    if rest.status is Rest.UNDAMPED or not passivity(track).passive or passivity(track).lossless:
        raise InputError("track", "takes up no power, or gives some, at rest: give it some damping")
    return track_guide(track, Fraction(0))


def _speeds(guide: Guide, high: Fraction) -> list[arb]:
    """The wave speeds up to `high`, scaled, as balls."""
    top = max(i + j for i, j in guide.D_rest)
    row = [Fraction(0)] * (top + 1)
    for (i, j), c in guide.D_rest.items():
        if i + j == top:
            row[j] += c * (-1) ** j
    f = fmpq_poly([as_fmpq(c) for c in row])
    return [ball for ball, _ in positive_roots(f) if not ball > rational_ball(high)] if f.degree() > 0 else []


class _Search:
    """One track and its range; velocities are scaled inside, exact as fractions."""

    def __init__(
        self, guide: Guide, low: Fraction, high: Fraction, bits: int, effort: Effort, tell: Progress
    ) -> None:
        self.guide, self.bits, self.effort, self.tell = guide, bits, effort, tell
        self.unit = unscaled(Moving(guide, 0))
        self.low, self.high = low, high
        with precision(64):
            self.speeds = _speeds(guide, high / self.unit)

    def answer(self) -> PassivityVelocity:
        low, high = self.low / self.unit, self.high / self.unit
        if self.speeds:
            slowest = Fraction(float(self.speeds[0].lower())) * _BELOW_WAVES
            if slowest <= low:
                return self._open("wave-speed", "the range lies at or above a wave speed of the track", None)
            high = min(high, slowest)
        problem = self._premise(low, high)
        if problem is not None:
            return problem
        self.tell("search", 0.0)
        try:
            lost = self._first_loss(low, high)
            if lost is None:
                return self._whole(low, high)
            if lost == low:
                return self._from_start(low)
            return self._lost(low, lost)
        except EffortError as error:
            return self._open("effort", str(error), None, MORE_EFFORT)
        except PrecisionError as error:
            return self._open("precision", str(error), None)

    def _premise(self, low: Fraction, high: Fraction) -> PassivityVelocity | None:
        inside = Fraction(float(low + (high - low) * Fraction(5, 8)))
        fast = moving(self.guide.D_rest, inside), moving(self.guide.N_rest, inside)
        if not vanishes(*fast, inside):
            return self._open("decay", "the receptance is not proved to vanish at infinity", None)
        if not any(i + j <= 1 for i, j in self.guide.D_rest):
            return self._open("waves-meet", "two waves of the track come to p = 0 as q goes to 0", None)
        self.upper = upper_count(Symbol.of(fast[0]))
        return None

    def _at(self, v: Fraction) -> Guide:
        g = self.guide
        return Guide(g.length, g.time, g.D_rest, g.N_rest, moving(g.D_rest, v), moving(g.N_rest, v), v, g.g)

    def _loses(self, v: Fraction) -> tuple[bool, bool]:
        """In floats: whether passivity is lost at v, and whether it is lost at q → 0."""
        receptance = Receptance(self._at(v))
        if v:
            vars(receptance)["upper"] = self.upper
        q = np.geomspace(1e-3, 20, 100)
        G, _ = receptance(1j * q, [Fraction(0)], False)
        _, slope = receptance(np.array([1e-7j]), [Fraction(0)], True)
        bad = bool((G[0].imag > 1e-13 * np.abs(G[0])).any())
        zero = bool(slope[0][0].real > 0)
        return bad or zero, zero

    def _first_loss(self, low: Fraction, high: Fraction) -> Fraction | None:
        """In floats: a velocity just above the first loss, `low` itself, or None."""
        before = None
        for k in range(_GRID + 1):
            v = low + (high - low) * Fraction(k, _GRID)
            self.effort.spend(1)
            if v and self._loses(v)[0]:
                break
            before = v
        else:
            return None
        if before is None:
            return low
        for _ in range(40):
            middle = Fraction(float((before + v) / 2))
            if not before < middle < v:
                break
            before, v = (before, middle) if self._loses(middle)[0] else (middle, v)
        return v

    def _whole(self, low: Fraction, high: Fraction) -> PassivityVelocity:
        self.tell("cover", 0.2)
        if len(self._covered(low, float_beside(high, up=True), 0.0)):
            return self._open("boxes", "the balance of power is too close at some frequency to be decided", None)
        with precision(self.bits):
            to = rational_ball(high * self.unit)
        if self.speeds:
            stated = "a wave speed of the track lies in the range, above which nothing is proved"
            return self._open("wave-speed", stated, to, "give a range that ends below it")
        return self._result(Kind.WHOLE, None, to, Status.UNVERIFIED)

    def _from_start(self, low: Fraction) -> PassivityVelocity:
        """A frequency at which the track gives, proved."""
        with precision(96):
            for q in (*np.geomspace(1e-4, 20, 200).tolist(),):
                try:
                    G = Moving(self.guide, self.upper).germ(acb(0, q), rational_ball(low), 0).value[0]
                except PrecisionError:
                    continue
                if G.imag > 0:
                    return self._result(Kind.FROM_START, None, None, Status.UNVERIFIED)
        return self._open("start", "the track seems not to be passive at the lower end of the range", None)

    def _lost(self, low: Fraction, near: Fraction) -> PassivityVelocity:
        if not self._loses(near)[1]:
            return self._open("inner-loss", "passivity seems to be lost first at a frequency q > 0", None)
        here = Moving(self.guide, self.upper)
        value = velocity_of_loss(here, float(near), self.bits)
        self.tell("corner", 0.1)
        found = corner(here, value, self.effort)
        if found is None:
            return self._open("corner", "the loss at q → 0 is not proved to be the first", None)
        below = max(Fraction(found.below), low)
        self.tell("cover", 0.3)
        if len(self._covered(below, outward(value, up=True), found.reach)):
            return self._open("boxes", "the balance of power next to the loss is too close to be decided", None)
        if below > low and len(self._covered(low, float_beside(below, up=True), 0.0)):
            return self._open("boxes", "the balance of power is too close at some frequency to be decided", None)
        with precision(self.bits):
            v = value * rational_ball(self.unit)
        return self._result(Kind.LOST, v, v, Status.UNVERIFIED)

    def _covered(self, low: Fraction, high: float, first: float) -> Reals:
        return cover(Strip(Moving(self.guide, self.upper), float_beside(low, up=False), high), first, self.effort)

    def _open(self, code: str, message: str, to: Any, remedy: str = "") -> PassivityVelocity:
        return self._result(Kind.UNDECIDED, None, to, Status.UNDECIDED, Reason(code, message, {}, remedy))

    def _result(
        self, kind: Kind, value: arb | None, to: arb | None, status: Status, reason: Reason | None = None
    ) -> PassivityVelocity:
        with precision(self.bits):
            speeds = tuple(ball * rational_ball(self.unit) for ball in self.speeds)
        return PassivityVelocity(kind, value, self.low, self.high, to, speeds, status, reason)


def velocity_of_string(track: String, low: Fraction, high: Fraction, bits: int) -> PassivityVelocity:
    """The answer for low ≤ v ≤ high and a damped string, without any boxes; balls of that many bits."""
    with precision(bits):
        speed = (rational_ball(track.T) / rational_ball(track.m)).sqrt()
        end = rational_ball(high)
    square = track.T / track.m
    if low * low >= square:
        stated = "faster than its waves a string carries none ahead, and G(0, q) = 0: single contacts do not feel it"
        reason = Reason("wave-speed", stated, {}, "give a range that begins below the speed of its waves")
        return PassivityVelocity(Kind.UNDECIDED, None, low, high, None, (), Status.UNDECIDED, reason)
    if high * high < square:
        return PassivityVelocity(Kind.WHOLE, None, low, high, end, (), Status.UNVERIFIED)
    return PassivityVelocity(Kind.LOST, speed, low, high, speed, (speed,), Status.UNVERIFIED)
