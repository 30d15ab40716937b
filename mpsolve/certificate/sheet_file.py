"""Certificates of version 2 of the whole sheet: paths, loops and the closing in z = q − iη (certs/SPEC2.md)."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from mpsolve.certificate.format import FORMAT, Certificate, digest
from mpsolve.certificate.spectrum_file import KIND, VERSION, RootEntry, dyadic, equations, point, root_entry
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.branch_loops import Loop
from mpsolve.spectrum.sheet import Half, SheetCount

_SMALL = 2.0**-8  # of a piece next to a branch point: smaller ones ask for more bits


def sheet_certificate(reduced: Reduced, count: SheetCount, roots: Iterable[RootEntry], unstable: int) -> Certificate:
    """The certificate of a count on the whole sheet and of the discs that explain it."""
    unit = reduced.frequency_unit
    rest = {} if count.rest is None else {"rest": [dyadic(z * unit) for z in count.rest.z]}
    content: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "kind": KIND,
        "equations": equations(reduced),
        "basis": None,
        "bits": _bits(count),
        "start": dyadic(Fraction(count.start.depth) * unit),
        "paths": [*_half(count.lower, unit), *_half(count.upper, unit)],
        "theorem": {
            "begin": dyadic(count.begins * unit),
            "end": dyadic(Fraction(count.end) * unit),
            "lower": [_loop(loop, unit) for loop in count.lower.loops],
            "upper": [_loop(loop, unit) for loop in count.upper.loops],
            **rest,
        },
        "claim": {"region": {"kind": "sheet"}, "count": count.total, "unstable": unstable},
        "roots": [root_entry(root) for root in roots],
    }
    return Certificate(content | {"sha256": digest(content)})


def _bits(count: SheetCount) -> int:
    """More of them where loops are small: p-roots are closer to each other there."""
    radii = [loop.radius for half in (count.lower, count.upper) for loop in half.loops if loop.ways is not None]
    radii += [] if count.rest is None or count.rest.closest > _SMALL else [count.rest.closest]
    return 64 if not radii else min(256, 96 + 2 * int(-math.log2(min(radii))))


def _half(half: Half, unit: Fraction) -> list[dict[str, Any]]:
    """The link, and the turns with the ways to small loops at their ends."""
    out: list[dict[str, Any]] = [
        {"kind": path.kind, "points": [point(z, unit) for z in path.points.tolist()]} for path in half.paths
    ]
    for k, loop in enumerate(half.loops, 1):
        if loop.ways is not None:
            before, behind = ([point(t, unit, about=loop.about) for t in way.tolist()] for way in loop.ways.ends)
            if loop.ways.linked:
                out[0]["points"] += before
                out[1]["points"] = before[-1:]
            else:
                out[k]["points"] += before
            out[k + 1]["points"] = behind + out[k + 1]["points"]
    return out


def _loop(loop: Loop, unit: Fraction) -> dict[str, Any]:
    return {
        "centre": dyadic((Fraction(loop.centre) + loop.about) * unit),
        "radius": dyadic(Fraction(loop.reach) * unit),
        "points": [point(z, unit, about=loop.about) for z in loop.points.tolist()],
    }
