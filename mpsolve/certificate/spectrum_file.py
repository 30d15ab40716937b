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
from mpsolve.numbers.float64 import short
from mpsolve.passivity.envelope import OMEGA
from mpsolve.passivity.far import FarNumbers
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import Guide, Reduced
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
    if count.beyond is None:
        return None
    far = count.beyond.tail
    entry, factor = tail_entry(reduced.guide, reduced.frequency_unit, far)
    return {**entry, "envelope": dyadic(Fraction(short(far.constant)) * factor)}


def tail_entry(guide: Guide, unit: Fraction, far: FarNumbers) -> tuple[dict[str, Any], Fraction]:
    """(the tail theorem in the problem's units, the factor of what bounds short waves there).

    p = p̂/L, q = q̂/T, N/D = 2^n N̂/D̂.
    """
    L, T = guide.length, guide.time
    order = guide.g.numerator.bit_length() - guide.g.denominator.bit_length() + L  # of N/D against N̂/D̂
    powers = (T * far.gamma - L, order - T * far.e, Fraction(order - L * far.alpha))
    if any(x.denominator != 1 for x in powers):
        raise CertificateError("the scaling of the tail theorem is no power of two: it cannot be written exactly")
    z, kappa, envelope = (Fraction(2) ** int(x) for x in powers)
    entry = {
        "gamma": [far.gamma.numerator, far.gamma.denominator],
        "blocks": [[dyadic(Fraction(short(x)) * by) for x, by in zip(one, (z, z, kappa), strict=True)]
                   for one in far.blocks],
        "alpha": far.alpha,
        "omega": dyadic(Fraction(OMEGA) * unit),
    }  # fmt: skip
    return entry, envelope


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
