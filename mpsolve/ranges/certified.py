"""Certificates of answers over ranges, as JSON (certs/SPEC2.md, section 10); all exact, in the problem's units.

`CertificateError` where an answer cannot be written: the checker knows less than the proof uses. Each is handed to
the standalone verifier, within a bounded work.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.certificate.format import FORMAT, Certificate, digest
from mpsolve.certificate.spectrum_file import VERSION, basis_entry, dyadic
from mpsolve.errors import CertificateError, PrecisionError
from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.numbers.balls import arb
from mpsolve.numbers.several import Several
from mpsolve.outcome import Status
from mpsolve.passivity.far import far_numbers
from mpsolve.problem.family import Family
from mpsolve.problem.free_equations import FreeEquations, free_equations
from mpsolve.proof.effort import Effort
from mpsolve.proof.in_time import in_time
from mpsolve.proof.sheared import SLOPED
from mpsolve.proof.subdivide import OPEN, Tree
from mpsolve.ranges.enclosed import Crossing
from mpsolve.ranges.far_entry import beyond, far_entry
from mpsolve.ranges.judge import ABSORBING, ARC, KNOWN, NONZERO, OUTSIDE, PASSIVE
from mpsolve.ranges.scope import Scope

_MARKS = {NONZERO: "n", PASSIVE: "p", ABSORBING: "g", KNOWN: "z", ARC: "o", OPEN: "o", OUTSIDE: "b"}
_REGIONS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
_MOST_CELLS, _MOST_NODES = 512, 20_000  # of a chart: along each parameter; of the tree, a minute or two of a checker
_ROOM = 4  # by how much balls are wider in the file than they are known


@dataclass(frozen=True)
class Base:
    """The certified spectrum at one point, in the problem's units."""

    at: tuple[Fraction, ...]
    spectrum: Any


def crossings_certificate(
    scope: Scope, tree: Tree, zeros: Sequence[tuple[Crossing, tuple[Any, Any]]], base: Base, claim: Mapping[str, Any]
) -> Certificate:
    """Of a complete list of crossings; zeros: each with its room, those outside of the range too."""
    return _certificate("crossings", scope, tree, zeros, (base,), claim)


def stable_certificate(scope: Scope, tree: Tree, base: Base) -> Certificate:
    """Of a number of growing roots that is the same over a box of parameters."""
    return _certificate("stable", scope, tree, (), (base,), {"unstable": int(base.spectrum.unstable)})


def chart_certificate(scope: Scope, tree: Tree, bases: Sequence[Base], cells: Integers) -> Certificate:
    """Of regions over each of which the number of growing roots is that at its base. cells: the number of the region
    of each cell, −1 where nothing is said.
    """
    if max(cells.shape) > _MOST_CELLS:
        raise CertificateError(
            f"a certificate holds charts of up to {_MOST_CELLS} fine cells along each parameter; ask for less depth"
        )
    if tree.nodes > _MOST_NODES:
        raise CertificateError(
            f"the chart took {tree.nodes} boxes, more than a checker goes through in a minute or two"
        )
    marks = np.array([*_REGIONS, "."])
    rows = ["".join(row) for row in marks[cells]]
    return _certificate("chart", scope, tree, (), bases, {"cells": rows})


def _certificate(
    kind: str,
    scope: Scope,
    tree: Tree,
    zeros: Sequence[tuple[Crossing, tuple[Any, Reals]]],
    bases: Sequence[Base],
    claim: Mapping[str, Any],
) -> Certificate:
    family, chart = scope.family, kind == "chart"
    if (len(tree.open) and not chart) or any(base.spectrum.certificate is None for base in bases):
        raise CertificateError("an answer that is open has no certificate")
    far = far_numbers(scope.envelope)
    if far is None:
        raise CertificateError("no frequency is found beyond which a checker can see passivity")
    X = Fraction(scope.X) * family.frequency_unit
    Q = max(Fraction(far.X) * family.frequency_unit, X)
    entries = [{"at": list(map(str, base.at)), "spectrum": base.spectrum.certificate.content} for base in bases]
    content: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "kind": kind,
        "equations": _equations(free_equations(family)),
        "basis": basis_entry(family.base),
        "range": [[str(a), str(b)] for a, b in family.over.values()],
        "base": entries if chart else entries[0],
        "tail": far_entry(scope, far, Q),
        "X": dyadic(X),
        "beyond": [dyadic(x) for x in beyond(X, Q)],
        "tree": tree_text(tree, family.frequency_unit / family.units[0]),
        "zeros": [_zero(zero, room, family) for zero, room in zeros],
        "claim": dict(claim),
    }
    return Certificate(content | {"sha256": digest(content)})


