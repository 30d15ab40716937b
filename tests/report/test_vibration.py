"""Frequencies, rates and times are enclosed, and agree with mpmath at a higher precision."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import mpmath
import pytest

from mpsolve import Case, PhysicalCase, certify, read_case
from mpsolve.numbers.decimals import decimal
from mpsolve.report.vibration import Trend, vibrations

EXAMPLES = Path(__file__).parents[2] / "examples"
DIGITS = 40
MP = mpmath.MPContext()
MP.dps = 80


def exact(ball: Any) -> Any:
    """The midpoint of a flint.arb in mpmath."""
    mantissa, exponent = ball.mid().man_exp()
    return MP.ldexp(MP.mpf(int(mantissa)), int(exponent))


def holds(ball: Any, value: Any) -> bool:
    """`value`, computed from the root's midpoint, is inside `ball`, which is sharp."""
    radius = MP.mpf(decimal(ball, DIGITS).radius_text)
    return bool(abs(exact(ball) - value) <= radius and radius <= abs(value) * MP.mpf(10) ** (-DIGITS + 8))


@pytest.fixture(scope="module")
def rail() -> PhysicalCase:
    case = read_case(EXAMPLES / "rail_60e1.toml")
    assert isinstance(case, PhysicalCase)
    return case


def test_physical_units(rail: PhysicalCase) -> None:
    spectrum = certify(rail, digits=DIGITS)
    found = vibrations(spectrum)
    assert [motion.trend for motion in found] == [Trend.DECAYS, Trend.DECAYS]
    assert [round(float(motion.frequency), 3) for motion in found] == [2.939, 3.643]
    for motion in found:
        re, im = exact(motion.root.q.real), exact(motion.root.q.imag)
        assert re > 0
        assert holds(motion.frequency, re / (2 * MP.pi))
        assert holds(motion.rate, -im)
        assert holds(motion.time, MP.log(2) / im)


def test_in_units_of_tau() -> None:
    case = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    slow, fast = vibrations(certify(case, digits=DIGITS))
    assert (slow.trend, fast.trend) == (Trend.DECAYS, Trend.GROWS)
    re, im = exact(fast.root.q.real), exact(fast.root.q.imag)
    assert holds(fast.frequency, re / (2 * MP.pi))
    assert holds(fast.rate, -im)
    assert holds(fast.time, MP.log(2) / -im)
    assert float(fast.rate) > 0 > float(slow.rate)


def test_an_undamped_vibration_is_steady() -> None:
    case = Case(alpha="0.5", eta_b=0, eta_m=(20, 30), positions=(0, 1))
    found = vibrations(certify(case))
    assert [motion.trend for motion in found] == [Trend.STEADY, Trend.STEADY]
    assert all(motion.time is None and motion.rate == 0 for motion in found)


def test_a_lone_root_with_a_negative_real_part_is_kept() -> None:
    from mpsolve import Rectangle

    case = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    spectrum = certify(case, region=Rectangle("-0.2", 0, "-0.1", "0.01"))
    found = vibrations(spectrum)
    assert len(found) == spectrum.count == 2
    assert all(motion.frequency > 0 for motion in found)
