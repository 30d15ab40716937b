"""Root balls: they hold the roots of Δ from residues in mpmath, are as sharp as asked, and know their symmetry."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

import pytest
from multiprecision import Multiprecision
from residue import TRACKS, Residues, holds, random_track

from mpsolve import Case, certify
from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.floats import Floats
from mpsolve.characteristic.proved import Proved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.spectrum.enclose import Symmetry, enclose, in_units, isolate, refine
from mpsolve.tracks import EulerBernoulli, Timoshenko, TwoLayer
from mpsolve.vehicles import Bogie, Mass, Vehicle

BEAM = EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
BOGIE = Bogie(wheel=1813, frame=2615, inertia=1476, wheelbase="2.5", k="2.4e6", c="3e4", k_contact="1.5e9")
PROBLEMS = {
    "wire": (Problem(TRACKS["string"], [Mass("8.5").at(0)], 100), 15.64 + 0.716j),
    "pair": (Problem(BEAM, [Mass(70).at(0), Mass(70).at("1.5")], "0.67"), 0.1558609631 - 0.0000272301j),
    "bogie": (Problem(TRACKS["two-layer"], [BOGIE], 600), 63.96 + 31.5j),
    "random": (Problem(random_track(3, 1), [Mass(5).at(0), Mass(7).at(2)], "0.3"), 0.3 + 0.1j),
}


def floats_root(reduced: Reduced, q: complex) -> complex:
    """σ̂ where Newton's method leads from q."""
    sigma, floats = 1j * q / float(reduced.frequency_unit), Floats(reduced)
    for _ in range(60):
        value, slope = floats.delta([sigma])
        step = (value / slope)[0]
        sigma -= step
        if abs(step) < 1e-14 * abs(sigma):
            return complex(sigma)
    raise AssertionError("no root there")


@cache
def problem(name: str) -> tuple[Proved, complex]:
    given, q = PROBLEMS[name]
    reduced = reduce_problem(given)
    return Proved(reduced), floats_root(reduced, q)


