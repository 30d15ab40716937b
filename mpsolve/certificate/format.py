"""Certificates as JSON, specified in certs/SPEC.md: the whole problem, the claim and the steps, in exact numbers."""

from __future__ import annotations

import hashlib
import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from mpsolve.errors import known
from mpsolve.files import write_whole
from mpsolve.numbers.rootball import RootBall, Symmetry
from mpsolve.problem.case import Case
from mpsolve.spectrum.regions import Rectangle

if TYPE_CHECKING:
    from mpsolve.sheet.count import Count

FORMAT = "mpsolve certificate"
VERSION = 1
KIND = "induced frequencies"


@dataclass(frozen=True)
class Certificate:
    """A certificate's content; `text` is what stands in the file."""

    content: dict[str, Any]

    @property
    def text(self) -> str:
        """JSON with one line a number or root, so that two certificates can be compared by eye."""
        entries = ",\n".join(f"{json.dumps(key)}: {_lines(value)}" for key, value in self.content.items())
        return "{\n" + entries + "\n}\n"

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Writes the file whole or not at all; CertificateError if it cannot be written."""
        return write_whole(Path(path), self.text)


def _lines(value: Any) -> str:
    if isinstance(value, dict):
        return "{\n" + ",\n".join(f" {json.dumps(k)}: {_lines(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list) and any(isinstance(v, (list, dict)) for v in value):
        return "[\n" + ",\n".join("  " + json.dumps(v, allow_nan=False) for v in value) + "]"
    return json.dumps(value, allow_nan=False)


def make_certificate(case: Case, count: Count, roots: tuple[RootBall, ...]) -> Certificate:
    """The certificate of a count and of the root balls that explain it."""
    claim: dict[str, Any] = {"count": count.total}
    unstable = _unstable(roots)
    if unstable is not None:
        claim["unstable"] = unstable
    content = {
        "format": FORMAT,
        "version": VERSION,
        "kind": KIND,
        "case": case.as_dict(),
        "claim": claim,
        "contour": _contour(count),
        "roots": [_root(root) for root in roots],
        "identity": [root.multiplicity for root in roots],
    }
    return Certificate(content | {"sha256": digest(content)})


def digest(content: dict[str, Any]) -> str:
    """SHA-256 of the content in canonical JSON: sorted keys, no spaces, ASCII."""
    canonical = json.dumps(content, sort_keys=True, separators=(",", ":"), ensure_ascii=True, allow_nan=False)
    return hashlib.sha256(canonical.encode("ascii")).hexdigest()


def _unstable(roots: tuple[RootBall, ...]) -> int | None:
    number = 0
    for root in roots:
        if root.q.imag < 0:
            number += root.multiplicity
        elif not (root.q.imag >= 0 or root.symmetry is Symmetry.REAL):
            return None
    return number


def _contour(count: Count) -> dict[str, Any]:
    if isinstance(count.contour, Rectangle):
        sides = [[dyadic(x) for x in path.breaks] for path in count.paths]
        return {"kind": "rectangle", "bits": count.bits, "bounds": count.contour.as_dict(), "sides": sides}
    breaks = [dyadic(x) for x in count.paths[0].breaks]
    radius = dyadic(known(count.radius, "the radius"))
    return {"kind": count.contour, "bits": count.bits, "radius": radius, "breaks": breaks}


def _root(root: RootBall) -> dict[str, Any]:
    re, im = (_on_grid(x.mid(), root.exponent) for x in (root.q.real, root.q.imag))
    return {
        "re": re,
        "im": im,
        "exponent": root.exponent,
        "multiplicity": root.multiplicity,
        "axis": root.symmetry.value,
    }


def _on_grid(x: Any, exponent: int) -> str:
    """The integer x/2^exponent."""
    mantissa, own = x.man_exp()
    return hex(int(mantissa) << (int(own) - exponent)) if mantissa else "0x0"


def dyadic(x: float) -> list[Any]:
    """An exact dyadic number m·2^e as ["±0x…", e]."""
    numerator, denominator = x.as_integer_ratio()
    return [hex(numerator), 1 - denominator.bit_length()]
