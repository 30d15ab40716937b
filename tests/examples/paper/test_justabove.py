"""The count just above α_C: F against the paper's own formulas, the root against `certify`, and that it can fail."""

from __future__ import annotations

from dataclasses import replace

import flint
import pytest
from oracle import Truth

from mpsolve import certify
from mpsolve.numbers.balls import precision
from paper import justabove
from paper.cases import pair, single

acb, arb = flint.acb, flint.arb
ALPHA = "1.08"


def place(z):
    """e, q and the roots at a point of the quarter disc, as the file says."""
    e = (arb(ALPHA) ** 2 - 1).sqrt()
    found = justabove._roots(e, z * z)
    return e, e * e * found.q_hat, found


@pytest.mark.parametrize("d", [None, "3"])
@pytest.mark.parametrize(("x", "y"), [("0.3", "-0.2"), ("0.05", "-0.4")])
def test_F_is_z_times_the_determinant(d: str | None, x: str, y: str) -> None:
    case = single(ALPHA, "0", "10") if d is None else pair(ALPHA, "0", "10", d)
    truth = Truth(case, 30)
    with precision(128):
        z = acb(x, y)
        e, q, _ = place(z)
        value = justabove._value(e, z, arb(10), None if d is None else arb(d))
        assert q.imag < 0
        expected = complex(truth.delta(truth.middle(q))) * complex(float(x), float(y))
        assert abs(complex(float(value.F.real), float(value.F.imag)) - expected) < 1e-8 * (1 + abs(expected))


def test_the_rate_is_the_slope_of_q() -> None:
    with precision(128):
        e, square, step = (arb(ALPHA) ** 2 - 1).sqrt(), acb("0.05", "-0.12"), arb("0.001")
        high, low = (justabove._roots(e, square + s * step).q_hat for s in (1, -1))
        slope = justabove._roots(e, square).rate
        assert abs((high - low) / (2 * step) - slope).upper() < 1e-5


@pytest.mark.parametrize(("eta_m", "d"), [("10", None), ("10", "3.5"), ("40", "1"), ("70", "4.5")])
def test_a_strip_is_proved_and_its_root_is_there(eta_m: str, d: str | None) -> None:
    assert justabove.unstable_up_to("1.02", eta_m, d)
    case = single("1.015", "0", eta_m) if d is None else pair("1.015", "0", eta_m, d)
    assert certify(case, digits=15).unstable == 2


def test_too_wide_a_strip_is_not_proved() -> None:
    assert not justabove.unstable_up_to("1.4", "70", "1")
    assert not justabove.unstable_up_to("1.1", "70", "4.5")


def test_a_kernel_of_the_wrong_sign_breaks_the_count(monkeypatch: pytest.MonkeyPatch) -> None:
    """Then F has no zero in the quarter disc: the count must not come out."""
    right = justabove._value

    def turned(*given):
        value = right(*given)
        return replace(value, F=2 * given[1] - value.F, rest=-value.rest)

    monkeypatch.setattr(justabove, "_value", turned)
    assert not justabove.unstable_up_to.__wrapped__("1.02", "40", "1")