def tree_text(tree: Tree, unit: Fraction = Fraction(1)) -> str:
    """Each node before its halves, the lower half first: the axis of a halving, or the kind of a leaf.

    unit: of slopes, a power of two.
    """
    out, stack = [], [0]
    while stack:
        n = stack.pop()
        axis, first = int(tree.axis[n]), int(tree.child[n])
        if axis < 0:
            out.append(_MARKS[int(tree.kind[n])])
            continue
        out.append(str(axis) if axis != SLOPED else _slope(Fraction(float(tree.low[-1, first])) * unit))
        stack += [first + 1, first]
    return "".join(out)


def _slope(x: Fraction) -> str:
    """s, and a number times a power of two."""
    m, e = dyadic(x)
    return f"s{m}e{e};"


def _equations(free: FreeEquations) -> dict[str, Any]:
    matrix = [
        [[[i, j, _free(c)] for (i, j), c in sorted(entry.items()) if c] for entry in row] for row in free.matrix
    ]
    pencil = free.pencil
    vehicle: dict[str, Any] = {
        key: [list(map(_free, row)) for row in free.several(getattr(pencil, key))] for key in "MCKB"
    }
    places, h = free.several([pencil.places, pencil.h])
    vehicle |= {"places": list(map(_free, places)), "compliances": list(map(_free, h))}
    return {
        "free": list(free.ring.names),
        "track": {"matrix": matrix, "loaded": free.loaded},
        "velocity": _free(free.v),
        "vehicle": vehicle,
    }


def _free(c: Several) -> Any:
    """A number as text, or [[e₁, …, "c"], …]."""
    terms = sorted(c)
    if not terms:
        return "0"
    if len(terms) == 1 and not any(terms[0][0]):
        return str(terms[0][1])
    return [[*powers, str(value)] for powers, value in terms]


def _zero(zero: Crossing, room: tuple[Any, Any], family: Family) -> dict[str, Any]:
    units = (family.frequency_unit, family.units[0])
    sides = [
        [dyadic(Fraction(float(end)) * unit) for end in ends]
        for ends, unit in zip(zip(*room, strict=True), units, strict=True)
    ]
    x = ball_entry(zero.x, units[1])
    if zero.q == 0:  # a ball of q that is to the room as that of x is
        share = Fraction(float(room[1][0])) / Fraction(float(room[1][1] - room[0][1]))
        radius = Fraction(x["radius"][0]) * Fraction(2) ** x["radius"][1] / units[1] * share * units[0]
        return {"room": sides, "q": {"middle": "0x0", "exponent": 0, "radius": _radius(radius)}, "x": x}
    return {"room": sides, "q": ball_entry(zero.q, units[0]), "x": x}


def with_room(zero: Crossing) -> Crossing:
    """With wider balls, so that a checker need not come as near; what is said is what the certificate states."""
    return replace(zero, q=zero.q if zero.q == 0 else _wider(zero.q), x=_wider(zero.x))


def _wider(ball: Any) -> arb:
    middle, radius = ball.mid(), ball.rad() * _ROOM
    return arb(middle, radius if radius > 0 else abs(middle) * arb(2) ** -64)


def ball_entry(ball: Any, unit: Fraction) -> dict[str, Any]:
    """A ball times a power of two."""
    mantissa, exponent = ball.mid().man_exp()
    radius, own = ball.rad().man_exp()
    shift = unit.numerator.bit_length() - unit.denominator.bit_length()
    return {
        "middle": hex(int(mantissa)),
        "exponent": int(exponent) + shift,
        "radius": [int(radius), int(own) + shift],
    }


def _radius(x: Fraction) -> list[int]:
    """[m, e] with m·2^e ≥ x and m of a few digits."""
    e = x.numerator.bit_length() - x.denominator.bit_length() - 8
    scaled = x / Fraction(2) ** e
    return [-(-scaled.numerator // scaled.denominator), e]


_A_NODE, _PIECES = 1, 3000
"""Boxes that the verifier may look at: so many for each node of the tree, and so many more."""


@dataclass(frozen=True)
class Verified:
    """status: PROVED if the certificate passed, else UNVERIFIED; note: why there is none; seconds: of the check."""

    status: Status
    certificate: Certificate | None = None
    note: str = ""
    seconds: float = 0.0


def verified(make: Callable[[], Certificate], nodes: int, budget: Effort | None) -> Verified:
    """Make a certificate and have it checked within the effort; None: neither."""
    if budget is None:
        return Verified(Status.UNVERIFIED, note="the verifier was not asked")
    from mpsolve.certificate.verify_ranges import verify_bytes

    def made_and_checked() -> tuple[Certificate | None, str]:
        try:
            certificate = make()
            verdict = verify_bytes(certificate.text.encode("ascii"), _A_NODE * nodes + _PIECES)
        except (CertificateError, PrecisionError) as error:
            return None, str(error)
        return (certificate, "") if verdict.valid else (None, f"the verifier does not pass one: {verdict.reason}")

    found, late, seconds = in_time(made_and_checked, budget)
    certificate, why = found or (None, late)
    status = Status.UNVERIFIED if certificate is None else Status.PROVED
    return Verified(status, certificate, why, seconds)
