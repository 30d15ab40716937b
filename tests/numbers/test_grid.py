import pytest

from mpsolve.errors import InputError
from mpsolve.numbers.grid import checked_places, checked_times


def test_places_and_times_are_lists_of_floats():
    assert checked_places(None, [1, 2]).tolist() == [1.0, 2.0]
    assert checked_places("0.5", [1]).tolist() == [0.5]
    assert checked_times([3, 1]).tolist() == [3.0, 1.0]
    with pytest.raises(InputError, match="tau"):
        checked_times([-1])
