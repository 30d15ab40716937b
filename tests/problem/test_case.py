"""A Case and a PhysicalCase hold exact values within their bounds, and (10)–(12) connect the two."""

from __future__ import annotations

import dataclasses
import json
import pickle
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case
from mpsolve.problem.physical import Mass, PhysicalCase

above_zero = st.fractions(min_value=Fraction(1, 1000), max_value=1000, max_denominator=1000)
at_least_zero = st.one_of(st.just(Fraction(0)), above_zero)
roots = st.builds(Exact.root4, at_least_zero)
TINY = Fraction(1, 10**300)
RAIL = {"EI": "6.4e6", "m": 60, "k": "1e6", "v": 100, "masses": ((10000, 0), (10000, "3.4"))}


def case(**changes: Any) -> Case:
    values = {"alpha": "0.67", "eta_b": "0.05", "eta_m": ("70", "70"), "positions": ("0", "1.5")}
    return Case(**(values | changes))


def rail(**changes: Any) -> PhysicalCase:
    return PhysicalCase(**(RAIL | changes))


def cases() -> st.SearchStrategy[Case]:
    return st.builds(
        lambda masses, places, alpha, eta_b, tension, eta_s: Case(
            alpha=alpha,
            eta_b=eta_b,
            eta_m=masses,
            positions=sorted(places[: len(masses)]),
            eta_n=-tension,
            eta_s=eta_s * tension,
        ),
        st.lists(above_zero, min_size=1, max_size=4),
        st.lists(roots, min_size=4, max_size=4),
        roots,
        roots,
        roots,
        at_least_zero,
    )


@st.composite
def physical_cases(draw: st.DrawFn) -> PhysicalCase:
    values = {name: draw(above_zero) for name in ("EI", "m", "k")}
    values |= {name: draw(at_least_zero) for name in ("v", "c", "kp")}
    masses = zip(draw(st.lists(above_zero, min_size=1, max_size=3)), (0, draw(above_zero), 1000), strict=False)
    return PhysicalCase(**values, N=-draw(at_least_zero), masses=masses)


def test_values_become_exact() -> None:
    assert case(alpha=0.67, eta_b=Fraction(1, 20), eta_m=np.array([70.0, 70.0]), positions=[0, 1.5]) == case()
    assert case().alpha.as_fraction() == Fraction(67, 100)
    assert case().positions == (0, Fraction(3, 2))
    assert (case().eta_n, case().eta_s, case().axial, case().count) == (0, 0, 0, 2)


@pytest.mark.parametrize("eta_m", ["70", 70, 70.0, Exact(70), Fraction(70), [70], np.float64(70)])
@pytest.mark.parametrize("positions", [None, 0, "0", (0,)])
def test_a_single_mass_may_be_given_bare(eta_m: Any, positions: Any) -> None:
    single = Case(alpha="0.67", eta_b=0, eta_m=eta_m, positions=positions)
    assert (single.eta_m, single.positions, single.count) == ((70,), (0,), 1)


@pytest.mark.parametrize(
    ("changes", "key", "reason"),
    [
        ({"alpha": "-0.1"}, "alpha", "is -0.1, but must not be below 0"),
        ({"alpha": "fast"}, "alpha", "not a number"),
        ({"alpha": [1]}, "alpha", "type list"),
        ({"eta_b": -TINY}, "eta_b", "must not be below 0"),
        ({"eta_s": "-root4(2)"}, "eta_s", "is -1.18921, but must not be below 0"),
        ({"eta_m": (70, 0)}, r"eta_m\[2\]", "is 0, but must be above 0"),
        ({"eta_m": (70, None)}, r"eta_m\[2\]", "type NoneType"),
        ({"eta_m": ()}, "eta_m", "is empty"),
        ({"eta_m": None}, "eta_m", "type NoneType"),
        ({"eta_m": {70, 71}}, "eta_m", "type set"),
        ({"eta_m": {70: 71}}, "eta_m", "type dict"),
        ({"positions": None}, "positions", "has 0 values for 2 masses"),
        ({"positions": (0, 1, 2)}, "positions", "has 3 values for 2 masses"),
        ({"positions": (1, 0)}, r"positions\[2\]", "is 0, below the 1 before it"),
        ({"positions": (0, "x")}, r"positions\[2\]", "not a number"),
        ({"eta_n": 1}, "eta_n", "is 1, not below 1, so the beam buckles"),
        ({"eta_n": "3.5", "eta_s": "2.5"}, "eta_n", "buckles"),
        ({"eta_n": "root4(1.0001)"}, "eta_n", "buckles"),
        ({"eta_n": "root4(2)", "eta_s": 1}, "eta_n", "no rational ratio"),
    ],
)
def test_a_bad_argument_is_named(changes: dict[str, Any], key: str, reason: str) -> None:
    with pytest.raises(InputError, match=f"^{key}: .*{reason}.*: "):
        case(**changes)