def true_root(reduced: Reduced, start: Any, digits: int) -> Any:
    """q of the root by the secant method on the determinant of residues, with p-roots told by the sign of Re P."""
    truth, K, border = Residues(reduced.guide, digits), Multiprecision(digits), Bordering.of(reduced)

    def delta(sigma: Any) -> Any:
        return K.det(border.at(K, sigma, [truth(x, sigma) for x in border.distances]))

    mp = K.mp
    a, b = mp.mpmathify(start), mp.mpmathify(start) * (1 + mp.mpf(10) ** -12)
    fa, fb = delta(a), delta(b)
    for _ in range(60):
        a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
        if abs(a - b) < abs(b) * mp.mpf(10) ** (-digits // 2 - 3):
            break
        fb = delta(b)
    unit = mp.mpf(reduced.frequency_unit.numerator) / reduced.frequency_unit.denominator
    return -mp.j * b * unit


def sharp(ball: Any, digits: int) -> bool:
    with precision(4 * digits + 100):
        return bool((ball - ball.mid()).abs_upper() <= ball.abs_lower() * arb(10) ** -digits)


@pytest.mark.parametrize("name", PROBLEMS)
@pytest.mark.parametrize("digits", [15, 30, 60])
def test_balls_hold_the_true_root_and_are_sharp(name: str, digits: int) -> None:
    proved, sigma = problem(name)
    ball = enclose(proved, sigma, digits)
    assert ball.multiplicity == 1
    assert ball.symmetry is Symmetry.NONE
    assert sharp(ball.q, digits)
    assert not sharp(ball.q, digits + 6)
    assert holds(ball.q, true_root(proved.reduced, sigma, 2 * digits + 20))


def test_the_contact_wire() -> None:
    """One mass of 8.5 kg on a wire; an independent float program gives the twelve decimals."""
    proved, sigma = problem("wire")
    for start in (sigma, sigma.conjugate()):
        q = complex(enclose(proved, start, 20).q)
        assert abs(abs(q.real) - 15.641876611743) < 1e-12
        assert abs(q.imag - 0.715988110564) < 1e-12


@pytest.mark.parametrize("digits", [30, 1000])
def test_the_roots_of_the_paper_s_beam(digits: int) -> None:
    """Against today's special proof of the same beam."""
    case = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    proved = problem("pair")[0]
    spectrum = certify(case, digits=digits)
    assert spectrum.roots
    for root in spectrum.roots:
        ball = enclose(proved, floats_root(proved.reduced, complex(root.q.mid())), digits)
        assert ball.q.overlaps(root.q)
        assert sharp(ball.q, digits)


def test_no_number_of_digits_is_missed() -> None:
    """The ladder of precisions never asks more of a Newton step than the one before has given."""
    for name in ("wire", "pair"):
        proved, sigma = problem(name)
        box = isolate(proved, sigma)
        for digits in (*range(10, 60), *range(60, 400, 13)):
            assert sharp(refine(box, digits).q, digits)


def test_ten_thousand_digits() -> None:
    proved, sigma = problem("wire")
    box = isolate(proved, sigma)
    ball, few = refine(box, 10_000), refine(box, 50)
    assert sharp(ball.q, 10_000)
    assert few.q.contains(ball.q)


def test_the_box_holds_the_ball() -> None:
    proved, sigma = problem("bogie")
    box = isolate(proved, sigma)
    ball = refine(box, 20)
    with precision(200):
        assert in_units(box.root.found.box, box.unit).contains(ball.q)
        assert box.root.found.box.contains_interior(box.root.found.image)
        assert in_units(acb(1, 2), Fraction(4)) == acb(8, -4)


JOINED = Vehicle(
    M=[[10, 0], [0, 10]], C=[[0, 0], [0, 0]], K=[[10, -10], [-10, 10]], B=[[1, 0], [0, 1]], places=["-0.75", "0.75"]
)
"""Two masses of 10 at a distance of 1.5, joined by a spring of 10."""


def test_divergence_is_on_the_imaginary_axis_exactly() -> None:
    """At α = 1.3, η_b = 0.5 one root has passed q = 0 alone: q = −0.0852i."""
    beam = EulerBernoulli(EI="1/4", m=1, k=1, c=1)
    reduced = reduce_problem(Problem(beam, [JOINED], "1.3"))
    proved = Proved(reduced)
    for digits in (15, 200):
        ball = enclose(proved, floats_root(reduced, -0.085j), digits)
        assert ball.symmetry is Symmetry.IMAGINARY
        assert ball.q.real == 0
        assert abs(float(ball.q.imag.mid()) + 0.0852) < 5e-5
        assert sharp(ball.q, digits)
        assert ball.mirrored.q.contains(ball.q)
        exact = true_root(reduced, floats_root(reduced, -0.085j), 2 * digits + 30)
        assert abs(exact.real) < 10.0**-digits
        assert holds(ball.q, exact - exact.real)


def test_mirrored() -> None:
    proved, sigma = problem("pair")
    ball = enclose(proved, sigma, 30)
    other = enclose(proved, sigma.conjugate(), 30)
    assert ball.mirrored.q.overlaps(other.q)
    assert sharp(ball.mirrored.q, 30)
    assert ball.mirrored.mirrored.q.str(40) == ball.q.str(40)


@pytest.mark.parametrize("sigma", [1 + 1j, 0.3 + 3j])
def test_no_box_where_there_is_no_root(sigma: complex) -> None:
    """Newton's method may lead to a root from there; then the box holds that root, and else it is refused."""
    proved = problem("pair")[0]
    try:
        ball = enclose(proved, sigma, 15)
    except PrecisionError:
        return
    unit = float(proved.reduced.frequency_unit)
    start = 1j * complex(ball.q.mid()) / unit
    assert holds(ball.q, true_root(proved.reduced, start, 50))


EI = 210 * 10**9 * Fraction("3.037e-5")
RAIL = {"EI": "6.4e6", "m": 60, "k": "1e6", "c": 770}
STEM = Bogie(
    wheel=1500, frame=3000, inertia=155, wheelbase="2.5", k="4.8e6", c=250, body=12500, k2="2.708e6", c2="64e3"
)
SHEAR = Fraction("0.393") * Fraction("80.769e9") * Fraction("76.70e-4")
ROLLAND = {"k_pad": "300e6", "c_pad": "3e4", "m_sleeper": 250, "k_ballast": "100e6", "c_ballast": "8e4"}
ONSETS = {
    "timoshenko": (
        Timoshenko(EI=EI, m="60.2", S=SHEAR, J=7860 * Fraction("3.037e-5"), k="1e6", c=770),
        [Mass(10_000)],
        Fraction("309.445688"),
        17.0711,
    ),
    "two-layer": (
        TwoLayer(EI=210 * 10**9 * Fraction("3038.30e-8"), m="60.2", **ROLLAND),
        [Mass(900)],
        Fraction("1413.817865"),
        673.4268,
    ),
    "kelvin-voigt": (
        EulerBernoulli(**RAIL, eta="1e-4"),
        [Mass(10_000).at(0), Mass(10_000).at("3.4")],
        Fraction("197.878094"),
        19.3498,
    ),
    "bogie": (EulerBernoulli(**RAIL), [STEM], Fraction("334.590808"), 31.971),
}


@pytest.mark.parametrize("name", ONSETS)
def test_published_onsets(name: str) -> None:
    """Velocities in m/s at which an independent float program loses stability: proved on both sides, 1e-6 away."""
    track, vehicles, v, q = ONSETS[name]
    for factor, sign in ((Fraction(999_999, 10**6), 1), (Fraction(1_000_001, 10**6), -1)):
        reduced = reduce_problem(Problem(track, vehicles, v * factor))
        ball = enclose(Proved(reduced), floats_root(reduced, q), 20)
        assert sign * ball.q.imag > 0
        assert abs(float(ball.q.real.mid()) - q) < 1e-3 * q
        assert abs(float(ball.q.imag.mid())) < 1e-4 * q
