"""The closing argument is that of det M, as it is continued from the imaginary axis far below."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oracle_general import Floats
from oracle_general.named import at, masses
from oracle_general.package import as_problem

from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.start import start
from mpsolve.errors import PrecisionError
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.spectrum.closing import closing_argument

RAIL = {"model": "euler-bernoulli", "EI": "6.38e6", "m": "60.2", "k": "1e6", "c": "770"}
OSCILLATOR = {"model": "oscillator", "wheel": "900", "body": "6000", "k": "5e5", "c": "2e3"}
CASES = {
    "one mass": masses("900", "0"),
    "three masses": masses("900", "0", "2.5", "7"),
    "oscillators": at(OSCILLATOR, OSCILLATOR),
    "two at one place": [*masses("900", "0"), {**OSCILLATOR, "at": "0"}],
}


def at_rho(name: str, v: str = "150", rho: float = 4.0) -> tuple[dict[str, Any], Reduced, float, Any]:
    row = {"track": RAIL, "vehicles": CASES[name], "v": v}
    reduced = reduce_problem(as_problem(row))
    _, G, good = Arrays(reduced).evaluate(np.array([1j * rho]), np.zeros(1), start(reduced.guide).up)
    assert good[0]
    return row, reduced, rho, G


@pytest.mark.parametrize("name", CASES)
def test_the_argument_along_the_walls(name: str) -> None:
    row, reduced, rho, G = at_rho(name)
    floats, unit = Floats(row), float(reduced.frequency_unit)
    way = np.concatenate([-1j * np.linspace(2 * rho, 1e-9, 4000)[:1], np.linspace(-2j * rho, rho - 2j * rho, 4000),
                          rho - 1j * np.linspace(2 * rho, 0, 4000)]) * unit  # fmt: skip
    delta = floats.log_delta(way).imag
    steps = np.angle(np.exp(1j * np.diff(delta)))
    assert np.abs(steps).max() < 0.3
    turn = steps.sum() + (reduced.contacts - reduced.bodies) * np.pi / 2  # det M = σ^(nc − nb) Δ
    closing = closing_argument(reduced, rho, G.a[0], G.e[0])
    assert closing.contains(turn) or abs(float(closing.mid()) - turn) < 1e-6
    assert float(closing.rad()) < 1e-6


def test_where_the_middle_is_not_passive_it_stays_open() -> None:
    _, reduced, rho, G = at_rho("three masses")
    a = G.a[0].copy()
    a[0, 0] = a[0, 0].conjugate()
    with pytest.raises(PrecisionError, match="not passive"):
        closing_argument(reduced, rho, a, G.e[0])


def test_a_wide_receptance_stays_open() -> None:
    _, reduced, rho, G = at_rho("three masses")
    with pytest.raises(PrecisionError):
        closing_argument(reduced, rho, G.a[0], np.abs(G.a[0]))
    wide = closing_argument(reduced, rho, G.a[0], 1e-4 * np.abs(G.a[0]))
    sharp = closing_argument(reduced, rho, G.a[0], G.e[0])
    assert wide.contains(sharp)
    assert float(wide.rad()) > 1e-5
