"""The answer on the whole sheet in dimensionless terms, for what still speaks in them."""

from __future__ import annotations

import pytest

from mpsolve import Case, InputError, PhysicalCase, Problem, certify, response
from mpsolve.certificate.on_sheet import sheet_of
from mpsolve.certificate.sheet import certify_sheet
from mpsolve.tracks import String
from mpsolve.vehicles import Mass

CASE = Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
RAIL = PhysicalCase(EI="6.4e6", m=60, k="1e6", c=770, v=100, masses=[(10_000, 0)])


@pytest.mark.parametrize("given", [CASE, RAIL], ids=["ratios", "SI"])
def test_the_answer_in_the_ratios_of_the_paper(given: Case | PhysicalCase) -> None:
    case = given if isinstance(given, Case) else given.dimensionless
    found, old = sheet_of(certify(given, digits=20)), certify_sheet(case, 30)
    assert (found.case, found.count, found.unstable, found.proved) == (case, old.count, old.unstable, True)
    for one, other in zip(found.roots, old.roots, strict=True):
        assert one.q.overlaps(other.q)
        assert one.symmetry is other.symmetry


def test_what_is_no_answer_about_the_sheet() -> None:
    found = certify(CASE, digits=20)
    sheet = sheet_of(found)
    assert sheet_of(sheet) is sheet
    assert len(response(CASE, tau=[1.0], spectrum=found).tau) == 1
    other = certify(Problem(String(T=1, m=1, k=1, c="0.1"), [Mass(1)], v=0), region="unstable", check=False)
    for wrong in (other, "x", None):
        with pytest.raises(InputError, match=r"spectrum: is .*pass certify\(case"):
            sheet_of(wrong)  # type: ignore[arg-type]
