"""The amplification of finite trains: enclosed, with the growth per wheel of the endless row."""

from __future__ import annotations

from fractions import Fraction

import pytest
from endless_rows import masses

from mpsolve import Effort, InputError, amplification
from mpsolve.endless.axis import gains
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.ratio import Largest, Ratio
from mpsolve.problem.reduced import reduce_problem


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
