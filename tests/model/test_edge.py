"""G± on the cut: the limit of R·Δ from either side, finite at branch points; its balls hold every point."""

from __future__ import annotations

import dataclasses
from typing import Any

import flint
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from oracle import Truth, cases, grid, holds

from mpsolve import Case
from mpsolve.errors import PrecisionError
from mpsolve.fields import MP, ball_arithmetic
from mpsolve.model import scaled
from mpsolve.model.branch import pairing, track
from mpsolve.model.characteristic import characteristic
from mpsolve.model.edge import EdgeValue, edge_roots, edge_value
from mpsolve.model.limits import branch_points

few = settings(max_examples=25)
numbers = pytest.mark.parametrize("masses", [1, 2, 3])


def one_sided(case: Case, r: Any, side: int) -> Any:
    """R·Δ at q = r + iη_b − side·iε by (26), conjugated above the cut."""
    truth = Truth(case, 80)
    q = truth.mp.mpf(r) + truth.mp.j * (truth.eta_b - side * truth.mp.mpf(10) ** -40)
    value = truth.resultant(q) * truth.delta(q)
    return value if side > 0 else value.conjugate()


# the truth is taken 1e-40 beside the edge: what that may change, and no more, is added to the ball
BESIDE = flint.acb(flint.arb(0, 1e-30), flint.arb(0, 1e-30))


def close(ball: Any, truth: Any, tolerance: float) -> bool:
    return bool(abs(flint.acb(ball) - flint.acb(truth)) < tolerance * (1 + abs(flint.acb(truth))))


def at(case: Case, r: Any, reach: float = 0, bits: int = 100) -> EdgeValue:
    with ball_arithmetic(bits) as field:
        return edge_value(track(case, field), flint.arb(r, reach))


@numbers
@few
@given(st.data())
def test_the_edge_is_the_limit_from_either_side(masses: int, data: st.DataObject) -> None:
    case = data.draw(cases(masses=masses))
    r = data.draw(grid(0.05, 6))
    assume(all(abs(r - p) > 1e-3 for p in branch_points(case)))
    value = at(case, r)
    assert close(value.plus, one_sided(case, r, 1), 1e-15)
    assert close(value.minus, one_sided(case, r, -1), 1e-15)


CASES = {
    "subcritical": {"alpha": "0.5", "eta_b": "0.05"},
    "supercritical, four real p-roots": {"alpha": "1.3", "eta_b": "0.05"},
    "second branch points on the cut": {"alpha": "0.1", "eta_b": "0", "eta_n": "0.6"},
    "tension": {"alpha": "0.7", "eta_b": "0.2", "eta_n": "-1.5"},
    "standing load": {"alpha": "0", "eta_b": "0.05", "eta_n": "0.3"},
    "standing load in tension": {"alpha": "0", "eta_b": "0", "eta_s": "0.3"},
}
MASSES = [((70,), (0,)), ((70, 70), (0, "1.5")), ((70, 30), (0, "0.25")), ((70, 30, 5), (0, 1, "2.5"))]
named = pytest.mark.parametrize("name", CASES)
loads = pytest.mark.parametrize(("eta_m", "positions"), MASSES)


@named
@loads
def test_the_edge_of_typical_cases(name: str, eta_m: tuple[int, ...], positions: tuple[Any, ...]) -> None:
    case = Case(**CASES[name], eta_m=eta_m, positions=positions)
    for r in (0.125, 0.375, 0.75, 0.96875, 1.5, 4.0, 20.0):
        value = at(case, r)
        assert close(value.plus, one_sided(case, r, 1), 1e-15)
        assert close(value.minus, one_sided(case, r, -1), 1e-15)
        assert (value.plus - value.plus.mid()).abs_upper() < 1e-18 * (1 + value.plus.abs_upper())


def test_the_cases_are_what_their_names_say() -> None:
    with ball_arithmetic(100) as field:
        z = edge_roots(track(Case(**CASES["supercritical, four real p-roots"], eta_m=1), field), 0.125)
        assert all(p.imag == 0 for p in (z.a, z.b, z.c, z.e))
    assert len(branch_points(Case(**CASES["second branch points on the cut"], eta_m=1))) > 1


