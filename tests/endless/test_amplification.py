"""The amplification of finite trains: enclosed, with the growth per wheel of the endless row."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest
from endless_rows import BEAM, bogies, masses

from mpsolve import Effort, InputError, amplification, receptance
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.start import start
from mpsolve.endless.amplification import Largest, Ratio
from mpsolve.endless.axis import gains
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.row import Row
from mpsolve.problem.reduced import Reduced, reduce_problem


def test_it_grows_with_the_train_where_the_row_does_and_falls_where_it_does_not() -> None:
    back = {n: amplification(masses("0.4").train(n)) for n in (16, 24, 32)}
    assert all(one.proved and one.stable for one in back.values())
    peaks = [one.back for one in back.values()]
    assert all(peak is not None and peak.low <= peak.high <= peak.low * (1 + 2e-6) for peak in peaks)
    factor = gains(Bloch(masses("0.4")), 1.0)[1].factor
    per_wheel = (back[32].back.low / back[24].back.low) ** (1 / 8)  # type: ignore[union-attr]
    assert 1.02 < per_wheel < factor
    assert back[32].ahead.high < back[16].ahead.low  # type: ignore[union-attr]
    calm = [amplification(masses("0.1").train(n)).back for n in (8, 16)]
    assert calm[1].high < calm[0].low  # type: ignore[union-attr]


def test_a_band_whose_ends_are_no_floats_is_looked_at_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    seen = []

    def largest(_: Ratio, low: float, high: float, *__: object) -> Largest:
        seen.append((low, high))
        return Largest(0.0, 1.0, low)

    monkeypatch.setattr(Ratio, "largest", largest)
    for band in (("1/10", "1/3"), ("2/5", "9/10"), ("3/7", "6/7")):
        train = masses("0.4").train(2)
        amplification(train, band=band)
        unit = reduce_problem(train).frequency_unit
        assert all(Fraction(low) * unit <= Fraction(band[0]) for low, _ in seen[-2:])
        assert all(Fraction(high) * unit >= Fraction(band[1]) for _, high in seen[-2:])


def test_at_rest_both_directions_are_alike() -> None:
    found = amplification(masses("0").train(3), band=("0.1", 1))
    assert found.ahead is not None
    assert found.back is not None
    assert abs(found.ahead.low - found.back.low) < 2e-6 * found.back.low


def test_an_unstable_train_is_said_to_be_so() -> None:
    found = amplification(masses("0.62").train(4), band=(0, "0.5"))
    assert (found.proved, found.stable) == (False, False)
    assert found.reason is not None
    assert found.reason.code == "unstable"


def test_what_it_refuses_and_what_it_leaves_open() -> None:
    with pytest.raises(InputError, match="two"):
        amplification(masses("0.1").train(1))
    with pytest.raises(InputError, match="band"):
        amplification(masses("0.1").train(2), band=(1, 0))
    with pytest.raises(InputError, match="tolerance"):
        amplification(masses("0.1").train(2), tolerance=0)
    found = amplification(masses("0").train(2), band=(0, 1), effort=Effort(evaluations=100))
    assert found.reason is not None
    with pytest.raises(TypeError):
        bool(found)


def test_the_bounds_known_when_the_effort_ends_are_given(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mpsolve.endless.amplification._EVALUATIONS", 360)
    monkeypatch.setattr("mpsolve.endless.amplification._LEAST", 1)
    found = amplification(masses("0.4").train(5), band=(0, 1))
    assert not found.proved
    assert found.reason is not None
    assert found.reason.code == "effort"
    for peak in (found.ahead, found.back):
        assert peak is not None
        assert 0 < peak.low < peak.high


def by_hand(v: float, count: int, q: float) -> tuple[float, float]:
    """(back, ahead) for masses of 40 at distances of 1.5: λ = (C + G)⁻¹ε with C = −1/(40 q²)."""
    x = 1.5 * np.arange(count)
    G = receptance(BEAM, (x[:, None] - x[None, :]).ravel(), [q], v=v).reshape(count, count)
    force = np.linalg.inv(G - np.eye(count) / (40 * q * q))
    return abs(force[0, -1] / force[-1, -1]), abs(force[-1, 0] / force[0, 0])


def test_the_ratio_is_that_of_the_receptances() -> None:
    reduced = reduce_problem(masses("0.4").train(4))
    up = start(reduced.guide).up
    for q in (0.05, 0.195, 0.7):
        at = np.array([q + 0j])
        for truth, source, target in zip(by_hand(0.4, 4, q), (3, 0), (0, 3), strict=True):
            jet, fine = Ratio(Arrays(reduced), up, source, target).jets(at, at)
            assert fine.all()
            assert abs(abs(jet.a[0]) - truth) < 1e-9 + jet.e[0]


def shaken_in_full(reduced: Reduced, q: float, source: int, target: int) -> float:
    """The same by the whole bordered matrix with a unit in the row of the contact."""
    from mpsolve.characteristic.bordering import Bordering
    from mpsolve.characteristic.floats import Receptance
    from mpsolve.numbers.float64 import Float64

    border, sigma = Bordering.of(reduced, eliminate=False), np.array([1j * q])
    G = Receptance(reduced.guide)(sigma, border.distances, slope=False)[0]
    A = border.at(Float64(), sigma, G)[0]
    right = np.zeros(len(A))
    right[reduced.bodies + source] = 1
    force = np.linalg.solve(A, right)[reduced.bodies :]
    return float(abs(force[target] / force[source]))


@pytest.mark.parametrize("make", [masses, bogies])
def test_coupled_wheels_and_discs_of_some_size(make: Callable[[str], Row]) -> None:
    reduced = reduce_problem(make("0.4").train(2))
    up, last = start(reduced.guide).up, reduced.contacts - 1
    a, b = np.array([0.3, 0.5, 1.0]) + 0j, np.array([0.302, 0.503, 1.001]) + 0j
    for source, target in ((0, last), (last, 0)):
        jet, fine = Ratio(Arrays(reduced), up, source, target).jets(a, b)
        assert fine.all()
        for share in (-1, -0.4, 0.3, 1):
            q = ((a + b) / 2 + share * (b - a) / 2).real
            truth = [shaken_in_full(reduced, x, source, target) for x in q]
            value = np.abs(jet.a + jet.b * 1j * share * (b - a) / 2)
            assert (np.abs(value - truth) <= jet.e + 1e-9).all()
        assert (jet.e < 0.05 * np.abs(jet.a) + 0.01).all()


def test_the_maximum_is_enclosed() -> None:
    reduced = reduce_problem(masses("0.4").train(5))
    ratio = Ratio(Arrays(reduced), start(reduced.guide).up, 4, 0)
    found = ratio.largest(0.0, 1.0, 1e-6, Effort(evaluations=20_000))
    grid = max(by_hand(0.4, 5, q)[0] for q in np.linspace(0.15, 0.3, 1501))
    assert found.low <= found.high <= found.low * (1 + 2e-6)
    assert 0 < found.high - grid < 1e-2 * grid
    assert abs(by_hand(0.4, 5, found.q)[0] - found.low) < 1e-5


def test_what_is_known_when_the_effort_ends_holds_too() -> None:
    reduced = reduce_problem(masses("0.4").train(5))
    ratio = Ratio(Arrays(reduced), start(reduced.guide).up, 4, 0)
    truth = ratio.largest(0.0, 1.0, 1e-6, Effort(evaluations=20_000))
    for evaluations in (300, 350, 400):
        early = ratio.largest(0.0, 1.0, 1e-6, Effort(evaluations=evaluations))
        assert early.reason is not None
        assert early.low <= truth.high
        assert early.high >= truth.low
    assert early.high < 2 * truth.high
    assert ratio.largest(0.0, 1.0, 1e-6, Effort(evaluations=100)).high == np.inf
