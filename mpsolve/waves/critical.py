"""Critical velocities of a moving force, all in a range by proof: double real p-roots of the undamped D on its line.

There a wave runs with the force: its group velocity is v, so that it carries nothing away, and without damping the
deflection grows without end. The discriminant in p is an exact polynomial in v, whose roots FLINT isolates. A simple
root belongs to one double p-root, which is real as its conjugate could be no other; at the others the p-roots are
computed over the field of the algebraic number v. Where the leading coefficient is 0 a p-root runs to infinity.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

from flint import fmpq, fmpq_poly

from mpsolve.errors import ContradictionError, InputError, PrecisionError
from mpsolve.numbers.balls import arb, precision, rational_ball
from mpsolve.numbers.decimals import working_bits
from mpsolve.numbers.model import rational, velocities, whole
from mpsolve.numbers.realroots import as_fmpq
from mpsolve.outcome import Reason, Status
from mpsolve.tracks.at_rest import Status as Rest
from mpsolve.tracks.at_rest import at_rest
from mpsolve.tracks.undamped import undamped
from mpsolve.tracks.waveguide import Track, Waveguide
from mpsolve.waves.algebraic import middle
from mpsolve.waves.line import Line, double_roots, line
from mpsolve.waves.place import Place, places_of, still
from mpsolve.waves.speeds import wave_speeds
from mpsolve.waves.velocity import CriticalVelocities, CriticalVelocity, Kind

_MOST_DIGITS = 4000


def critical_velocities(
    track: Track | Waveguide, omega: Any = 0, over: Mapping[str, Any] | None = None, digits: int = 30
) -> CriticalVelocities:
    """All velocities at which a force of frequency ω [rad/s] meets a double real p-root of the undamped track.

    over: {"v": (lower, upper)} in m/s, both ends included, 0 ≤ lower < upper; 0 to 2000 if left out. The damping of
    the track is left out (`mpsolve.tracks.undamped`). A force of frequency −ω, or one that runs the other way, has
    the same velocities. Proved complete, but for what the answer names in `undecided`. v = 0 is listed where two
    p-roots meet there, not where the degree of D drops. InputError for a track that is unstable at rest.

    >>> from mpsolve.tracks import EulerBernoulli
    >>> [(one.exact, one.kind.name) for one in critical_velocities(EulerBernoulli(EI="1/4", m=1, k=1))]
    [(Exact('1'), 'MINIMUM')]
    """
    if not isinstance(track, (Track, Waveguide)) and not hasattr(track, "waveguide"):
        raise InputError("track", f"is of type {type(track).__name__}: give a track of mpsolve.tracks or a Waveguide")
    low, high = velocities({"v": (0, 2000)} if over is None else over, '{"v": (0, 2000)}')
    frequency = abs(rational(omega, "omega"))
    digits = whole(digits, "digits", 1, _MOST_DIGITS)
    guide = undamped(track)
    found = at_rest(guide)
    if found.status is Rest.UNSTABLE:
        raise InputError("track", f"has no critical velocity, for {found.sentence}: change its parameters")
    names: dict[Any, str] = {}
    for name, square in wave_speeds(track).items():
        names[as_fmpq(square)] = " and ".join(filter(None, (names.get(as_fmpq(square)), name)))
    return _Search(line(guide, frequency), frequency, low, high, working_bits(digits), names).answer()


class _Search:
    """One line, its range, and what is found along it."""

    def __init__(
        self, along: Line, omega: Fraction, low: Fraction, high: Fraction, bits: int, names: Mapping[fmpq, str]
    ) -> None:
        self.line, self.omega, self.low, self.high, self.bits, self.names = along, omega, low, high, bits, names
        self.undecided: list[Any] = []

    def answer(self) -> CriticalVelocities:
        found = [*self._on_whole_lines(), *self._at_infinity(), *self._long(), *self._double()]
        status = Status.UNDECIDED if self.undecided else Status.UNVERIFIED
        stated = "double roots in p are not told apart at the highest precision"
        return CriticalVelocities(
            tuple(sorted(found, key=lambda one: middle(one.value))),
            self.omega,
            self.low,
            self.high,
            status,
            tuple(self.undecided),
            self._always(),
            Reason("wavenumbers-not-apart", stated) if self.undecided else None,
        )

    def _always(self) -> tuple[str, ...]:
        out = []
        if self.line.squared and self.line.stripped:
            out.append("p = 0 is a double root of D at every velocity: infinitely long waves need no force")
        elif self.line.stripped:
            out.append("p = 0 is a root at every velocity: the frequency is that of an infinitely long wave at rest")
        if self.line.repeated:
            out.append("D has a repeated factor, so that on its branches every p-root is double at every velocity")
        return tuple(out)

    def _on_whole_lines(self) -> Iterator[CriticalVelocity]:
        for place, _ in self._places(self.line.content):
            yield self._found(place, None, Kind.EVERY, self._name(place))
        if not self.low and not self.line.content[0]:
            yield self._found(still(), None, Kind.EVERY, "")

    def _at_infinity(self) -> Iterator[CriticalVelocity]:
        for place, _ in self._places(self.line.lead):
            yield self._found(place, None, Kind.WAVE_SPEED, self._name(place))

    def _long(self) -> Iterator[CriticalVelocity]:
        """p = 0 is a root of what is left, which is even for ω = 0, and else has lost a root at p = 0 already."""
        if not self.line.squared and not self.line.stripped:
            return
        for place, _ in self._places(self.line.rows[0]):
            yield self._found(place, arb(0), Kind.LONG_WAVES)
        if not self.low and not self.line.rows[0][0]:
            yield self._found(still(), arb(0), Kind.LONG_WAVES)

    def _double(self) -> Iterator[CriticalVelocity]:
        discriminant = self.line.discriminant
        if not discriminant:
            raise ContradictionError(
                "the discriminant of a squarefree polynomial is 0: please report this as a fault"
            )
        for place, power in self._places(discriminant):
            yield from self._tried(place, power == 1 and not place.annuls(self.line.lead))
        if not self.low and not discriminant[0]:
            yield from self._tried(still(), False)

    def _tried(self, place: Place, single: bool) -> Iterator[CriticalVelocity]:
        try:
            for p, kind in double_roots(self.line, place, single, self.bits):
                yield from self._of_wave(place, p, kind)
        except PrecisionError:
            self.undecided.append(place.velocity(self.bits))

    def _of_wave(self, place: Place, root: Any, kind: Kind) -> Iterator[CriticalVelocity]:
        """The critical velocity of a real root; none for y < 0, and y = 0 is found elsewhere."""
        if not self.line.squared:
            yield self._found(place, root, kind)
        elif root > 0:
            with precision(self.bits):
                yield self._found(place, root.sqrt(), kind)
        elif not root < 0 and not place.annuls(self.line.rows[0]):
            raise PrecisionError("the square of a wavenumber has no proved sign")

    def _found(self, place: Place, p: arb | None, kind: Kind, name: str = "") -> CriticalVelocity:
        v = place.velocity(self.bits)
        with precision(self.bits):
            frequency = None if p is None else rational_ball(self.omega) - v * p
        return CriticalVelocity(v, p, frequency, kind, name, place.exact)

    def _name(self, place: Place) -> str:
        m = place.w.m
        return self.names.get(-fmpq_poly(m)[0] / fmpq_poly(m)[1], "") if m.degree() == 1 else ""

    def _places(self, f: fmpq_poly) -> Iterator[tuple[Place, int]]:
        return places_of(f, self.line.squared, self.low, self.high, self.bits)
