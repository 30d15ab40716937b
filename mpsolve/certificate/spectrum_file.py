"""Certificates of version 2, kind "spectrum", as JSON: equations, claim, every choice of the proof (certs/SPEC2.md).

All numbers are exact and in the problem's own units: scaled ones are multiplied by powers of two.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import lcm
from types import MappingProxyType
from typing import Any

from mpsolve.certificate.format import FORMAT, Certificate, digest
from mpsolve.errors import CertificateError
from mpsolve.frozen import frozen
from mpsolve.passivity.tail import Tail
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.count import Count, on_its_half
from mpsolve.spectrum.regions import Below, HalfPlane, Rectangle, Region

VERSION = 2
KIND = "spectrum"


@frozen
class RootEntry:
    """A disc |q − (re + i im)·2^exponent| ≤ radius with `multiplicity` roots; pair: its mirror −q̄ is counted too."""

    re: int
    im: int
    exponent: int
    radius: Fraction
    multiplicity: int
    pair: bool


def spectrum_certificate(reduced: Reduced, count: Count, roots: Iterable[RootEntry], unstable: int) -> Certificate:
    """The certificate of a count and of the discs that explain it."""
    unit = reduced.frequency_unit
    lines = _lines(_of_points(reduced, count), unit)
    content: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "kind": KIND,
        "equations": equations(reduced),
        "basis": basis_entry(reduced),
        "bits": 64,
        "start": dyadic(Fraction(count.start.depth) * unit),
        "paths": [
            {"kind": p.kind, "points": [point(q, unit, lines) for q in p.points.tolist()]} for p in count.paths
        ],
        "theorem": {"half": count.half} if count.half else _closing(reduced, count),
        "claim": {"region": _region(count.region), "count": count.total, "unstable": unstable},
        "roots": [root_entry(root) for root in roots],
    }
    return Certificate(content | {"sha256": digest(content)})


def equations(reduced: Reduced) -> dict[str, Any]:
    """The equations as they are meant: the track's matrix, the velocity, the vehicle's pencil."""
    waveguide, pencil = reduced.problem.track.waveguide, reduced.problem.pencil
    matrix = [
        [[[i, j, _text(c)] for (i, j), c in sorted(entry.items())] for entry in row] for row in waveguide.matrix
    ]
    vehicle: dict[str, Any] = {key: [list(map(_text, row)) for row in getattr(pencil, key)] for key in "MCKB"}
    vehicle |= {"places": list(map(_text, pencil.places)), "compliances": list(map(_text, pencil.h))}
    return {
        "track": {"matrix": matrix, "loaded": waveguide.loaded},
        "velocity": _text(reduced.problem.v),
        "vehicle": vehicle,
    }


def basis_entry(reduced: Reduced) -> dict[str, Any] | None:
    parts = reduced.parts
    if parts.basis is None:
        return None
    unfelt = len(parts.unfelt[0]) if parts.unfelt is not None else 0
    return {"matrix": [list(map(_text, row)) for row in parts.basis], "neutral": parts.neutral, "unfelt": unfelt}


def _region(region: Region) -> dict[str, Any]:
    if isinstance(region, Rectangle):
        re, im = (region.re_min, region.re_max), (region.im_min, region.im_max)
        return {"kind": "rectangle", "re": list(map(_text, re)), "im": list(map(_text, im))}
    if isinstance(region, HalfPlane):
        return {"kind": "unstable"} if region.radius is None else {"kind": "disc", "radius": _text(region.radius)}
    _require_reach(region)
    height = _text(region.height)
    if region.radius is not None:
        return {"kind": "below disc", "height": height, "radius": _text(region.radius)}
    return {"kind": "below", "height": height, "reach": _text(region.reach or Fraction(0))}


def _require_reach(region: Below) -> None:
    """A counted region below a height says how far it reaches."""
    if region.reach is None:
        raise CertificateError("a region below a height that does not say how far it reaches cannot be written")


def _closing(reduced: Reduced, count: Count) -> dict[str, Any] | None:
    return _theorem(reduced, count.beyond.tail) if count.beyond is not None else None


def _theorem(reduced: Reduced, tail: Tail) -> dict[str, Any]:
    """The tail theorem in the problem's units: p = p̂/L, q = q̂/T, N/D = 2^n N̂/D̂."""
    guide = reduced.guide
    L, T = guide.length, guide.time
    order = _exponent(guide.g) + L  # of N/D against N̂/D̂

    def shift(power: Fraction) -> int:
        return _whole(power, "the scaling of the tail theorem")

    z = Fraction(2) ** shift(T * tail.gamma - L)
    kappa = Fraction(2) ** shift(order - T * tail.e)
    envelope = Fraction(2) ** shift(Fraction(order - L * tail.alpha))
    return {
        "gamma": [tail.gamma.numerator, tail.gamma.denominator],
        "blocks": [
            [dyadic(Fraction(z1) * z), dyadic(Fraction(z2) * z), dyadic(Fraction(k) * kappa)]
            for z1, z2, k in tail.blocks
        ],
        "alpha": tail.alpha,
        "omega": dyadic(Fraction(tail.omega0) * reduced.frequency_unit),
        "envelope": dyadic(Fraction(tail.C) * envelope),
    }


