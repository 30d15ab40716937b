"""What the explorer begins with."""

from __future__ import annotations

import tempfile
from pathlib import Path

from mpsolve.presets.written import input_file
from mpsolve.problem.inputfile import ProblemFile, read_problem
from mpsolve.problem.problem import Problem

FIRST = "ballasted"
"""The preset that stands there without a file."""


def begun(file: Path | None) -> tuple[Problem, str]:
    """The problem of an input file, or of the first preset, with its title."""
    read = read_problem(file) if file is not None else _preset(FIRST, None)
    return read.problem, read.title or (file.stem if file is not None else "")


def problem_of(track: str, vehicle: str | None = None) -> tuple[Problem, str]:
    """The problem of a preset of a track, with a preset of a vehicle or with its usual one, and its title."""
    read = _preset(track, vehicle)
    return read.problem, read.title


def _preset(track: str, vehicle: str | None) -> ProblemFile:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{track}.toml"
        path.write_text(input_file(track, vehicle), encoding="utf-8")
        return read_problem(path)
