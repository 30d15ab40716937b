"""Certificates of version 2 of the whole sheet: paths, loops and the closing in z = q − iη (certs/SPEC2.md)."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from mpsolve.certificate.format import FORMAT, Certificate, digest
from mpsolve.certificate.spectrum_file import KIND, VERSION, RootEntry, dyadic, equations, point, root_entry
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.branch_loops import Loop
from mpsolve.spectrum.sheet import SheetCount


def sheet_certificate(reduced: Reduced, count: SheetCount, roots: Iterable[RootEntry], unstable: int) -> Certificate:
    """The certificate of a count on the whole sheet and of the discs that explain it."""
    unit = reduced.frequency_unit
    far = None if count.far is None else dyadic(Fraction(count.far.W) * Fraction(2) ** -reduced.guide.length)
    content: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "kind": KIND,
        "equations": equations(reduced),
        "basis": None,
        "bits": 64,
        "start": dyadic(Fraction(count.start.depth) * unit),
        "paths": [
            {"kind": path.kind, "points": [point(z, unit) for z in path.points.tolist()]}
            for path in (*count.lower.paths, *count.upper.paths)
        ],
        "theorem": {
            "begin": dyadic(Fraction(count.begin) * unit),
            "end": dyadic(Fraction(count.end) * unit),
            "reach": far,
            "lower": [_loop(loop, unit) for loop in count.lower.loops],
            "upper": [_loop(loop, unit) for loop in count.upper.loops],
        },
        "claim": {"region": {"kind": "sheet"}, "count": count.total, "unstable": unstable},
        "roots": [root_entry(root) for root in roots],
    }
    return Certificate(content | {"sha256": digest(content)})


def _loop(loop: Loop, unit: Fraction) -> dict[str, Any]:
    return {
        "centre": dyadic(Fraction(loop.centre) * unit),
        "radius": dyadic(Fraction(loop.reach) * unit),
        "points": [point(z, unit) for z in loop.points.tolist()],
    }
