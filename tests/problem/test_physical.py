"""The beam in SI: what is admissible, and its ratios against (10) to (12) in mpmath."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest

from mpsolve import InputError, Mass, PhysicalCase

RAIL: dict[str, Any] = {"EI": "6.4e6", "m": 60, "k": "1e6", "c": 770, "kp": "2e4", "N": "-3e5", "v": 100}
PAIR = [(10_000, 0), (8_000, "3.4")]


def test_the_ratios() -> None:
    mp = mpmath.MPContext()
    mp.dps = 40
    EI, m, k, c, kp, N, v = map(mp.mpf, ("6.4e6", "60", "1e6", "770", "2e4", "-3e5", "100"))
    chi, omega = mp.sqrt(mp.sqrt(k / (4 * EI))), mp.sqrt(k / m)
    found = PhysicalCase(**RAIL, masses=PAIR).dimensionless
    truth = {
        found.alpha: v * chi / omega,
        found.eta_b: c / (2 * mp.sqrt(m * k)),
        found.eta_n: N / (2 * mp.sqrt(k * EI)),
        found.eta_s: kp / (2 * mp.sqrt(k * EI)),
        found.eta_m[1]: 8000 * chi / m,
        found.positions[1]: mp.mpf("3.4") * chi,
    }
    for ratio, value in truth.items():
        assert abs(mp.mpf(ratio.short(30)) - value) < mp.mpf(10) ** -25 * abs(value)


def test_a_beam_that_buckles_exactly_there() -> None:
    """2√(k EI) = 2√(6.4e12) is irrational; with EI = 4, k = 1 it is 4 exactly."""
    beam: dict[str, Any] = {"EI": 4, "m": 1, "k": 1, "v": 0, "masses": [(1, 0)]}
    assert PhysicalCase(**beam, N="3.999999").N
    assert PhysicalCase(**beam, N=5, kp="1.01").kp
    with pytest.raises(InputError, match=r"N: N − kp is 4 N, not below 2√\(k EI\) = 4 N"):
        PhysicalCase(**beam, N=5, kp=1)


@pytest.mark.parametrize(
    ("changed", "key"),
    [
        ({"EI": 0}, "EI"),
        ({"v": -1}, "v"),
        ({"masses": []}, "mass"),
        ({"masses": [(1, 1), (1, 0)]}, "mass[2].position"),
        ({"masses": [(1, 0), "x"]}, "mass[2]"),
        ({"masses": [(0, 0)]}, "mass[1].M"),
    ],
)
def test_what_is_refused(changed: dict[str, Any], key: str) -> None:
    with pytest.raises(InputError) as caught:
        PhysicalCase(**{**RAIL, "masses": PAIR, **changed})
    assert caught.value.key == key


def test_irrational_measures_are_refused() -> None:
    from mpsolve import Exact

    with pytest.raises(InputError, match="is irrational, unlike a measured value"):
        Mass(Exact.sqrt(2), 0)
