"""Checks certificates of version 2 against certs/SPEC2.md; shares no code with their maker.

Needs Python ≥ 3.11 and python-flint only, and runs as a plain script:  python verify2.py FILE [FILE …]
Exit status 0: every file is valid; 1: one is not, and its line says why.

A certificate carries the equations (the track's matrix A(P, s), velocity, M, C, K, B, places, compliances), the
claim, and every choice of its maker: break points of the contours, numbers of the theorem at large q, root balls.
The verifier forms D = det A, the cofactor N and S(σ) = K + Cσ + Mσ² itself. Throughout P = ip, σ = iq,
s = σ − vP; everything varies as e^{Px + σt} in the moving frame, x ahead; Re σ > 0 grows (Im q < 0).
"""

from __future__ import annotations

import hashlib
import json
import re
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache, partial
from itertools import combinations, pairwise, product
from math import comb, prod
from operator import lt
from typing import Any

import flint
from flint import acb, acb_mat, acb_poly, arb, arb_mat, fmpq, fmpq_mat, fmpq_mpoly_ctx, fmpq_poly

MAX_BYTES, MAX_PIECES, MAX_WORK, MAX_ROOTS, MAX_BOXES = 16_000_000, 20_000, 1e9, 1_000, 20_000
PARTS, MAX_REST = 16, 400
MAX_ROWS, MAX_BODIES, MAX_CONTACTS, MAX_DEGREE, MAX_BITS, MAX_MULTIPLICITY = 5, 192, 64, 24, 70_000, 8
MAX_TERMS, MAX_SIZE, BOXES = 120, 20_000, 20_000  # with free parameters: of a track, a polynomial; parts of a range
SMALL, CORNERS = 8, 3  # matrices up to this size are eliminated entry by entry; exact in so many variables
RING = fmpq_mpoly_ctx.get(("P", "s"), "lex")
P_, S_ = RING.gens()

Exponents = tuple[int, ...]
Free = dict[Exponents, Any]  # {exponents of free parameters: c}; of a number {(): c}
Box = tuple[tuple[Any, Any], ...]  # exact ends of free parameters; () where there are none
Point = tuple[Any, Any]  # of q: real and imaginary part, exact


class Refused(Exception):  # noqa: N818
    """The certificate does not prove its claim; the message says where it fails."""


@dataclass(frozen=True)
class Verdict:
    """valid: every step was checked. reason: why not. claim: what is proved, of which equations, if valid."""

    valid: bool
    reason: str = ""
    claim: str = ""

    def __bool__(self) -> bool:
        raise TypeError("a verdict has no truth value: ask for .valid")


def verify(path: Any) -> Verdict:
    """The verdict on the certificate in the file `path`. Never raises for what the file holds."""
    return of_file(path, verify_bytes)


def verify_bytes(raw: bytes) -> Verdict:
    """The verdict on a certificate's bytes. Never raises for what they hold."""
    return judged(raw, lambda: spectrum(opened(raw)))


def of_file(path: Any, judge: Callable[[bytes], Verdict], most: int = MAX_BYTES) -> Verdict:
    """The verdict on what a file of up to `most` bytes holds."""
    try:
        with open(path, "rb") as file:
            raw = file.read(most + 1)
        return judge(raw)
    except OSError as error:
        return Verdict(False, f"the file cannot be read: {error.strerror or error}")


def judged(raw: bytes, claim: Callable[[], str], most: int = MAX_BYTES) -> Verdict:
    """Valid with what `claim` says, unless it raises."""
    try:
        require(len(raw) <= most, f"the file is larger than {most} bytes")
        with precision(64):
            return Verdict(True, "", claim())
    except Refused as error:
        return Verdict(False, str(error))
    except (UnicodeDecodeError, json.JSONDecodeError) as error:
        return Verdict(
            False, f"no certificate, which is JSON in ASCII: give the file that certify wrote ({error})"[:200]
        )
    except (ValueError, TypeError, KeyError, IndexError, ArithmeticError, RecursionError, MemoryError) as error:
        return Verdict(False, f"malformed: {type(error).__name__}: {str(error)[:200]}")


def require(condition: Any, message: str) -> None:
    if not condition:
        raise Refused(message)


_lock = vars(flint).setdefault("_precision_lock", threading.RLock())  # flint's precision is one per process


@contextmanager
def precision(bits: int, terms: int = 0) -> Iterator[None]:
    """flint at `bits`, and with `terms` of series, inside the block; put back after it. Other threads wait."""
    with _lock:
        before, cap = flint.ctx.prec, flint.ctx.cap
        flint.ctx.prec, flint.ctx.cap = bits, max(cap, terms)
        try:
            yield
        finally:
            flint.ctx.prec, flint.ctx.cap = before, cap


# --- reading: numbers, objects ----------------------------------------------------------------------------


KEYS = {"spectrum": "equations basis bits start paths theorem claim roots"}


def opened(
    raw: bytes, kinds: dict[str, str] = KEYS, form: str = "mpsolve certificate", number: int = 2
) -> dict[str, Any]:
    """The file's object without its digest, which fits, with format, version, kind and keys checked."""

    def no_number(text: str) -> Any:
        raise Refused(f"{text[:40]} is not an exact number: numbers are integers, or text")

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        require(len({k for k, _ in pairs}) == len(pairs), "a key stands twice in one object")
        return dict(pairs)

    read = json.loads(raw.decode("ascii"), parse_constant=no_number, parse_float=no_number, object_pairs_hook=unique)
    require(isinstance(read, dict), "the file holds no JSON object")
    require(read.get("format") == form, f"the format is not '{form}'")
    version = read.get("version")
    require(version == number and type(version) is int, f"version {str(version)[:20]} is not known to this verifier")
    require(read.get("kind") in tuple(kinds), "the kind is not known to this verifier")
    keys(read, f"format version kind sha256 {kinds[read['kind']]}")
    rest = {key: value for key, value in read.items() if key != "sha256"}
    canonical = json.dumps(rest, sort_keys=True, separators=(",", ":"), ensure_ascii=True)
    digest = hashlib.sha256(canonical.encode("ascii")).hexdigest()
    require(digest == read["sha256"], "the digest does not fit the content")
    return rest


def keys(value: Any, names: str, optional: str = "") -> None:
    require(isinstance(value, dict), "an object is missing")
    missing = sorted(set(names.split()) - value.keys())
    unknown = sorted(value.keys() - set(names.split()) - set(optional.split()))
    require(not missing and not unknown, f"keys missing: {missing[:5]}, unknown: {[u[:40] for u in unknown[:5]]}")


def items(value: Any, most: int, name: str, length: int | None = None) -> list[Any]:
    require(isinstance(value, list) and len(value) <= most, f"{name}: no list, or more than {most} entries")
    require(length is None or len(value) == length, f"{name}: {len(value)} entries in place of {length}")
    return list(value)


def integer(value: Any, low: int, high: int, name: str) -> int:
    require(type(value) is int and low <= value <= high, f"{name} is not an integer from {low} to {high}")
    return int(value)


def rational(text: Any, name: str, digits: int = 120) -> Any:
    """Reads "p" or "p/q"."""
    form = rf"(-?[0-9]{{1,{digits}}})(?:/([0-9]{{1,{digits}}}))?"
    match = re.fullmatch(form, text, re.ASCII) if isinstance(text, str) else None
    if match is None or int(match[2] or 1) == 0:
        raise Refused(f"{name} is not a rational number in text")
    return fmpq(int(match[1]), int(match[2] or 1))


def power_of_2(e: int) -> Any:
    return fmpq(1 << max(e, 0), 1 << max(-e, 0))


def dyadic(value: Any, name: str) -> Any:
    m, e = items(value, 2, name, 2)
    return integer(m, -(2**200), 2**200, name) * power_of_2(integer(e, -1100, 1100, name))


def point(value: Any) -> Point:
    """[m, n, e] is (m + in)·2^e; ["p/q", "r/s"] is exact as well."""
    value = items(value, 3, "a point")
    if len(value) == 2:
        return rational(value[0], "a point"), rational(value[1], "a point")
    require(len(value) == 3, "a point has not two or three entries")
    m, n = (integer(x, -(2**200), 2**200, "a point") for x in value[:2])
    unit = power_of_2(integer(value[2], -1100, 1100, "a point"))
    return m * unit, n * unit


def read_ball(
    value: Any, names: str, name: str, most: int = MAX_BITS, high: int = 1100
) -> tuple[list[Any], Any, int]:
    """(numbers of these names, radius, bits): hexadecimal mantissas times 2^exponent; bits that tell them apart."""
    parts = []
    for key in names.split():
        known = isinstance(value[key], str) and re.fullmatch(r"-?0x[0-9a-f]{1,20000}", value[key], re.ASCII)
        require(known, f"{name}: a mantissa is not hexadecimal")
        parts.append(int(value[key], 16))
    e = integer(value["exponent"], -most, high, name)
    m, f = items(value["radius"], 2, name, 2)
    radius = integer(m, 1, 2**64, name) * power_of_2(integer(f, -most, high, name))
    bits = max(0, max(abs(p).bit_length() for p in parts) + e - f)
    require(bits <= most, f"{name} has too many digits")
    return [p * power_of_2(e) for p in parts], radius, bits


def matrix(rows: Any, height: int, width: int, name: str) -> Any:
    rows = items(rows, height, name, height)
    entries = fmpq_mat(height, width, [rational(x, name) for row in rows for x in items(row, width, name, width)])
    require_short(entries, name)
    return entries


def require_short(entries: Any, name: str) -> None:
    numerators, denominator = entries.numer_denom()
    bits = max([int(denominator).bit_length(), *(int(x).bit_length() for x in numerators.entries())])
    require(bits * max(entries.nrows(), entries.ncols()) <= 8_000, f"{name} has too many digits")


def at_q(z: Point) -> Any:
    """σ = iq in balls."""
    return acb(-arb(z[1]), arb(z[0]))


# --- exact algebra ----------------------------------------------------------------------------------------


def nonnegative(p: Any, strictly: bool) -> bool:
    """p(y) ≥ 0 for all y ≥ 0 and p ≠ 0: no root y > 0 of odd multiplicity; strictly: p(y) > 0, no root at all."""
    c = p.coeffs()
    if not c or c[-1] <= 0 or (strictly and c[0] <= 0):
        return False
    return all(x >= 0 for x in c) or not any(
        z.imag.contains(0) and not z.real <= 0 and (strictly or k % 2) for z, k in p.complex_roots()
    )  # balls of roots: those of real ones hold a real number, those of others none


def semidefinite(a: Any) -> bool:
    """Symmetric, with eigenvalues ≥ 0 only: the signs of the characteristic polynomial alternate."""
    n = a.nrows()
    return a == a.transpose() and all(c * (-1) ** (n - k) >= 0 for k, c in enumerate(a.charpoly().coeffs()))


def free(value: Any, count: int, name: str, least: int = 0) -> Free:
    """A polynomial in the parameters: "c", or [[e1, …, em, "c"], …]."""
    if isinstance(value, str) or not count:
        c = rational(value, name)
        return {(0,) * count: c} if c != 0 else {}
    out: Free = {}
    for term in items(value, 40, name):
        *powers, c = items(term, count + 1, name, count + 1)
        key = tuple(integer(e, least, 4, name) for e in powers)
        require(key not in out, f"{name}: a power stands twice")
        out[key] = rational(c, name)
        require(out[key] != 0, f"{name}: a coefficient is 0")
    return out


def at(f: Free, x: Sequence[Any]) -> Any:
    """The value at exact parameters."""
    total = fmpq(0)
    for powers, c in f.items():
        for y, e in zip(x, powers, strict=True):
            c = c * y**e if e > 0 else c / y ** (-e) if e < 0 else c
        total += c
    return total


@lru_cache(maxsize=256)
def basis(n: int, low: Any, high: Any, kind: Any) -> Any:
    """The matrix that takes coefficients (ascending, degree n) to those of Bernstein on [low, high]."""
    rows = [
        [low ** (k - j) * (high - low) ** j * comb(k, j) if k >= j else 0 for k in range(n + 1)] for j in range(n + 1)
    ]
    return kind(n + 1, n + 1, [fmpq(comb(i, j), comb(n, j)) for i in range(n + 1) for j in range(n + 1)]) * kind(rows)


