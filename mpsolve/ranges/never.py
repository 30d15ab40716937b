"""Theorems by which nothing grows in whole ranges, so that no boxes are needed."""

from __future__ import annotations

from collections.abc import Mapping

from mpsolve.problem.family import Interval
from mpsolve.problem.problem import Problem
from mpsolve.ranges import on_string, undamped


def never_unstable(problem: Problem, over: Mapping[str, Interval]) -> str | None:
    """Why nothing grows at any point of the ranges, by some theorem; None where none tells."""
    if undamped.never_unstable(problem, over):
        return undamped.NOTE
    return on_string.quiet(problem, over)
