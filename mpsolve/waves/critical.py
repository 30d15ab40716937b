"""Critical velocities of a moving force, all in a range by proof: double real p-roots of the undamped D on its line.

There a wave runs with the force: its group velocity is v, so that it carries nothing away, and without damping the
deflection grows without end. The discriminant in p is an exact polynomial in v, whose roots FLINT isolates. A simple
root belongs to one double p-root, which is real as its conjugate could be no other; at the others the p-roots are
computed over the field of the algebraic number v. Where the leading coefficient is 0 a p-root runs to infinity.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from typing import Any

from flint import fmpq_poly, fmpz_poly

from mpsolve.errors import ContradictionError, InputError, PrecisionError
from mpsolve.numbers.balls import arb, precision, rational_ball
from mpsolve.numbers.decimals import proved_digits, working_bits
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import rational
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.ranges import checked_range
from mpsolve.numbers.realroots import as_fmpq
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.tracks.at_rest import Status as Rest
from mpsolve.tracks.at_rest import at_rest
from mpsolve.tracks.undamped import undamped
from mpsolve.tracks.waveguide import Track, Waveguide
from mpsolve.waves.algebraic import (
    Algebraic,
    embedded,
    isolated,
    middle,
    multiple_roots,
    places,
    real_roots,
    slope,
    split,
)
from mpsolve.waves.line import Line, line
from mpsolve.waves.speeds import wave_speeds

_TRIES = 4  # doublings of the precision before a double root is sought over the field
_MOST_BITS = 1 << 14
_MOST_DIGITS = 4000


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

    value: Any
    wavenumber: Any
    frequency: Any
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
    undecided: tuple[Any, ...] = ()
    always: tuple[str, ...] = ()
    reason: Reason | None = None

    def __iter__(self) -> Iterator[CriticalVelocity]:
        return iter(self.velocities)

    def __len__(self) -> int:
        return len(self.velocities)

    @property
    def sentence(self) -> str:
        """What is proved about the whole range."""
        whole = f"{float(self.lower):g} ≤ v ≤ {float(self.upper):g}"
        rest = "no two p-roots of the undamped track meet on the real axis, and for v > 0 none runs to infinity"
        rest += ", but for what holds always" if self.always else ""
        if not self.undecided:
            return f"proved, without certificate: the list is complete for {whole}; at every other v there {rest}"
        where = ", ".join(proved_digits(ball, 8) for ball in self.undecided)
        return f"undecided at v = {where}; at every other v in {whole} that is not listed {rest}"

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
    low, high = _range(over)
    frequency = abs(rational(omega, "omega"))
    if isinstance(digits, bool) or not isinstance(digits, int) or not 1 <= digits <= _MOST_DIGITS:
        raise InputError("digits", f"is {digits!r}: give a whole number from 1 to {_MOST_DIGITS}")
    guide = undamped(track)
    found = at_rest(guide)
    if found.status is Rest.UNSTABLE:
        raise InputError("track", f"has no critical velocity, for {found.sentence}: change its parameters")
    names: dict[Any, str] = {}
    for name, square in wave_speeds(track).items():
        names[as_fmpq(square)] = " and ".join(filter(None, (names.get(as_fmpq(square)), name)))
    return _Search(line(guide, frequency), frequency, low, high, working_bits(digits), names).answer()


def _range(over: Mapping[str, Any] | None) -> tuple[Fraction, Fraction]:
    given = {"v": (0, 2000)} if over is None else over
    if not isinstance(given, Mapping) or list(given) != ["v"]:
        raise InputError("over", f'is {given!r}: give the range of velocities, {{"v": (0, 2000)}}')
    low, high = checked_range(given["v"], "over['v']")
    if low.sign < 0:
        raise InputError("over['v']", f"starts at {low.short()}: give v ≥ 0, for the track is the same both ways")
    return low.as_fraction(), high.as_fraction()


@dataclass(frozen=True)
class _Place:
    """A velocity as an algebraic number: its square w, and x, which is w itself for ω = 0 and v else."""

    w: Algebraic
    x: Algebraic

    def velocity(self, bits: int) -> Any:
        with precision(bits):
            return self.w.ball(bits).sqrt()


class _Search:
    """One line, its range, and what is found along it."""

    def __init__(
        self, along: Line, omega: Fraction, low: Fraction, high: Fraction, bits: int, names: Mapping[Any, str]
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
            yield self._found(_still(), None, Kind.EVERY, "")

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
            yield self._found(_still(), arb(0), Kind.LONG_WAVES)

    def _double(self) -> Iterator[CriticalVelocity]:
        discriminant = self.line.discriminant
        if not discriminant:
            raise ContradictionError(
                "the discriminant of a squarefree polynomial is 0: please report this as a fault"
            )
        for place, power in self._places(discriminant):
            yield from self._tried(place, power == 1 and not _vanishes(self.line.lead, place.x.m))
        if not self.low and not discriminant[0]:
            yield from self._tried(_still(), False)

    def _tried(self, place: _Place, single: bool) -> Iterator[CriticalVelocity]:
        try:
            p = self._single(place) if single else None
            if p is not None:
                bends = self.line.squared and p > 0
                yield from self._of_wave(place, p, self._curvature(place, p) if bends else Kind.TOUCHING)
                return
            for p, kind in self._over_field(place):
                yield from self._of_wave(place, p, kind)
        except PrecisionError:
            self.undecided.append(place.velocity(self.bits))

    def _single(self, place: _Place) -> Any:
        """The one double root (y for ω = 0), known to be real, in a ball; None where precision does not show it."""
        bits = self.bits + 64
        for _ in range(_TRIES):
            with precision(bits):
                f = embedded(self.line.rows, place.x.ball(bits))
                try:
                    roots = isolated(f.derivative())
                except ValueError:
                    roots = []
                near = [root for root in roots if f(root).contains(0)]
                if len(near) == 1 and near[0].imag.contains(0) and _fine(near[0].real, self.bits):
                    return arb(near[0].real)
            bits *= 2
        return None

    def _over_field(self, place: _Place) -> Iterator[tuple[Any, Kind]]:
        """Every double real root, by exact common divisors."""
        m = fmpq_poly(place.x.m)
        _, rest = split(
            multiple_roots(self.line.rows, m), [fmpq_poly([]), fmpq_poly([1])], m
        )  # p = 0 is found elsewhere
        meeting, rest = split(rest, self.line.slope, m)
        for y in places(meeting, place.x, self.bits + 64):
            yield y, Kind.MEETING
        if not self.line.squared:
            for p in places(rest, place.x, self.bits + 64):
                yield p, Kind.TOUCHING
            return
        flat, rest = split(rest, slope(slope(self.line.rows)), m)
        for y in places(flat, place.x, self.bits + 64):
            yield y, Kind.STATIONARY
        for y in places(rest, place.x, self.bits + 64):
            yield y, self._curvature(place, y)

    def _curvature(self, place: _Place, y: Any) -> Kind:
        """w = (phase velocity)² over y along the branch has w″ = −f_yy/f_w where f_y = 0."""
        rows, across = self.line.rows, [row.derivative() for row in self.line.rows]
        with precision(self.bits + 64):
            x = place.x.ball(self.bits + 64)
            bend = embedded(slope(slope(rows)), x)(y).real * embedded(across, x)(y).real
        if bend < 0:
            return Kind.MINIMUM
        if bend > 0:
            return Kind.MAXIMUM
        raise PrecisionError("the curvature of a branch has no proved sign")

    def _of_wave(self, place: _Place, root: Any, kind: Kind) -> Iterator[CriticalVelocity]:
        """The critical velocity of a real root; none for y < 0, and y = 0 is found elsewhere."""
        if not self.line.squared:
            yield self._found(place, root, kind)
        elif root > 0:
            with precision(self.bits):
                yield self._found(place, root.sqrt(), kind)
        elif not root < 0 and not _vanishes(self.line.rows[0], place.x.m):
            raise PrecisionError("the square of a wavenumber has no proved sign")

    def _found(self, place: _Place, p: Any, kind: Kind, name: str = "") -> CriticalVelocity:
        v = place.velocity(self.bits)
        with precision(self.bits):
            frequency = None if p is None else rational_ball(self.omega) - v * p
        return CriticalVelocity(v, p, frequency, kind, name, _exact(place.w.m))

    def _name(self, place: _Place) -> str:
        m = place.w.m
        return self.names.get(-fmpq_poly(m)[0] / fmpq_poly(m)[1], "") if m.degree() == 1 else ""

    def _places(self, f: fmpq_poly) -> Iterator[tuple[_Place, int]]:
        """The roots v > 0 of f in the range, with their multiplicities; f is even or odd in v."""
        if not f or f.degree() == 0:
            return
        _, factors = (f if self.line.squared else _in_squares(f)).numer().factor()
        for m, power in factors:
            for k, ball in self._real(m):
                if ball > 0 and self._inside(Algebraic(m, k)):
                    w = Algebraic(m, k)
                    yield _Place(w, w if self.line.squared else _square_root(w)), power

    def _real(self, m: fmpz_poly) -> list[tuple[int, Any]]:
        """The roots with their numbers, all but 0 told apart from 0."""
        bits = self.bits
        while bits <= _MOST_BITS * 4:
            with precision(bits):
                found = real_roots(m, bits)
                if all(ball > 0 or ball < 0 or not m[0] for ball in found):
                    return list(enumerate(found))
            bits *= 2
        raise ContradictionError("a root that is not 0 is not told apart from 0: please report this as a fault")

    def _inside(self, w: Algebraic) -> bool:
        """Whether low² ≤ w ≤ high², exactly: an irrational number meets neither."""
        if w.m.degree() == 1:
            exact = -Fraction(int(w.m[0]), int(w.m[1]))
            return self.low**2 <= exact <= self.high**2
        bits = self.bits
        while bits <= _MOST_BITS * 4:
            with precision(bits):
                ball = w.ball(bits)
                low, high = rational_ball(self.low**2), rational_ball(self.high**2)
                if low < ball < high:
                    return True
                if ball < low or high < ball:
                    return False
            bits *= 2
        raise ContradictionError(
            "an irrational velocity is not told apart from an end: please report this as a fault"
        )


def _still() -> _Place:
    """v = 0."""
    zero = Algebraic(fmpz_poly([0, 1]), 0)
    return _Place(zero, zero)


def _vanishes(f: fmpq_poly, m: fmpz_poly) -> bool:
    """Whether f is 0 at the roots of the irreducible m."""
    return not f % fmpq_poly(m)


def _in_squares(f: fmpq_poly) -> fmpq_poly:
    """g with f(v) = v^k g(v²)."""
    coefficients = f.coeffs()
    first = next(k for k, c in enumerate(coefficients) if c)
    if any(coefficients[first + 1 :: 2]):
        raise ContradictionError("the two directions of the force differ: please report this as a fault")
    return fmpq_poly(coefficients[first::2])


def _square_root(w: Algebraic) -> Algebraic:
    """√w among the roots of the factors of m(x²)."""
    spread = [0] * (2 * w.m.degree() + 1)
    spread[::2] = [int(c) for c in w.m.coeffs()]
    _, factors = fmpz_poly(spread).factor()
    bits = 64
    while bits <= _MOST_BITS:
        with precision(bits):
            root = w.ball(bits).sqrt()
            near = [
                Algebraic(m, k)
                for m, _ in factors
                for k, ball in enumerate(real_roots(m, bits))
                if ball.overlaps(root)
            ]
        if len(near) == 1:
            return near[0]
        bits *= 2
    raise PrecisionError("the square root of an algebraic number is not told apart from others")


def _fine(ball: Any, bits: int) -> bool:
    """Whether the ball has the digits asked for."""
    return bool(ball.is_exact() or ball.rel_accuracy_bits() >= bits - 32)


def _exact(m: fmpz_poly) -> Exact | None:
    """√w where w or w² is rational, w > 0."""
    if m.degree() == 1:
        return Exact.sqrt(-Fraction(int(m[0]), int(m[1])))
    if m.degree() == 2 and not m[1]:
        return Exact.root4(-Fraction(int(m[0]), int(m[2])))
    return None
