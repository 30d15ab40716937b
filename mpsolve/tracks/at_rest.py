"""Whether a track at rest is stable for every real wavenumber, and how far its cuts stay from the real axis.

D(ip, s) is a real polynomial in s with coefficients in y = p². Its roots have Re s < 0 exactly where the leading
coefficient and all Hurwitz determinants are positive; as functions of y these are polynomials, whose signs on y ≥ 0
are decided. Rows are the coefficients of s⁰, s¹, … over y. Im Ω = −Re s, so that the lowest cut is at the height
h_c = inf −Re s.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from fractions import Fraction
from functools import lru_cache
from math import comb
from typing import Any

from flint import arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import complex_roots
from mpsolve.numbers.bivariate import Rows, from_rows, to_rows
from mpsolve.numbers.realroots import as_fmpq, end_of, is_positive, negative_point, positive_roots, samples, sign_at
from mpsolve.tracks.hurwitz import hurwitz_minors, is_stable
from mpsolve.tracks.waveguide import Polynomial, Track, Waveguide

_ROUNDS = 7  # of four, so that the wavenumber of the lowest cut is guessed to 10⁻⁴


class Status(Enum):
    """How the vibrations of a track at rest decay."""

    STRICT = "every vibration decays, at a rate above one that is positive"
    TOUCHING = "every vibration decays, some at rates that come down to 0"
    UNDAMPED = "none grows, and at every wavenumber one does not decay"
    UNSTABLE = "some vibration grows without any vehicle"


@frozen
class AtRest:
    """The decision about a track at rest.

    wavenumbers: p ≥ 0 where the decay rate comes down to 0 (TOUCHING), or one where a vibration grows (UNSTABLE).
    at_infinity: the rate comes down to 0 as p → ∞. buckles: D(ip, 0) ≤ 0 at the wavenumber of UNSTABLE.
    """

    status: Status
    wavenumbers: tuple[float, ...] = ()
    at_infinity: bool = False
    buckles: bool = False

    @property
    def sentence(self) -> str:
        """The status in words, with the wavenumbers."""
        where = [f"p = {p:.6g}" for p in self.wavenumbers] + ["p → ∞"] * self.at_infinity
        if self.status is Status.UNSTABLE:
            return f"the track {'buckles' if self.buckles else 'grows'} by itself at {', '.join(where)}"
        return str(self.status.value) + (f": {', '.join(where)}" if where else "")


def require_stable(track: Track | Waveguide) -> None:
    """InputError for a track that is unstable without any force."""
    found = at_rest(track)
    if found.status is Status.UNSTABLE:
        raise InputError("track", f"is unstable without any force: {found.sentence}; lower the axial force N")


@lru_cache(maxsize=256)
def at_rest(track: Track | Waveguide) -> AtRest:
    """The status of the track, decided exactly; InputError where D is odd in P, 0, or loses its inertia at some p."""
    D = rows_of(track.waveguide)
    damped, undamped = _split(D)
    grows = _growing(damped) or (_real_growth(undamped) if len(undamped) > 1 else None)
    if grows is not None:
        return AtRest(Status.UNSTABLE, (wavenumber(grows),), buckles=sign_at(D[0], grows) < 0)
    verge = [root for root, _ in positive_roots(D[0])]
    if verge:
        return AtRest(Status.UNSTABLE, (wavenumber(verge[0]),), buckles=True)
    if len(undamped) > 1:
        return AtRest(Status.UNDAMPED)
    minors = hurwitz_minors(damped)
    edge = minors[-1] if len(minors) < 2 else minors[-2] * damped[0]
    touches = [0.0] * (edge[0] == 0) + [wavenumber(root) for root, _ in positive_roots(edge)]
    far = not _bounded_away(damped)
    return AtRest(Status.TOUCHING if touches or far else Status.STRICT, tuple(touches), far)


@lru_cache(maxsize=256)
def lowest_cut(track: Track | Waveguide, bits: int = 20) -> tuple[Fraction, Fraction]:
    """Bounds lower ≤ h_c ≤ upper of the height of the lowest cut, within 2^−bits; (0, 0) where it touches.

    Both are proved exactly. InputError for a track that is unstable at rest.
    """
    found = at_rest(track)
    if found.status is Status.UNSTABLE:
        raise InputError("track", f"{found.sentence}, so no height of its cuts is asked for: change its parameters")
    if found.status is not Status.STRICT:
        return Fraction(0), Fraction(0)
    D = rows_of(track.waveguide)
    guess, fine = _guessed_height(D), Fraction(1, 2 ** (bits + 1))
    low, high = guess * (1 - fine), guess * (1 + fine)
    while not is_stable(shifted(D, as_fmpq(low))):
        low, high = low / 2, low
    while is_stable(shifted(D, as_fmpq(high))):
        low, high = high, 2 * high
    while high - low > 2 * fine * high:
        middle = (low + high) / 2
        low, high = (middle, high) if is_stable(shifted(D, as_fmpq(middle))) else (low, middle)
    return low, high


def rows_of(waveguide: Waveguide) -> Rows:
    """As `_rows_of`, which keeps the answers of the last tracks."""
    return list(_rows_of(waveguide))


@lru_cache(maxsize=64)
def _rows_of(waveguide: Waveguide) -> Rows:
    """D(ip, s) over y, with a leading coefficient that is positive for all y ≥ 0; InputError where there is none."""
    rows = in_squares(waveguide.dispersion, "D")
    if not rows:
        raise InputError("matrix", "has determinant 0 everywhere, so it carries no wave: check its entries")
    if not rows[0]:
        stated = "has determinant 0 without frequency, so a constant force moves the track without end"
        raise InputError("matrix", f"{stated}: give it a stiffness, or divide a row by Omega")
    if len(rows) == 1:
        raise InputError(
            "matrix", "has no frequency in its determinant, so it carries no wave: give it mass or damping"
        )
    lead = rows[-1] if rows[-1](1) >= 0 else -rows[-1]
    if not is_positive(lead):
        where = next((wavenumber(root) for root, _ in positive_roots(lead)), 0.0)
        stated = f"loses the highest power of the frequency at the wavenumber p = {where:.6g}"
        raise InputError("matrix", f"{stated}: give every field of the track some mass or damping there")
    return [row if lead is rows[-1] else -row for row in rows]


def in_squares(polynomial: Polynomial, name: str) -> Rows:
    """A polynomial in P and s as one in s over y = −P²; InputError where it has odd powers of P."""
    if any(i % 2 for i, _ in polynomial):
        raise InputError("matrix", f"gives {name} with odd powers of p, so the track differs from its mirror image: "
                         "give one that is the same in both directions")  # fmt: skip
    size = max((j for _, j in polynomial), default=-1) + 1
    table: list[dict[int, Fraction]] = [{} for _ in range(size)]
    for (i, j), value in polynomial.items():
        table[j][i // 2] = value * (-1) ** (i // 2)
    return [fmpq_poly([as_fmpq(row.get(k, Fraction(0))) for k in range(max(row, default=-1) + 1)]) for row in table]


def shifted(D: Sequence[Any], h: Any) -> list[Any]:
    """D(ip, s − h), h a number of FLINT, or a polynomial as those of D."""
    return [sum((comb(j, k) * (-h) ** (j - k) * D[j] for j in range(k + 1, len(D))), D[k]) for k in range(len(D))]


def wavenumber(y: Fraction | arb) -> float:
    """p = √y, to be shown."""
    return float((arb(as_fmpq(y)) if isinstance(y, Fraction) else y).sqrt())


def _growing(D: Rows) -> Fraction | None:
    """A rational y with a root Re s > 0, or None; D has no pair ±s for all y. One Hurwitz determinant is negative.

    Where one is 0 for all y, all y but isolated ones have such a root.
    """
    minors = hurwitz_minors(D)
    if minors and not minors[-1]:
        return max((Fraction(2) ** k for k in range(-20, 21)), key=lambda y: _rate(D, y))
    order = [D[0], *minors] if len(D) > 1 else []
    return next((y for y in map(negative_point, order) if y is not None), None)


def _split(D: Rows) -> tuple[Rows, Rows]:
    """D = damped(s) · undamped(s²), the latter as a polynomial in z = s² that holds every pair ±s."""
    context = fmpq_mpoly_ctx.get(("z", "y"), "lex")
    even, odd = (from_rows(D[k::2], context) for k in (0, 1))
    common = even.gcd(odd)
    if not common.degrees()[0]:
        return D, [fmpq_poly([1])]
    sign = 1 if to_rows(common)[-1](1) > 0 else -1
    halves = [to_rows(sign * (part // common)) for part in (even, odd)]
    size = max(2 * len(halves[0]) - 1, 2 * len(halves[1]))
    rest = [halves[k % 2][k // 2] if k // 2 < len(halves[k % 2]) else fmpq_poly([]) for k in range(size)]
    return rest, to_rows(sign * common)


def _real_growth(g: Rows) -> Fraction | None:
    """A rational y where g(z) has a root z = s² that is not real and ≤ 0, or None; one y for each cell decides."""
    context = fmpq_mpoly_ctx.get(("z", "y"), "lex")
    _, factors = from_rows(g, context).factor_squarefree()
    for factor, _ in factors:
        rows = to_rows(factor)
        if len(rows) < 2:
            continue
        edges = to_rows(factor.discriminant("z"))[0] if len(rows) > 2 else fmpq_poly([1])
        for y in samples(edges * rows[-1] * (rows[0] or fmpq_poly([1]))):
            at = fmpq_poly([row(as_fmpq(y)) * (-1) ** j for j, row in enumerate(rows)])
            if len(positive_roots(at)) + (not rows[0]) < at.degree():
                return y
    return None


def _guessed_height(D: Rows) -> Fraction:
    """A guess of the height of the lowest cut: wavenumbers in octaves about one that balances D, then finer ones."""
    ends = [(row.degree(), _size(row[row.degree()]) - _size(row[0])) for row in D if row.degree() > 0 and row[0]]
    middle = -sum(size // k for k, size in ends) // len(ends) if ends else 0
    points = [Fraction(0), *(Fraction(2) ** (middle + k) for k in range(-28, 29))]
    best, rate = max(((y, _rate(D, y)) for y in points), key=lambda pair: pair[1])
    width = best / 2
    for _ in range(_ROUNDS if best else 0):
        around = [(y, _rate(D, y)) for y in (best + width * k / 4 for k in range(-3, 4) if k)]
        best, rate = max([(best, rate), *around], key=lambda pair: pair[1])
        width /= 4
    return -rate if rate < 0 else Fraction(1)


def _rate(D: Rows, y: Fraction) -> Fraction:
    """The largest Re s at y, nearly."""
    line = fmpq_poly([row(as_fmpq(y)) for row in D])
    return max(end_of(arb(root.real), 0) for root, _ in complex_roots(line.numer()))


def _size(x: fmpq) -> int:
    """log₂ |x|, nearly."""
    return int(x.p).bit_length() - int(x.q).bit_length()


def _bounded_away(D: Rows) -> bool:
    """Whether the decay rate stays above some h > 0 as p → ∞: the signs of the determinants there for small h."""
    context = fmpq_mpoly_ctx.get(("h", "y"), "lex")
    h = context.gens()[0]
    rows = [from_rows([row], context) for row in D]
    return all(_far_sign(minor) > 0 for minor in hurwitz_minors(shifted(rows, h)))


def _far_sign(minor: fmpq_mpoly) -> int:
    """The sign for y → ∞ at a fixed h > 0 that is small."""
    terms = minor.to_dict()
    top = max(int(k) for _, k in terms)
    least = min(int(j) for j, k in terms if int(k) == top)
    return 1 if terms[least, top] > 0 else -1
