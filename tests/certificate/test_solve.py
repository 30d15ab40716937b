"""The verb of the general engine: exact bounds, words on what closes the count."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from oracle_general.package import as_problem

from mpsolve.certificate.solve import certify_problem, checked_digits
from mpsolve.errors import InputError
from mpsolve.outcome import Status
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.regions import Below, HalfPlane, Rectangle
from mpsolve.tracks import EulerBernoulli, String, Timoshenko, TwoLayer
from mpsolve.vehicles import Bogie, Coach, Mass, Oscillator, Vehicle

WIRE = Problem(String(T=27_000, m="1.07", k=500, c=2), [Mass("8.5")], v=100)


def test_sides_and_heights_are_kept_exactly() -> None:
    """Also where they are no floats in the scaled unit, with the verifier's word on them."""
    asked = Rectangle("14.1", "16.7", "-0.1", "0.9")
    found = certify_problem(WIRE, region=asked, digits=15)
    assert (found.status, found.count, found.region) == (Status.PROVED, 1, asked)
    below = certify_problem(WIRE, region=("below", "0.9"), digits=15)
    assert isinstance(below.region, Below)
    assert (below.status, below.count, below.region.height) == (Status.PROVED, 2, Fraction("0.9"))


def test_what_closes_the_count_is_said() -> None:
    assert "takes up power" in certify_problem(WIRE, region="unstable", check=False).closing
    assert "sides of the rectangle" in certify_problem(WIRE, region=Rectangle(1, 2, -1, 0), check=False).closing
    rest = Problem(WIRE.track, [Mass(1)], v=0)
    found = certify_problem(rest, region="unstable", check=False)
    assert found.closing.startswith("nothing moves")
    assert (found.note, found.count, found.region) == ("", 0, HalfPlane())
    assert certify_problem(rest, region=("below", "0.1"), check=False).closing.startswith("nothing moves")


def test_a_divergence_is_one_root_on_the_axis() -> None:
    """Two masses of 10 joined by a spring of 10 on the paper's beam at α = 1.3, η_b = 0.5: f(0) = −0.699."""
    track = EulerBernoulli(EI="1/4", m=1, k=1, c=1)
    joined = Vehicle(
        M=[[10, 0], [0, 10]], C=[[0, 0], [0, 0]], K=[[10, -10], [-10, 10]], B=[[1, 0], [0, 1]], places=[0, "1.5"]
    )
    found = certify_problem(Problem(track, [joined], v="1.3"), region="unstable", digits=20, check=False)
    assert found.proved, found.reason
    odd = [root for root in found.roots if root.q.real == 0]
    assert len(odd) == 1
    assert abs(complex(odd[0].q.mid()) + 0.0852j) < 1e-4
    assert found.unstable is not None
    assert found.unstable % 2 == 1


@pytest.mark.parametrize("digits", [14, 10_001, 20.0, "20", None, True])
def test_digits_that_are_none(digits: object) -> None:
    with pytest.raises(InputError, match="digits"):
        checked_digits(digits)


@pytest.mark.parametrize("seed", [78, 123])
def test_p_roots_that_nearly_meet_on_the_line(seed: int) -> None:
    """The verifier's nodes keep apart on their own scale, and the contour's crowds of points do not hide a root."""
    table = json.loads((Path(__file__).parents[1] / "data" / "general_counts.json").read_text())
    row = next(row for row in table if row.get("seed") == seed)
    found = certify_problem(as_problem(row), region="unstable")
    assert (found.status, found.count) == (Status.PROVED, row["count"])


SOFT = Vehicle(M=[["8.08"]], C=[["0.568"]], K=[[0]], B=[[1]], places=[0], k_contact="0.316")
ALL_BEHIND = [
    (Timoshenko(EI=1, m=1, S="2.21", J="1.76", c="0.0584"), [Mass(3).at(0), Mass(2).at(1)], "2.47"),
    (String(T=1, m=1, k="0.108", c="0.205"), [Mass("0.602").at(0), Mass("0.556").at("0.0545"), SOFT.at(1)], "1.66"),
]


@pytest.mark.parametrize("problem", ALL_BEHIND)
def test_all_p_roots_of_one_side_are_followed_where_real_ones_become_complex(
    problem: tuple[Any, list[Any], str],
) -> None:
    """No wave reaches a place ahead, so Δ̂ is a product of the vehicles': masses have no root, the soft one decays.

    All p-roots are of L, and any nodes are nodes of it; without stiffness one is 0 at q = 0.
    """
    found = certify_problem(Problem(*problem), region="unstable", digits=15)
    assert (found.status, found.count) == (Status.PROVED, 0)


def test_a_root_next_to_the_line_is_not_taken_for_one_that_was_counted() -> None:
    """One at Im q = 5e-9 beside 13 that grow, one of them on the imaginary axis; a float contour counts 13 too."""
    track = TwoLayer(EI=1, m=1, k_pad="2.25", c_pad="0.303", m_sleeper="0.32", k_ballast="2.67", c_ballast="0.096")
    bogie = Bogie(wheel="65.2", frame="11.5", inertia="71.2", wheelbase="1.13", k="16.2", k_contact="12.4")
    coach = Coach(body="39.4", inertia="0.31", bogie=bogie, pivots="5.87", k2="0.471")
    spring = Vehicle(M=[[0]], C=[[0]], K=[["0.289"]], B=[[-1, -1]], places=[0, "0.643"])
    damper = Vehicle(M=[[0]], C=[["6.16"]], K=[["5.28"]], B=[[1]], places=[0])
    problem = Problem(track, [spring, coach.at("2.59"), damper.at("2.73")], v="5.41")
    found = certify_problem(problem, region="unstable", digits=15, check=False)
    assert (found.status, found.unstable) == (Status.UNVERIFIED, 13)


def test_a_root_on_the_real_axis_is_named_and_left_out_by_the_rectangle_that_is_advised() -> None:
    """Faster than its waves the wire does not feel one vehicle: k_contact and k alone tell its two frequencies.

    Wheel 2 and body 3 on springs of 5 and 4: 6 q⁴ − 35 q² + 20 = 0, by hand.
    """
    problem = Problem(
        String(T=1, m=1, k="0.543", c="0.0134"), Oscillator(wheel=2, body=3, k=4, k_contact=5), v="1.42"
    )
    found = certify_problem(problem, digits=15)
    assert found.reason is not None
    assert (found.reason.code, found.count) == ("sign", 4)
    q = abs(float(found.reason.numbers["re"]))
    assert abs(6 * q**4 - 35 * q**2 + 20) < 1e-6
    below = certify_problem(problem, region=Rectangle(-5, 5, -1, "-0.001"), digits=15)
    assert (below.status, below.count) == (Status.PROVED, 0)


def test_without_a_stated_effort_it_ends_all_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mpsolve.certificate.solve._SECONDS", 1e-3)
    problem = Problem(EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770), [Mass(10000).at(x) for x in (0, 3)], v=200)
    found = certify_problem(problem, region="unstable")
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "effort"
    assert certify_problem(problem, region="unstable", effort=Effort()).proved
    for wrong in (0, ""):
        with pytest.raises(InputError, match="effort"):
            certify_problem(problem, region="unstable", effort=wrong)  # type: ignore[arg-type]
