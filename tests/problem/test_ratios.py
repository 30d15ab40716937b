"""The paper's ratios as paths, against the cases that have them."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import Case, InputError, Problem, crossings, onset, prove_stable, tracks, vehicles, worst
from mpsolve.numbers.balls import precision
from mpsolve.problem.cases import as_problem

CASE = {
    "alpha": "0.7",
    "eta_b": "0.05",
    "eta_m": (70, 70, 70),
    "positions": (0, "1.5", 3),
    "eta_n": "0.1",
    "eta_s": "0.2",
}


@pytest.mark.parametrize(
    ("path", "value", "keys"),
    [
        ("alpha", "0.9", {"alpha": "0.9"}),
        ("eta_b", "0.3", {"eta_b": "0.3"}),
        ("eta_n", "-0.4", {"eta_n": "-0.4"}),
        ("eta_s", "0.7", {"eta_s": "0.7"}),
        ("eta_m", "12", {"eta_m": (12, 12, 12)}),
        ("d", "2", {"positions": (0, 2, 4)}),
    ],
)
def test_a_ratio_changes_the_case(path: str, value: str, keys: dict[str, object]) -> None:
    changed = as_problem(Case(**CASE)).changed(path, value)  # type: ignore[arg-type]
    assert changed == as_problem(Case(**(CASE | keys)))  # type: ignore[arg-type]


def test_only_a_case_has_them() -> None:
    rail = Problem(tracks.EulerBernoulli(EI=6.4e6, m=60, k=1e6, c=770), vehicles.Mass(900), v=10)
    with pytest.raises(InputError, match="unknown"):
        rail.changed("alpha", "0.5")
    with pytest.raises(InputError, match="eta_s"):
        as_problem(Case(**CASE)).changed("eta_x", "0.5")  # type: ignore[arg-type]
    with pytest.raises(InputError) as caught:
        as_problem(Case(**CASE)).changed("eta_b", "-1")  # type: ignore[arg-type]
    assert caught.value.key == "eta_b"
    one = as_problem(Case(alpha="0.5", eta_b="0.1", eta_m=3, positions=0))
    with pytest.raises(InputError, match="unknown"):
        one.changed("d", 2)


def test_answers_are_in_their_names() -> None:
    case = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    by_ratio, plain = onset(case, over={"alpha": ("0.6", "0.7")}), onset(case, over={"v": ("0.6", "0.7")})
    assert list(by_ratio.over) == ["alpha"]
    with precision(80):
        assert by_ratio.value.overlaps(plain.value)  # type: ignore[union-attr]
    mass = crossings(case, over={"eta_m": (20, 80)}, check=False)
    with precision(80):
        scaled = crossings(case, over={"scale.mass": ("2/7", "8/7")}, check=False)
        assert (mass.crossings[0].value - scaled.crossings[0].value * 70).contains(0)
    damped = crossings(case, over={"eta_b": ("0.04", "0.1")}, check=False)
    assert damped.proved
    assert prove_stable(case, over={"alpha": ("0.1", "0.3"), "eta_b": ("0.04", "0.06")}, check=False).stable
    assert worst(case, over={"d": (1, 2)}, check=False).over == {"d": (Fraction(1), Fraction(2))}
