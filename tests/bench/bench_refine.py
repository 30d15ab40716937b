"""One root sharpened from about 30 digits to many, against Δ and Δ_q evaluated once at the last precision."""

from __future__ import annotations

import math
from unittest import mock

import pytest
from measure import Counted, median, seconds

from mpsolve import Case
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.model.characteristic import characteristic, characteristic_rate
from mpsolve.sheet import enclose

GOAL = 4
CASE = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
SEED = 0.1558609631 - 0.0000272301j
START_BITS = 112  # the box is known to about 30 digits
REPEATS = {100: 25, 1000: 15, 10_000: 5}


def compare(digits: int) -> None:
    box, repeats = enclose.isolate(CASE, SEED, START_BITS), REPEATS[digits]
    bits = math.ceil(digits * math.log2(10))
    values, slopes = Counted(characteristic), Counted(characteristic_rate)
    with (
        mock.patch.object(enclose, "characteristic", values),
        mock.patch.object(enclose, "characteristic_rate", slopes),
    ):
        ball = enclose.refine(CASE, box, digits)
    sharpening = median(lambda: enclose.refine(CASE, box, digits), repeats)
    with ball_arithmetic(bits) as field:
        model, middle = track(CASE, field), ball.q.mid()
        once = median(lambda: characteristic_rate(model, middle), repeats)
        value, slope = characteristic_rate(model, ball.q)
    print(
        f"{digits:6} digits   refine {seconds(sharpening)} "
        f"({values.calls} of Δ, {slopes.calls} of Δ and Δ_q, at rising precision)   "
        f"Δ and Δ_q once {seconds(once)}   refine/once = {sharpening / once:.2f}  (goal at 10,000: {GOAL} or less)"
    )
    assert box.q.contains(ball.q)
    assert value.contains(0)
    assert not slope.contains(0)


@pytest.mark.parametrize("digits", REPEATS)
def test_a_sharpened_root_is_a_root(digits: int) -> None:
    compare(digits)


def main() -> None:
    for digits in REPEATS:
        compare(digits)


if __name__ == "__main__":
    main()
