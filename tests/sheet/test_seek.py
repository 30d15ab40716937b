"""Candidates: every root that a search of (26), (37) finds, without being told how many there are."""

from __future__ import annotations

import pytest
from oracle import Truth

from mpsolve import Case
from mpsolve.sheet.seek import Candidate, seek

PAIR = {"eta_m": (70, 70), "positions": (0, "1.5")}
CASES = [
    {"alpha": "0.5", "eta_b": "0.05", "eta_m": 70},
    {"alpha": "0.67", "eta_b": "0.05", **PAIR},
    {"alpha": "0.5", "eta_b": 0, **PAIR},
    {"alpha": "1.4", "eta_b": 0, "eta_m": (40, 40), "positions": (0, "4.5")},
    {"alpha": "1.2", "eta_b": "0.2", "eta_s": "0.4", "eta_m": (10, 3, 7), "positions": (0, 1, 3)},
    {"alpha": 0, "eta_b": "0.05", **PAIR},
    {"alpha": "0.5", "eta_b": "1.5", **PAIR},
]


@pytest.mark.parametrize("values", CASES)
def test_candidates_are_the_roots(values: dict[str, object]) -> None:
    case = Case(**values)
    truth = Truth(case, 25)
    candidates = seek(case, 40.0)
    if not case.overdamped:
        expected = truth.search(40.0)
        assert len(candidates) == len(expected)
        assert all(min(abs(c.q - q) for c in candidates) < 1e-8 * abs(q) for q in expected)
    for candidate in candidates:
        assert candidate.q.real >= -1e-10
        if case.cuts_on_line or candidate.q.imag < 0:
            assert abs(candidate.q - complex(truth.root(candidate.q))) < 1e-8 * abs(candidate.q)


def test_a_root_next_to_a_branch_point_is_found() -> None:
    """A light mass has its root at a distance like η_M² from q_lm; here about 1e-7."""
    case = Case(alpha="0.5", eta_b=0, eta_m="0.0005")
    assert len(seek(case, 20.0)) == 1


def test_more_effort_finds_no_fewer() -> None:
    case = Case(alpha="1.4", eta_b=0, eta_m=(40, 40), positions=(0, "4.5"))
    assert len(seek(case, 20.0, effort=2)) >= len(seek(case, 20.0))
    assert all(isinstance(c, Candidate) and c.step < 1e-9 * abs(c.q) for c in seek(case, 20.0))
