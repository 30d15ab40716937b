"""Rows of what a report shows of a case and of its roots: quantity, value, meaning."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import decimal, proved_digits, working_bits
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case
from mpsolve.problem.physical import PhysicalCase

if TYPE_CHECKING:
    from mpsolve.report.vibration import Vibration

_PLACES = 8  # digits of the physical quantities; every digit of q is printed
_TYPED = 36  # digits of a value that is typed; more are shortened
_BEAM = ("EI", "m", "k", "v", "c", "kp", "N")
_ROW = 76  # longest q that is printed in one row


def beam_rows(physical: PhysicalCase) -> Iterator[tuple[str, str, str]]:
    """Rows of quantity, value and meaning, in SI units."""
    for name, unit, meaning in (
        ("EI", "N m²", "bending stiffness of the beam"),
        ("m", "kg/m", "mass of the beam"),
        ("k", "N/m²", "stiffness of the foundation"),
        ("c", "N s/m²", "damping of the foundation"),
        ("kp", "N", "Pasternak modulus of the foundation"),
        ("N", "N", "axial force, compression positive"),
        ("v", "m/s", "velocity"),
    ):
        yield name, f"{shown(getattr(physical, name))} {unit}", meaning
    for j, mass in enumerate(physical.masses, 1):
        yield f"M{j}", f"{shown(mass.M)} kg", f"mass at s {_equals(mass.position)} m"
    yield "√(k/m)", f"{shown(physical.time_scale)} rad/s", "τ = √(k/m) t"
    yield "χ", f"{shown(physical.chi)} 1/m", "(k/4EI)^(1/4): ξ = χ s"
    yield "v_cr", f"{shown(physical.v_cr)} m/s", "critical velocity √(k/m)/χ on a Winkler foundation"
    if physical.N or physical.kp:
        yield "v_cr′", f"{_critical(physical)} m/s", "√(1 − η_N + η_S) v_cr, with N and kp, without damping"


def _critical(physical: PhysicalCase) -> str:
    with precision(working_bits(_PLACES)):
        share = 1 - physical.dimensionless.axial.ball()
        return f"≈ {proved_digits(share.sqrt() * physical.v_cr.ball(), _PLACES)}"


def ratio_rows(case: Case) -> Iterator[tuple[str, str, str]]:
    """Rows of the dimensionless parameters."""
    yield "α", shown(case.alpha), "velocity ratio v/v_cr"
    yield "η_b", shown(case.eta_b), "damping ratio c/(2√(mk))"
    yield "η_N", shown(case.eta_n), "axial force ratio"
    yield "η_S", shown(case.eta_s), "Pasternak modulus ratio"
    for j, (ratio, place) in enumerate(zip(case.eta_m, case.positions, strict=True), 1):
        yield f"η_M{j}", shown(ratio), f"mass ratio M χ/m, at ξ {_equals(place)}"


def shown(x: Exact) -> str:
    """x as it is typed: exactly if at most 36 digits do, else its first proved digits, marked ≈."""
    for digits in (12, _TYPED):
        short = x.short(digits)
        if Exact.parse(short) == x:
            return short
    with precision(working_bits(_PLACES)):
        return f"≈ {proved_digits(x.ball(), _PLACES)}"


def _equals(x: Exact) -> str:
    text = shown(x)
    return text if text.startswith("≈") else f"= {text}"


def root_rows(j: int, motion: Vibration, digits: int) -> list[tuple[str, str]]:
    """Label and digits of a root, at the precision that is set: one row, or two where one would be too long."""
    q = motion.root.q
    real, imag = decimal(abs(q.real), digits + 2).text, decimal(q.imag, digits + 2).text
    pair = "" if q.real == 0 else "±"
    if q.imag == 0:
        return [(f"q{j} =", pair + real)]
    whole = f"{pair}{real} {'-' if imag.startswith('-') else '+'} {imag.removeprefix('-')} i"
    if len(whole) <= _ROW:
        return [(f"q{j} =", whole)]
    return [(f"Re q{j} =", pair + real), (f"Im q{j} =", imag)]