@named
@loads
def test_the_edge_is_finite_through_its_branch_points(
    name: str, eta_m: tuple[int, ...], positions: tuple[Any, ...]
) -> None:
    """K has a pole in √(r − r_b) there, G has none: a ball about the point shrinks like its square root."""
    case = Case(**CASES[name], eta_m=eta_m, positions=positions)
    if name == "standing load" and len(eta_m) > 2:  # two pairs meet at once: refused, not guessed
        with pytest.raises(PrecisionError, match="two pairs of p-roots meet"):
            at(case, branch_points(case)[0], 1e-11)
        return
    for r in branch_points(case):
        wide, narrow = at(case, r, 1e-7), at(case, r, 1e-11)
        for side, before, ball in ((1, wide.plus, narrow.plus), (-1, wide.minus, narrow.minus)):
            truths = [one_sided(case, r + shift * 1e-11, side) for shift in (-0.9, -0.1, 0.2, 0.9)]
            assert all(holds(ball + BESIDE, truth) for truth in truths)
            assert (ball - ball.mid()).abs_upper() < 0.02 * (before - before.mid()).abs_upper()


@numbers
@few
@given(st.data())
def test_a_ball_of_r_holds_every_point(masses: int, data: st.DataObject) -> None:
    case = data.draw(cases(masses=masses))
    r, shrink = data.draw(grid(0.05, 6)), data.draw(st.integers(6, 24))
    reach, inside = 2.0**-shrink, data.draw(st.sampled_from([-0.99, -0.5, 0.0, 0.3, 0.99]))
    try:
        value = at(case, r, reach)
    except PrecisionError:
        return
    assert holds(value.plus + BESIDE, one_sided(case, r + inside * reach, 1))
    assert holds(value.minus + BESIDE, one_sided(case, r + inside * reach, -1))


@few
@given(cases(masses=2), grid(0.05, 6))
def test_two_formulas_for_two_masses_agree(case: Case, r: float) -> None:
    """The bordered determinant of many masses against the double divided difference."""
    with ball_arithmetic(150) as field:
        model = track(case, field)
        roots = edge_roots(model, r)
        kappas = [2 * (flint.arb(r) + s * flint.acb(0, 1) * model.eta_b) ** 2 / field.pi for s in (1, -1)]
        for special, general in zip(
            scaled._expand_two(model, roots, kappas, 1), scaled._expand_many(model, roots, kappas, 1), strict=True
        ):
            assert special.overlaps(general)
            assert (special - general).abs_upper() < 1e-20 * (1 + special.abs_upper())


def test_one_mass_is_two_at_no_distance() -> None:
    with ball_arithmetic(150) as field:
        model = track(Case(alpha="0.5", eta_b="0.05", eta_m=(3, 4), positions=(0, "1e-20")), field)
        single = track(Case(alpha="0.5", eta_b="0.05", eta_m=7), field)
        assert abs(edge_value(model, 0.9).plus - edge_value(single, 0.9).plus) < 1e-15


def test_edge_roots_lie_where_the_sheet_says() -> None:
    """The two upper p-roots of the sheet, as the cut is approached from below, and their factor's sum s."""
    case = Case(alpha="0.5", eta_b="0.05", eta_m=1)
    model = track(case, MP(300))
    pair = pairing(model, model.field.context.mpc(1, model.eta_b - model.field.context.mpf(10) ** -50))
    with ball_arithmetic(100) as field:
        z = edge_roots(track(case, field), 1)
        assert close(z.a + z.b, pair.s, 1e-25)
        assert close(z.R, pair.R, 1e-25)


def test_the_edge_joins_delta_in_the_gap() -> None:
    """At |r| < q_lm there is no cut: G₊ is R·Δ at q = r + iη_b itself."""
    case = Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    model = track(case, MP(200))
    q = model.field.context.mpc(0.25, model.eta_b)
    assert close(at(case, 0.25).plus, pairing(model, q).R * characteristic(model, q), 1e-25)
    assert dataclasses.is_dataclass(at(case, 0.25))