def bernstein(f: Free, box: Box, kind: Any) -> list[Any]:
    """Bernstein coefficients over a box: the values there lie between them; the first is that at all low ends.

    kind: of the matrices, fmpq_mat for exact ones, or arb_mat for balls.
    """
    degrees = [max(e[k] for e in f) for k in range(len(box))]
    size = prod(d + 1 for d in degrees)
    require(size <= MAX_SIZE, "a polynomial in the parameters has too high degrees")
    table = [f.get(e, 0) for e in product(*(range(d + 1) for d in degrees))]
    for n, (low, high) in zip(degrees, box, strict=True):  # each variable in turn stands first, and then goes last
        table = (basis(n, low, high, kind) * kind(n + 1, size // (n + 1), table)).transpose().entries()
    return table


def least(f: Free, box: Box) -> Any:
    """A lower bound over a box."""
    return min(bernstein(f, box, fmpq_mat)) if f else fmpq(0)


def everywhere(rows: Sequence[Free], box: Box, why: str, strictly: bool = True) -> None:
    """Σ f_k y^k > 0 (or ≥ 0) for all y ≥ 0 on parts of the box; others are halved along what the f_k hold.

    The longer the polynomials, in all their Bernstein coefficients, the fewer parts are looked at.
    """
    used = [k for k in range(len(box)) if any(e[k] for f in rows for e in f)]
    size = sum(prod(max(e[k] for e in f) + 1 for k in range(len(box))) for f in rows if f)
    stack, number = [(box, 0)], 0
    while stack:
        here, depth = stack.pop()
        number += 1
        if positive(rows, here, strictly):
            continue
        require(used and depth < 8 * len(used) and number < BOXES / max(1, size / 1000), why)
        stack += [(half, depth + 1) for half in halved(here, used[depth % len(used)])]


def halved(box: Box, k: int) -> list[Box]:
    low, high = box[k]
    middle = (low + high) / 2
    return [(*box[:k], (low, middle), *box[k + 1 :]), (*box[:k], (middle, high), *box[k + 1 :])]


def in_y(p: Any) -> list[Free]:
    """Of a polynomial in P and the parameters, even in P: for each power of y = −P² what stands with it."""
    out: dict[int, Free] = {}
    for (i, _, *e), c in p.to_dict().items():
        out.setdefault(int(i) // 2, {})[tuple(map(int, e))] = c * (-1) ** (int(i) // 2)
    return [out.get(k, {}) for k in range(max(out, default=-1) + 1)]


def positive(rows: Sequence[Free], box: Box, strictly: bool) -> bool:
    """Σ f_k y^k > 0 (or ≥ 0) for all y ≥ 0 and all parameters of the box: by lower bounds of the f_k."""
    low = [least(f, box) for f in rows]
    if not strictly and all(x >= 0 for x in low):
        return True
    return bool(nonnegative(fmpq_poly(low), strictly))


def monomial(x: Sequence[Any], e: Sequence[int]) -> Any:
    out = 1
    for y, k in zip(x, e, strict=True):
        out = out * y**k if k else out
    return out


def minus(a: Free, b: Free) -> Free:
    out = dict(a)
    for e, c in b.items():
        out[e] = out.get(e, fmpq(0)) - c
    return {e: c for e, c in out.items() if c != 0}


def times(a: Free, b: Free) -> Free:
    out: Free = {}
    for d, x in a.items():
        for e, y in b.items():
            key = tuple(i + j for i, j in zip(d, e, strict=True))
            out[key] = out.get(key, fmpq(0)) + x * y
    return out


def terms(p: Any) -> Free:
    return {tuple(map(int, e)): c for e, c in p.to_dict().items()}


def determinant(rows: Sequence[Sequence[Any]], one: Any) -> Any:
    """Of polynomials, along the first row."""
    if not rows:
        return one
    total = one - one
    for k, x in enumerate(rows[0]):
        if x:
            total += (-1) ** k * x * determinant([[*r[:k], *r[k + 1 :]] for r in rows[1:]], one)
    return total


def hurwitz(ring: Any, D: Any, box: Box) -> list[list[Free]]:
    """What must be positive for all y = −P² ≥ 0 that D, up to its sign, has roots Re s < 0 only: the highest and the
    lowest coefficient, and the Hurwitz determinants H_1 … H_{n−1} (H_n is the last times the lowest coefficient).

    They are the leading minors of a matrix: the pivots of Bareiss' elimination. It ends at one that vanishes.
    """
    parts: dict[int, Any] = {}
    for (i, j, *e), c in D.to_dict().items():
        parts.setdefault(int(j), {})[(int(i), 0, *map(int, e))] = c
    n, zero = max(parts), ring.constant(0)
    a = [real(ring, ring.from_dict(parts[j])) if j in parts else zero for j in range(n + 1)]
    if at(in_y(real(ring, a[n]))[-1], [(p + q) / 2 for p, q in box]) < 0:
        a = [-x for x in a]
    h = [[a[n - 2 * j + i] if 0 <= n - 2 * j + i <= n else zero for j in range(1, n + 1)] for i in range(1, n + 1)]
    minors, before = [a[n], a[0]], ring.constant(1)
    for k in range(n - 1):
        pivot = h[k][k]
        minors.append(pivot)
        require(len(pivot) <= MAX_SIZE, "the track's equations are too long")
        if not pivot:
            break
        for i in range(k + 1, n):
            h[i] = [(pivot * h[i][j] - h[i][k] * h[k][j]) // before if j > k else zero for j in range(n)]
        before = pivot
    return [in_y(real(ring, x)) for x in minors]


def real(ring: Any, p: Any) -> Any:
    """A polynomial even in P with P² = −y put for it, y standing as P²: its own inverse."""
    return ring.from_dict({e: c * (-1) ** (int(e[0]) // 2) for e, c in p.to_dict().items()})


# --- the equations ----------------------------------------------------------------------------------------


@dataclass(repr=False, eq=False)
class Track:
    """A(P, s) u = e·load; D = det A, N the cofactor of the loaded row; d, n: those at s = σ − vP, in (P, σ).

    With parameters all are polynomials in them too, and their powers stand last.
    """

    ring: Any
    rows: list[list[Any]]
    loaded: int
    velocity: Free
    D: Any
    N: Any
    d: Free
    n: Free

    @property
    def v(self) -> Any:
        """The velocity, without parameters."""
        return self.velocity.get((), fmpq(0))

    @property
    def degree(self) -> int:
        return max(e[0] for e in self.d)


def read_rows(value: Any, count: int) -> tuple[Any, list[list[Any]], int]:
    """(ring, rows, the loaded row): the entries Σ c P^i s^j, c numbers, or polynomials in `count` parameters."""
    keys(value, "matrix loaded")
    ring = fmpq_mpoly_ctx.get(("P", "s", *(f"x{k}" for k in range(count))), "lex")
    size = len(items(value["matrix"], MAX_ROWS - (count > 0), "the track's matrix"))
    require(size > 0, "the track has no equations")
    loaded, number = integer(value["loaded"], 0, size - 1, "loaded"), 0
    rows = []
    for row in value["matrix"]:
        entries = []
        for entry in items(row, size, "a row", size):
            found: dict[Exponents, Any] = {}
            for term in items(entry, 40, "an entry of the track"):
                i, j, c = items(term, 3, "a term", 3)
                i, j = integer(i, 0, 12, "a power of P"), integer(j, 0, 6, "a power of s")
                for powers, coefficient in free(c, count, "a coefficient").items():
                    key = (i, j, *powers)
                    require(key not in found, "a term stands twice")
                    found[key], number = coefficient, number + 1
            entries.append(ring.from_dict(found))
        rows.append(entries)
    require(not count or number <= MAX_TERMS, "the track's matrix has too many terms")
    return ring, rows, loaded


def dispersion(ring: Any, rows: list[list[Any]], loaded: int) -> tuple[Any, Any]:
    """D = det A and the cofactor N of the loaded row."""
    one = ring.constant(1)
    D = determinant(rows, one)
    N = determinant([[x for k, x in enumerate(r) if k != loaded] for i, r in enumerate(rows) if i != loaded], one)
    require(D and N, "the track's determinant or cofactor vanishes")
    for p in (D, N):
        require(
            len(ring.gens()) == 2 or (p.degrees()[1] <= 8 and len(p) <= 600), "the track's determinant is too long"
        )
        require(sum(p.degrees()[:2]) <= MAX_DEGREE, "the track's determinant has too high a degree")
        even = all(int(e[0]) % 2 == 0 for e in p.to_dict())
        require(even, "D or N is not even in P: the track is not the same in both directions")
    return D, N


def read_track(value: Any, velocity: Any, box: Box = ()) -> Track:
    ring, rows, loaded = read_rows(value, len(box))
    v = free(velocity, len(box), "velocity")
    everywhere([v], box, "the velocity is negative", False)
    return moving_track(ring, rows, loaded, v)


def moving_track(ring: Any, rows: list[list[Any]], loaded: int, velocity: Free) -> Track:
    D, N = dispersion(ring, rows, loaded)
    P, s, *x = ring.gens()
    moved = s - P * speed(ring, velocity)
    d, n = (terms(p.compose(P, moved, *x, ctx=ring)) for p in (D, N))
    track = Track(ring, rows, loaded, velocity, D, N, d, n)
    require(max(e[0] for e in n) + 2 <= track.degree, "N/D does not decay as 1/p²")
    return track


def speed(ring: Any, velocity: Free) -> Any:
    """The velocity as a polynomial of the ring."""
    return ring.from_dict({(0, 0, *e): c for e, c in velocity.items()})


def damped(D: Any, strictly: bool) -> bool:
    """D(ip, ·) has no root Re s > 0 for any real p; strictly: no root Re s ≥ 0. Exact."""
    top, *others = hurwitz(RING, D, ())
    return positive(top, (), True) and all(f and positive(f, (), strictly) for f in others)


def check_no_cut(track: Track, height: Any) -> None:
    """No p-root is real for Im q < 0, or, for height > 0, for Im q ≤ height; so none is at infinity inside."""
    require(
        damped(track.D.compose(P_, S_ - height, ctx=RING), height > 0),
        "a cut of the track may reach into the region: it is undamped, buckles, or is less damped than this",
    )


def check_passive(ring: Any, given: Sequence[Sequence[Any]], box: Box) -> None:
    """(A − A*)/2i ≥ 0 at P = ip, s = iΩ for all real p and Ω > 0, for all parameters: then W = −Im(N conj D) ≥ 0.

    Sufficient and exact: the coefficient of Ω^j vanishes for even j; for odd j its principal minors are ≥ 0.
    """
    size = len(given)
    parts: dict[int, list[list[dict[Any, Any]]]] = {}
    for r, c in product(range(size), repeat=2):
        for (i, j, *e), x in given[r][c].to_dict().items():
            i, j = int(i), int(j)
            rows = parts.setdefault(j, [[{} for _ in range(size)] for _ in range(size)])
            for a, b, y in ((r, c, x / 2), (c, r, x / 2 * (-1) ** (i + j + 1))):
                rows[a][b][(i, 0, *e)] = rows[a][b].get((i, 0, *e), fmpq(0)) + y
    for j, entries in parts.items():
        matrix = [[ring.from_dict({e: c for e, c in x.items() if c != 0}) for x in row] for row in entries]
        if j % 2 == 0:
            odd = any(x for row in matrix for x in row)
            require(not odd, "the track's matrix is not symmetric: it may not be passive")
            continue
        sign = 1 if j % 4 == 1 else -1
        for k in range(1, size + 1):
            for kept in combinations(range(size), k):
                minor = in_y(determinant([[sign * matrix[r][c] for c in kept] for r in kept], ring.constant(1)))
                everywhere(minor, box, "the track may give energy at rest: it is not passive", False)


def check_passive_track(track: Track) -> None:
    """The track, without cuts in Im q < 0, is passive at rest, and its receptance decays in frequency."""
    check_passive(RING, track.rows, ())
    require(
        max(j for _, j in terms(track.N)) < max(j for _, j in terms(track.D)),
        "the track's receptance does not decay in frequency",
    )


def absorption(ring: Any, D: Any, N: Any) -> tuple[Any, Any]:
    """W = −Im(N conj D) and |D|², polynomials in p, Ω (in the places of P and s) and the parameters."""
    parts = []
    for poly in (D, N):
        real_part: dict[Any, Any] = {}
        imag_part: dict[Any, Any] = {}
        for (i, j, *e), c in poly.to_dict().items():  # c (ip)^i (iΩ)^j, i even
            i, j = int(i), int(j)
            x = c * (-1) ** ((i + j - j % 2) // 2)
            (imag_part if j % 2 else real_part)[(i, j, *e)] = x
        parts.append((ring.from_dict(real_part), ring.from_dict(imag_part)))
    (a, b), (c, d) = parts
    return c * b - d * a, a * a + b * b


def read_vehicle(value: Any, basis: Any) -> Bodies:
    """Without parameters."""
    return read_bodies(value, basis, (), MAX_BODIES, MAX_CONTACTS)


@dataclass(repr=False, eq=False)
class Bodies:
    """M, C, K as {exponents of the parameters: matrix}, B, compliances and places of the felt coordinates; the last
    are neutral."""

    parts: list[dict[Exponents, Any]]
    B: Any
    h: list[Free]
    places: list[Free]
    neutral: int
    unfelt: int

    @property
    def numbers(self) -> tuple[Any, Any, Any]:
        """M, C, K without parameters."""
        none = fmpq_mat(self.B.nrows(), self.B.nrows())
        M, C, K = (part.get((), none) for part in self.parts)
        return M, C, K

    @property
    def sites(self) -> list[Any]:
        """The different places, ascending, without parameters."""
        return sorted({at(x, ()) for x in self.places})

    @cached_property
    def where(self) -> list[int]:
        """For each contact the number of its place."""
        kept: list[Free] = []
        for place in self.places:
            kept += [place] if place not in kept else []
        return [kept.index(place) for place in self.places]


def read_bodies(value: Any, basis: Any, box: Box, most: int, contacts: int) -> Bodies:
    """Passive for all parameters of the box, and in the basis felt, neutral and unfelt coordinates are apart."""
    keys(value, "M C K B places compliances")
    count, nc = len(box), len(items(value["places"], contacts, "places"))
    nb = len(items(value["M"], most, "M"))
    require(nc > 0 and nb > 0, "the vehicle has no body or no contact")
    parts, B = [read_matrix(value[name], nb, count, name) for name in "MCK"], matrix(value["B"], nb, nc, "B")
    check_semidefinite(parts, nb, box)
    neutral = unfelt = 0
    if basis is not None:
        keys(basis, "matrix neutral unfelt")
        neutral, unfelt = (integer(basis[name], 0, nb, name) for name in ("neutral", "unfelt"))
        Q = matrix(basis["matrix"], nb, nb, "basis")
        require(neutral + unfelt <= nb and Q.det() != 0, "the basis is singular, or names too many coordinates")
        B, parts = Q.transpose() * B, [{e: Q.transpose() * a * Q for e, a in part.items()} for part in parts]
    felt = nb - unfelt
    for i, j in product(range(felt - neutral, nb), range(nc)):
        require(B[i, j] == 0, "an unfelt or neutral coordinate carries a contact")
    for a in (a for part in parts for a in part.values()):
        for i, j in product(range(felt, nb), range(felt)):
            require(a[i, j] == 0, "the unfelt coordinates are coupled to the others")
    for a in parts[2].values():
        for i, j in product(range(felt - neutral, felt), range(felt)):
            require(a[i, j] == 0, "a neutral coordinate has a spring")
    parts = [{e: corner(a, felt, felt) for e, a in part.items()} for part in parts]
    places = [free(x, count, "a place") for x in value["places"]]
    h = [free(x, count, "a compliance", -4) for x in items(value["compliances"], nc, "compliances", nc)]
    for powers, c in (term for f in h for term in f.items()):
        fine = c > 0 and all(e == 0 or box[k][0] > 0 for k, e in enumerate(powers))
        require(fine, "a compliance may be negative, or infinite")
    bodies = Bodies(parts, corner(B, felt, nc), h, places, neutral, unfelt)
    check_forces(bodies.B, bodies.where, h)
    return bodies


def corner(a: Any, height: int, width: int) -> Any:
    return fmpq_mat(height, width, [a[i, j] for i in range(height) for j in range(width)])


def read_matrix(value: Any, size: int, count: int, name: str) -> dict[Exponents, Any]:
    """{exponents: matrix}, linear in each parameter."""
    out: dict[Exponents, Any] = {}
    for i, row in enumerate(items(value, size, name, size)):
        for j, x in enumerate(items(row, size, name, size)):
            for e, c in free(x, count, name).items():
                require(max(e, default=0) <= 1, f"{name} is not linear in each parameter")
                out.setdefault(e, fmpq_mat(size, size))[i, j] = c
    for a in out.values():
        require_short(a, name)
    return out


def check_semidefinite(parts: Sequence[dict[Exponents, Any]], size: int, box: Box) -> None:
    """M, C, K ≥ 0 and M + C + K > 0: at all corners of the box, and so everywhere, being linear in each parameter."""
    used = [k for k in range(len(box)) if any(e[k] for part in parts for e in part)]
    for ends in product((0, 1), repeat=len(used)):
        chosen = dict(zip(used, ends, strict=True))
        x, total = [pair[chosen.get(k, 0)] for k, pair in enumerate(box)], fmpq_mat(size, size)
        for part in parts:
            a = sum((c * at({e: fmpq(1)}, x) for e, c in part.items()), fmpq_mat(size, size))
            require(semidefinite(a), "M, C or K is not symmetric and positive semidefinite")
            total = total + a
        require(total.det() != 0, "a body has no mass, spring or damper")


def check_forces(B: Any, sites: Sequence[int], soft: Sequence[Any]) -> None:
    """No contact force is indeterminate: B f = 0, h f = 0 and no resultant at any place means f = 0.

    sites: the number of each contact's place; soft: whether its compliance is not 0.
    """
    nc = len(soft)
    rows = [[B[i, j] for j in range(nc)] for i in range(B.nrows())]
    rows += [[fmpq(int(x == site)) for x in sites] for site in sorted(set(sites))]
    rows += [[fmpq(int(i == j and bool(h))) for j in range(nc)] for i, h in enumerate(soft)]
    require(fmpq_mat(rows).rank() == nc, "two rigid contacts at one place share a force that nothing determines")


# --- Taylor forms -----------------------------------------------------------------------------------------


@lru_cache(maxsize=16)
def pairs(m: int) -> tuple[tuple[int, int, int], ...]:
    """(number of the coefficient, i, j) for i ≤ j, variables counted from 1."""
    both = [(i, j) for i in range(1, m + 1) for j in range(i, m + 1)]
    return tuple((1 + m + n, i, j) for n, (i, j) in enumerate(both))


Rows = list[list[Any]]


class Form:
    """A row of functions f(u) = k_0 + Σ k_i u_i + Σ_{i≤j} k_ij u_i u_j + rest, |rest| ≤ e, for all complex |u_i| ≤ 1.

    k: the coefficients, each a list of balls, one for each function of the row; without the k_ij the form is of first
    order. e: a list. m: the number of variables; 0 for numbers, which are balls without a rest.
    """

    def __init__(self, k: Rows, e: list[Any], m: int, known: dict[int, list[Any]] | None = None) -> None:
        self.k, self.e, self.m = k, e, m
        self.second = pairs(m) if len(k) > 1 + m else ()  # the coefficients of second order
        self.known = known or {}  # bounds, see `sizes`

    def sizes(self, order: int) -> list[Any]:
        """Bounds of the constants, of the linear, of the quadratic parts: order 0, 1, 2; of all, and the rest: 3."""
        found = self.known.get(order)
        if found is None:
            if order < 3:
                first, last = (0, 1, 1 + self.m, len(self.k))[order : order + 2]
                found = sums([[x.abs_upper() for x in row] for row in self.k[first:last]], len(self.e))
            else:
                found = sums([self.sizes(0), self.spread], len(self.e)) if self.m else self.sizes(0)
            self.known[order] = found
        return found

    @property
    def spread(self) -> list[Any]:
        """Bounds of what changes."""
        if not self.m:
            return self.e
        return sums([self.sizes(1), self.sizes(2), self.e] if self.second else [self.sizes(1), self.e], len(self.e))

    @property
    def size(self) -> list[Any]:
        """Bounds of all."""
        return self.sizes(3)

    def __add__(self, other: Form) -> Form:
        k = [[x + y for x, y in zip(a, b, strict=True)] for a, b in zip(self.k, other.k, strict=True)]
        return Form(k, [x + y for x, y in zip(self.e, other.e, strict=True)], self.m)

    def __neg__(self) -> Form:
        return Form([[-x for x in row] for row in self.k], self.e, self.m, self.known)

    def scaled(self, c: Sequence[Any]) -> Form:
        """Times numbers."""
        size = [abs(y) for y in c]
        k = [[x * y for x, y in zip(row, c, strict=True)] for row in self.k]
        e, *known = [[x * y for x, y in zip(row, size, strict=True)] for row in (self.e, *self.known.values())]
        return Form(k, e, self.m, dict(zip(self.known, known, strict=True)))

    def plus(self, c: Sequence[Any]) -> Form:
        known = {order: row for order, row in self.known.items() if order in (1, 2)}
        return Form([[x + y for x, y in zip(self.k[0], c, strict=True)], *self.k[1:]], self.e, self.m, known)

    def rested(self, more: Sequence[Any]) -> Form:
        """The same with more in the rest, or in the numbers where nothing varies."""
        if not self.m:
            return self.plus([box(x) for x in more])
        known = {order: row for order, row in self.known.items() if order < 3}
        return Form(self.k, [x + y for x, y in zip(self.e, more, strict=True)], self.m, known)

    def take(self, which: Sequence[int]) -> Form:
        """The functions of these numbers."""
        return self.picked(lambda row: [row[i] for i in which])

    def part(self, start: int, end: int) -> Form:
        return self.picked(lambda row: row[start:end])

    def picked(self, some: Callable[[list[Any]], list[Any]]) -> Form:
        known = {order: some(row) for order, row in self.known.items()}
        return Form([some(row) for row in self.k], some(self.e), self.m, known)

    def __mul__(self, other: Form) -> Form:
        """One by one."""
        a, b, first = self.k, other.k, range(1, 1 + self.m)
        k = [[x * y for x, y in zip(a[0], b[0], strict=True)]]
        if not self.m:
            return Form(k, self.e, 0)
        k += [[x * q + p * y for x, y, p, q in zip(a[0], b[0], a[i], b[i], strict=True)] for i in first]
        for n, i, j in self.second:
            row = [x * q + p * y for x, y, p, q in zip(a[0], b[0], a[n], b[n], strict=True)]
            row = [z + p * q for z, p, q in zip(row, a[i], b[j], strict=True)]
            k.append([z + p * q for z, p, q in zip(row, a[j], b[i], strict=True)] if i != j else row)
        x1, y1 = self.sizes(1), other.sizes(1)
        if self.second:
            x2, y2 = self.sizes(2), other.sizes(2)
            beyond = [p * r + q * (v + r) for p, q, v, r in zip(x1, x2, y1, y2, strict=True)]
        else:
            beyond = [p * q for p, q in zip(x1, y1, strict=True)]
        # |f g'| and |f' g| with all of f', g' but one rest, which is counted once
        rows = zip(beyond, self.size, self.e, other.size, other.e, strict=True)
        e = [w + q * f + (p - f) * g for w, p, f, q, g in rows]
        return Form(k, e, self.m, {0: [x * y for x, y in zip(self.sizes(0), other.sizes(0), strict=True)]})

    def inverse(self) -> Form:
        """1/f = (1 − w + w² − …)/k_0 with f = k_0 (1 + w), |w| ≤ y < 1: the rest of the series is y^n/(1 − y)."""
        require(not any(x.contains(0) for x in self.k[0]), "a quantity may be infinite")
        c, second = [1 / x for x in self.k[0]], self.second
        if not self.m:
            return Form([c], self.e, 0)
        w = [[x * y for x, y in zip(row, c, strict=True)] for row in self.k]
        k = [c] + [[-x * y for x, y in zip(row, c, strict=True)] for row in w[1 : 1 + self.m]]
        for n, i, j in second:
            twice = 1 if i == j else 2
            k.append([(p * q * twice - x) * y for p, q, x, y in zip(w[i], w[j], w[n], c, strict=True)])
        e, sizes = [], [abs(x) for x in c]
        for size, p, q, f in zip(sizes, self.sizes(1), self.sizes(2), self.e, strict=True):
            p, q, f = p * size, q * size, f * size
            y = p + q + f
            require(y < 0.95, "a quantity may be infinite")
            e.append(size * (f + ((q + f) * (p + y) + y**3 / (1 - y) if second else y * y / (1 - y))))
        return Form(k, e, self.m, {0: sizes})

    def exp(self) -> Form:
        """e^f = e^{k_0}(1 + w + …): what is left out of its series is that of e^y, |w| ≤ y; but where y is large
        |e^f| ≤ e^{Re k_0 + y} says more."""
        value, second, e = [x.exp() for x in self.k[0]], self.second, []
        sizes = [abs(x) for x in value]
        if not self.m:
            return Form([value], self.e, 0)
        k = [value] + [[x * y for x, y in zip(row, value, strict=True)] for row in self.k[1 : 1 + self.m]]
        for n, i, j in second:
            half = fmpq(1, 2) if i == j else 1
            k.append(
                [(x + p * q * half) * y for x, p, q, y in zip(*(self.k[r] for r in (n, i, j)), value, strict=True)]
            )
        for n, (p, q, f) in enumerate(zip(self.sizes(1), self.sizes(2), self.e, strict=True)):
            y = p + q + f
            if y < 2:
                left = y.expm1() - y
                left = left - y * y / 2 + (q + f) * (p + y) / 2 if second else left
                e.append(sizes[n] * (f + left))
            else:
                e.append(sizes[n] * y.exp())
                sizes[n] = ZERO
                for row in k:
                    row[n] = NONE
        return Form(k, e, self.m, {0: sizes})


ZERO, NONE = arb(0), acb(0)


def sums(rows: Sequence[Sequence[Any]], length: int) -> list[Any]:
    """Of rows, one by one."""
    total = list(rows[0]) if rows else [ZERO] * length
    for row in rows[1:]:
        total = [x + y for x, y in zip(total, row, strict=True)]
    return total


def joined(forms: Sequence[Form]) -> Form:
    """All their functions in one row."""
    if len(forms) == 1:
        return forms[0]
    k = [[x for row in rows for x in row] for rows in zip(*(f.k for f in forms), strict=True)]
    known = {
        order: [x for f in forms for x in f.known[order]]
        for order in range(4)
        if all(order in f.known for f in forms)
    }
    return Form(k, [x for f in forms for x in f.e], forms[0].m, known)


def along(
    E: Sequence[Form], sizes: Sequence[Sequence[Any]], h: Form, most: Sequence[Any], slope: bool = False
) -> Form:
    """Σ E_i h^i for |h| ≤ most, or its derivative in h. E: as many as a form tells; sizes: bounds of all."""
    n, start = len(h.e), int(slope)
    last = min(3 if h.second else start + 1, len(E) - 1)
    factor = range(len(sizes)) if slope else [1] * len(sizes)
    total = E[last].scaled([factor[last]] * n) if slope else E[last]
    for i in range(last - 1, start - 1, -1):
        total = total * h + (E[i].scaled([i] * n) if factor[i] > 1 else E[i])
    rest = [ZERO] * n
    for i in range(len(sizes) - 1, last, -1):
        rest = [(x + y * factor[i]) * z for x, y, z in zip(rest, sizes[i], most, strict=True)]
    return total.rested([x * y ** (last - start) for x, y in zip(rest, most, strict=True)])


@dataclass(repr=False, eq=False)
class Sums:
    """Polynomials in σ and the parameters, in balls: for each row the coefficients of these exponents."""

    exponents: tuple[Exponents, ...]
    matrix: Any

    @classmethod
    def of(cls, rows: Sequence[Free]) -> Sums:
        exponents = tuple(sorted({e for f in rows for e in f})) or ((),)
        return cls(exponents, acb_mat(len(rows), len(exponents), [acb(f.get(e, 0)) for f in rows for e in exponents]))


@lru_cache(maxsize=64)
def expansion(exponents: tuple[Exponents, ...], m: int, order: int) -> tuple[int, list[tuple[int, int, int, Any]]]:
    """(how many powers of u, [(number of an exponent, of a power of u, factor, ((i, power of x_i, of r_i), …)), …])
    of Π (x_i + r_i u_i)^{e_i}; the powers of the lowest orders stand first, as in a form."""
    parts = [
        [(f, tuple((i, k - (f[i] if i < m else 0), f[i] if i < m else 0) for i, k in enumerate(e) if k))
         for f in product(*(range(k + 1) for k in (*e, *[0] * m)[:m]))]
        for e in exponents
    ]  # fmt: skip
    unit = [tuple(int(i == j) for i in range(m)) for j in range(m)]
    first = [(0,) * m, *unit]
    if order == 2:
        first += [tuple(a + b for a, b in zip(unit[i - 1], unit[j - 1], strict=True)) for _, i, j in pairs(m)]
    number = {f: n for n, f in enumerate(dict.fromkeys([*first, *(f for row in parts for f, _ in row)]))}
    return len(number), [
        (n, number[f], prod(comb(a + b, b) for _, a, b in factors), factors)
        for n, row in enumerate(parts) for f, factors in row
    ]  # fmt: skip


class Place:
    """Where σ and the parameters vary: each is middle + half·u, or the middle alone; forms of their monomials."""

    def __init__(self, middle: Sequence[Any], half: Sequence[Any], order: int) -> None:
        self.middle, self.half, self.order, self.m = list(middle), list(half), order, len(half)
        self.known: dict[Exponents, Form] = {}

    @cached_property
    def powers(self) -> list[list[Form]]:
        """For each variable those that are known."""
        out = []
        for i, x in enumerate(self.middle):
            f = self.number(x)
            if i < self.m:
                f.k[1 + i] = [acb(self.half[i])]
            out.append([self.number(1), f])
        return out

    @classmethod
    def disc(cls, sigma: Any, r: Any) -> Place:
        """|σ − middle| ≤ r, for forms of first order; the point alone for r = 0."""
        return cls([sigma], [] if r.is_zero() else [r], 1)

    def number(self, c: Any) -> Form:
        return Form([[acb(c)], *([NONE] for _ in range(self.width - 1))], [ZERO], self.m)

    @cached_property
    def width(self) -> int:
        """How many coefficients a form has."""
        return 1 + self.m + (len(pairs(self.m)) if self.order == 2 else 0)

    def power(self, i: int, e: int) -> Form:
        if e < 0:
            return self.power(i, -e).inverse()
        row = self.powers[i]
        while len(row) <= e:
            row.append(row[-1] * row[1])
        return row[e]

    def monomial(self, e: Exponents) -> Form:
        """Of exponents of (σ, θ)."""
        found = self.known.get(e)
        if found is None:
            used = [(i, k) for i, k in enumerate(e) if k]
            found = self.power(*used[0]) if used else self.number(1)
            for i, k in used[1:]:
                found = found * self.power(i, k)
            self.known[e] = found
        return found

    def taylor(self, polynomials: Sums) -> Any:
        """Taylor's coefficients in u, all of them: a matrix with a row for each polynomial, those of a form first."""
        exponents = polynomials.exponents
        width, terms_ = expansion(exponents, self.m, self.order)
        most = [max((e[i] for e in exponents if e), default=0) for i in range(len(self.middle))]
        x = [powers(acb(y), n) for y, n in zip(self.middle, most, strict=True)]
        r = [powers(acb(y), n) for y, n in zip(self.half, most, strict=False)]
        matrix = acb_mat(len(exponents), width)
        for n, k, c, factors in terms_:
            value = acb(c)
            for i, a, b in factors:
                value = value * x[i][a] * r[i][b] if b else value * x[i][a]
            matrix[n, k] = value
        return polynomials.matrix * matrix

    def form(self, table: Any) -> Form:
        """From Taylor's coefficients."""
        return self.of_columns([list(x) for x in zip(*table.tolist(), strict=True)])

    def of_columns(self, columns: Rows) -> Form:
        e = sums([[x.abs_upper() for x in column] for column in columns[self.width :]], len(columns[0]))
        return Form(columns[: self.width], e, self.m)

    def value(self, polynomials: Sums) -> Form:
        return self.form(self.taylor(polynomials))


def horner(row: Sequence[Any], x: Any) -> Any:
    total = row[-1]
    for c in row[-2::-1]:
        total = total * x + c
    return total


def powers(x: Any, n: int) -> list[Any]:
    """x^0 … x^n."""
    out = [acb(1)]
    for _ in range(n):
        out.append(out[-1] * x)
    return out


# --- waves in balls: D and N over a place, the splitting D = lead·U·L -------------------------------------


def box(radius: Any) -> Any:
    """A ball that holds the disc of this radius round 0."""
    r = arb(0, radius.upper())
    return acb(r, r)


def by_power(f: Free) -> list[Free]:
    """For each power of the first variable, what stands with it."""
    out: list[Free] = [{} for _ in range(max(e[0] for e in f) + 1)]
    for (i, *e), c in f.items():
        out[i][tuple(e)] = c
    return out


class Local:
    """D and N over a place: for each power of P Taylor's coefficients, those of a form first."""

    def __init__(self, place: Place, d: Sums, n: Sums) -> None:
        self.place, self._n = place, n
        self.D = place.taylor(d)

    @property
    def degree(self) -> int:
        return int(self.D.nrows()) - 1

    @property
    def lead(self) -> Any:
        """A lower bound of the modulus of D's highest coefficient."""
        first, *change = [abs(x) for x in self.D.tolist()[-1]]
        return first - sum(change, ZERO)

    @cached_property
    def N(self) -> Any:
        return self.place.taylor(self._n)

    def about(self, z: Sequence[Any], table: Any) -> tuple[list[Form], list[list[Any]]]:
        """Of E_i in Σ f_j (z + h)^j = Σ E_i h^i, for each z: the first ones, and bounds of all from E_2 on."""
        n, width, m, columns = len(z), self.place.width, self.place.m, table.transpose().tolist()
        for column in columns:
            while column and column[-1].is_zero():
                column.pop()
        forms, bounds = [], list[list[Any]]()
        for i in range(table.nrows()):
            k: Rows = []
            parts: list[list[list[Any]]] = [[], [], [], []]  # bounds: of constants, linear, quadratic, the rest
            for number, column in enumerate(columns):
                c = column[i:]
                if i and len(c) > 1:
                    c[1:] = [comb(j, i) * x for j, x in enumerate(c[1:], i + 1)]
                row = [horner(c, x) for x in z] if len(c) > 1 else (c or [NONE]) * n
                if number < width:
                    k.append(row)
                if c and (number >= width or i > 1):
                    order = 3 if number >= width else min(number, 1) + (number > m)
                    parts[order].append([x.abs_upper() for x in row] if len(c) > 1 else [c[0].abs_upper()] * n)
            sizes = [sums(rows, n) for rows in parts]
            bounds.append(sums(sizes, n) if i > 1 else [])
            forms.append(Form(k, sizes[3], m, dict(enumerate(sizes[:2])) if i > 1 else {}))
        return forms[: self.place.order + 2], bounds


class Waves:
    """The track in balls at the present precision, and the gaps between places that its kernels are needed for."""

    def __init__(self, track: Track, places: Sequence[Free], at_: Sequence[Any] = ()) -> None:
        """places: of the contacts; at_: any parameters of the range, at which gaps are told from those behind."""
        self.track, self.d, self.n = track, Sums.of(by_power(track.d)), Sums.of(by_power(track.n))
        rows = [[minus(a, b) for b in places] for a in places]
        found: list[Free] = []
        for gap in (gap for row in rows for gap in row):
            found += [gap] if gap not in found else []
        self.gaps = sorted(found, key=lambda gap: bool(at(gap, at_) < 0))  # those ahead first
        self.index = [[self.gaps.index(gap) for gap in row] for row in rows]
        first = [k for k, place in enumerate(places) if place not in places[:k]]
        self.between = [[self.index[i][j] for j in first] for i in first]  # of the different places
        self.ahead = [at(gap, at_) >= 0 for gap in self.gaps]
        self.xi = Sums.of([{(0, *e): c for e, c in gap.items()} for gap in self.gaps])
        self.fixed = not any(any(e) for e in self.xi.exponents)  # no gap varies
        self.distances = [row[0] for row in self.xi.matrix.tolist()]

    def near(self, place: Place) -> Local:
        return Local(place, self.d, self.n)


Known = tuple[list[Any], int]  # numbers near p-roots, and how many of them, the first, for U


class Nodes:
    """Distinct points z_k, the first `up` of them for U; U = Π(P − z_k)·(1 + Σ a_k/(P − z_k)), L likewise."""

    def __init__(self, z: Sequence[Any], up: int, local: Local) -> None:
        n = len(z)
        self.z, self.up, self.local = list(z), up, local
        self.side = [range(up), range(up, n)]
        self.distance, inverse = [[ZERO] * n for _ in range(n)], arb_mat(n, n)
        self.own, self.all = [arb(1)] * n, [acb(1)] * n  # |U₀'(z_k)| or |L₀'(z_k)|, (U₀L₀)'(z_k)
        for i, k in combinations(range(n), 2):
            gap = z[i] - z[k]
            size = self.distance[i][k] = self.distance[k][i] = abs(gap)
            self.all[i], self.all[k] = self.all[i] * gap, self.all[k] * -gap
            if (i < up) == (k < up):
                self.own[i], self.own[k] = self.own[i] * size, self.own[k] * size
            else:
                inverse[i, k] = inverse[k, i] = 1 / size
        self.inverse = inverse
        self.rows = (acb_mat([powers(x, n) for x in z]) * local.D).tolist()
        self.values = local.place.of_columns([list(x) for x in zip(*self.rows, strict=True)])

    def split(self, thin: bool = False) -> Split:
        """The pair over the place, or Refused; thin: at its middle, where the constants are the values of D."""
        low = abs(self.local.D[len(self.z), 0]) if thin else self.local.lead
        require(low > 0, "the highest coefficient may vanish on a piece")
        sizes = self.values.sizes(0) if thin else self.values.size
        w = [(x / (abs(size) * low)).upper() for x, size in zip(sizes, self.all, strict=True)]
        found = contraction(w, self.inverse, tiny(self.z))
        require(found, "the p-roots of both sides are not kept apart on a piece: it is too long")
        return Split(self, *(found or ([], [])))


def tiny(z: Sequence[Any]) -> Any:
    return max((abs(x).upper() for x in z), default=arb(1)) * arb(2) ** (-4 * flint.ctx.prec)


def contraction(w: Sequence[Any], inverse: Any, tiny: Any) -> tuple[list[Any], list[Any]] | None:
    """(β, τ) of Lemma 1 for |W_k| ≤ w_k; inverse: 1/|z_k − z_l| for nodes of two sides, else 0.

    β is found by iteration; what counts is the last inequality. The wider of two joins more neighbours.
    """

    def image(beta: list[Any]) -> tuple[list[Any], bool]:
        s = (inverse * arb_mat(len(w), 1, beta)).entries() if w else []
        tau = [(x / (1 - y)).upper() for x, y in zip(w, s, strict=True)] if all(y < 1 for y in s) else [arb("inf")]
        return tau, all(y < 0.5 for y in s) and all(map(lt, tau, beta))

    beta = [(x * 1.2 + tiny).upper() for x in w]
    for _ in range(10):
        tau, holds = image(beta)
        if holds:
            wide = [(x * 2).upper() for x in beta]
            return (wide if image(wide)[1] else beta), tau
        if not tau[0].is_finite():
            return None
        beta = [(x * 1.15 + tiny).upper() for x in tau]
    return None


@dataclass(repr=False, eq=False)
class Split:
    """For each σ of the disc exactly one pair U·L = D/lead has |a_k| ≤ box_k; it is analytic; |a_k| ≤ tight_k."""

    nodes: Nodes
    box: list[Any]
    tight: list[Any]

    def pair(self, sigma: Any) -> list[Any]:
        """The a_k at a σ of the disc, in balls: W_k/(1 + x), |x| ≤ Σ τ_l/|z_k − z_l|."""
        nodes, place = self.nodes, self.nodes.local.place
        u = (sigma - place.middle[0]) / place.half[0] if place.m else ZERO
        lead, *values = (horner(row, u) for row in (nodes.local.D.tolist()[-1], *nodes.rows))
        return [d / (lead * size) * x for d, size, x in zip(values, nodes.all, self.spread, strict=True)]

    @cached_property
    def spread(self) -> list[Any]:
        """Balls of 1/(1 + x), |x| ≤ Σ τ_l/|z_k − z_l|."""
        s = (self.nodes.inverse * arb_mat(len(self.tight), 1, self.tight)).entries()
        return [1 + box(x / (1 - x)) for x in s]

    def near(self, sigma: Any) -> Known:
        """Near the p-roots at a σ of the disc, or next to it."""
        nodes, place = self.nodes, self.nodes.local.place
        moved, lead = nodes.values.k[0], nodes.local.D[nodes.local.degree, 0]
        if place.m:
            u = (sigma - place.middle[0]) / place.half[0]
            moved = [x + y * u for x, y in zip(moved, nodes.values.k[1], strict=True)]
        return [(z - x / (lead * y)).mid() for z, x, y in zip(nodes.z, moved, nodes.all, strict=True)], nodes.up

    def links(self, other: Split, sigma: Any) -> bool:
        """Whether the pair of another splitting is the one here, at a σ of both: |U(z_k)/U₀'(z_k)| < box_k."""
        z, w, a = self.nodes.z, other.nodes.z, other.pair(sigma)
        for side in self.nodes.side:
            for k in side:
                full, rest = acb(1), acb(0)  # Π(z_k − w) and Σ a Π'(z_k − w)
                for i in side:
                    gap = z[k] - w[i]
                    full, rest = full * gap, rest * gap + a[i] * full
                if not abs(full + rest) < self.box[k] * self.nodes.own[k]:
                    return False
        return self.nodes.up == other.nodes.up

    def holds(self, found: Apart) -> bool:
        """Whether the roots of the pair at a σ of the disc are those found there, side by side."""
        nodes, balls = self.nodes, [x + box(e) for x, e in zip(found.z, found.e, strict=True)]
        sizes = ((k, prod((nodes.z[k] - balls[i] for i in side), start=acb(1))) for side in nodes.side for k in side)
        return nodes.up == found.up and all(abs(x) < self.box[k] * nodes.own[k] for k, x in sizes)


@dataclass(repr=False, eq=False)
class Apart:
    """All p-roots over a place, each alone in a disc |P − z| ≤ e, disjoint from the others; the first `up` are those
    of U. D, sizes: see `Local.about`."""

    local: Local
    z: list[Any]
    up: int
    e: list[Any]
    D: list[Form]
    sizes: list[list[Any]]

    @classmethod
    def of(cls, local: Local, z: Sequence[Any], up: int) -> Apart:
        """Near these points, or Refused: D/lead = Π(P − z_k)·(1 + Σ W_k/(P − z_k)) (SPEC2, 4.3)."""
        low, (D, sizes) = local.lead, local.about(z, local.D)
        require(low > 0, "the highest coefficient may vanish on a piece")
        gaps = [[abs(x - y) for y in z] for x in z]
        w = [x / prod((g for i, g in enumerate(row) if i != k), start=low)
             for k, (x, row) in enumerate(zip(D[0].size, gaps, strict=True))]  # fmt: skip
        return cls(local, list(z), up, [isolated(k, w, row) for k, row in enumerate(gaps)], D, sizes)

    def __post_init__(self) -> None:
        pairs_ = combinations(zip(self.z, self.e, strict=True), 2)
        require(all(abs(x - y) > d + f for (x, d), (y, f) in pairs_), APART)

    @property
    def sides(self) -> list[range]:
        return [range(self.up), range(self.up, len(self.z))]

    def near(self, sigma: Any) -> Known:
        """Near the p-roots at a σ of the disc, or next to it."""
        place, moved = self.local.place, self.D[0].k[0]
        if place.m:
            u = (sigma - place.middle[0]) / place.half[0]
            moved = [x + y * u for x, y in zip(moved, self.D[0].k[1], strict=True)]
        return [(z - x / y).mid() for z, x, y in zip(self.z, moved, self.D[1].k[0], strict=True)], self.up

    def holds(self, found: Apart) -> bool:
        """Whether at a common σ the roots found are these, side by side: discs of different sides are disjoint."""
        across = ((i, k) for a, b in zip(self.sides, reversed(found.sides), strict=True) for i in a for k in b)
        return self.up == found.up and all(abs(self.z[i] - found.z[k]) > self.e[i] + found.e[k] for i, k in across)

    @property
    def known(self) -> Known:
        return [x.mid() for x in self.z], self.up

    @property
    def sided(self) -> bool:
        """Whether all roots of U have Re P < 0, and those of L Re P > 0."""
        return all(
            (x.real if k >= self.up else -x.real) > e for k, (x, e) in enumerate(zip(self.z, self.e, strict=True))
        )


APART = "p-roots are not told apart: the piece is too long"


def isolated(k: int, w: Sequence[Any], gaps: Sequence[Any]) -> Any:
    """e with w_k/e + Σ_{j ≠ k} w_j/(gap_j − e) < 1: exactly one root in |P − z_k| < e, and it has |P − z_k| ≤ e."""
    e, others = w[k].upper(), [(y, gap) for j, (y, gap) in enumerate(zip(w, gaps, strict=True)) if j != k]
    for _ in range(8):
        away = [gap - e for _, gap in others]
        require(all(x > 0 for x in away), APART)
        left = 1 - sum([y / x for (y, _), x in zip(others, away, strict=True)], ZERO)
        require(left > 0, APART)
        if w[k] < e * left or w[k].is_zero():
            return e
        e = (w[k] / left * 1.02).upper()
    raise Refused(APART)


def p_roots(local: Local) -> list[Any]:
    """Near the roots of D(·, m), exact numbers, to half of the digits computed with: nothing rests on them."""
    D, n = acb_poly([local.D[i, 0].mid() for i in range(local.degree + 1)]), local.degree
    low = next((k for k in range(n) if D[k] != 0), 0)  # 0 may be a root
    size = abs(D[low] / D[n]) ** arb(fmpq(1, n - low))
    try:
        D.roots(maxprec=2000)  # where two are one that is told before the digits cost much
        found = D.roots(tol=size * arb(2) ** (-flint.ctx.prec // 2), maxprec=2 * flint.ctx.prec + 1000)
    except ValueError:
        raise Refused("p-roots meet in the middle of a piece") from None
    return [x.mid() for x in found]


def nearest(x: Any, others: Sequence[Any]) -> int:
    """The number of the one next to x. Nothing rests on it."""
    return min(range(len(others)), key=lambda k: abs(complex(x - others[k])))


def sorted_roots(local: Local, known: Known | None = None) -> Known:
    """The p-roots of a middle; for U those with Re P < 0, or those next to the first of the known ones."""
    z = p_roots(local)
    side = [x.real > 0 if known is None else nearest(x, known[0]) >= known[1] for x in z]
    order = sorted(range(len(z)), key=side.__getitem__)
    return [z[k] for k in order], side.count(False)


def nodes_near(local: Local, known: Known | None = None) -> Nodes:
    """Nodes at the p-roots of a middle, see `sorted_roots`."""
    return Nodes(*sorted_roots(local, known), local)


def going_on(local: Local, known: Known, prove: Callable[[list[Any], int], Any]) -> Any:
    """What `prove` finds over a place from numbers that go on from known ones, or next to them; or Refused."""
    z = newton([local.D[i, 0].mid() for i in range(local.degree + 1)], known[0])
    if z is not None:  # real numbers find no complex roots
        try:
            return prove(z, known[1])
        except Refused:
            pass
    return prove(*sorted_roots(local, known))


def split_near(local: Local, known: Known) -> Any:
    """The pair over a place. Where all roots are of one side any nodes would do."""
    return going_on(local, known, lambda z, up: Nodes(z, up, local).split())


def apart_near(local: Local, known: Known) -> Any:
    """The p-roots over a place."""
    return going_on(local, known, lambda z, up: Apart.of(local, z, up))


def newton(D: Sequence[acb], z: Sequence[acb]) -> list[acb] | None:
    """Nearer to the roots of Σ D_i P^i, by Newton's method, in floats where they do: nothing rests on it.

    None where it does not settle.
    """
    if flint.ctx.prec <= 64:
        try:
            c = [complex(x) for x in reversed(D)]
            first = [complex(x) for x in z]
            near = [in_floats(c, x, 1e-7 * max(map(abs, first))) for x in first]
            return [acb(x) for x in near if x is not None] if None not in near else None
        except (OverflowError, ZeroDivisionError):
            pass
    p = acb_poly(D)
    slope, small = p.derivative(), max(abs(x).upper() for x in z) * arb(2) ** (-flint.ctx.prec // 4)
    for _ in range(flint.ctx.prec.bit_length() + 4):
        step = [(p(x) / slope(x)).mid() for x in z]
        z = [(x - y).mid() for x, y in zip(z, step, strict=True)]
        if all(abs(y) < small for y in step):  # the next one is about as its square
            return list(z)
    return None


def in_floats(c: Sequence[complex], z: complex, small: float) -> complex | None:
    """A root of the polynomial with these coefficients, the highest first, near z."""
    for _ in range(12):
        value, slope = c[0], 0j
        for x in c[1:]:
            value, slope = value * z + x, slope * z + value
        step = value / slope
        z -= step
        if abs(step) <= small:
            return z
    return None


REAL = "a p-root may be real there"


def sided(split: Split) -> bool:
    """Each root of U lies within (their number)·τ_k of some node, so all have Re P < 0, and those of L Re P > 0."""
    pairs_ = zip(split.nodes.side, (-1, 1), strict=True)
    return all(sign * split.nodes.z[k].real > len(side) * split.tight[k] for side, sign in pairs_ for k in side)


# --- kernels: G(ξ) over a place ---------------------------------------------------------------------------


def residues(found: Sequence[Apart], used: Sequence[int]) -> tuple[Form, Form]:
    """The roots of these numbers over each place, place by place, and N/D_P there.

    With D(z + h) = Σ E_i h^i a root has h = −(E_0 + (E_1 − E_1(0))h + E_2h² + …)/E_1(0), in forms of first order.
    """
    z, e = ([row[k] for row in rows for k in used] for rows in ([x.z for x in found], [x.e for x in found]))
    D = [joined([f.take(used) for f in forms]) for forms in zip(*(x.D for x in found), strict=True)]
    sizes = [[row[k] for row in rows if row for k in used] for rows in zip(*(x.sizes for x in found), strict=True)]
    numerators = [x.local.about([x.z[k] for k in used], x.local.N) for x in found]
    N = [joined(forms) for forms in zip(*(forms for forms, _ in numerators), strict=True)]
    above = [[y for row in rows for y in row] for rows in zip(*(bounds for _, bounds in numerators), strict=True)]
    c = [-1 / x for x in D[1].k[0]]
    rest = [ZERO] * len(z)
    for size in (*reversed(sizes[2:]), D[1].spread):
        rest = [(x + y) * r for x, y, r in zip(rest, size, e, strict=True)]
    h = D[0].rested(rest).scaled(c)
    e = [min_bound(x, y) for x, y in zip(e, h.size, strict=True)]
    return h.plus(z), along(N, above, h, e) * along(D, sizes, h, e, True).inverse()


def kernels(waves: Waves, found: Sequence[Apart], pole: Any = None) -> list[tuple[Form, Form]]:
    """Over each place G = ± Σ N e^{Pξ}/D_P for each gap, over the roots of its side; and Σ N/D_P over U.

    With a pole that is e^{pole·ξ}·H(ξ) for each gap, and g, with G = e^{pole·ξ}(g + H): only g is large where
    P = pole is double.
    """
    sides = [list(side) if pole is not None or any(ahead == (not k) for ahead in waves.ahead) else []
             for k, side in enumerate(found[0].sides)]  # fmt: skip
    used = [k for side in sides for k in side]
    P = weight = found[0].local.place.number(0).take([])
    if used:
        P, weight = residues(found, used)
    numbers = [[used.index(k) for k in side] for side in sides]
    return summed(waves, [x.local.place for x in found], P, weight, numbers, pole)


def summed(
    waves: Waves, places: Sequence[Place], P: Form, weight: Form, sides: Sequence[Sequence[int]], pole: Any = None
) -> list[tuple[Form, Form]]:
    """Over each place for each gap ± Σ weight·e^{Pξ} over the roots of its side; and Σ weight over those of U.

    P, weight: of roots, place by place, as many of each; sides: the numbers of those of U and of L.
    """
    count, number = len(places), len(P.e) // len(places)
    chosen = [[g for g, ahead in enumerate(waves.ahead) if ahead == (side == 0)] for side in (0, 1)]
    every = [(n * number + k, n, g) for mine, gaps in zip(sides, chosen, strict=True)
             for k in mine for n in range(count) for g in gaps]  # fmt: skip
    roots = [k for k, _, _ in every]
    ride = P.take(roots)
    if pole is not None:
        ride = ride.plus([-pole] * len(every))
    if waves.fixed:
        ride = ride.scaled([waves.distances[g] for _, _, g in every])
    else:
        xi = joined([place.value(waves.xi) for place in places])
        ride = ride * xi.take([n * len(waves.gaps) + g for _, n, g in every])
    ride = ride.exp()
    if pole is not None:
        ride = ride.plus([acb(-1)] * len(every))
    weight.sizes(1)
    ride = ride * weight.take(roots)
    ahead, behind = (count * len(gaps) for gaps in chosen)
    split = len(sides[0]) * ahead
    G = folded(ride.part(0, split), ahead)
    if behind:
        G = joined([G, -folded(ride.part(split, len(every)), behind)])
    fine = all(x.is_finite() for row in (*G.k, G.e) for x in row)
    require(fine, "a kernel is not bounded on a piece")
    out, (a, b) = [], map(len, chosen)
    for n in range(count):
        one = G.take([*range(n * a, (n + 1) * a), *range(ahead + n * b, ahead + (n + 1) * b)])
        if pole is None:
            out.append((one, one))
        else:
            g = folded(weight.take([n * number + k for k in sides[0]]), 1)
            out.append((one.scaled([(pole * x).exp() for x in waves.distances]), g))
    return out


def folded(f: Form, n: int) -> Form:
    """The sum of the parts of a row, each of n functions; 0 where it has none."""
    parts = [f.part(k, k + n) for k in range(0, len(f.e), n)] if n else []
    return sum(parts[1:], parts[0]) if parts else Form([[NONE] * n for _ in f.k], [ZERO] * n, f.m)


class Origin:
    """Waves next to q = 0 where k of them come to P = 0 there: P = ζσ, E(ζ, σ) = D(ζσ, σ)/σ^k = 0 (SPEC2, 4.8)."""

    def __init__(self, waves: Waves) -> None:
        k, low = (min(i + j for i, j in t) for t in (waves.track.d, waves.track.n))
        self.waves, self.power = waves, low + 1 - k
        stated = "waves come to P = 0 at q = 0, where the receptance is not bounded"
        require((k, 0) in waves.track.d and self.power >= 0, stated)
        lowered = [Sums.of(by_power({(i, i + j - f): c for (i, j), c in t.items()}))
                   for t, f in ((waves.track.d, k), (waves.track.n, low))]  # fmt: skip
        self.kinds = [(lowered, 0, k), ([waves.d, waves.n], k, waves.track.degree)]

    def locals(self, r: Any) -> list[Local]:
        """In ζ and in P, over |σ| ≤ r."""
        place = Place.disc(acb(0), r)
        return [Local(place, *both) for both, _, _ in self.kinds]

    def roots(self, r: Any) -> list[Apart]:
        """Over |σ| ≤ r the ζ, and the P of the other roots, off the imaginary axis."""
        out = []
        for local, (_, first, last) in zip(self.locals(r), self.kinds, strict=True):
            z = acb_poly([local.D[i, 0].mid() for i in range(first, last + 1)]).roots()
            z = sorted((x.mid() for x in z), key=lambda x: bool(x.real > 0))
            D, sizes = local.about(z, local.D)
            rows = zip(D[0].size, D[1].spread, *sizes[2:], strict=True)
            e = [alone(row, slope.abs_lower()) for row, slope in zip(rows, D[1].k[0], strict=True)]
            out.append(Apart(local, z, sum(not x.real > 0 for x in z), e, D, sizes))
        require(all(found.sided for found in out), "a p-root may be real next to q = 0")
        number = sum(len(found.z) for found in out)
        require(number == self.waves.track.degree, "a p-root is at infinity next to q = 0")
        return out

    def kernels(self, r: Any) -> Form:
        """For each gap G over |σ| ≤ r."""
        found, parts, sides = self.roots(r), [], list[list[int]]([[], []])
        for kind, one in enumerate(found):
            P, weight = residues([one], range(len(one.z)))
            if not kind:
                sigma = one.local.place.power(0, 1).take([0] * len(one.z))
                P = P * sigma
                for _ in range(self.power):
                    weight = weight * sigma
            for side, mine in zip(sides, one.sides, strict=True):
                side += [k + (len(found[0].z) if kind else 0) for k in mine]
            parts.append((P, weight))
        P, weight = map(joined, zip(*parts, strict=True))
        return summed(self.waves, [found[0].local.place], P, weight, sides)[0][0]

    def at(self, sigma: Any, r: Any) -> Apart:
        """The P of all roots at a σ with |σ| ≤ r."""
        slow, others = self.roots(r)
        z, e = [z * sigma for z in slow.z], [e * abs(sigma) for e in slow.e]
        (a, b), (c, d) = ((slice(x.up), slice(x.up, None)) for x in (slow, others))
        z, e = ([*x[a], *y[c], *x[b], *y[d]] for x, y in ((z, others.z), (e, others.e)))
        return Apart(others.local, z, slow.up + others.up, e, [], [])


def alone(sizes: Sequence[Any], slope: Any) -> Any:
    """e < e': exactly one |u| < e' solves Σ E_i u^i = 0, and it has |u| ≤ e, where |E_i| ≤ sizes_i, but E_1 is, to
    within its size, a number of modulus ≥ slope; by Rouché."""
    require(slope > 0, "p-roots meet")
    row = [x / slope for x in sizes]
    e = (row[0] * 1.5 + arb(2) ** (-4 * flint.ctx.prec)).upper()
    for _ in range(12):
        image = horner(row, e)
        if image < e:
            return image.upper()
        e = (image * 1.6).upper()
    raise Refused(APART)


def min_bound(x: Any, y: Any) -> Any:
    """The smaller of two upper bounds, whichever balls decide; x where they do not."""
    return y.upper() if y < x else x


# --- the characteristic function --------------------------------------------------------------------------

Forms = tuple[list[Any], Any]  # a matrix of forms: the matrices of their coefficients, and that of their rests


class Bordered:
    """Δ̂ = det [[S, −B], [Bᵀ, G + h]] with the rows of neutral coordinates divided by σ, up to a constant.

    Contacts that are tight and alone on a body with no other contact are direct: their bodies y = −(Gλ)/b are
    eliminated. Rows: all bodies, then the contacts that are not direct; columns: the bodies that are left, then λ.
    """

    def __init__(self, vehicle: Bodies, waves: Waves) -> None:
        nb, nc = vehicle.B.nrows(), len(vehicle.h)
        self.vehicle, self.waves, self.nb, self.nc = vehicle, waves, nb, nc
        direct = direct_contacts(vehicle)
        kept = [i for i in range(nb) if i not in direct.values()]
        indirect = [j for j in range(nc) if j not in direct]
        self.size, left = nb + len(indirect), len(kept)
        zero = (0,) * len(waves.d.exponents[0])
        entries: dict[Exponents, Any] = {zero: fmpq_mat(self.size, self.size)}
        own = [[self.entry(i, j) for j in range(nb)] for i in range(nb)]
        put = [(i, k, e, c) for i in range(nb) for k, j in enumerate(kept) for e, c in own[i][j].items()]
        put += [(i, left + j, zero, -vehicle.B[i, j]) for i in range(nb) for j in range(nc)]
        for i, j in enumerate(indirect, nb):
            put += [(i, k, zero, vehicle.B[body, j]) for k, body in enumerate(kept)]
            put += [(i, left + j, (0, *e), c) for e, c in vehicle.h[j].items()]
        for i, k, e, c in put:
            entries.setdefault(e, fmpq_mat(self.size, self.size))[i, k] = c
        self.constant = [(e, acb_mat(a), moduli(acb_mat(a))) for e, a in entries.items()]
        # the columns of λ: in each row the sum of (factor, number of a contact): factor·G(x_contact − x_j) at j
        factors: list[Free] = []
        self.links: list[list[tuple[int, int]]] = []
        for i in range(self.size):
            row: list[tuple[int, Free]] = [(indirect[i - nb], {zero: fmpq(1)})] if i >= nb else []
            for j, body in direct.items() if i < nb else ():
                row.append((j, {e: -c / vehicle.B[body, j] for e, c in own[i][body].items()}))
            for _, f in row:
                factors += [f] if f and f not in factors else []
            self.links.append([(factors.index(f), j) for j, f in row if f])
        self.factors = Sums.of(factors)
        used = sorted({(f, g) for row in self.links for f, j in row for g in waves.index[j]})
        self.used, number = list(zip(*used, strict=True)), {pair: n for n, pair in enumerate(used)}
        # each layer: for every entry of the matrix the number of one product of a factor and a G that it has, or none
        self.layers = [[len(used)] * self.size**2 for _ in range(max(map(len, self.links)))]
        for i, link in enumerate(self.links):
            for layer, (n, j) in zip(self.layers, link, strict=False):
                layer[i * self.size + left : (i + 1) * self.size] = [number[n, g] for g in waves.index[j]]

    def entry(self, i: int, j: int) -> Free:
        """S_ij in σ and the parameters."""
        v = self.vehicle
        less = int(i >= self.nb - v.neutral)
        parts = [(power - less, e, a[i, j]) for power, part in enumerate(reversed(v.parts)) for e, a in part.items()]
        return {(power, *e): c for power, e, c in parts if c != 0}

    def __call__(self, place: Place, G: Form) -> Forms:
        """The matrix over a place."""
        some, gaps = self.used
        products = joined([place.value(self.factors).take(some) * G.take(gaps), place.number(0)])
        total = sum(map(products.take, self.layers[1:]), products.take(self.layers[0]))
        A, E = [acb_mat(self.size, self.size, row) for row in total.k], arb_mat(self.size, self.size, total.e)
        for e, a, size in self.constant:
            if not any(e):
                A[0] = A[0] + a
                continue
            f = place.monomial(e)
            A = [x if y[0].is_zero() else x + a * y[0] for x, y in zip(A, f.k, strict=True)]
            E = E + size * f.e[0]
        return A, E

    def beside_pole(self, place: Place, H: Form, g: Form, pole: Any) -> Forms:
        """A matrix with the determinant Δ̂/g up to a constant.

        With μ = g Σ e^{−pole·x_j} λ_j as one more unknown, Gλ = e^{pole·x} μ + (the part of H).
        """
        (A, E), corner = self(place, H), g.inverse()
        ahead = [(pole * arb(at(x, ()))).exp() for x in self.vehicle.places]
        mixed = acb_mat(self.size, self.factors.matrix.nrows())
        for i, row in enumerate(self.links):
            for f, j in row:
                mixed[i, f] += ahead[j]
        column = place.form(mixed * place.taylor(self.factors))
        low = [acb(0)] * (self.size - self.nc) + [-1 / x for x in ahead]
        full = [
            [[*line, x] for line, x in zip(a.tolist(), more, strict=True)]
            + [[*(low if not k else [0] * self.size), *end]]
            for k, (a, more, end) in enumerate(zip(A, column.k, corner.k, strict=True))
        ]
        rest = [[*line, x] for line, x in zip(E.tolist(), column.e, strict=True)] + [[*[0] * self.size, *corner.e]]
        return [acb_mat(a) for a in full], arb_mat(rest)


def direct_contacts(vehicle: Any) -> dict[int, int]:
    """Each contact that is tight and alone on a body with no other contact, and that body."""
    nb, nc = vehicle.B.nrows(), len(vehicle.h)
    touched = [[j for j in range(nc) if vehicle.B[i, j] != 0] for i in range(nb)]
    out = {}
    for j in range(nc):
        bodies = [i for i in range(nb) if j in touched[i]]
        if not vehicle.h[j] and len(bodies) == 1 and touched[bodies[0]] == [j]:
            out[j] = bodies[0]
    return out


def contracting(E: Any) -> bool:
    """E x < x for some x > 0, for a matrix of moduli."""
    return bool(near_weights(E, 1.0)[1] < 1)


def near_weights(E: Any, goal: float) -> tuple[list[Any], Any]:
    """x > 0 by power iteration, each in its own unit, and a bound of max (E x)_i/x_i, for a matrix of moduli."""
    n = E.nrows()
    x, best = arb_mat(n, 1, [1] * n), None
    for _ in range(14):
        y = (E * x).entries()
        eta = max_bound(*(a / b for a, b in zip(y, x.entries(), strict=True)))
        if best is None or eta < best[1]:
            best = x.entries(), eta
        if eta < goal:
            break
        weights = [float(a) + 0.02 * float(b) for a, b in zip(y, x.entries(), strict=True)]
        if not all(b > 0 for b in weights):  # a bound's ball may have a middle below 0
            break
        x = arb_mat(n, 1, weights)
    return best or ([], arb(0))


def moduli(a: Any) -> Any:
    """Upper bounds of the moduli of the entries."""
    return arb_mat(a.nrows(), a.ncols(), [x.abs_upper() for x in a.entries()])


@lru_cache(maxsize=64)
def identity(n: int) -> Any:
    return acb_mat(n, n, [int(i == j) for i in range(n) for j in range(n)])


def near_inverse(a: Any) -> Any:
    """About the inverse, exact numbers, or none (nan), with which no bound holds: nothing rests on it."""
    a = a.mid()
    try:
        return a.solve(identity(a.nrows()), algorithm="approx").mid()
    except ZeroDivisionError:
        raise Refused("the matrix is singular in the middle of a piece") from None


def pivots(a: Any) -> Iterator[Any]:
    """Those of an elimination on the diagonal, in order."""
    for block in diagonal(a):
        rows = block.tolist()
        for k, row in enumerate(rows):
            yield row[k]
            for low in rows[k + 1 :]:
                factor = low[k] / row[k]
                for j in range(k + 1, len(rows)):
                    low[j] = low[j] - factor * row[j]


def turn_of(a: Any) -> Any:
    """Σ Arg of the pivots."""
    return sum((x.arg() for x in pivots(a)), ZERO)


def diagonal(a: Any) -> Iterator[Any]:
    """Small blocks that have the pivots of an elimination on the diagonal: a leading block, then what is left.

    The Schur complement of a leading block has the pivots that elimination finds after those of the block.
    """
    n = a.nrows()
    if n <= SMALL:
        yield a
        return
    rows, k = a.tolist(), n // 2
    one, two = ([row[part] for row in rows[:k]] for part in (slice(k), slice(k, n)))
    three, four = ([row[part] for row in rows[k:]] for part in (slice(k), slice(k, n)))
    block = acb_mat(one)
    try:
        left = acb_mat(four) - acb_mat(three) * block.solve(acb_mat(two))
    except ZeroDivisionError:
        raise Refused("a pivot may vanish") from None
    yield from diagonal(block)
    yield from diagonal(left)


# --- walking along the paths ------------------------------------------------------------------------------


@dataclass(repr=False, eq=False)
class Mark:
    """A point of a path, and the pair or p-roots of a disc that holds it; p-roots at the point once they are needed.

    known: None at q = 0 where waves come to P = 0 there. matrices: a pole, and those of `Walker.over` for it.
    """

    q: Point
    known: Any
    thin: Any = None
    matrices: tuple[Any, list[Any]] = (None, [])

    @cached_property
    def sigma(self) -> Any:
        return at_q(self.q)


JOIN = "the splitting does not join on to its neighbour's"
KERNELS = 1_000  # so many are taken at once, of all pieces of a path or of some


@dataclass(repr=False, eq=False)
class Walker:
    """Carries the splitting along the paths, and proves each piece."""

    waves: Waves
    bordered: Bordered
    work: float = 0.0
    pieces: int = 0
    marks: dict[Point, Mark] = field(default_factory=dict)

    def spend(self, units: float) -> None:
        self.work += units
        require(self.work < MAX_WORK, "the certificate asks for more work than this verifier does")

    def near(self, sigma: Any) -> Local:
        return self.waves.near(Place.disc(sigma, ZERO))

    def begin(self, depth: Any) -> None:
        """The pair at q = −i·depth is (roots with Re P < 0, the others): each root in a disc on its side."""
        at = (fmpq(0), -depth)
        split = nodes_near(self.near(at_q(at))).split()
        require(sided(split), REAL)
        self.marks[at] = Mark(at, split)

    def thin(self, mark: Mark) -> Apart:
        """The p-roots at a mark, those of the pair that is known there."""
        if mark.thin is None:
            found = apart_near(self.near(mark.sigma), mark.known.near(mark.sigma))
            require(mark.known.holds(found), JOIN)
            mark.thin = found
        return mark.thin  # type: ignore[no-any-return]

    def over(self, place: Place, G: Form, g: Form, pole: Any) -> list[Forms]:
        """Matrices over a place whose determinants have the product Δ̂, up to a constant: next to a branch point,
        where P = pole is nearly double, of Δ̂/g and of g, which have no pole that differs from theirs."""
        if pole is None:
            return [self.bordered(place, G)]
        return [self.bordered.beside_pole(place, G, g, pole), ([acb_mat([row]) for row in g.k], arb_mat([g.e]))]

    def matrices(self, mark: Mark, pole: Any) -> list[Any]:
        """Those at a mark."""
        if mark.matrices[0] is not pole or not mark.matrices[1]:
            ((place, G, g),) = self.kernels([ZERO if mark.known is None else self.thin(mark)], pole)
            mark.matrices = pole, [a for (a,), _ in self.over(place, G, g, pole)]
        return mark.matrices[1]

    def kernels(self, found: Sequence[Any], pole: Any) -> list[tuple[Place, Form, Form]]:
        """Of p-roots over places, or of radii of discs round q = 0: each place, and `kernels` over it."""
        apart = [one for one in found if isinstance(one, Apart)]
        known, out = iter(kernels(self.waves, apart, pole) if apart else ()), []
        for one in found:
            if isinstance(one, Apart):
                out.append((one.local.place, *next(known)))
            elif self.origin is not None:
                G = self.origin.kernels(one)
                out.append((Place.disc(acb(0), one), G, G))
        return out

    def chain(self, kind: str, points: Sequence[Point], pole: Any = None) -> tuple[list[Mark], list[list[Turn]]]:
        """Proves every piece of a path: the marks at its points and, for "turn", the turns of each piece."""
        marks, turns, told = [self.marks[points[0]]], list[list[Turn]](), partial(in_piece, kind, points)
        batch = max(1, KERNELS // len(self.waves.gaps))
        for first in range(0, len(points) - 1, batch):
            found = {}
            for k, b in enumerate(points[first + 1 : first + batch + 1], first):
                with told(k):
                    end, found[k] = self.piece(kind, marks[-1], b)
                marks.append(end)
            if kind == "link":
                continue
            for k, (place, G, g) in zip(found, self.told_kernels(found, pole, told), strict=True):
                with told(k):
                    if kind == "turn":
                        turns.append([Turn.over(part, place) for part in self.over(place, G, g, pole)])
                    else:
                        self.passive(place, (marks[k + 1].sigma - marks[k].sigma) / (2 * place.half[0]), G)
        return marks, turns

    def told_kernels(
        self, found: dict[int, Any], pole: Any, told: Callable[[int], Any]
    ) -> list[tuple[Place, Form, Form]]:
        """`kernels`; a refusal says of which piece."""
        try:
            return self.kernels(list(found.values()), pole)
        except Refused:
            out = []
            for k, one in found.items():
                with told(k):
                    out += self.kernels([one], pole)
            return out

    def path(self, path: Path) -> Any:
        """Proves every piece; the change of arg Δ̂ along the path, for "turn"."""
        marks, turns = self.chain(path.kind, path.points)
        self.marks |= {mark.q: mark for mark in marks}
        return self.turned(marks, turns) if path.kind == "turn" else arb(0)

    def turned(self, marks: Sequence[Mark], turns: Sequence[Sequence[Turn]], pole: Any = None) -> Any:
        """The change of arg Δ̂ along pieces that follow each other."""
        total = arb(0)
        for k, row in enumerate(zip(*turns, strict=True)):
            total += turned_one(marks, row, partial(lambda k, mark: self.matrices(mark, pole)[k], k))
        return total

    def around(self, loop: Loop, pole: Any) -> tuple[Any, Any]:
        """The change of arg Δ̂ along a loop that comes back to its pair, and along its first part; the mark there."""
        marks, turns = self.chain("turn", loop.points, pole)
        first, last, back = marks[0], marks[-1], loop.back
        self.marks[loop.points[back]] = marks[back]
        same = self.thin(first).holds(self.thin(last))
        require(same, "a loop does not come back to the splitting that it began with")
        return self.turned(marks, turns, pole), self.turned(marks[: back + 1], turns[:back], pole)

    def piece(self, kind: str, mark: Mark, b: Point) -> tuple[Mark, Any]:
        """From a mark to b: what is known at b, and over the disc over both, linked with what was known before."""
        n, size = self.waves.track.degree, self.bordered.size
        self.pieces += 1
        self.spend(60 * n**2 + (0 if kind == "link" else 12 * n * len(self.waves.gaps) + 100 * n**2 + size**3 / 3))
        require(mark.q != b, "two points of a path are the same")
        end = Mark(b, None)
        if self.origin is not None and (0, 0) in (mark.q, b):
            return end, self.at_origin(self.origin, kind, mark, end)
        m = (mark.sigma + end.sigma) / 2
        local = self.waves.near(Place.disc(m, wide(end.sigma - m)))
        end.known = (split_near if kind == "link" else apart_near)(local, mark.known.near(m))
        require(self.joins(mark, end.known), JOIN)
        return end, end.known

    def joins(self, mark: Mark, found: Any) -> bool:
        """Whether the pair, or p-roots, of a disc with the mark in it are what is known there."""
        known, at = mark.known, mark.sigma
        if isinstance(found, Apart):
            return known.holds(found) or found.holds(self.thin(mark))
        if isinstance(known, Apart):
            return bool(found.holds(self.thin(mark)))
        if found.links(known, at):
            return True
        thin = split_near(self.near(at), known.near(at))
        return bool(known.links(thin, at) and found.links(thin, at))

    @cached_property
    def origin(self) -> Origin | None:
        """What stands for a splitting at q = 0 where D has no terms of first order."""
        return Origin(self.waves) if min(i + j for i, j in self.waves.track.d) > 1 else None

    def at_origin(self, origin: Origin, kind: str, mark: Mark, end: Mark) -> Any:
        """A piece with one end at q = 0: the radius of a disc round 0 that holds the other."""
        require(kind != "passive", "a passive piece ends at q = 0, where waves come to P = 0")
        other = mark if end.q == (0, 0) else end
        if other is end:
            end.known = end.thin = apart_near(self.near(end.sigma), origin.at(end.sigma, ZERO).known)
        r = wide(other.sigma)
        require(origin.at(other.sigma, r).holds(self.thin(other)), "the splitting does not join on to q = 0")
        return r

    def passive(self, place: Place, direction: Any, G: Form) -> None:
        """The Hermitian part of V = σ(G_ij), over the places, is positive definite on u = direction·(−1 … 1)."""
        V = place.power(0, 1).take([0] * len(G.e)) * G
        fine = definite(*hermitian(V, self.waves.between, [acb(1), direction]))
        require(fine, "the receptance is not proved passive on it: it is too long, or not passive")


@contextmanager
def in_piece(kind: str, points: Sequence[Point], k: int) -> Iterator[None]:
    """A refusal says in which piece of a path it was."""
    try:
        yield
    except Refused as error:
        x, y = (float(arb(c)) for c in points[k])
        raise Refused(f"piece {k} of a path ({kind}), from q = {x:.6g}{y:+.6g}i: {error}") from None


def wide(half: Any) -> Any:
    """The radius of the disc of a piece whose middle is so far from its ends."""
    return (abs(half) * arb(1 + 2.0**-12)).upper()


def hermitian(F: Form, index: Sequence[Sequence[int]], turns: Sequence[Any]) -> Forms:
    """The Hermitian parts of the matrices F_index, each coefficient times its number, and bounds of their rests."""
    H = []
    for row, turn in zip(F.k, turns, strict=True):
        a = acb_mat([[row[g] * turn for g in line] for line in index])
        H.append((a + a.conjugate().transpose()) * acb(0.5))
    E = arb_mat([[F.e[g] for g in line] for line in index])
    return H, (E + E.transpose()) * arb(0.5)


def definite(H: Sequence[Any], E: Any) -> bool:
    """Whether H_0 + Σ ε_k H_k + R > 0 is proved for all |ε_k| ≤ 1 and all Hermitian |R| ≤ E entry by entry.

    The (ε_k) at which it is > 0 with one R are a convex set: corners C are enough. C > 0 by its pivots, and C + sR is
    regular for 0 ≤ s ≤ 1: so it stays > 0.
    """
    first, *others = H
    for a in others[CORNERS:]:
        E = E + moduli(a)
    ends = [first]
    for a in others[:CORNERS]:
        ends = [y for end in ends for y in (end + a, end - a)]
    try:
        return all(all(y.real > 0 for y in pivots(C)) and stays_regular(C, E) for C in ends)
    except Refused:
        return False


def stays_regular(A: Any, E: Any) -> bool:
    """Whether A + R is regular for all |R| ≤ E entry by entry: |X(A + R) − 1| contracts, X near 1/A."""
    X = near_inverse(A)
    return contracting(moduli(X * A - identity(A.nrows())) + moduli(X) * E)


@dataclass(repr=False, eq=False)
class Turn:
    """det A ≠ 0 on a disc |σ − m| ≤ r: R A is near 1, so that arg det R A is the sum of Arg over its pivots.

    It is `near`(σ) to within `lost` (SPEC2, 4.6; nan if that is not bounded).
    """

    place: Place
    R: Any
    slope: Any
    lost: Any

    @classmethod
    def over(cls, matrix: Forms, place: Place) -> Turn:
        """From A over a disc."""
        (A, slope), rest = matrix
        R = near_inverse(A)
        one = identity(R.nrows())
        near, ahead, rest = R * A - one, R * slope, moduli(R) * rest
        E = moduli(near) + moduli(ahead) + rest
        require(contracting(E), "the determinant may vanish on it: it is too long, or meets a root")
        lost = abs(near.trace()) + rest.trace() - (one.real - E).det().log() - E.trace()
        return cls(place, R, ahead.trace(), lost)

    def sharp(self, a: Any) -> Any:
        """arg det R A at one point of the disc, from A there."""
        return turn_of(self.R * a)

    @cached_property
    def det(self) -> Any:
        """det R, by halves where they leave enough digits: FLINT takes three times as long."""
        out = acb(1)
        try:
            for block in diagonal(self.R):
                out *= block.det()
        except Refused:
            return self.R.det()
        return self.R.det() if out.contains(0) or out.rel_accuracy_bits() < 30 else out

    def near(self, sigma: Any) -> Any:
        return (self.slope * (sigma - self.place.middle[0]) / self.place.half[0]).imag


def turned_one(marks: Sequence[Mark], turns: Sequence[Turn], matrix: Callable[[Mark], Any]) -> Any:
    """Of one determinant: from piece to piece arg det R A jumps by what the determinants of R say, but for whole
    turns, which rough bounds tell. Where they do not, A is taken there."""
    total, i, last = turns[-1].sharp(matrix(marks[-1])) - turns[0].sharp(matrix(marks[0])), 0, len(turns) - 1
    while i < last:
        about, lost, j = arb(0), turns[i].lost, i
        while j < last and lost + turns[j + 1].lost < 3:
            at = marks[j + 1].sigma
            about += turns[j].near(at) - turns[j + 1].near(at)
            j += 1
            lost += 2 * turns[j].lost
        known = (turns[i].det / turns[j].det).arg()
        whole = ((about + arb(0, 3) - known) / (2 * arb.pi())).unique_fmpz() if j > i else None
        if whole is None:
            here = matrix(marks[i + 1])
            total += turns[i].sharp(here) - turns[i + 1].sharp(here)
            i += 1
        else:
            total += known + 2 * arb.pi() * int(whole)
            i = j
    return total


# --- the track alone: passive for all real q ≥ X, and decay at infinity -----------------------------------


def check_positive(f: Free, box: Box, product_below: Any, name: str, other: Free | None = None) -> None:
    """f > 0, or other > 0, on a box (where x·y ≤ product_below, if given): Bernstein coefficients and bisection."""
    degrees = [max(e[k] for e in f) for k in range(len(box))]
    steps = [prod(d + 1 for d in degrees[k + 1 :]) for k in range(len(box))]
    stack, number = [(box, 0)], 0
    while stack:
        here, depth = stack.pop()
        if product_below is not None and here[0][0] * here[1][0] > product_below:
            continue
        number += 1
        values = bernstein(f, here, arb_mat)
        if all(x > 0 for x in values) or (other and all(x > 0 for x in bernstein(other, here, arb_mat))):
            continue
        fine = (
            (other or not values[0] < 0)
            and number < MAX_BOXES / max(sum(degrees) + 2, len(values) / 100)
            and depth < 60
        )
        require(fine, f"the theorem at large q: {name}")
        near = [float(x) for x in values]
        moved = [
            sum(abs(near[i + s] - x) for i, x in enumerate(near) if i // s % (n + 1) < n)
            for s, n in zip(steps, degrees, strict=True)
        ]
        stack += [(half, depth + 1) for half in halved(here, moved.index(max(moved)))]


def in_block(t: Free, v: Free, k: int, m: int) -> tuple[Free, int]:
    """A polynomial in p, Ω at p = zq^γ, Ω = q − vp, γ = k/m, over q^{top/m}: in z, τ = q^{−1/m} and θ."""
    top = max(k * e[0] + m * e[1] for e in t)
    out: Free = {}
    for (i, j, *e), c in t.items():
        power: Free = {tuple(e): c}
        for a in range(j + 1):
            for own, x in power.items():
                key = (i + a, top - k * i - m * j + (m - k) * a, *own)
                out[key] = out.get(key, fmpq(0)) + x * comb(j, a)
            power = times(power, {f: -y for f, y in v.items()})
    return {e: c for e, c in out.items() if c != 0}, top


def check_tail(track: Track, theorem: Any, X: Any, sites: Sequence[Any]) -> None:
    """The receptance matrix is passive at all real q ≥ X: what a block of p absorbs exceeds what p ≥ q/v gives."""
    keys(theorem, "gamma blocks alpha omega envelope")
    C, v = dyadic(theorem["envelope"], "envelope"), track.v
    gap = min((b - a for a, b in pairwise(sites)), default=None)
    parts = absorption(RING, track.D, track.N)
    tail_alpha(theorem, 2, parts, {(): v}, v, X, gap, [(X / v, C)], (), own_damping(track))


def own_damping(track: Track) -> tuple[Any, int] | None:
    """(c, i) if the loaded field has the damping c p^i, even i ≥ 2, without which the track is passive too (6.2)."""
    entry = track.rows[track.loaded][track.loaded]
    i = max((i for i, j in terms(entry) if j == 1), default=0)
    c = terms(entry).get((i, 1), fmpq(0)) * (-1) ** (i // 2)
    if i < 2 or i % 2 or c <= 0:
        return None
    rows = [list(row) for row in track.rows]
    rows[track.loaded][track.loaded] = entry - RING.from_dict({(i, 1): c * (-1) ** (i // 2)})
    try:
        check_passive(RING, rows, ())
    except Refused:
        return None
    return c, i


def tail_alpha(
    content: Any,
    least_alpha: int,
    parts: Sequence[Any],
    v: Free,
    fastest: Any,
    Q: Any,
    gap: Any,
    bounds: Sequence[tuple[Any, Any]],
    box: Box,
    own: tuple[Any, int] | None = None,
) -> int:
    """α, if the theorem at large q (section 6.2) holds for q ≥ Q and all parameters of the box.

    parts: W and |D|². v ≤ fastest: the velocity. gap: the least distance of two places, None of one alone.
    bounds: (p₀, C), |W|/|D|² ≤ C p^−α for p ≥ p₀. own: (c, i), |N/D| ≤ 1/(|s| c p^i), of a track without parameters.
    """
    k, m = (integer(x, 0, 12, "gamma") for x in items(content["gamma"], 2, "gamma", 2))
    omega, alpha = dyadic(content["omega"], "omega"), integer(content["alpha"], least_alpha, 64, "alpha")
    blocks = [
        [dyadic(x, "a block") for x in items(one, 3, "a block", 3)] for one in items(content["blocks"], 200, "blocks")
    ]
    require(k <= m and m > 0 and blocks and min(omega, Q) > 0, "the theorem's numbers are out of range")
    require(all(z1 < z2 and kappa > 0 for z1, z2, kappa in blocks), "a block is empty")
    require(all(a[1] <= b[0] for a, b in pairwise(blocks)), "blocks overlap")
    require(all(p > 0 and C > 0 for p, C in bounds), "a bound is not positive")
    w, d = (terms(x) for x in parts)
    (block_w, top_w), (block_d, top_d) = (in_block(x, v, k, m) for x in (w, d))
    x = arb(Q)
    growth, tau = x ** arb(fmpq(k, m)), no_less(x ** arb(fmpq(-1, m)))
    between = 2 * arb.pi() / arb(gap) if gap is not None else arb(0)
    require(arb(fastest * blocks[-1][1]) * growth < x, "the blocks reach to where the track gives")
    for z1, z2, kappa in blocks:
        difference = minus(block_w, {e: kappa * c for e, c in block_d.items()})
        check_positive(difference, ((z1, z2), (fmpq(0), tau), *box), None, "a block absorbs less than kappa")
    iw, id_ = (max(e[0] for e in t) for t in (w, d))
    nw, nd = (max(e[0] + e[1] for e in t) for t in (w, d))
    require(alpha <= min(id_ - iw, nd - nw), "alpha is too large")
    for p0, C in bounds:
        near: Free = {}
        far: Free = {}
        for source, factor, less in ((d, C, 0), (w, fmpq(1), alpha)):
            for (i, j, *e), c in source.items():
                for chart, key in ((near, (id_ - less - i, j, *e)), (far, (id_ - less - i, nd - less - i - j, *e))):
                    chart[key] = chart.get(key, fmpq(0)) + factor * c * (-1) ** j
        give = "the giving part may exceed the envelope"
        near_own: Free | None = None
        far_own: Free | None = None
        if own is not None and own[1] >= alpha:
            c, left = own[0] * C, own[1] - alpha
            near_own, far_own = {(0, 1): c, (left, 0): fmpq(-1)}, {(0, 0): c, (left, left + 1): fmpq(-1)}
        check_positive(near, ((fmpq(0), 1 / p0), (fmpq(0), omega), *box), fastest, give, near_own)  # u·(−Ω) ≤ v
        check_positive(far, ((fmpq(0), fastest), (fmpq(0), 1 / omega), *box), 1 / p0, give, far_own)
    known = [arb(C) for p0, C in bounds if p0 * fastest <= Q]
    require(known, "short waves are not bounded beyond Q")
    turn = arb(Q / fastest)
    absorbed = sum(((arb(z2 - z1) * growth - between) * arb(kappa) for z1, z2, kappa in blocks), arb(0))
    takes = absorbed * x ** arb(fmpq(top_w - top_d, m))
    gives = known[-1] * (turn ** (1 - alpha) / (alpha - 1) + between * turn ** (-alpha))
    require(takes > gives, "the theorem at large q: the blocks do not absorb what the rest may give")
    require(
        (alpha - 1) * m >= top_d - top_w - k, "the theorem at large q: absorption falls faster than what is given"
    )
    return alpha


def no_less(x: Any) -> Any:
    """A rational number that is no less, with few digits."""
    mantissa, exponent = x.upper().man_exp()
    return fmpq(int(mantissa)) * power_of_2(int(exponent))


def check_decay(ring: Any, D: Any, N: Any, v: Any) -> None:
    """G(ξ, σ) → 0 as σ → ∞: on each edge of the Newton polygon roots P ~ cσ^θ are simple, and weights N/D_P fall.

    Roots with s = σ − vP = o(σ) (several have c = 1/v) are taken in s and σ, P = (σ − s)/v. With parameters: for all
    of them but those of a set without inner points (over their rational functions).
    """
    P, s, *x = ring.gens()
    d, n = (p.compose(P, s - v * P, *x, ctx=ring) for p in (D, N))
    check_edges(d, n, v, ring, False)
    slow = []
    for p in (D, N):  # at P = (σ − s)/v, times a power of v
        terms, top = p.to_dict(), max(int(e[0]) for e in p.to_dict())
        total = ring.constant(0)
        for (i, j, *e), c in terms.items():
            total += c * (s - P) ** int(i) * v ** (top - int(i)) * P ** int(j) * monomial(x, list(map(int, e)))
        slow.append(total)
    check_edges(slow[0], slow[1], v, ring, True)


def check_edges(d: Any, n: Any, v: Any, ring: Any, slow: bool) -> None:
    """The edges of Newton's polygon of d (of exponent θ < 1 only, if slow; else without roots 1/v where θ = 1)."""
    at_: dict[tuple[int, int], dict[Any, Any]] = {}
    for (i, j, *e), c in d.to_dict().items():
        at_.setdefault((int(i), int(j)), {})[(0, 0, *e)] = c
    top: dict[int, int] = {}
    for i, j in at_:
        top[i] = max(top.get(i, j), j)
    support = {(int(e[0]), int(e[1])) for e in n.to_dict()}
    P, i = ring.gens()[0], 0
    while i < max(top):
        slope = max(fmpq(top[a] - top[i], a - i) for a in top if a > i)  # −θ
        on = {a for a, b in top.items() if a >= i and b - top[i] == slope * (a - i)}
        edge = sum((ring.from_dict(at_[a, top[a]]) * P ** (a - i) for a in on), ring.constant(0))
        if slope == -1:
            while True:
                quotient, rest = divmod(edge, 1 - v * P)
                if rest:
                    break
                edge = quotient
        if slope > -1 or not slow:
            common = edge.gcd(edge.derivative(0)) if edge.degrees()[0] else ring.constant(1)
            require(common.degrees()[0] == 0, "waves of one speed at high frequency: decay is not proved")
            weight = max(b - slope * a for a, b in support) - (top[i] - slope * i + slope)
            require(weight < 0, "the receptance does not decay at high frequency")
        i = max(on)


# --- regions ----------------------------------------------------------------------------------------------


@dataclass(repr=False, eq=False)
class Region:
    """Where the roots are counted. All numbers exact; height 0: only Im q < 0."""

    kind: str
    height: Any
    reach: Any = None
    re: tuple[Any, Any] | None = None
    im: tuple[Any, Any] | None = None

    @property
    def words(self) -> str:
        if self.kind == "sheet":
            return "any real part and any imaginary part, on the whole physical sheet (the plane without the cuts)"
        if self.re and self.im:
            return f"{self.re[0]} < Re q < {self.re[1]}, {self.im[0]} < Im q < {self.im[1]}"
        strip = f" or Im q < {self.height}, |Re q| < {self.reach}" if self.height > 0 else ""
        return "Im q < 0" + (f", |q| < {self.reach}" if "disc" in self.kind else "") + strip

    def holds(self, z: Point, r: Any) -> bool:
        """Whether the closed disc of radius r round z lies inside (that it meets no cut, its splitting shows)."""
        if self.kind == "sheet":
            return True
        if self.re and self.im:
            return bool(
                self.re[0] < z[0] - r and z[0] + r < self.re[1] and self.im[0] < z[1] - r and z[1] + r < self.im[1]
            )
        low = z[1] + r < 0
        within = "disc" not in self.kind or (r < self.reach and z[0] ** 2 + z[1] ** 2 < (self.reach - r) ** 2)
        if low or self.height == 0:
            return bool(low and within)
        return bool(z[1] + r < self.height and abs(z[0]) + r < self.reach and (within or z[1] - r >= 0))


def read_region(value: Any) -> Region:
    require(isinstance(value, dict) and isinstance(value.get("kind"), str), "the region has no kind")
    kind = value["kind"]
    names = {
        "unstable": "",
        "disc": "radius",
        "below": "height reach",
        "below disc": "height radius",
        "rectangle": "re im",
        "sheet": "",
    }
    require(kind in names, "the region's kind is not known to this verifier")
    keys(value, f"kind {names[kind]}")
    if kind == "rectangle":
        re_, im = (tuple(rational(x, "a side") for x in items(value[name], 2, name, 2)) for name in ("re", "im"))
        require(re_[0] < re_[1] and im[0] < im[1], "the rectangle is empty")
        return Region(kind, max(im[1], fmpq(0)), None, (re_[0], re_[1]), (im[0], im[1]))
    height = rational(value["height"], "height") if "height" in value else fmpq(0)
    reach = rational(value.get("radius", value.get("reach")), "radius") if names[kind] else None
    require(
        (height > 0 or "below" not in kind) and (reach is None or reach > 0), "a height or radius is not positive"
    )
    return Region(kind, height, reach)


@dataclass(repr=False, eq=False)
class Path:
    kind: str
    points: list[Point]


def read_paths(values: Any, kinds: str) -> list[Path]:
    out = []
    for value, kind in zip(items(values, 24, "paths", len(kinds.split())), kinds.split(), strict=True):
        keys(value, "kind points")
        require(value["kind"] == kind, f"a path is of another kind than {kind}")
        out.append(Path(kind, read_points(value["points"])))
    require(sum(len(p.points) - 1 for p in out) <= MAX_PIECES, "there are too many pieces")
    return out


def read_points(value: Any) -> list[Point]:
    points = [point(x) for x in items(value, MAX_PIECES + 1, "points")]
    require(points, "a path has no points")
    return points


def check_lines(points: Sequence[Point], corners: Sequence[Point]) -> None:
    """The points run along the polygon through the corners, in order, and hold each corner."""
    require(points[0] == corners[0], "a path begins elsewhere than its region asks")
    at, ahead = points[0], 1
    for z in points[1:]:
        require(ahead < len(corners), "a path goes on beyond its end")
        a, b = corners[ahead - 1], corners[ahead]
        direct = (b[0] - a[0], b[1] - a[1])
        step, rest = (z[0] - at[0], z[1] - at[1]), (b[0] - z[0], b[1] - z[1])
        straight = direct[0] * (z[1] - a[1]) == direct[1] * (z[0] - a[0])
        forward = all(x * direct[0] + y * direct[1] >= 0 for x, y in (step, rest)) and z != at
        require(straight and forward, "a point is not on the line that its region asks for, or not in order")
        at, ahead = z, ahead + (z == b)
    require(ahead == len(corners), "a path ends before its last corner")


def check_arc(points: Sequence[Point], radius: Any) -> None:
    """From (radius, 0) on each disc over neighbouring points holds the arc of |q| = radius between them, in one
    quarter."""
    require(points[-1] == (0, -radius), "the arc does not end on the imaginary axis")
    require(all(x >= 0 >= y for x, y in points), "a point of the arc is not in its quarter")
    for a, b in pairwise(points):
        m = acb(arb((a[0] + b[0]) / 2), arb((a[1] + b[1]) / 2))
        half = acb(arb((b[0] - a[0]) / 2), arb((b[1] - a[1]) / 2))
        r = abs(half) * arb(1 + 2.0**-12)
        for z in (a, b):
            w = acb(arb(z[0]), arb(z[1]))
            require(abs(w * (arb(radius) / abs(w)) - m) < r, "a piece's disc does not hold its arc")


KINDS = {
    "unstable": "link turn passive passive",
    "below": "link turn passive passive",
    "disc": "link turn",
    "below disc": "link turn",
    "rectangle": "link turn",
}


def check_paths(region: Region, paths: Sequence[Path], start: Any) -> None:
    """The paths are those that the region's count rests on."""
    zero = fmpq(0)
    link, turn = (p.points for p in paths[:2])
    require(link[0] == (zero, -start), "the first path does not begin at the start")
    require(all(y <= region.height for _, y in link), "a point of the first path is above the region")
    if region.re and region.im:
        (a, b), (c, d) = region.re, region.im
        require(link[-1] == (a, c), "the first path does not end at the rectangle's corner")
        check_lines(turn, [(a, c), (b, c), (b, d), (a, d), (a, c)])
        return
    require(
        link[-1] == (zero, region.height), "the first path does not end on the imaginary axis, at the region's height"
    )
    rho = region.reach if region.reach is not None else turn[-1][0]
    require(rho > 0, "rho is not positive")
    corner = (rho, zero)
    above_axis = [(zero, region.height), (rho, region.height)] if region.height > 0 else [(zero, zero)]
    require(corner in turn, "the path does not come to the real axis at its corner")
    where = turn.index(corner)
    check_lines(turn[: where + 1], [*above_axis, corner])
    if "disc" in region.kind:
        check_arc(turn[where:], rho)
        return
    require(where == len(turn) - 1, "the path goes on beyond its corner")
    if len(paths) == 2:
        return
    walls, axis = paths[2].points, paths[3].points
    d = walls[-1][1]
    require(d < 0, "the walls do not go down")
    check_lines(walls, [corner, (rho, d), (zero, d)])
    if len(axis) == 1:
        require(axis[0] == corner, "the path beyond the corner begins elsewhere")
    else:
        check_lines(axis, [corner, axis[-1]])
        require(axis[-1][1] == 0 and axis[-1][0] > rho, "the path beyond the corner leaves the real axis")


def accretive(b: Bordered, sigma: Any, G: Sequence[Any]) -> list[list[Any]]:
    """[[S/σ, −B], [Bᵀ, σ(G + h)]], the rows of neutral coordinates undivided."""
    v, nb, size = b.vehicle, b.nb, b.nb + b.nc
    M, C, K = map(acb_mat, v.numbers)
    S = (K * (1 / sigma) + C + M * sigma).tolist()
    a = [[*row, *[acb(0)] * b.nc] for row in S] + [[acb(0)] * size for _ in range(b.nc)]
    for i, j in product(range(nb), range(b.nc)):
        a[i][nb + j], a[nb + j][i] = acb(-arb(v.B[i, j])), acb(arb(v.B[i, j]))
    for i, row in enumerate(b.waves.index):
        for j, g in enumerate(row):
            a[nb + i][nb + j] = sigma * (G[g] + (arb(at(v.h[i], ())) if i == j else 0))
    return a


def closing(walker: Walker, mark: Mark) -> Any:
    """Σ Arg of the pivots of M = [[S/σ, −B], [Bᵀ, σ(G + h)]] at a mark σ = iρ: an accretive matrix.

    The more contacts, the more digits elimination loses: G is taken with as many as leave the sum sharp.
    """
    b, found, bits = walker.bordered, walker.thin(mark), flint.ctx.prec
    sharper = found
    for more in (1, 2, 4, 8, 16):
        with precision(bits * more):
            waves, sigma = Waves(walker.waves.track, b.vehicle.places), at_q(mark.q)
            try:
                if more > 1:
                    sharper = apart_near(waves.near(Place.disc(sigma, ZERO)), found.near(sigma))
                    require(found.holds(sharper), "sharper p-roots are not those of the mark")
                total = turn_of(acb_mat(accretive(b, sigma, kernels(waves, [sharper])[0][0].k[0])))
            except Refused:
                continue
            if total.is_finite() and total.rad() < 0.1:
                return total
    raise Refused("a pivot may vanish where the path comes to its corner")


def whole(number: Any) -> int:
    n = number.unique_fmpz()
    require(n is not None, "the change of the argument does not tell the number of roots")
    return int(n)


def count_roots(walker: Walker, region: Region, paths: Sequence[Path], theorem: Any, track: Track) -> int:
    """The number of roots in the region, proved."""
    passive = region.kind in ("unstable", "below")
    require((passive and track.v != 0) or theorem is None, "this region needs no theorem")
    turned = arb(0)
    for path in paths:
        turned += walker.path(path)
    pi, b = arb.pi(), walker.bordered
    if passive:
        with precision(128):
            check_passive_track(track)
            if track.v != 0:
                check_decay(RING, track.D, track.N, RING.constant(track.v))
                check_tail(track, theorem, paths[3].points[-1][0], b.vehicle.sites)
        rho = paths[1].points[-1][0]
        closed = closing(walker, walker.marks[rho, fmpq(0)])
        number = (closed + (b.nb - b.nc - b.vehicle.neutral) * pi / 2 - turned) / pi
    else:
        number = turned / (2 * pi) if region.kind == "rectangle" else -turned / pi
    return whole(number)


def check_behind(vehicle: Bodies, first: Mark) -> None:
    """No root in Im q < 0: no wave runs ahead of the one place that is touched (SPEC2, section 5)."""
    require(first.known.nodes.up == 0, "waves run ahead of the contacts")
    require(len(vehicle.sites) == 1, "the track is touched at several places")
    nc = vehicle.B.ncols()
    forces = vehicle.B.tolist() + [
        [fmpq(int(i == j and bool(h))) for j in range(nc)] for i, h in enumerate(vehicle.h)
    ]
    require(fmpq_mat(forces).rank() == nc, "contacts share a force that a rail at rest does not determine")


def count_behind(walker: Walker, region: Region, values: Any, start: Any, track: Track) -> int:
    """The number of roots in a half-plane, or below a height, where none is in Im q < 0."""
    require(region.kind in ("unstable", "below"), "this region needs no theorem")
    paths = read_paths(values, "link turn" if region.kind == "below" else "")
    if not paths:
        return 0
    disc = replace(region, kind="below disc")
    check_paths(disc, paths, start)
    return count_roots(walker, disc, paths, None, track)


# --- the whole sheet --------------------------------------------------------------------------------------


@dataclass(repr=False, eq=False)
class Sheet:
    """A beam whose cuts lie on Im q = height: undamped in τ = σ + height; the vehicles below and above that line."""

    height: Any
    track: Track
    lower: Bodies
    upper: Bodies

    @classmethod
    def of(cls, track: Track, vehicle: Bodies) -> Sheet:
        t = terms(track.D)
        known = set(t) <= {(4, 0), (2, 0), (0, 0), (0, 1), (0, 2)} and set(terms(track.N)) == {(0, 0)}
        sizes = [t.get((4, 0), 0), t.get((0, 2), 0), terms(track.N).get((0, 0), 0)]
        require(known and all(x > 0 for x in sizes), "the whole sheet is known for a beam on one layer only")
        height = t.get((0, 1), fmpq(0)) / (2 * t[0, 2])
        rows = [[x.compose(P_, S_ - height, ctx=RING) for x in row] for row in track.rows]
        undamped = moving_track(RING, rows, track.loaded, track.velocity)
        static = in_y(undamped.D.subs({"s": 0}))
        require(height >= 0 and positive(static, (), True), "the cuts do not lie on one line")
        require(vehicle.neutral == 0, "neutral coordinates are not known on this sheet")
        M, C, K = vehicle.numbers
        C, K = C - 2 * height * M, K - height * C + height * height * M
        lower, upper = (replace(vehicle, parts=[{(): a} for a in (M, sign * C, K)]) for sign in (1, -1))
        return cls(height, undamped, lower, upper)

    def along(self, square: Any) -> list[Any]:
        """EI y² + (T − m v²) y + k + m·square, ascending: D for real p = √y, or with −m z² for `square` at v = 0."""
        t = terms(self.track.D)
        return [t[0, 0] + t[0, 2] * square, -t.get((2, 0), fmpq(0)) - t[0, 2] * self.track.v**2, t[4, 0]]


@dataclass(repr=False, eq=False)
class Loop:
    """A closed path several times round the one branch point in |z − centre| ≤ radius, first below the real axis."""

    centre: Any
    radius: Any
    points: list[Point]

    def holds(self, z: Point) -> bool:
        return bool((z[0] - self.centre) ** 2 + z[1] ** 2 <= self.radius**2)

    @property
    def back(self) -> int:
        """After how many pieces the path is back on the real axis for the first time."""
        found = next((k for k, z in enumerate(self.points) if k and z[1] == 0), 0)
        require(all(y < 0 for _, y in self.points[1:found]), "a loop does not begin below the real axis")
        return found


def read_loops(values: Any) -> list[Loop]:
    out = []
    for value in items(values, 8, "loops"):
        keys(value, "centre radius points")
        loop = Loop(
            dyadic(value["centre"], "centre"), dyadic(value["radius"], "radius"), read_points(value["points"])
        )
        require(loop.radius < loop.centre, "a loop holds no branch point alone")
        require(all(map(loop.holds, loop.points)), "a loop leaves its disc")
        out.append(loop)
    return out


def check_loop(loop: Loop, track: Track, sites: int, walker: Walker) -> Any:
    """No root on any sheet round the one branch point in the disc: Δ̂ turns as often as its pole there asks.

    The change of arg Δ̂ along the first part of the loop, below the real axis, is what it gives to its path.
    """
    centre, radius = arb(loop.centre), arb(loop.radius)
    inside = []
    for square, times in meeting(track):
        for z in (square.sqrt(), -square.sqrt()):
            if not abs(z - centre) > radius:
                require(abs(z - centre) < radius, "a branch point may lie on the rim of a loop's disc")
                inside.append((z, times))
    require(len(inside) == 1, "a loop's disc does not hold one branch point alone")
    (z, times), at_rest = inside[0], track.v == 0 and (2, 0) not in terms(track.D)
    require(times < 3 or at_rest, "more p-roots meet in a loop than is known")
    turns, poles = (4, 4 if sites > 1 else 3) if times == 3 else (2, min(times, sites))
    winding = arb(0)
    for a, b in pairwise([acb(arb(x), arb(y)) - z for x, y in loop.points]):
        step = (b / a).arg()
        require(step > 0, "a loop does not go round its branch point counterclockwise")
        winding += step
    once = (len(loop.points) - 1) // turns
    same = loop.points[once:] == loop.points[: len(loop.points) - once] and turns * once == len(loop.points) - 1
    turned = (winding / (2 * arb.pi())).unique_fmpz()
    require(same and turned == turns, "a loop does not go round its branch point as it must")
    pole = None
    if times == 1:  # where the pair meets: any number would do, a near one serves
        beside = (z + radius / 1024).mid()  # at z itself two are one
        p = p_roots(walker.waves.near(Place.disc(acb(0, 1) * beside, ZERO)))
        near = min(combinations(p, 2), key=lambda two: abs(complex(two[0] - two[1])))
        pole = acb(0, (near[0] + near[1]).imag / 2).mid()
    whole, part = walker.around(loop, pole)
    require((whole / (2 * arb.pi())).unique_fmpz() == -poles, "a root lies next to a branch point")
    return part


def meeting(track: Track) -> list[tuple[Any, int]]:
    """The z² at which p-roots meet, z = −iσ, in balls, with multiplicities: roots of the discriminant, even in σ."""
    moved, squares = track.D.compose(P_, S_ - track.v * P_, ctx=RING), [fmpq(0)] * 13
    for (_, j), c in terms(moved.discriminant("P")).items():
        squares[j // 2] += c * (-1) ** (j // 2)
    found: list[Any] = list(fmpq_poly(squares).complex_roots())
    return found


def check_far(sheet: Sheet, walker: Walker, rho: Any) -> Any:
    """How arg Δ̂ changes along the edge from ρ to infinity, and on below it to −i∞; no root is on that edge (8.5)."""
    t, v, eta, bodies = terms(sheet.track.D), sheet.track.v, sheet.height, sheet.lower
    n, B, sites, (M, C, K) = len(bodies.h), bodies.B, bodies.sites, bodies.numbers
    single = B.nrows() == n and all(sum(x != 0 for x in row) == 1 for a in (B, B.transpose()) for row in a.tolist())
    diagonal = all(i == j or M[i, j] == 0 for i in range(n) for j in range(n))
    rigid = all(a == a * 0 for a in (C + 2 * eta * M, K - eta**2 * M)) and not any(bodies.h)
    require(single and diagonal and rigid, "the theorem far out is known for tight masses only")
    require(rho > eta, "damping is not small far out")
    EI, m = t[4, 0], t[0, 2]
    active, c0 = arb(2 * rho * eta / (rho**2 - eta**2)), arb(EI / m).sqrt()
    steep, pull, top = m * v * v / EI, (t.get((2, 0), fmpq(0)) + m * v * v) / EI, (c0 / arb(rho)).upper() / PARTS
    parts = [far_waves(steep, pull, t[0, 0] / EI, (top * i).union(top * (i + 1))) for i in range(PARTS)]
    (low, _, decay), (high, skew, _) = (list(map(end, *parts)) for end in (min_lower, max_bound))
    require(1 + low > (1 + active * active) * skew, "waves far out are not what they tend to")
    r = (1 / (1 + low).sqrt()).upper()
    floor, Z, lost, rest = arb(1), r, arb(0), len(sites) - 1
    for _ in range(rest):
        left = 1 - r * Z
        require(left > 0, "the masses may reflect more than they get")
        floor *= left
        passive = (Z + r) / (1 + r * Z) if Z <= 1 else (1 + (1 - r * r) * (Z * Z - 1) / (left * left)).sqrt()
        Z = (passive + 2 * active * Z / left).upper()
    if rest:
        gap = arb(min(y - x for x, y in pairwise(sites))) * (arb(rho) / c0).sqrt()
        small, most = r * high.sqrt() * (-decay * gap).exp(), r * (skew.sqrt() + (skew - 1).upper().sqrt())
        row = (1 + rest * (most + small) * (most + small)).sqrt()
        lost = len(sites) * arb(rest).sqrt() * small * row**rest / floor
        require(lost < 1, "evanescent waves may cancel the others far out")
    masses = [fmpq(0)] * len(sites)
    for j, place in enumerate(bodies.places):
        masses[sites.index(at(place, ()))] += sum(M[i, i] / B[i, j] ** 2 for i in range(n) if B[i, j] != 0)
    return arb(0, lost.upper().asin().upper()) - far_argument(
        walker.thin(walker.marks[rho, fmpq(0)]), acb(-arb(eta), arb(rho)), list(zip(sites, masses, strict=True))
    )


def far_waves(steep: Any, pull: Any, stiff: Any, y: Any) -> tuple[Any, Any, Any]:
    """|w_e|²/αβ, (α + β)²/4αβ, and the rate of decay over λ, for all y = 1/λ² of a ball (8.5)."""
    square = arb(4)
    for _ in range(12):
        wide = arb(square.mid(), (2 * square.rad() + arb(2) ** -40).upper())
        step = y * (4 * steep / wide - pull)
        square = step * step + 4 * (1 - stiff * y * y)
        require(square > 0, "waves far out are not what they tend to")
        if wide.contains(square):
            break
    else:
        raise Refused("waves far out are not bounded")
    s, b = square.sqrt(), 4 * steep * y / square
    x = b - 2 * pull * y
    out = (2 * s - x) / (2 * s + x), (s + b) * (s + b) / (square + 2 * b * (b - pull * y)), (2 * s + x).sqrt() / 2
    fine = 2 * s - x > 0 and 2 * s + x > 0 and all(one.is_finite() for one in out)
    require(fine, "it is open which waves travel far out")
    return out


def far_argument(found: Apart, sigma: Any, masses: Sequence[tuple[Any, Any]]) -> Any:
    """Of (place, mass) at ρ: Arg of σ² and d of each, and of 1 + g⁻z from the last one on."""
    P, weight = (f.k[0] for f in residues([found], range(len(found.z))))
    travelling = []
    for side, sign in zip(found.sides, (1, -1), strict=True):
        waves = [(P[k], sign * weight[k]) for k in side if not sign * P[k].real < 0]
        require(len(waves) == 1, "the waves far out are not told apart")
        travelling += waves
    (a, ahead), (c, behind) = travelling
    at_contact = sum((weight[k] for k in found.sides[0]), acb(0))
    total, arriving, last = arb(0), acb(0), masses[-1][0]
    for x, mass in reversed(masses):
        arriving *= ((a - c) * arb(last - x)).exp()
        d = at_contact + 1 / (arb(mass) * sigma * sigma)
        factor = 1 + behind / d * arriving
        total += 2 * sigma.arg() + (-d).arg() - arb.pi() + factor.arg()
        arriving, last = (arriving * (1 - (ahead + behind) / d) - ahead / d) / factor, x
    return total


def min_lower(*values: Any) -> Any:
    """A lower bound of all of them, exact."""
    least = arb(values[0].lower())
    for x in values[1:]:
        least = least.min(arb(x.lower()))
    return least


def max_bound(*values: Any) -> Any:
    """An upper bound of all of them."""
    most = arb(0)
    for x in values:
        most = most.max(arb(x.upper()))
    return most


def count_sheet(sheet: Sheet, spent: Walker, content: Any, start: Any) -> int:
    """The number of roots on the physical sheet, proved; points are z = q − i height."""
    theorem, values, zero = content["theorem"], content["paths"], fmpq(0)
    keys(theorem, "begin end lower upper", "rest")
    begin, end = (dyadic(theorem[name], name) for name in ("begin", "end"))
    loops, above = read_loops(theorem["lower"]), read_loops(theorem["upper"])
    damped, one = sheet.height > 0, 2 + len(loops)
    rest = [dyadic(x, "rest") for x in items(theorem.get("rest", []), MAX_REST, "rest")]
    if rest:  # the paths begin beyond the branch points
        known = rest[0] == begin and rest[-1] == end and not loops and begin > 0
        require(known, "the way past the branch points begins or ends elsewhere")
    two = damped and end > begin and not rest
    paths = read_paths(values, "link" + " turn" * (one - 1) + (" link turn" + " turn" * len(above) if two else ""))
    passive = all(map(semidefinite, sheet.upper.numbers[1:]))
    require(passive, "above the cuts the vehicle is not passive")
    require(0 <= begin <= end, "the count begins or ends elsewhere")
    require(begin == 0 or in_gap(sheet, begin), "the count does not begin in the gap of the cuts")
    require(nonnegative(fmpq_poly(sheet.along(end**2)), False), "the track is not passive beyond the end")
    require(damped or not in_gap(sheet, end), "without damping the path ends on the cut, for both halves")
    require(two or not above, "loops without a path")
    waves = Waves(sheet.track, sheet.upper.places)
    below, up = Walker(waves, Bordered(sheet.lower, waves)), Walker(waves, Bordered(sheet.upper, waves))
    turned = arb(0)
    for bordered in (below.bordered, *([up.bordered] if damped else [])) if rest else ():
        turned += turn_at_rest(sheet, bordered, rest, spent)
    for walker, chain, rounds in [(below, paths[:one], loops), (up, paths[one:], above)]:
        if not chain:
            continue
        link, at = chain[0].points, (end if rest else begin, zero)
        require(link[0] == (zero, -start) and link[-1] == at, "a link does not lead to where the count begins")
        require(all(y <= 0 for _, y in link), "a link is above the line")
        walker.begin(start)
        walker.path(chain[0])
        for k, path in enumerate(chain[1:]):
            edge = path.points
            require(edge[0] == at, "a path does not begin where the one before ends")
            far = k == len(rounds) and damped and walker is below
            require(all(y == 0 for _, y in edge), "a path leaves the edge of the cut")
            require(k < len(rounds) or far or edge[-1][0] == end, "a path does not end where the count closes")
            turned += walker.path(path)
            turned += check_far(sheet, walker, edge[-1][0]) if far else 0
            if k < len(rounds):
                require(edge[-1] == rounds[k].points[0], "a path does not end where its loop begins")
                turned += check_loop(rounds[k], sheet.track, len(sheet.upper.sites), walker)
                at = rounds[k].points[rounds[k].back]
        spent.pieces += walker.pieces
    marks = (up if two else below).marks
    b, pi = up.bordered, arb.pi()
    closed = closing(up, marks[end, zero]) + (b.nb - b.nc) * pi / 2
    return whole((closed - turned) * (1 if damped else 2) / pi)


class Along(Place):
    """A disc of s, over which σ is a given form."""

    def stand(self, sigma: Form) -> Along:
        self.powers = [[self.number(1), sigma]]
        return self

    def value(self, polynomials: Sums) -> Form:
        rows = polynomials.matrix.tolist()
        parts = [self.monomial(e).take([0] * len(rows)) for e in polynomials.exponents]
        scaled = [f.scaled([row[n] for row in rows]) for n, f in enumerate(parts)]
        return sum(scaled[1:], scaled[0])


@dataclass(repr=False, eq=False)
class AtRest:
    """The edge of the cut in s, at v = 0: D = EI (P² + sP + π)(P² − sP + π) with 2π = s² + A, A = T/EI."""

    EI: Any
    A: Any
    k: Any
    m: Any

    def Q(self, z: Any) -> Any:
        """π² at z."""
        return (self.k - self.m * z * z) / self.EI

    def s(self, z: Any) -> Any:
        """On the edge seen from below: π and s are the roots with real parts above 0, or their limits."""
        Q, A = self.Q(z), self.A
        if Q < 0:
            return (acb(-arb(A), 2 * arb(-Q).sqrt())).sqrt()
        w = arb(Q).sqrt()
        square = arb(4 * Q - A * A) / (2 * w + arb(A)) if A > 0 else 2 * w - arb(A)
        return acb(square.sqrt()) if A <= 0 or 4 * Q > A * A else acb(0, (-square).sqrt())

    def disc(self, a: Any, b: Any) -> Place:
        """A disc that holds the image of a ≤ z ≤ b: real, then imaginary, then on the hyperbola Re s² = −A."""
        Q, last, A = self.Q(a), self.Q(b), self.A
        ends, arc = [self.s(a), self.s(b)], []
        if A >= 0 and 4 * Q >= A * A >= 4 * last:
            ends.append(acb(0))
        if Q >= 0 > last:
            ends.append(acb(-arb(A)).sqrt())
        if last < 0 and A != 0:  # |ds/dy| = 1/|s| along s² = 2iy − A
            low, high = arb(max(-Q, fmpq(0))).sqrt(), arb(-last).sqrt()
            least = abs(acb(-arb(A), 2 * low).sqrt())
            arc.append((acb(-arb(A), low + high).sqrt(), (high - low) / 2 / least))
        middle = ((ends[0] + ends[1]) / 2).mid()
        r = max_bound(*(abs(x - middle) for x in ends), *(abs(x - middle) + e for x, e in arc))
        return Along([middle], [(r * arb(1 + 2.0**-20)).upper()], 1)

    def matrix(self, b: Bordered, place: Place) -> Forms:
        """Its determinant is −4(EI)²πs²Δ̂ up to a constant, or 2EIπsΔ̂ where there is one place."""
        EI, A = arb(self.EI), arb(self.A)
        s = place.power(0, 1)
        pi = (s * s).plus([A]).scaled([acb(0.5)])
        square = pi * pi
        along = Along(place.middle, place.half, 1).stand(
            root(square.plus([-arb(self.k / self.EI)]), self.EI / self.m)
        )
        sites = [at(x, ()) for x in b.vehicle.places]
        middle = (min(sites) + max(sites)) / 2
        x = [arb(y - middle) for y in sites]
        gaps = [max(arb(0), -y.real) if not y.is_zero() else arb(0) for y in b.waves.distances]
        rho = (s.size[0] + pi.size[0].sqrt() + abs(A).sqrt()).upper()
        widest = (rho * max_bound(*map(abs, x), *gaps)).upper()
        require(widest < 64, "the places are too far apart for the way past the branch points")
        terms_ = 12 + 4 * int(float(widest)) + flint.ctx.prec // 3  # > 2ρ|x|, see `series`
        one, zero = s.scaled([NONE]).plus([1]), s.scaled([NONE])
        p, q, K = [one, zero], [zero, one], [zero] * 3 + [one.scaled([1 / EI])]
        while len(p) < terms_:
            p.append(-(s * p[-1] + pi * p[-2]))
            q.append(-(s * q[-1] + pi * q[-2]))
        while len(K) < terms_:
            K.append(-(K[-2].scaled([A]) + square * K[-4]) if len(K) % 2 else zero)
        A_, E = b(along, series(K, gaps, 3, rho))
        waves = [p] if len(b.vehicle.sites) == 1 else [p, q]
        factors, columns, low = along.value(b.factors), [], []
        links = [(i, f, j) for i, row in enumerate(b.links) for f, j in row]
        for order, wave in enumerate(waves):
            products = factors.take([f for _, f, _ in links]) * series(wave, x, order, rho).take(
                [j for *_, j in links]
            )
            rows = [[n for n, (i, *_) in enumerate(links) if i == row] for row in range(b.size)]
            columns.append(joined([folded(products.take(row), 1) if row else zero for row in rows]))
            low.append(-series(wave, [-y for y in x], order, rho))
        corner = [(s * pi).scaled([2 * EI]), s.scaled([-2 * EI])]
        empty = b.size - b.nc

        def full(matrix: Any, some: Callable[[Form], list[Any]], nothing: Any) -> list[list[Any]]:
            top = [[*line, *(some(c)[i] for c in columns)] for i, line in enumerate(matrix.tolist())]
            for n, form in enumerate(low):
                ends = [some(corner[n])[0] if i == n else nothing for i in range(len(low))]
                top.append([*[nothing] * empty, *some(form), *ends])
            return top

        matrices = [acb_mat(full(a, lambda f, k=k: f.k[k], NONE)) for k, a in enumerate(A_)]  # type: ignore[misc]
        return matrices, arb_mat(full(E, lambda f: f.e, ZERO))


def root(f: Form, factor: Any) -> Form:
    """√(factor·f) = i√(−factor·f), the root of −factor·f with positive real part."""
    f = f.scaled([acb(-arb(factor))])
    c = f.k[0][0].sqrt()
    require(c.real > 0, "z = 0 lies on a piece of the way past the branch points")
    if not f.m:
        return f.scaled([NONE]).plus([acb(0, 1) * c])
    size = abs(f.k[0][0])
    y = (f.sizes(1)[0] + f.e[0]) / size
    require(y < 0.9, "a piece of the way past the branch points comes too close to z = 0")
    rest = abs(c) * (f.e[0] / size / 2 + y * y / 8 / (1 - y) ** 2)
    return Form([[acb(0, 1) * c], [acb(0, 1) * f.k[1][0] / (2 * c)]], [rest], 1)


def series(f: Sequence[Form], x: Sequence[Any], order: int, rho: Any) -> Form:
    """Σ f_n xⁿ/n! at each x; |f_n| ≤ ρ^(n − order) |f_order|, so what more than 2ρ|x| terms leave out is at most
    twice its first term."""
    n, total = len(x), None
    power = [acb(1)] * n
    for k, one in enumerate(f):
        power = [y * z / k for y, z in zip(power, x, strict=True)] if k else power
        term = one.take([0] * n).scaled(power)
        total = term if total is None else total + term
    first, last = abs(f[order].k[0][0]), len(f)
    sizes = [abs(arb(y)) for y in x]
    left = [2 * first * y**order * (rho * y) ** (last - order) / arb(last).fac() for y in sizes]
    return total.rested([y.upper() for y in left])  # type: ignore[union-attr]


def turn_at_rest(sheet: Sheet, b: Bordered, z: Sequence[Any], spent: Walker) -> Any:
    """The change of arg Δ̂ along the edge of the cut from z[0] in the gap to z[-1] beyond all branch points, v = 0."""
    t = terms(sheet.track.D)
    edge = AtRest(t[4, 0], t.get((2, 0), fmpq(0)) / t[4, 0], t[0, 0], t[0, 2])
    fine = sheet.track.v == 0 and terms(sheet.track.N) == {(0, 0): 1} and all(x < y for x, y in pairwise(z))
    require(fine and edge.Q(z[0]) > 0 > edge.Q(z[-1]), "the way past the branch points is another one")
    total = arb(0)
    for x, y in pairwise(z):
        spent.pieces += 1
        spent.spend(4000 + 200 * b.size**2 + b.size**3)
        place = edge.disc(x, y)
        turn = Turn.over(edge.matrix(b, place), place)
        first, last = (edge.matrix(b, Place.disc(edge.s(w), ZERO))[0][0] for w in (x, y))
        total += turn.sharp(last) - turn.sharp(first)
    return total - (1 if len(b.vehicle.sites) == 1 else 2) * edge.s(z[-1]).arg() - arb.pi() / 2


def count_beside(sheet: Sheet, region: Region, spent: Walker, content: Any, start: Any) -> int:
    """The number of roots in a rectangle on one half of the sheet, or across its gap; points are z, or z̄ above."""
    keys(content["theorem"], "half")
    (a, b), (c, d) = region.re or (0, 0), region.im or (0, 0)
    c, d, waves = c - sheet.height, d - sheet.height, Waves(sheet.track, sheet.lower.places)
    lower = content["theorem"]["half"] == "lower"
    if lower:
        require(d < 0 or (in_gap(sheet, a) and in_gap(sheet, b)), "the rectangle meets a cut")
    else:
        require(content["theorem"]["half"] == "upper" and c > 0, "the rectangle is not above the cuts")
        c, d = -d, -c
    walker = Walker(waves, Bordered(sheet.lower if lower else sheet.upper, waves))
    link, turn = read_paths(content["paths"], "link turn")
    ends = link.points[0] == (0, -start) and link.points[-1] == (a, c)
    require(ends and all(y <= 0 for _, y in link.points), "the first path does not lead to the rectangle's corner")
    check_lines(turn.points, [(a, c), (b, c), (b, d), (a, d), (a, c)])
    walker.begin(start)
    walker.path(link)
    n = whole(walker.path(turn) / (2 * arb.pi()))
    spent.pieces += walker.pieces
    return n


def in_gap(sheet: Sheet, z: Any) -> bool:
    """No p-root is real at this z: D(ip, iz) > 0 for all real p."""
    t, v = terms(sheet.track.D), sheet.track.v
    m = t[0, 2]
    c = [t[0, 0] - m * z * z, 2 * m * v * z, -t.get((2, 0), fmpq(0)) - m * v * v, fmpq(0), t[4, 0]]
    return all(nonnegative(fmpq_poly([x * sign**i for i, x in enumerate(c)]), True) for sign in (1, -1))


# --- roots ------------------------------------------------------------------------------------------------


@dataclass(repr=False, eq=False)
class Root:
    """Claimed: exactly `multiplicity` roots with |q − z| ≤ radius; `pair`: and as many at −q̄."""

    z: Point
    radius: Any
    multiplicity: int
    pair: bool
    bits: int

    @property
    def number(self) -> int:
        return self.multiplicity * (2 if self.pair else 1)


def read_root(value: Any) -> Root:
    keys(value, "re im exponent radius multiplicity pair")
    (x, y), radius, bits = read_ball(value, "re im", "a root")
    require(type(value["pair"]) is bool, "pair is not true or false")
    multiplicity = integer(value["multiplicity"], 1, MAX_MULTIPLICITY, "multiplicity")
    return Root((x, y), radius, multiplicity, value["pair"], bits)


def check_root(track: Track, vehicle: Bodies, root: Root, walker: Walker) -> None:
    """Exactly `multiplicity` roots in the disc: those of a small block, proved by Rouché's theorem (section 7)."""
    m, bits, size = root.multiplicity, root.bits + 128, walker.bordered.size + root.multiplicity
    walker.spend((8 * size**3 + 2000) * (1 + bits / 512) ** 1.5)
    with precision(bits):
        waves = Waves(track, vehicle.places)
        place = Place.disc(at_q(root.z), arb(root.radius).upper())
        local = waves.near(place)
        found = Apart.of(local, *sorted_roots(local))
        require(found.sided, REAL)
        check_zeros(Bordered(vehicle, waves)(place, kernels(waves, [found])[0][0]), m)


def check_zeros(A: Forms, m: int) -> None:
    """det A has exactly m zeros |u| < 1, for any A of forms of first order in one variable."""
    (F0, F1), rest = block(A, m)
    V = (near_inverse(F1) * F0).mid().eig(right=True, algorithm="approx")[1].mid()  # any numbers
    L = near_inverse(F1 * V)
    E = moduli(L * F1 * V - identity(m)) + moduli(L * F0 * V) + moduli(L) * rest * moduli(V)
    require(contracting(E), "the disc is not proved to hold as many roots as claimed")


def block(matrix: Forms, m: int) -> Forms:
    """F, an m × m matrix that is singular exactly where A = A₀ + A₁u + rest is, |u| ≤ 1.

    F is the last block of the inverse of B = [[A, X], [Y, 0]]: det A = ± det B · det F, and B is proved regular.
    X and Y are any numbers, in the units of rows and columns: A₁ counts too, as a diagonal may be 0 at a root.
    """
    A, rest = matrix
    n, (whole, slope) = rest.nrows(), (moduli(a) for a in A)
    most = [max(float(x) for x in a.entries()) for a in (whole, slope)]
    sizes = whole + slope * arb(most[0] / most[1] if most[1] else 0)
    none = [[0] * m] * n, [[0] * n] * m
    B0, B1, Q = acb_mat(framed(A[0], *frame(sizes, m))), acb_mat(framed(A[1], *none)), arb_mat(framed(rest, *none))
    R = near_inverse(B0)
    N0, N1, size = B0 * R - identity(n + m), B1 * R, moduli(R)
    N = moduli(N0) + moduli(N1) + Q * size  # BR = 1 + (a matrix with these moduli at most)
    x, eta = near_weights(N, 0.9)
    require(eta < 0.9, "the matrix without its kernel may be singular on the disc")
    first = [R * N0, R * N1, size * Q * size]
    F = [[a.tolist()[i][n:] for i in range(n, n + m)] for a in (R, *first)]
    tail = (size * arb_mat(n + m, 1, x)).entries()  # of R N² (1 + N)⁻¹ in the last columns
    twice = (N * N).tolist()
    worst = [max_bound(*(row[n + j] / y for row, y in zip(twice, x, strict=True))) / (1 - eta) for j in range(m)]
    lost = arb_mat([[y + tail[n + i] * worst[j] for j, y in enumerate(row)] for i, row in enumerate(F[3])])
    return [acb_mat(F[0]) - acb_mat(F[1]), -acb_mat(F[2])], lost


def units(a: Any) -> tuple[list[float], list[float]]:
    """Of the rows and the columns of a matrix."""
    rows = a.tolist()
    tall = [max((float(abs(x)) for x in row), default=0) or 1.0 for row in rows]
    return tall, [
        max(float(abs(row[j])) / t for row, t in zip(rows, tall, strict=True)) or 1.0 for j in range(len(rows))
    ]


def frame(a: Any, m: int) -> tuple[Rows, Rows]:
    """m columns and m rows for the edges of a matrix: any numbers, in its units."""
    tall, wide = units(a)

    def uneven(i: int, j: int) -> float:
        return 1 + ((i + 1) * (j + 2) * 0.6180339887498949) % 1

    right = [[t * uneven(i, j) for j in range(m)] for i, t in enumerate(tall)]
    return right, [[w * uneven(j, i + m) for j, w in enumerate(wide)] for i in range(m)]


def framed(a: Any, right: Rows, low: Rows) -> Rows:
    """[[a, right], [low, 0]]."""
    rows = [[*row, *more] for row, more in zip(a.tolist(), right, strict=True)]
    return rows + [[*row, *[0] * len(low)] for row in low]


def require_apart(balls: list[tuple[Point, Any]], why: str) -> None:
    """No two closed discs (middle, radius) have a point in common."""
    balls.sort(key=lambda ball: ball[0][0] - ball[1])
    for k, ((x, y), r) in enumerate(balls):
        for (u, w), s in balls[k + 1 :]:
            if u - s > x + r:
                break
            require((u - x) ** 2 + (w - y) ** 2 > (r + s) ** 2, why)


def check_roots(values: Any, region: Region, track: Track, vehicle: Bodies, walker: Walker) -> list[Root]:
    """The claimed roots: inside the region, apart from each other, each proved."""
    roots = [read_root(value) for value in items(values, MAX_ROOTS, "roots")]
    balls: list[tuple[Point, Any]] = []
    for k, root in enumerate(roots):
        x, y = root.z
        mirror = (-x, y)
        require(region.holds(root.z, root.radius), f"root {k} is not inside the region")
        if root.pair:
            require(x > root.radius and region.holds(mirror, root.radius), f"root {k} is no pair inside the region")
            balls.append((mirror, root.radius))
        else:
            require(
                region.kind == "rectangle" or x == 0, f"root {k} is neither one of a pair nor on the imaginary axis"
            )
        balls.append((root.z, root.radius))
    require_apart(balls, "two balls of roots overlap")
    for k, root in enumerate(roots):
        try:
            check_root(track, vehicle, root, walker)
        except Refused as error:
            raise Refused(f"root {k}: {error}") from None
    return roots


# --- the certificate --------------------------------------------------------------------------------------


def spectrum(content: dict[str, Any]) -> str:
    """The claim in words, if every step of the certificate holds."""
    keys(content["equations"], "track velocity vehicle")
    track = read_track(content["equations"]["track"], content["equations"]["velocity"])
    vehicle = read_vehicle(content["equations"]["vehicle"], content["basis"])
    keys(content["claim"], "region count unstable")
    region, claim = read_region(content["claim"]["region"]), content["claim"]
    count = integer(claim["count"], 0, 10_000, "count")
    start, bits = dyadic(content["start"], "start"), integer(content["bits"], 53, 256, "bits")
    require(start > 0, "the start is not below the real axis")
    at_rest = region.kind == "unstable" and track.v == 0
    with precision(bits):
        walker = Walker(waves := Waves(track, vehicle.places), Bordered(vehicle, waves))
        if region.kind == "sheet":
            number = count_sheet(Sheet.of(track, vehicle), walker, content, start)
        elif region.re and content["theorem"] is not None:
            number = count_beside(Sheet.of(track, vehicle), region, walker, content, start)
        elif region.kind == "unstable" and content["theorem"] == {"half": "passive"}:
            read_paths(content["paths"], "")
            sheet = Sheet.of(track, vehicle)
            passive = sheet.height == 0 and nonnegative(fmpq_poly(sheet.along(fmpq(0))), False)
            require(passive, "the beam is not undamped and passive at all frequencies")
            number = 0
        elif at_rest:
            read_paths(content["paths"], "")
            check_no_cut(track, region.height)
            require(content["theorem"] is None, "at rest no theorem is needed")
            check_passive_track(track)
            number = 0
        elif content["theorem"] == {"half": "behind"}:
            check_no_cut(track, region.height)
            walker.begin(start)
            check_behind(vehicle, walker.marks[fmpq(0), -start])
            number = count_behind(walker, region, content["paths"], start, track)
        else:
            paths = read_paths(content["paths"], "link turn" if track.v == 0 else KINDS[region.kind])
            check_no_cut(track, region.height)
            check_paths(region, paths, start)
            walker.begin(start)
            number = count_roots(walker, region, paths, content["theorem"], track)
    require(number == count, f"the number of roots is {number}, not as claimed")
    roots = check_roots(content["roots"], region, track, vehicle, walker)
    found = sum(root.number for root in roots)
    require(found == number, f"the file names {found} of {number} roots")
    below = sum(root.number for root in roots if root.z[1] + root.radius < 0)
    even = all(j % 2 == 0 for p in (track.D, track.N) for _, j in terms(p))
    lossless = (
        even and vehicle.numbers[1] == vehicle.numbers[1] * 0 and vehicle.neutral == 0
    )  # q and q̄ are roots together
    real = [lossless and root.z[1] == 0 and root.multiplicity == 1 for root in roots]  # its ball is its own mirror
    require(
        all(x or abs(root.z[1]) > root.radius for x, root in zip(real, roots, strict=True)),
        "a root may lie on either side of the real axis",
    )
    require(
        below == integer(claim["unstable"], 0, 10_000, "unstable"), f"{below} roots have Im q < 0, not as claimed"
    )
    return words(content, track, vehicle, region, roots, walker.pieces)


def polynomial_words(p: Any) -> str:
    return str(p).replace("*", " ") if p else "0"


def words(content: Any, track: Track, vehicle: Bodies, region: Region, roots: Sequence[Root], pieces: int) -> str:
    """What has been verified, of which equations."""
    number, below = sum(r.number for r in roots), sum(r.number for r in roots if r.z[1] < 0)
    said = [
        f"exactly {number} induced frequenc{'y' if number == 1 else 'ies'} q with {region.words}"
        + (f", {below} of them with Im q < 0" if region.kind not in ("unstable", "disc") else "")
        + (f", enclosed in {len(roots)} ball{'' if len(roots) == 1 else 's'}" if roots else "")
    ]
    for root in roots:
        x, y = (float(arb(c)) for c in root.z)
        sign = "±" if root.pair else ""
        more = f" ({root.multiplicity} roots)" if root.multiplicity > 1 else ""
        axis = " (imaginary)" if not root.pair and root.z[0] == 0 and root.multiplicity == 1 else ""
        said.append(f"  q ≈ {sign}{x:.15g}{y:+.15g}i, in a ball of radius {two_digits(root.radius)}{more}{axis}")
    if vehicle.neutral:
        said.append(f"  and {vehicle.neutral} neutral at q = 0 (a coordinate without spring or contact), named apart")
    if vehicle.unfelt:
        said.append(
            f"  modes of {vehicle.unfelt} coordinates that no contact feels are named apart; none has Im q < 0"
        )
    said.append(
        f"proved in {pieces} pieces, of these equations (P = ∂/∂x, s = ∂/∂t; row {track.loaded + 1}: contacts):"
    )
    for k, row in enumerate(track.rows):
        left = " + ".join(f"({polynomial_words(x)}) u{j + 1}" for j, x in enumerate(row) if x)
        said.append(f"  {left} = {'load' if k == track.loaded else '0'}")
    return "\n".join([*said, f"  velocity {track.v}; {vehicle_words(content['equations']['vehicle'])}"])


def two_digits(radius: Any) -> str:
    """Not less than a radius > 0, however small it is."""
    return str((arb(radius) * 1.06).str(2, radius=False))


def vehicle_words(value: Any) -> str:
    said = ["bodies M ÿ + C ẏ + K y = B λ, rail under the contacts Bᵀ y + h λ"]
    said += [f"  {name} = {listed(value[name])}" for name in "MCKB"]
    return "\n".join([*said, f"  contacts at {listed(value['places'])}, compliances {listed(value['compliances'])}"])


def listed(value: Any) -> str:
    return "[" + ", ".join(map(listed, value)) + "]" if isinstance(value, list) else str(value)


def main(paths: Sequence[str], check: Callable[[Any], Verdict] = verify, name: str = "verify2.py") -> int:
    """Prints what each file proves; 0 if all are valid."""
    if not paths:
        print(f"usage: {name} FILE [FILE …]", file=sys.stderr)
        return 1
    verdicts = [(path, check(path)) for path in paths]
    for path, verdict in verdicts:
        print(f"{path}: " + (f"valid: {verdict.claim}" if verdict.valid else f"INVALID: {verdict.reason}"))
    return 0 if all(verdict.valid for _, verdict in verdicts) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