def test_bounds_are_exact() -> None:
    assert case(eta_n=1 - TINY).axial == 1 - TINY
    assert case(eta_n=Exact.root4(1 - TINY)).axial < 1
    assert case(eta_n="3.5", eta_s=Fraction(5, 2) + TINY).axial == 1 - TINY
    assert case(eta_n="-1e100").axial == -(10**100)
    assert case(alpha=0, eta_b=0, positions=(0, 0)).positions == (0, 0)
    assert case(eta_n="root4(8)", eta_s="root4(1/2)").axial == Exact("root4(1/2)")


@pytest.mark.parametrize(
    ("eta_b", "axial", "expected"),
    [
        ("0", "0.99", True),
        ("0.8", "0.6", False),  # N = β exactly
        ("0.8", Fraction(3, 5) - TINY, True),
        (Fraction(4, 5) - TINY, "0.6", True),
        (Fraction(4, 5) + TINY, "0.6", False),
        ("root4(1/4)", "root4(1/4)", False),  # N = β = √½, irrational
        ("root4(1/4)", Exact.root4(Fraction(1, 4) - TINY), True),
        ("root4(1/4)", Exact.root4(Fraction(1, 4) + TINY), False),
        ("0.9", "0.9", False),
        ("0.9", "0", True),
        ("0.9", "-5", True),
        (1 - TINY, "0", True),
        ("1", "0", False),
        ("1", "-5", False),
        ("1.5", "-5", False),
    ],
)
def test_cuts_on_line_is_decided_exactly(eta_b: Any, axial: Any, expected: bool) -> None:
    assert case(eta_b=eta_b, eta_n=axial).cuts_on_line is expected


@settings(max_examples=50)
@given(st.fractions(0, 2), st.fractions(-1, 1).filter(lambda n: n < 1), st.booleans())
def test_regimes_agree_with_high_precision(damping: Fraction, axial: Fraction, rooted: bool) -> None:
    eta_b = Exact.root4(damping) if rooted else Exact(damping)
    regime = case(eta_b=eta_b, eta_n=axial)
    with mpmath.workprec(500):
        b, n = eta_b.mpf(mpmath.mp), Exact(axial).mpf(mpmath.mp)
        gap = 1 - b**2 - n**2 if n > 0 else 1 - b
        assert regime.overdamped is bool(b >= 1)
        if abs(gap) > mpmath.mpf(10) ** -100:
            assert regime.cuts_on_line is bool(gap > 0)


def test_merged_sums_the_masses_at_one_place() -> None:
    parts = case(eta_m=(1, 2, 3, 4), positions=(0, 0, "root4(2)", "root4(2)"), eta_s="0.1")
    assert parts.merged == case(eta_m=(3, 7), positions=(0, "root4(2)"), eta_s="0.1")
    assert case().merged == case()
    similar = case(eta_m=("root4(2)", "root4(32)"), positions=(0, 0))
    assert similar.merged.eta_m == (Exact("root4(162)"),)
    with pytest.raises(InputError, match=r"^eta_m: .*no rational ratio"):
        assert case(eta_m=(1, "root4(2)"), positions=(0, 0)).merged


@settings(max_examples=40)
@given(cases())
def test_a_record_gives_the_case_back(original: Case) -> None:
    record = json.loads(json.dumps(original.as_dict()))
    again = Case.from_dict(record)
    assert again == original
    assert hash(again) == hash(original)
    assert again.as_dict() == original.as_dict()
    assert pickle.loads(pickle.dumps(original)) == original


def test_the_record_is_canonical() -> None:
    record = {"alpha": "67/100", "eta_b": "1/20", "eta_m": ["70", "70"], "positions": ["0", "3/2"]}
    assert case().as_dict() == record | {"eta_n": "0", "eta_s": "0"}


def test_a_record_with_a_wrong_key_is_refused() -> None:
    record = case().as_dict()
    with pytest.raises(InputError, match=r"^eta_x: is unknown"):
        Case.from_dict(record | {"eta_x": "1"})
    for name in ("alpha", "eta_b", "eta_m", "positions"):
        with pytest.raises(InputError, match=f"^{name}: is missing"):
            Case.from_dict({key: value for key, value in record.items() if key != name})


def test_cases_are_values() -> None:
    changed = dataclasses.replace(case(), alpha=Exact("0.5"))
    assert changed == case(alpha="1/2") != case()
    assert len({case(), case(alpha="67/100"), changed}) == 2
    for value, name in ((case(), "alpha"), (rail(), "EI"), (Mass(1, 0), "M")):
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(value, name, 1)
    assert pickle.loads(pickle.dumps(rail())) == rail()
    assert dataclasses.replace(rail(), v=Exact(0)).dimensionless.alpha == 0


