"""Lines and counts put together: what does not fit leaves the answer open."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from free_cases import BEAM, PAIR

from mpsolve import Problem, frequency_lines
from mpsolve.loci import assembly
from mpsolve.ranges.base import base_at

PROBLEM = Problem(BEAM, PAIR, v="0.5")
OVER = {"v": ("0.5", "0.52")}


def lines(monkeypatch: pytest.MonkeyPatch, change: Any) -> Any:
    def certified(*args: Any, **options: Any) -> Any:
        return change(base_at(*args, **options))

    monkeypatch.setattr(assembly, "base_at", certified)
    return frequency_lines(PROBLEM, over=OVER, region=("below", "0.046"), points=2, check=False)


def test_weights_are_the_number_of_roots(monkeypatch: pytest.MonkeyPatch) -> None:
    found = lines(monkeypatch, lambda base: base)
    assert found.proved, found.reason
    assert found.counts == (sum(line.weight for line in found.lines),)


def twice(base: Any) -> Any:
    """As if a root were double."""
    return replace(base, roots=(replace(base.roots[0], multiplicity=2), *base.roots[1:]))


@pytest.mark.parametrize(
    ("change", "code"),
    [
        (twice, "multiple"),
        (lambda base: replace(base, roots=base.roots[1:-1]), "lines"),  # a root and its mirror are forgotten
        (lambda base: replace(base, count=base.count + 2), "lines"),
    ],
)
def test_what_does_not_fit_is_a_reason(monkeypatch: pytest.MonkeyPatch, change: Any, code: str) -> None:
    found = lines(monkeypatch, change)
    assert (found.proved, found.counts) == (False, None)
    assert found.reason.code == code
