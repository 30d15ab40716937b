from fractions import Fraction

import numpy as np
import pytest

from mpsolve.errors import InputError
from mpsolve.numbers.float_list import checked_places, checked_times, float_list


@pytest.mark.parametrize("given", ["0.5", 0.5, Fraction(1, 2), np.float64(0.5), np.array(0.5), [0.5], (0.5,)])
def test_one_number_may_come_in_any_form(given):
    assert float_list(given, "times").tolist() == [0.5]


@pytest.mark.parametrize(
    ("given", "word"),
    [(["1e350"], r"times\[1\].*beyond"), (np.array([1.0, np.inf]), r"times\[2\]"), (["x"], "times")],
)
def test_what_is_no_finite_number_is_named(given, word):
    with pytest.raises(InputError, match=word):
        float_list(given, "times")


def test_places_and_times_are_lists_of_floats():
    assert checked_places(None, [1, 2]).tolist() == [1.0, 2.0]
    assert checked_places("0.5", [1]).tolist() == [0.5]
    assert checked_times([3, 1]).tolist() == [3.0, 1.0]
    with pytest.raises(InputError, match="tau"):
        checked_times([-1])
