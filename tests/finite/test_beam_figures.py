"""Length, modes and steps of the finite beam: given, found, or refused."""

from __future__ import annotations

import numpy as np
import pytest
from beam_loads import pair
from infinite import response

from mpsolve import InputError
from mpsolve.finite.beam import finite_beam
from mpsolve.vehicles.load import Load


def test_given_figures_stay_and_a_short_beam_says_so() -> None:
    case, tau = pair("0.5", 10, "0", "1"), [5.0, 30.0, 60.0]
    short = finite_beam(case, tau=tau, length=40)
    assert (short.length, short.start) == (40, pytest.approx(4.5))
    truth = response(case, (Load(), Load()), tau, line=0.06)
    assert 1e-4 < np.abs(short.displacement - truth).max() < short.error.ends
    bare = finite_beam(case, tau=tau, length=31.2)
    assert 1e-3 < np.abs(bare.displacement - truth).max() < bare.error.ends
    given = finite_beam(case, tau=tau, start=20, modes=200, steps=90)
    assert (given.start, given.modes, given.steps, given.length) == (20, 200, 90, pytest.approx(71))


@pytest.mark.parametrize(
    ("key", "arguments"),
    [
        ("tau", {"tau": []}),
        ("tau", {"tau": [0.0]}),
        ("tau", {"tau": [3.0, 2.0]}),
        ("tau[1]", {"tau": [float("nan")]}),
        ("tau[1]", {"tau": [True]}),
        ("tau", {"tau": [-5, 5]}),
        ("xi[1]", {"xi": ["here"]}),
        ("tolerance", {"tolerance": 0}),
        ("tolerance", {"tolerance": 1}),
        ("tolerance", {"tau": [1e6]}),
        ("length", {"length": 25}),
        ("length", {"length": -1}),
        ("start", {"start": 0}),
        ("start", {"start": 3, "xi": [-4.0]}),
        ("modes", {"modes": 2}),
        ("modes", {"modes": 10.5}),
        ("steps", {"steps": 4}),
        ("modes", {"modes": 50_000}),
        ("length", {"length": 1e6}),
        ("steps", {"steps": 10**8, "tolerance": 0.9}),
        ("loads", {"loads": [Load()]}),
    ],
)
def test_what_cannot_be_used_is_named(key: str, arguments: dict[str, object]) -> None:
    with pytest.raises(InputError) as caught:
        finite_beam(pair("0.5", 10, "0.1", "1"), **{"tau": [50.0], **arguments})
    assert caught.value.key == key


def test_the_needed_length_is_said() -> None:
    with pytest.raises(InputError, match="give more than 26") as caught:
        finite_beam(pair("0.5", 10, "0.1", "1"), tau=[50.0], length=25)
    assert caught.value.key == "length"
