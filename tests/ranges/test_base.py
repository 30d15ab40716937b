"""The roots at one point take no more effort than is left, wherever a range is counted from them."""

import ast
from pathlib import Path

import pytest

import mpsolve
from mpsolve import Case, Effort
from mpsolve.outcome import Reason, Status
from mpsolve.problem.cases import as_problem
from mpsolve.ranges.base import base_at, growing, uncounted
from mpsolve.spectrum.regions import HalfPlane, Rectangle

PAIR = as_problem(Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5")))


def test_the_roots_that_grow_are_counted() -> None:
    found = base_at(PAIR, None, check=False)
    assert (found.region, growing(found)) == (HalfPlane(), 2)
    part = base_at(PAIR, None, False, Rectangle("0.1", "0.2", "-0.1", "0"))
    assert (part.proved, growing(part)) == (True, None)
    assert "whether a root grows there is open" in str(uncounted(part, "there"))


def test_the_effort_is_kept_and_told() -> None:
    found = base_at(PAIR, Effort(evaluations=6).half(), check=False)
    assert found.status is Status.UNDECIDED
    reason = uncounted(found, "there")
    assert isinstance(reason, Reason)
    assert "the effort of 6 evaluations is spent" in reason.message


@pytest.mark.parametrize("room", ["ranges", "loci"])
def test_no_proof_within_a_range_is_without_an_effort(room: str) -> None:
    """Lines of a coach with 3 s of effort took 14 s: the roots from which they start had no limit."""
    for file in sorted((Path(mpsolve.__file__).parent / room).glob("*.py")):
        calls = [one for one in ast.walk(ast.parse(file.read_text(encoding="utf-8"))) if isinstance(one, ast.Call)]
        for call in calls:
            if ast.unparse(call.func) in ("certify", "certify_problem"):
                assert "effort" in {one.arg for one in call.keywords}, f"{file.name}:{call.lineno}"
