"""That the track is statically stable and damped for all parameters of a family: exact, by lower bounds.

D(ip, s) is a polynomial in s whose coefficients are polynomials in y = p² and in the parameters. All its roots have
Re s < 0 where the leading coefficient and all Hurwitz determinants are positive. Over a box of parameters the
coefficient of each power of y has its least Bernstein coefficient as a lower bound, which gives one polynomial in y
that lies below for y ≥ 0; that it is positive is decided exactly. A power of y may be a factor (a motion that does
not decay as p → 0).
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from math import comb

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from mpsolve.errors import InputError
from mpsolve.numbers.realroots import as_fmpq, is_positive
from mpsolve.problem.family import Family, Interval
from mpsolve.tracks.hurwitz import hurwitz_minors
from mpsolve.waves.speeds import wave_speeds

_HALVINGS = 8


def require_stable_track(family: Family) -> None:
    """InputError where some parameters may let the track buckle, or leave it without damping."""
    free = [k for k in range(len(family.paths)) if any(e[k] for c in family.D_rest.values() for e, _ in c)]
    if not free:
        return
    conditions = [_rows_in_y(minor, len(free)) for minor in _conditions(family, free)]
    waiting = [(tuple(family.box[k] for k in free), 0)]
    while waiting:
        box, depth = waiting.pop()
        if all(_positive(rows, box) for rows in conditions):
            continue
        if depth == _HALVINGS * len(free):
            names = ", ".join(family.paths[k] for k in free)
            raise InputError(
                "over", f"holds values of {names} for which the track is not proved stable and damped by itself: "
                "give narrower ranges, or more damping")  # fmt: skip
        waiting += [(half, depth + 1) for half in _halves(box, depth % len(free))]


def require_no_wave_speed(family: Family) -> None:
    """InputError where the highest coefficient of D in P may vanish: short waves then run with the contacts."""
    top = family.degree
    lead = [c for (i, _), c in family.D.items() if i == top]
    constant = all(j == 0 for i, j in family.D if i == top)
    row = {tuple(e): c for e, c in lead[0]} if len(lead) == 1 else {}
    if constant and row and all(min(e) >= 0 for e in row):
        least, most = _least(row, family.box), _least({e: -c for e, c in row.items()}, family.box)
        if least > 0 or most > 0 or (len(family.paths) == 1 and _keeps_sign(row, family.box[0])):
            return
    for path, (low, high), power in zip(family.paths, family.box, zip(*row, strict=True), strict=False):
        if low <= 0 <= high and min(power) > 0 and path not in ("v", "alpha"):
            raise InputError(path, "is 0 somewhere in its range, and there the track has fewer waves: begin above 0")
    speeds = ", ".join(f"{name}: {float(x) ** 0.5:.6g}" for name, x in wave_speeds(family.problem.track).items())
    known = f" ({speeds})" if speeds else ""
    raise InputError("over", f"may hold a speed at which short waves of the track run{known}: ask below and above it")


def _keeps_sign(row: dict[tuple[int, ...], Fraction], interval: Interval) -> bool:
    """Exactly, by the roots of a polynomial in one parameter: none in the closed interval."""
    low, high = interval
    # x = (low + high y)/(1 + y) runs through [low, high) for y ≥ 0; times (1 + y)^degree
    degree = max(e[0] for e in row)
    total = fmpq_poly([])
    for (e,), c in row.items():
        first, second = fmpq_poly([as_fmpq(low), as_fmpq(high)]), fmpq_poly([1, 1])
        total += as_fmpq(c) * first**e * second ** (degree - e)
    ends = sum((c * high ** e[0] for e, c in row.items()), Fraction(0))
    return ends != 0 and (is_positive(total) or is_positive(-total))


def _conditions(family: Family, free: list[int]) -> list[fmpq_mpoly]:
    """Polynomials in y and the free parameters that must be positive, FLINT's, with positive powers only."""
    context = fmpq_mpoly_ctx.get(("y", *(f"x{k}" for k in free)), "lex")
    lowest = [min((e[k] for c in family.D_rest.values() for e, _ in c), default=0) for k in free]
    size = max(j for _, j in family.D_rest) + 1
    rows: list[dict[tuple[int, ...], fmpq]] = [{} for _ in range(size)]
    for (i, j), c in family.D_rest.items():
        for e, value in c:
            key = (i // 2, *(e[k] - min(low, 0) for k, low in zip(free, lowest, strict=True)))
            rows[j][key] = as_fmpq(value * (-1) ** (i // 2))
    D = [context.from_dict(row) for row in rows]
    lead = D[-1](*(as_fmpq(x) for x in (Fraction(1), *(family.ring.point[k] for k in free))))
    D = [a if lead > 0 else -a for a in D]
    return [D[-1], D[0], *hurwitz_minors(D)[:-1]]  # the last is the one before it times D[0]


def _rows_in_y(polynomial: fmpq_mpoly, free: int) -> list[dict[tuple[int, ...], Fraction]]:
    """For each power of y the polynomial in the parameters; the lowest power of y divided out."""
    out: dict[int, dict[tuple[int, ...], Fraction]] = {}
    for key, c in polynomial.to_dict().items():
        power, *rest = map(int, key)
        out.setdefault(power, {})[tuple(rest)] = Fraction(int(c.p), int(c.q))
    if not out:
        return [{(0,) * free: Fraction(0)}]
    return [out.get(k, {}) for k in range(min(out), max(out) + 1)]


def _positive(rows: list[dict[tuple[int, ...], Fraction]], box: tuple[Interval, ...]) -> bool:
    return is_positive(fmpq_poly([as_fmpq(_least(row, box)) for row in rows]))


def _least(row: dict[tuple[int, ...], Fraction], box: tuple[Interval, ...]) -> Fraction:
    """The least Bernstein coefficient over the box."""
    if not row:
        return Fraction(0)
    degrees = [max(e[k] for e in row) for k in range(len(box))]
    table = dict(row)
    for k, (low, high) in enumerate(box):
        moved: dict[tuple[int, ...], Fraction] = {}
        for e, c in table.items():
            for n in range(e[k] + 1):  # (low + (high − low) t)^e
                key = (*e[:k], n, *e[k + 1 :])
                moved[key] = moved.get(key, Fraction(0)) + c * comb(e[k], n) * low ** (e[k] - n) * (high - low) ** n
        table = moved
    for k, d in enumerate(degrees):
        moved = {}
        for e, c in table.items():
            for n in range(e[k], d + 1):
                key = (*e[:k], n, *e[k + 1 :])
                moved[key] = moved.get(key, Fraction(0)) + c * Fraction(comb(n, e[k]), comb(d, e[k]))
        table = moved
    return min(table.get(key, Fraction(0)) for key in product(*(range(d + 1) for d in degrees)))


def _halves(box: tuple[Interval, ...], k: int) -> list[tuple[Interval, ...]]:
    low, high = box[k]
    middle = (low + high) / 2
    return [(*box[:k], (low, middle), *box[k + 1 :]), (*box[:k], (middle, high), *box[k + 1 :])]
