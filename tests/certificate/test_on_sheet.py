"""The whole sheet in other units: roots scaled, remedies in the words of `certify`, the inner answer at hand."""

from __future__ import annotations

import pytest

from mpsolve import Case, Effort, InputError, PhysicalCase, Problem, Rectangle, Status, certify
from mpsolve.certificate.on_sheet import certify_on_sheet, sheet_of
from mpsolve.certificate.sheet import certify_sheet
from mpsolve.motion import response
from mpsolve.tracks import String
from mpsolve.vehicles import Mass

CASE = Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
RAIL = PhysicalCase(EI="6.4e6", m=60, k="1e6", c=770, v=100, masses=[(10_000, 0)])


def test_scaled_balls_hold_the_scaled_roots_to_as_many_digits() -> None:
    """To 40 digits, with √(k/m) = √(50000/3) by another program's square root."""
    found = certify_on_sheet(RAIL, RAIL, "sheet", 40)
    inner = certify_sheet(RAIL, digits=60)
    from mpmath import mp, mpf, sqrt

    with mp.workdps(70):
        unit = sqrt(mpf(10**6) / 60)
        for root, ratio in zip(found.roots, inner.roots, strict=True):
            for got, exact in ((root.q.real, ratio.q.real), (root.q.imag, ratio.q.imag)):
                wanted = unit * mpf(exact.mid().str(66, radius=False))
                assert abs(mpf(got.mid().str(66, radius=False)) - wanted) <= mpf(float(got.rad())) + mpf("1e-55")
            assert (root.q - root.q.mid()).abs_upper() <= 1e-40 * root.q.abs_upper()


def test_the_inner_answer_is_at_hand() -> None:
    found = certify(CASE, digits=20)
    assert sheet_of(found) is found.sheet
    assert sheet_of(found.sheet) is found.sheet
    assert len(response(CASE, tau=[1.0], spectrum=found).tau) == 1
    other = certify(Problem(String(T=1, m=1, k=1, c="0.1"), [Mass(1)], v=0), region="unstable", check=False)
    for wrong in (other, "x", None):
        with pytest.raises(InputError, match=r"spectrum: is .*pass certify\(case"):
            sheet_of(wrong)  # type: ignore[arg-type]


def test_undecided_keeps_what_is_known_and_says_what_helps() -> None:
    found = certify(CASE, effort=Effort(evaluations=20), digits=15)
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "pieces"
    assert found.reason.remedy == 'ask for the region "unstable", or allow more effort, with effort=Effort(seconds=…)'
    assert certify(CASE, effort=Effort(seconds=60), digits=15).proved
    assert certify(CASE, region="unstable", digits=15).proved


def test_a_rectangle_of_a_case() -> None:
    box = Rectangle("0.01", "0.2", "-0.1", "0.01")
    found = certify(CASE, region=box, digits=15)
    assert (found.region, found.count, found.stable) == (box, 2, None)
    assert "sides of the rectangle" in found.closing
