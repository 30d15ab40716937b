"""What û is at most far out, between line and path: the tail of the integral, and why the path may leave the line.

The equations are divided by powers of σ so that they have a limit; one ball holds all of them for |σ| ≥ R. If it is
invertible, û falls as a power of σ there, and has no pole.

A wave P = z₀σ + … takes the time d = |z₀ξ| over the distance ξ, and one that stays on the track, P = (σ − s)/v, the
time |ξ|/v: |e^{Pξ}| is a constant times e^{−d Re σ}, at most e^{−dα + dδ(r − r₀)} between line and path. At a place
that such waves reach the path serves the times t > d, as e^{(t − d)σ} falls on it. Between contacts they are refused:
what is reflected to and fro has poles that come back to the axis, or cross every such path.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, arb_mat, precision, rational_ball
from mpsolve.vibration.balls.image import BallImage
from mpsolve.vibration.balls.polygon import FarRoot, far_roots, power_of, turn
from mpsolve.vibration.balls.solved import Disc, Waves, solved
from mpsolve.vibration.path import Path

_FIRST, _TIMES, _TRIES = 32.0, 2.0, 22
_ECHOES = "echoes between contacts arrive too late for the path of balls: give one contact, or use float64"


class Bound(NamedTuple):
    """|û| ≤ size · e^{delay δ(r − r₀)} at the height r² or below, between line and path."""

    size: Any
    delay: Any


def far_field(image: BallImage, path: Path, last: float) -> tuple[float, list[Bound]]:
    """R > `last`, and for |Im σ| ≥ R between line and path bounds of |û| by channels."""
    radius = max(_FIRST, last)
    for _ in range(_TRIES):
        try:
            return radius, _Far(image, path, radius).bounds()
        except PrecisionError as error:
            found = error
        radius *= _TIMES
    raise found


class _Far:
    """The equations for all |σ| ≥ R, divided by powers of σ."""

    def __init__(self, image: BallImage, path: Path, radius: float) -> None:
        self.image, self.path, self.radius = image, path, arb(radius)
        guide = image.image.guide
        with precision(image.bits):
            roots = far_roots(guide.D, guide.N, guide.v, self.radius)
            self.upper, self.lower = self._sides(roots)
            self.gamma = min(root.gamma for root in self.upper)
        self.powers = self._powers()

    def _sides(self, roots: Sequence[FarRoot]) -> tuple[list[FarRoot], list[FarRoot]]:
        """Which are upper ones, told at one point of the line."""
        sigma = self.path.line(acb(self.radius))
        balls = [root.at(sigma) for root in roots]
        sides: list[list[FarRoot]] = []
        for side in self.image.physical(sigma):
            near = [[k for k, ball in enumerate(balls) if ball.overlaps(z)] for z in side]
            if any(len(one) != 1 for one in near):
                raise PrecisionError("p-roots far out cannot be told apart: go further")
            sides.append([roots[one[0]] for one in near])
        return sides[0], sides[1]

    def _powers(self) -> list[Fraction]:
        """e_i of coordinates and contact forces: rows and columns are multiplied by σ^(−e)."""
        pencil = self.image.image.pencil
        out = []
        for k in range(pencil.size):
            out.append(Fraction(1) if pencil.M[k][k] else Fraction(1, 2) if pencil.C[k][k] else Fraction(0))
        return out + [Fraction(0) if h else -self.gamma / 2 for h in pencil.h]

    def disc(self, value: acb, power: Fraction) -> Disc:
        """value σ^power for all |σ| ≥ R, power ≤ 0."""
        if power > 0:
            raise PrecisionError(
                "the equations of this vehicle far out are beyond what is proved of the motion in balls"
            )
        if not power or value == 0:
            return value, arb(0)
        return acb(0), abs(value) * power_of(self.radius, power)

    def received(self, xi: Fraction, power: Fraction = Fraction(0), without: Sequence[FarRoot] = ()) -> Disc:
        """σ^γ G(ξ) between contacts, times σ^power; without some of the waves."""
        disc, delay = self.late(xi, power, without)
        if delay > 0:
            raise PrecisionError(_ECHOES)
        return disc

    def late(self, xi: Fraction, power: Fraction = Fraction(0), without: Sequence[FarRoot] = ()) -> tuple[Disc, arb]:
        """The same at any place, and the delay of its waves: up to e^{delay δ(r − r₀)}."""
        late = arb(0)
        roots, sign = (self.upper, 1) if xi >= 0 else (self.lower, -1)
        middle, radius = acb(0), arb(0)
        if not xi:
            roots, middle, radius = self._alike(power)
        for root in roots:
            if root in without:
                continue
            m, r = self.disc(self.image.scale * sign * root.weight, self.gamma - root.gamma + power)
            if xi:
                grown, delay = self._grown(root, xi)
                m, r, late = acb(0), (abs(m) + r) * grown, late.max(delay)
            middle, radius = middle + m, radius + r
        return (middle, radius), late

    def _alike(self, power: Fraction) -> tuple[list[FarRoot], acb, arb]:
        """The upper waves without those that have the lowest γ and one ζ, and these at the contact: w₁ may cancel."""
        some = [z for z in self.upper if z.gamma == self.gamma and z.parts is not None]
        some = [z for z in some if z.power.denominator == some[0].power.denominator and not power]
        parts = [z.parts for z in some if z.parts is not None]
        if not parts:
            return self.upper, acb(0), arb(0)
        zeta, size = power_of(self.radius, Fraction(-1, some[0].power.denominator)), abs(self.image.scale)
        first, second = (sum((own[k] for own in parts), acb(0)) for k in (0, 1))
        radius = size * (abs(second) * zeta + sum((own[2] for own in parts), arb(0)))
        return [z for z in self.upper if not any(z is one for one in some)], self.image.scale * first, radius

    def _grown(self, root: FarRoot, xi: Fraction) -> Bound:
        """A bound of |e^{Pξ}|."""
        x, R, w = self.image.away[xi], self.radius, root.power
        b = w.denominator
        aside = (abs(arb(self.path.alpha)) + self.path.delta * R.sqrt()) / R  # |Re σ|/|σ| at most
        zeta = power_of(R, Fraction(-1, b))
        if root.neutral:
            if w == 1 and (root.still is not None or b == 1):
                return self._delayed(root, x)
            if w > Fraction(1, 2) or w > Fraction(1, b):
                stated = "a wave over a distance is beyond what is proved of the motion in balls"
                raise PrecisionError(f"{stated}: give no place but the contacts")
            grows = abs(root.z0) * rational_ball(w) * (1 + aside) * aside * power_of(R, w)
            second = (
                x * root.z1.real if w == Fraction(1, b) else abs(x) * abs(root.z1) * power_of(R, w - Fraction(1, b))
            )
            return Bound((abs(x) * (grows + root.left * power_of(R, w - Fraction(2, b))) + second).exp(), arb(0))
        own = root.z0 * turn(w)
        falls = x * own.real + abs(x) * (
            abs(own) * rational_ball(w) * aside + abs(root.z1) * zeta + root.left * zeta**2
        )
        if not falls < 0:
            raise PrecisionError("p-roots far out may be real: go further")
        return Bound((falls * power_of(R, w)).exp(), arb(0))

    def _at_once(self, root: FarRoot, xi: Fraction) -> Any:
        size, delay = self._grown(root, xi)
        if delay > 0:
            raise PrecisionError(_ECHOES)
        return size

    def _delayed(self, root: FarRoot, x: Any) -> Bound:
        """Of P = z₀σ + z₁ + rest, |rest| ≤ left/|σ|, or of P = (σ − s)z₀; z₀ is real, as the wave is neutral."""
        z0 = root.z0.real
        if not x * z0 < 0:
            raise PrecisionError("p-roots far out cannot be told apart: go further")
        other = -root.still * root.z0 if root.still is not None else root.z1
        left = arb(0) if root.still is not None else root.left / self.radius
        return Bound((x * other.real + abs(x) * left + x * z0 * self.path.alpha).exp(), arb(abs(x * z0).upper()))

    def waves(self) -> Waves | None:
        """The waves that run between tight contacts and do not decay, where there are such in either direction."""
        image, n = self.image, self.image.image.size
        at = image.at
        chain = [j for j, h in enumerate(image.image.pencil.h) if not h]
        one, other = ([z for z in side if z.neutral and z.gamma == self.gamma] for side in (self.upper, self.lower))
        if len(chain) < 2 or len(one) != 1 or len(other) != 1:
            return None
        ahead, behind = image.scale * one[0].weight, -image.scale * other[0].weight
        size = n + image.image.contacts
        sizes = arb_mat(size, size)
        for i in chain:
            for j in chain:
                if i != j:
                    root, wave = (one[0], ahead) if at[i] > at[j] else (other[0], behind)
                    sizes[n + i, n + j] = abs(wave) * self._at_once(root, at[i] - at[j])
        to_and_fro = [
            self._at_once(one[0], at[j] - at[i]) * self._at_once(other[0], at[i] - at[j]) for i, j in pairwise(chain)
        ]
        return Waves(tuple(n + j for j in chain), ahead, behind, tuple(to_and_fro), sizes)

    def rows(self, waves: Waves | None) -> list[list[Disc]]:
        """The equations, without these waves."""
        image, e = self.image, self.powers
        n, m = image.image.size, image.image.contacts
        S, B, h, at = image.S, image.B, image.h, image.at
        rate, rows = image.rate_ball, []
        for i in range(n):
            own = [
                _sum([self.disc(acb(S[k][i][j] * rate**k), k - e[i] - e[j]) for k in range(3) if S[k][i][j] != 0])
                for j in range(n)
            ]
            rows.append([*own, *(self.disc(acb(B[i][j]), -e[i] - e[n + j]) for j in range(m))])
        for i in range(m):
            own = [self.disc(acb(B[j][i]), -e[j] - e[n + i]) for j in range(n)]
            for j in range(m):
                apart = waves and i != j and {n + i, n + j} <= set(waves.chain)
                travelling = [z for z in (*self.upper, *self.lower) if z.neutral and z.gamma == self.gamma]
                middle, radius = self.received(
                    at[i] - at[j], -self.gamma - e[n + i] - e[n + j], travelling if apart else ()
                )
                own.append((-middle - (acb(h[i]) if i == j else 0), radius))
            rows.append(own)
        return rows

    def bounds(self) -> list[Bound]:
        """Of |û| by channels."""
        image, e = self.image, self.powers
        n, R = image.image.size, self.radius
        if any(1 + power <= 0 for power in e):
            raise PrecisionError("the forces far out are beyond what is proved of the motion in balls")
        with precision(image.bits):
            force = [sum(map(abs, self.disc(x, -e[k]))) for k, x in enumerate(image.far_forces(R))]
            waves = self.waves()
            x = solved(self.rows(waves), [*force, *[arb(0)] * image.image.contacts], waves)
            out = [one * power_of(R, -1 - power) for one, power in zip(x, e, strict=True)]
            delays = [arb(0)] * len(out)
            for at in image.seen:
                rail, late = arb(0), arb(0)
                for j, y in enumerate(image.at):
                    disc, delay = self.late(at - y)
                    rail = rail + sum(map(abs, disc)) * x[n + j] * power_of(R, -1 - e[n + j] - self.gamma)
                    late = late.max(delay)
                out.append(image.touching(at, out, rail))
                delays.append(late)
            if not all(bound.is_finite() for bound in out):
                raise PrecisionError("the motion far out has no bound: go further")
            return [Bound(arb(bound.upper()), delay) for bound, delay in zip(out, delays, strict=True)]


def _sum(discs: list[Disc]) -> Disc:
    return sum((m for m, _ in discs), acb(0)), sum((r for _, r in discs), arb(0))
