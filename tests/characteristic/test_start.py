"""Where the splitting starts, against p-roots at 40 digits."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from receptance_truth import Receptance
from track_models import DAMPED

from mpsolve import certify
from mpsolve.characteristic import start as module
from mpsolve.characteristic.discs import Splittings, split
from mpsolve.characteristic.start import APART, NoStartError, factors, start
from mpsolve.characteristic.table import Table
from mpsolve.errors import PrecisionError
from mpsolve.presets.written import problem_of
from mpsolve.problem.reduced import Guide, reduce_problem, track_guide


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
