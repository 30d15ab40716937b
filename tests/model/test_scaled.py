"""R·det[unit·I − κ K M] from the p-roots against the residue sums: any masses, κ, unit and order of roots."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Truth, cases, frequencies, grid, holds

from mpsolve import Case
from mpsolve.discs import DiscField, Discs, DualField
from mpsolve.dual import Dual
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import Track, track
from mpsolve.model.scaled import SplitRoots, scaled_characteristic

few = settings(max_examples=12)
numbers = pytest.mark.parametrize("masses", [1, 2, 3, 4])
factors = st.builds(complex, grid(-2, 2), grid(-2, 2))


def exact(truth: Truth, q: Any, kappa: Any, unit: Any) -> Any:
    """R det[unit·I − κ K M]."""
    order, p_roots = range(len(truth.x)), truth.p_roots(q)
    rows = [
        [
            (i == k) * unit - kappa * truth.eta_m[k] * truth._residue_sum(truth.x[i] - truth.x[k], q, p_roots)
            for k in order
        ]
        for i in order
    ]
    return truth.resultant(q) * truth.mp.det(truth.mp.matrix(rows))


def orders(truth: Truth, q: Any) -> list[tuple[Any, Any, Any, Any]]:
    (a, b), (c, e) = truth.p_roots(q)
    return [(u, v, w, z) for u, v in ((a, b), (b, a)) for w, z in ((c, e), (e, c))]


@numbers
@few
@given(st.data(), factors, factors)
def test_balls_hold_the_determinant_in_any_order_of_roots(
    masses: int, data: st.DataObject, kappa: complex, unit: complex
) -> None:
    case = data.draw(cases(masses=masses))
    q = data.draw(frequencies(case))
    truth = Truth(case, 80)
    expected = exact(truth, q, kappa, unit)
    with ball_arithmetic(200) as field:
        for order in orders(truth, q):
            roots = SplitRoots(*(_ball(p) for p in order))
            values = scaled_characteristic(
                track(case, field), roots, [flint.acb(kappa), flint.acb(1)], flint.acb(unit)
            )
            assert len(values) == 2
            assert holds(values[0], expected)
            assert (values[0] - values[0].mid()).abs_upper() < 1e-25 * (1 + abs(flint.acb(expected)))


def _ball(p: Any) -> Any:
    spread = flint.arb(0, 1e-60)
    return flint.acb(p) + flint.acb(spread, spread)


@numbers
@few
@given(st.data())
def test_the_factor_of_26_gives_r_times_delta(masses: int, data: st.DataObject) -> None:
    case = data.draw(cases(masses=masses))
    q = data.draw(frequencies(case))
    truth = Truth(case, 80)
    with ball_arithmetic(200) as field:
        kappa = 2 * flint.acb(q) ** 2 / field.pi
        for order in orders(truth, q)[:1]:
            roots = SplitRoots(*(_ball(p) for p in order))
            (value,) = scaled_characteristic(track(case, field), roots, [kappa])
            assert holds(value, truth.resultant(q) * truth.delta(q))
            assert holds(roots.R, truth.resultant(q))


def disc(p: Any) -> Discs:
    return Discs(np.array([complex(p)]), np.array([1e-15 * (1 + abs(complex(p)))]))


@numbers
@few
@given(st.data(), factors, grid(0, 1))
def test_discs_hold_the_determinant(masses: int, data: st.DataObject, kappa: complex, unit: float) -> None:
    case = data.draw(cases(masses=masses))
    q = data.draw(frequencies(case, 2**-4))
    truth = Truth(case, 50)
    expected = exact(truth, q, kappa, unit)
    model = track(case, DiscField())
    for order in orders(truth, q):
        with np.errstate(all="ignore"):
            roots = SplitRoots(*(disc(p) for p in order))
            (value,) = scaled_characteristic(model, roots, [Discs(np.array([kappa]))], unit)
        radius = float(value.r[0])
        if np.isfinite(radius):
            assert abs(expected - complex(value.m[0])) <= radius


@numbers
@few
@given(st.data(), grid(0.25, 2))
def test_slopes_by_dual_numbers(masses: int, data: st.DataObject, unit: float) -> None:
    """Along each p-root, and along the positions, as differences of the same formula in balls."""
    case = data.draw(cases(masses=masses))
    q = data.draw(frequencies(case, 2**-4))
    truth = Truth(case, 60)
    speeds = data.draw(st.lists(grid(-1, 1), min_size=4 + masses, max_size=4 + masses))
    order = orders(truth, q)[0]
    model = track(case, DiscField())
    dual = [Dual(disc(p), [speed]) for p, speed in zip(order, speeds, strict=False)]
    places = tuple(Dual(x, [speed]) for x, speed in zip(model.positions, speeds[4:], strict=True))
    with np.errstate(all="ignore"):
        moving = replace(model, field=DualField(), positions=places)
        (value,) = scaled_characteristic(moving, SplitRoots(*dual), [Dual(disc(0.7 - 0.2j), [0])], unit)
    with ball_arithmetic(400) as field:
        balls, h = track(case, field), flint.arb(2) ** -120
        ends = [_moved(balls, order, speeds, step, unit) for step in (h, -h)]
        slope = (ends[0] - ends[1]) / (2 * h)
        found, radius = value.slopes[0], float(value.slopes[0].r[0])
        if np.isfinite(radius):
            assert (slope - flint.acb(complex(found.m[0]))).abs_upper() < radius * (1 + 1e-9) + 1e-15


def _moved(model: Track, order: Any, speeds: Any, step: Any, unit: float) -> Any:
    roots = SplitRoots(*(flint.acb(p) + step * speed for p, speed in zip(order, speeds, strict=False)))
    places = tuple(x + step * speed for x, speed in zip(model.positions, speeds[4:], strict=True))
    return scaled_characteristic(replace(model, positions=places), roots, [flint.acb(0.7, -0.2)], flint.acb(unit))[0]


@numbers
def test_a_shared_disc_of_a_colliding_pair_is_finite(masses: int) -> None:
    """a and c in one disc that holds both: an enclosure of the value, though K has a pole within."""
    places = ("0", "0.5", "1.5", "2")[:masses]
    case = Case(alpha="0.6", eta_b="0.001", eta_m=(1, 2, 3, 1)[:masses], positions=places)
    truth = Truth(case, 50)
    q = truth.mp.mpf("0.49")
    (a, c), (b, e) = _closest(*truth.p_roots(q))
    centre = complex(a + c) / 2
    hull = Discs(np.array([centre]), np.array([1.01 * abs(complex(a - c)) / 2]))
    with np.errstate(all="ignore"):
        roots = SplitRoots(hull, disc(b), hull, disc(e))
        kappa = Discs(np.array([2 * 0.49**2 / np.pi]), np.array([1e-14]))
        (value,) = scaled_characteristic(track(case, DiscField()), roots, [kappa])
    assert np.isfinite(value.r[0])
    assert abs(truth.resultant(q) * truth.delta(q) - complex(value.m[0])) <= float(value.r[0])


def _closest(upper: Any, lower: Any) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
    pairs = [(abs(upper[j] - lower[k]), j, k) for j in (0, 1) for k in (0, 1)]
    _, j, k = min(pairs, key=lambda pair: pair[0])
    return (upper[j], lower[k]), (upper[1 - j], lower[1 - k])
