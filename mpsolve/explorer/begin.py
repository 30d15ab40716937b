"""What the explorer begins with."""

from __future__ import annotations

import tempfile
from pathlib import Path

from mpsolve.presets.written import input_file
from mpsolve.problem.inputfile import read_problem
from mpsolve.problem.problem import Problem

FIRST = "ballasted"
"""The preset that stands there without a file."""


def begun(file: Path | None) -> tuple[Problem, str]:
    """The problem of an input file, or of the first preset, with its title."""
    if file is not None:
        read = read_problem(file)
        return read.problem, read.title or file.stem
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{FIRST}.toml"
        path.write_text(input_file(FIRST), encoding="utf-8")
        read = read_problem(path)
    return read.problem, read.title
