"""Values and their floats are rounded outward; data is plain."""

from fractions import Fraction

from mpsolve.numbers.balls import arb, precision
from mpsolve.ranges.answer import outward, plain, within


def test_floats_of_a_ball_hold_it() -> None:
    with precision(200):
        ball = arb(1) / 3
        low, high = outward(ball, up=False), outward(ball, up=True)
        assert arb(low) < ball < arb(high)
        assert high - low < 1e-15
    assert (outward(arb(0.5), up=False), outward(arb(0.5), up=True)) == (0.5, 0.5)


def test_whether_a_ball_lies_in_a_range() -> None:
    interval = (Fraction(1, 3), Fraction(2, 3))
    assert within(arb(0.5), interval) is True
    assert within(arb(0.7), interval) is False
    with precision(100):
        assert within(arb(1) / 3, interval) is None


def test_data_is_plain() -> None:
    data = plain({"a": arb(2), "b": (Fraction(1, 3), None)})
    assert float(data["a"]["decimal"]) == data["a"]["lower"] == 2
    assert data["b"] == [{"exact": "1/3", "decimal": 1 / 3}, None]
