"""The shape of a vibration satisfies the equations of motion, which are put together here anew."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from residue import TRACKS

from mpsolve.characteristic.floats import Floats, Receptance
from mpsolve.characteristic.proved import Proved
from mpsolve.errors import InputError, PrecisionError
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.enclose import RootBall, enclose
from mpsolve.spectrum.shape import root_shape
from mpsolve.tracks import EulerBernoulli
from mpsolve.vehicles import Bogie, Mass, Vehicle

BEAM = EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")


NEUTRAL = Vehicle(
    M=[[9, 0, 0], [0, 4, 0], [0, 0, 6]],
    C=[["0.7", "-0.5", "-0.2"], ["-0.5", "0.5", 0], ["-0.2", 0, "0.2"]],
    K=[[3, 0, -3], [0, 0, 0], [-3, 0, 3]],
    B=[[1], [0], [0]],
    places=[0],
    names=["wheel", "damped body", "sprung body"],
)
"""A wheel that carries a body by a damper alone, a neutral mode, and a body on a spring."""
BOGIE = Bogie(wheel=1813, frame=2615, inertia=1476, wheelbase="2.5", k="2.4e6", c="3e4", k_contact="1.5e9")
PROBLEMS = {
    "pair": (Problem(BEAM, [Mass(70).at(0), Mass(70).at("1.5")], "0.8"), 0.15 - 0.001j),
    "bogie": (Problem(TRACKS["two-layer"], [BOGIE.at(3)], 1500), 50 - 5j),
    "neutral": (Problem(BEAM, [NEUTRAL, Mass(30).at(2)], "1.1"), 0.15 - 0.05j),
}


def root(given: Problem, q: complex) -> RootBall:
    """The root to which Newton's method leads."""
    reduced = reduce_problem(given)
    floats, unit = Floats(reduced), float(reduced.frequency_unit)
    sigma = 1j * q / unit
    for _ in range(100):
        value, slope = floats.delta([sigma])
        sigma -= (value / slope)[0]
    return enclose(Proved(reduced), complex(sigma), 30)


@pytest.mark.parametrize("name", PROBLEMS)
def test_it_satisfies_the_equations(name: str) -> None:
    """S y = B λ and Bᵀy = w − hλ, with w = −G λ by the receptances of float64."""
    given, start = PROBLEMS[name]
    ball = root(given, start)
    q = complex(ball.q.mid())
    shape = root_shape(given, ball.q)
    pencil = given.pencil
    y = np.array([complex(x) for x in shape.bodies.values()])
    rail = np.array([complex(x) for x in shape.rail])
    M, C, K, B, h = (np.array(rows, float) for rows in (pencil.M, pencil.C, pencil.K, pencil.B, pencil.h))
    forces = np.linalg.lstsq(B, (K + 1j * q * C - q * q * M) @ y, rcond=None)[0]
    guide, places = reduce_problem(given).guide, pencil.places
    distances = sorted({a - b for a in places for b in places})
    scaled = [x / Fraction(2) ** guide.length for x in distances]
    G = Receptance(guide)(np.array([1j * q * 2.0**guide.time]), scaled)[0]
    number = {x: float(guide.g) * g[0] for x, g in zip(distances, G, strict=True)}
    w = -np.array([sum(number[a - b] * f for b, f in zip(places, forces, strict=True)) for a in places])
    scale = np.abs(rail).max()
    assert list(shape.bodies) == list(pencil.names)
    assert shape.places == pencil.places
    assert np.abs((K + 1j * q * C - q * q * M) @ y - B @ forces).max() < 1e-9 * np.abs(K).max() + 1e-11
    assert np.abs(w - rail).max() < 1e-9 * scale
    assert np.abs(B.T @ y - w + h * forces).max() < 1e-9 * scale


@pytest.mark.parametrize("name", PROBLEMS)
def test_the_largest_motion_is_one(name: str) -> None:
    given, start = PROBLEMS[name]
    shape = root_shape(given, root(given, start).q)
    sizes = [float(abs(x).upper()) for x in shape.bodies.values()]
    assert sum(x == 1 for x in shape.bodies.values()) == 1
    assert max(sizes) == 1
    assert all(float(x.rad()) < 1e-20 for x in shape.bodies.values())


def test_tight_wheels_move_with_the_rail() -> None:
    given, start = PROBLEMS["pair"]
    shape = root_shape(given, root(given, start).q, places=[0, "1.5", "0.75", -3])
    for wheel, rail in zip(shape.bodies.values(), shape.rail, strict=False):
        assert rail.overlaps(wheel)
    assert len(shape.rail) == 4
    assert shape.places == (0, Fraction(3, 2), Fraction(3, 4), -3)


def test_what_has_no_shape() -> None:
    given, start = PROBLEMS["pair"]
    ball: Any = root(given, start)
    with pytest.raises(PrecisionError, match="several roots"):
        root_shape(given, ball.q, 2)
    with pytest.raises(InputError, match="places"):
        root_shape(given, ball.q, places=["a"])
