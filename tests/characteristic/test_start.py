"""Where the splitting starts, against p-roots at 40 digits."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from receptance_truth import Receptance
from sympy import I, symbols
from track_models import DAMPED

from mpsolve import Problem, certify
from mpsolve.characteristic import start as module
from mpsolve.characteristic.discs import Splittings, split
from mpsolve.characteristic.start import APART, REPEATED, NoStartError, factors, start
from mpsolve.characteristic.table import Table
from mpsolve.errors import PrecisionError
from mpsolve.presets.written import problem_of
from mpsolve.problem.reduced import Guide, reduce_problem, track_guide
from mpsolve.tracks import Waveguide
from mpsolve.vehicles import Mass


@pytest.mark.parametrize("name", DAMPED)
@pytest.mark.parametrize("v", [0, 5, 90, 4000])
def test_the_number_of_decaying_roots(name: str, v: int) -> None:
    guide = track_guide(DAMPED[name], Fraction(v))
    found = start(guide)
    assert found.up == len(Receptance(guide).roots(found.depth)[0])
    assert found.splitting.m[0] == found.depth
    U, L = factors(found.splitting, 0)
    decaying, growing = Receptance(guide).roots(found.depth)
    for polynomial, roots in ((U, decaying), (L, growing)):
        for root in roots:
            assert polynomial(module.acb(str(root.real), str(root.imag))).contains(0)


def test_a_splitting_with_the_wrong_roots_is_no_start(monkeypatch: pytest.MonkeyPatch) -> None:
    guide = track_guide(DAMPED["euler-bernoulli"], Fraction(40))

    def swapped(table: Table, m: object, r: object, up: int) -> Splittings:
        s = split(table, m, r, up)
        return replace(s, z=s.z[:, [2, 1, 0, 3]])

    monkeypatch.setattr(module, "split", swapped)
    with pytest.raises(PrecisionError, match="told apart"):
        start(guide)


def test_a_depth_with_a_double_root_is_passed_over() -> None:
    """D = P⁴ − 2(1 + σ)P² + 4σ has the discriminant (1 − σ)²: double roots at σ = 1."""
    D = {(4, 0): Fraction(1), (2, 0): Fraction(-2), (2, 1): Fraction(-2), (0, 1): Fraction(4)}
    guide = Guide(0, 0, D, {(0, 0): Fraction(1)}, D, {(0, 0): Fraction(1)}, Fraction(0), Fraction(1))
    found = start(guide)
    assert found.depth == 0.5
    assert found.up == 2


def test_real_wavenumbers_are_no_start() -> None:
    D = {(2, 0): Fraction(1), (0, 0): Fraction(1)}  # P = ±i for all σ
    guide = Guide(0, 0, D, {(0, 0): Fraction(1)}, D, {(0, 0): Fraction(1)}, Fraction(0), Fraction(1))
    with pytest.raises(PrecisionError, match="told apart"):
        start(guide)


def test_a_velocity_beyond_all_waves_is_told_with_a_remedy_that_helps() -> None:
    """3·10⁸ m/s on a ballasted track: a rectangle was advised, which needs a start as well."""
    problem = problem_of("ballasted", "manchester")[0].changed("v", "3e8")
    found = certify(problem, region="unstable", digits=15, check=False)
    assert found.reason is not None
    assert str(found.reason) == ": ".join(APART)
    with pytest.raises(NoStartError, match="check v and its unit"):
        start(reduce_problem(problem).guide)


def absorbed(*parts: tuple[int, int]) -> Waveguide:
    """A beam with absorbers along it: the mass of each, and how many equal springs and dampers it is on."""
    p, omega = symbols("p Omega")
    springs = [number * (2 + I * omega / 5) for _, number in parts]
    rows = [[p**4 / 4 - omega**2 + 1 + I * omega / 10 + sum(springs), *[-spring for spring in springs]]]
    for k, ((mass, _), spring) in enumerate(zip(parts, springs, strict=True)):
        rows.append([-spring, *[(spring - mass * omega**2) * int(j == k) for j in range(len(parts))]])
    return Waveguide(rows)


def test_equal_parts_of_a_track_are_named_and_the_remedies_help() -> None:
    """Of three equal absorbers two combinations move without the beam, with the same p-roots."""
    load = Mass(2)
    found = certify(Problem(absorbed((3, 1), (3, 1), (3, 1)), load, v="0.4"), digits=15)
    assert found.reason is not None
    assert (found.reason.code, str(found.reason)) == ("start", ": ".join(REPEATED))
    for helped in (absorbed((9, 3)), absorbed((3, 1), (4, 1), (5, 1))):
        assert certify(Problem(helped, load, v="0.4"), region="unstable", digits=15).stable