def _exponent(x: Fraction) -> int:
    return x.numerator.bit_length() - x.denominator.bit_length()


def _whole(x: Fraction, what: str) -> int:
    if x.denominator != 1:
        raise CertificateError(f"{what} is no power of two, so the certificate cannot be written exactly")
    return int(x)


def root_entry(root: RootEntry) -> dict[str, Any]:
    return {
        "re": hex(root.re),
        "im": hex(root.im),
        "exponent": root.exponent,
        "radius": dyadic(root.radius),
        "multiplicity": root.multiplicity,
        "pair": root.pair,
    }


def _of_points(reduced: Reduced, count: Count) -> Region:
    """The region in the plane in which the points of the paths lie."""
    line = on_line(reduced) if count.half else None
    if line is None or not isinstance(count.region, Rectangle):
        return count.region
    return on_its_half(line, count.region)


def _lines(region: Region, unit: Fraction) -> dict[float, Fraction]:
    """The exact coordinate of each side of the region by its nearest float in scaled units."""
    if isinstance(region, Rectangle):
        sides = [region.re_min, region.re_max, region.im_min, region.im_max]
    else:
        given = (region.radius, getattr(region, "reach", None), getattr(region, "height", None))
        sides = [sign * x for x in given if x is not None for sign in (1, -1)]
    return {float(x / unit): x for x in sides}


def point(
    q: complex, unit: Fraction, lines: Mapping[float, Fraction] = MappingProxyType({}), about: Fraction = Fraction(0)
) -> list[Any]:
    """[m, n, e]: (m + i n)·2^e in the problem's units, or two rationals; on a side of the region exactly.

    about: what q counts from, scaled.
    """
    re, im = (lines.get(x, (Fraction(x) + real) * unit) for x, real in ((q.real, about), (q.imag, Fraction(0))))
    if any(x.denominator & (x.denominator - 1) for x in (re, im)):
        return [_text(re), _text(im)]
    down = lcm(re.denominator, im.denominator)  # a power of two
    m, n, e = int(re * down), int(im * down), -(down.bit_length() - 1)
    while (m or n) and m % 2 == 0 and n % 2 == 0:
        m, n, e = m // 2, n // 2, e + 1
    return [m, n, e if m or n else 0]


def dyadic(x: Fraction) -> list[int]:
    """[m, e]: m·2^e."""
    m, e = x.numerator, -(x.denominator.bit_length() - 1)
    while m and m % 2 == 0:
        m, e = m // 2, e + 1
    return [m, e if m else 0]


def _text(x: Fraction) -> str:
    return str(x)