@pytest.mark.parametrize(
    ("changes", "key", "reason"),
    [
        ({"EI": 0}, "EI", "is 0, but must be above 0"),
        ({"m": -60}, "m", "is -60, but must be above 0"),
        ({"k": "0"}, "k", "is 0, but must be above 0"),
        ({"v": -1}, "v", "must not be below 0"),
        ({"c": -1}, "c", "must not be below 0"),
        ({"kp": -1}, "kp", "must not be below 0"),
        ({"N": "much"}, "N", "not a number"),
        ({"N": "5.06e6"}, "N", r"is 5.06e\+6 N, not below .* 5.05964e\+6 N, so the beam buckles"),
        ({"k": "root4(2)"}, "k", "irrational"),
        ({"masses": ()}, "mass", "is empty"),
        ({"masses": [(1, 0), (0, 1)]}, r"mass\[2\].M", "is 0, but must be above 0"),
        ({"masses": [(1, 0), (1, "x")]}, r"mass\[2\].position", "not a number"),
        ({"masses": [(1, 0), (1, "root4(2)")]}, r"mass\[2\].position", "irrational"),
        ({"masses": [(1, 2), (1, 1)]}, r"mass\[2\].position", "is 1, below the 2 before it"),
        ({"masses": [1]}, r"mass\[1\]", "neither a Mass nor a pair"),
    ],
)
def test_a_bad_physical_argument_is_named(changes: dict[str, Any], key: str, reason: str) -> None:
    with pytest.raises(InputError, match=f"^{key}: .*{reason}.*: "):
        rail(**changes)


def test_buckling_is_decided_exactly() -> None:
    beam = {"EI": 4, "k": 9}  # 2√(k EI) = 12
    assert rail(**beam, N=12 - TINY).dimensionless.axial == 1 - TINY / 12
    assert rail(**beam, N=112, kp=100 + TINY).dimensionless.axial < 1
    for compression in (12, 12 + TINY):
        with pytest.raises(InputError, match=r"^N: .*buckles"):
            rail(**beam, N=compression)


def test_the_rail_of_section_4() -> None:
    """χ = 0.445 1/m, α = 0.344 and η_M = 74.1 are the numbers that Section 4.1 quotes from [39]."""
    physical = rail()
    assert [physical.chi.short(3), physical.dimensionless.alpha.short(3)] == ["0.445", "0.344"]
    assert [ratio.short(3) for ratio in physical.dimensionless.eta_m] == ["74.1", "74.1"]
    assert physical.chi.fourth_power == Fraction(5, 128)
    assert physical.time_scale * physical.time_scale == Fraction(10**6, 60)
    assert physical.v_cr * physical.chi == physical.time_scale


@settings(max_examples=40)
@given(physical_cases())
def test_the_dimensionless_values_are_those_of_10_to_12(physical: PhysicalCase) -> None:
    case = physical.dimensionless
    with mpmath.workprec(200):
        names = ("EI", "m", "k", "v", "c", "kp", "N")
        EI, m, k, v, c, kp, N = (getattr(physical, name).mpf(mpmath.mp) for name in names)
        chi = mpmath.root(k / (4 * EI), 4)
        expected = [
            v / mpmath.root(4 * k * EI / m**2, 4),
            c / (2 * mpmath.sqrt(m * k)),
            N / (2 * mpmath.sqrt(k * EI)),
            kp / (2 * mpmath.sqrt(k * EI)),
            *(mass.M.mpf(mpmath.mp) * chi / m for mass in physical.masses),
            *(mass.position.mpf(mpmath.mp) * chi for mass in physical.masses),
        ]
        actual = [case.alpha, case.eta_b, case.eta_n, case.eta_s, *case.eta_m, *case.positions]
        for value, want in zip(actual, expected, strict=True):
            assert abs(value.mpf(mpmath.mp) - want) <= abs(want) * mpmath.mpf(2) ** -190


@settings(max_examples=40)
@given(physical_cases(), above_zero, above_zero, above_zero)
def test_other_units_leave_the_dimensionless_case(
    physical: PhysicalCase, metre: Fraction, kilogram: Fraction, second: Fraction
) -> None:
    newton = kilogram * metre / second**2
    units = {"EI": newton * metre**2, "m": kilogram / metre, "k": newton / metre**2, "v": metre / second}
    units |= {"c": newton * second / metre**2, "kp": newton, "N": newton}
    scaled = PhysicalCase(
        **{name: getattr(physical, name) * unit for name, unit in units.items()},
        masses=[(mass.M * kilogram, mass.position * metre) for mass in physical.masses],
    )
    assert scaled.dimensionless == physical.dimensionless
    assert scaled.chi * metre == physical.chi
    assert scaled.time_scale * second == physical.time_scale


def test_the_longest_physical_values_still_make_a_record() -> None:
    top, bottom = 10**400 - 1, 10**400 - 2
    long, inverse = Fraction(top, bottom), Fraction(bottom - 2, top - 1)
    physical = rail(EI=long, m=long, k=inverse, v=inverse, masses=[(inverse, 0), (inverse, long)], c=long)
    record = physical.dimensionless.as_dict()
    assert max(len(item) for item in record["eta_m"]) > 4000
    assert Case.from_dict(record) == physical.dimensionless


def test_a_mass_keeps_its_force() -> None:
    mass = Mass(10, "1.5", P="1e5", P_A=200, omega_f="0.5", phi_f="-0.1")
    assert (mass.P, mass.P_A, mass.omega_f) == (10**5, 200, Fraction(1, 2))
    assert mass.phi_f == Fraction(-1, 10)
    assert rail(masses=[Mass(10, 0), mass]).masses[1] == mass
