"""Loads are exact, one for each mass, and those of a physical case are its forces in newtons."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Case, InputError, Mass, PhysicalCase
from mpsolve.numbers.exact import Exact
from mpsolve.problem.load import loads_of
from mpsolve.vehicles.load import Load

CASE = Case(alpha="0.5", eta_b="0.1", eta_m=(70, 70), positions=(0, 1))


def test_a_load_is_one_constant_unit_by_default() -> None:
    assert (Load().constant, Load().amplitude, Load().frequency, Load().phase) == (1, 0, 0, 0)
    assert Load(0.1).constant == Fraction(1, 10)
    assert loads_of(CASE) == (Load(), Load())


def test_the_forces_of_a_physical_case_come_in_units_of_one_newton() -> None:
    masses = [Mass(100, 0, P=7, P_A=3, omega_f=20, phi_f="0.5"), Mass(100, 2)]
    case = PhysicalCase(EI="6e6", m=60, k="1e6", v=50, masses=masses)
    first, second = loads_of(case)
    assert (first.constant, first.amplitude, first.phase) == (7, 3, Fraction(1, 2))
    assert float(first.frequency) == pytest.approx(20 / (1e6 / 60) ** 0.5, rel=1e-15)
    assert second.constant == 0


def test_masses_without_any_force_carry_their_weight() -> None:
    case = PhysicalCase(EI="6e6", m=60, k="1e6", v=50, masses=[Mass(100, 0), Mass("0.5", 2)])
    assert [float(load.constant) for load in loads_of(case)] == [980.665, 4.903325]


@pytest.mark.parametrize(
    ("loads", "key"),
    [
        ((Load(),), "loads"),
        ((Load(),) * 3, "loads"),
        ((Load(), 1), r"loads\[2\]"),
        (5, "loads"),
        ("ab", "loads"),
        ({"a": 1}, "loads"),
    ],
)
def test_loads_that_fit_no_case_are_refused(loads: Any, key: str) -> None:
    with pytest.raises(InputError, match=key):
        loads_of(CASE, loads)


def test_a_wrong_number_is_named() -> None:
    with pytest.raises(InputError, match="frequency"):
        Load(frequency="much")
    assert Load(constant="-2").constant == Exact(-2)


@pytest.mark.parametrize("size", ["1e151", "-1e151", "1e-151"])
def test_forces_beyond_float64_are_refused(size: str) -> None:
    with pytest.raises(InputError, match=r"amplitude: is .* not within 1e-150 to 1e150"):
        Load(0, size, 1)


def test_a_physical_force_beyond_float64_is_named_by_its_key() -> None:
    case = PhysicalCase(EI="6e6", m=60, k="1e6", v=50, masses=[Mass(100, 0), Mass("1e300", 2)])
    with pytest.raises(InputError, match=r"^mass\[2\].M: is 9.80665e\+300, not within"):
        loads_of(case)
    pushed = PhysicalCase(EI="6e6", m=60, k="1e6", v=50, masses=[Mass(100, 0, P="1e200")])
    with pytest.raises(InputError, match=r"^mass\[1\].P: "):
        loads_of(pushed)


def test_a_case_that_is_none_is_refused() -> None:
    with pytest.raises(InputError, match="case: is NoneType"):
        loads_of(None)  # type: ignore[arg-type]
