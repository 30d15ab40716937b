"""Certificates of crossings: every passage of a root through a line, for a whole range of one parameter."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import Any, Protocol

from mpsolve.certificate import verify
from mpsolve.certificate.format import FORMAT, VERSION, Certificate, digest, dyadic
from mpsolve.certificate.sheet import SheetSpectrum
from mpsolve.errors import CertificateError, known
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case

KIND = "crossings"
_LEAST_REACH = 2.0**-48


class Zero(Protocol):
    """What is written of a passage: stability/zero.py says what its parts mean."""

    @property
    def x(self) -> Any: ...
    @property
    def t(self) -> Any: ...
    @property
    def level(self) -> Any: ...
    @property
    def reach(self) -> tuple[float, float]: ...
    @property
    def direction(self) -> int: ...


class Family(Protocol):
    """What is written of a family: stability/family.py."""

    @property
    def case(self) -> Case: ...
    @property
    def parameter(self) -> str: ...
    @property
    def height(self) -> Exact: ...


class Base(Protocol):
    """What is written of a certified count: stability/passages.py."""

    @property
    def t(self) -> Exact: ...
    @property
    def spectrum(self) -> SheetSpectrum: ...


class Passages(Protocol):
    """What is written of a proof: stability/passages.py."""

    @property
    def family(self) -> Family: ...
    @property
    def start(self) -> Exact: ...
    @property
    def end(self) -> Exact: ...
    @property
    def radius(self) -> float: ...
    @property
    def zeros(self) -> Sequence[Zero]: ...
    @property
    def counts(self) -> Sequence[int | None]: ...
    @property
    def bases(self) -> Sequence[Base]: ...
    @property
    def proved(self) -> bool: ...


def crossings_certificate(found: Passages) -> Certificate | None:
    """The certificate of a result; None if it is not proved, or lies on a line that the verifier does not take."""
    if not found.proved or found.family.height > 0:
        return None
    try:
        return make_crossings_certificate(found)
    except CertificateError:
        return None


def make_crossings_certificate(found: Passages) -> Certificate:
    """The certificate of a proved result. Raises CertificateError for one that has none."""
    if not found.proved:
        raise CertificateError("an undecided result has no certificate")
    family = found.family
    content: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "kind": KIND,
        "case": family.case.as_dict(),
        "family": {"parameter": family.parameter, "start": str(found.start), "end": str(found.end)},
        "height": str(family.height),
        "radius": dyadic(found.radius),
        "crossings": [],
        "base": None,
        "claim": {"counts": list(found.counts)},
    }
    zeros, counts = list(found.zeros), list(found.counts)
    if family.parameter == "level":  # counts mean something between mass levels η, which u does not order
        zeros.sort(key=lambda zero: float(zero.level.mid()))
        counts = [0, *itertools.accumulate(2 * zero.direction for zero in zeros)]
    content["claim"] = {"counts": counts}
    content["crossings"] = [_crossing(content, zero) for zero in zeros]
    if found.bases:
        base = found.bases[0]
        certificate = known(base.spectrum.certificate, "the certificate of the base")
        content["base"] = {"t": str(base.t), "certificate": certificate.content}
    return Certificate(content | {"sha256": digest(content)})


def _crossing(content: dict[str, Any], zero: Zero) -> dict[str, Any]:
    """The crossing with the largest box that the verifier's own enclosures confirm."""
    reach = min(zero.reach)
    while reach > _LEAST_REACH:
        crossing = _written(zero, reach)
        if verify.confirms_crossing(content, crossing):
            return crossing
        reach /= 2
    raise CertificateError("the verifier's enclosures confirm no box about a crossing: nothing was written")


def _written(zero: Zero, reach: float) -> dict[str, Any]:
    x, x_exponent = _on_grid(zero.x)
    t, t_exponent = _on_grid(zero.t)
    return {
        "x": x,
        "x_exponent": x_exponent,
        "t": t,
        "t_exponent": t_exponent,
        "direction": zero.direction,
        "reach": dyadic(reach),
    }


def _on_grid(ball: Any) -> tuple[str, int]:
    """The integer nearest to ball/2^exponent: the ball lies well within a unit of it."""
    exponent = math.frexp(float(ball.rad()))[1] + 2 if float(ball.rad()) > 0 else _exponent(ball)
    mantissa, own = ball.mid().man_exp()
    shift = int(own) - exponent
    m = int(mantissa)
    nearest = m << shift if shift >= 0 else (m + (1 << (-shift - 1))) >> -shift
    return hex(nearest), exponent


def _exponent(ball: Any) -> int:
    """The binary exponent of a radius too small for float64."""
    mantissa, exponent = ball.rad().man_exp()
    return int(exponent) + int(mantissa).bit_length() + 2
