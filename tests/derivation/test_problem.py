"""The derivation of a file's problem is printed whole, as text and as LaTeX."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp
from click.testing import CliRunner
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import tracks
from mpsolve.cli import cli
from mpsolve.derivation.problem import derivation_of
from mpsolve.derivation.rendered import render
from mpsolve.derivation.tracks import derived, symbols_of
from mpsolve.errors import InputError
from mpsolve.problem.problem import Problem
from mpsolve.vehicles import Mass

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize("track", DAMPED.values(), ids=lambda track: track.name)
def test_the_steps_of_a_track(track: object) -> None:
    steps = {step.number: step for step in derivation_of(Problem(track, Mass(1), v=3))}
    found = derived(type(track))
    assert steps["(T3)"].statement.rhs == found.matrix
    size = range(len(found.fields))
    entries = {sp.Symbol(f"A_{i + 1}{j + 1}"): found.matrix[i, j] for i in size for j in size}
    D, N = steps["(T4)"].statement
    assert sp.expand(D.rhs.subs(entries) - found.dispersion) == 0
    assert sp.expand(N.rhs.subs(entries) - found.numerator) == 0
    shown = {equation.lhs: equation.rhs for equation in steps["(T5)"].statement}
    assert shown == {
        symbol: sp.Rational(track.parameters[key]) for key, symbol in vars(symbols_of(type(track))).items()
    }


@pytest.mark.parametrize("vehicle", TYPICAL.values(), ids=lambda vehicle: vehicle.name)
def test_text_and_latex(vehicle: object) -> None:
    steps = derivation_of(Problem(DAMPED["string"], [vehicle.at(0), vehicle.at(40)], v=3))
    text, latex = render(steps), render(steps, "latex")
    assert "False" not in text
    assert "(V1.1)" in text
    assert "(V2.1)" not in text
    assert "operatorname{False}" not in latex
    assert latex.isascii()
    assert latex.count(r"\begin{align*}") == latex.count(r"\end{align*}") == len(steps)


def test_two_kinds_of_vehicle_are_both_derived() -> None:
    steps = derivation_of(Problem(DAMPED["string"], [TYPICAL["mass"], TYPICAL["coach"].at(40)], v=3))
    assert [step.title for step in steps if step.number.endswith(".1)")] == ["Energies: mass", "Energies: coach"]


def test_the_command() -> None:
    run = CliRunner().invoke
    result = run(cli, ["derive", str(EXAMPLES / "two_layer_bogie.toml")])
    assert result.exit_code == 0
    assert "(T1) Equations of motion: two-layer" in result.output
    assert "4 coordinates, 2 contacts" in result.output
    assert run(cli, ["derive", str(EXAMPLES / "rail_60e1.toml"), "--latex"]).output.startswith("\\documentclass")
    assert run(cli, ["derive", "none.toml"]).exit_code == 2


def test_a_track_by_its_matrix_has_nothing_to_derive() -> None:
    with pytest.raises(InputError, match="its matrix"):
        derivation_of(Problem(DAMPED["string"].waveguide, Mass(1), v=0))


def test_a_model_without_a_derivation_says_where_to_write_it() -> None:
    class Wire(tracks.String, frozen=True):
        """A string of another name."""

    class Wheel(Mass, frozen=True):
        """A mass of another name."""

    with pytest.raises(InputError, match=r"write them in mpsolve/derivation/tracks\.py"):
        derivation_of(Problem(Wire(T=1, m=1, k=1), Mass(1), v=0))
    with pytest.raises(InputError, match=r"write them in mpsolve/derivation/vehicles\.py"):
        derivation_of(Problem(DAMPED["string"], Wheel(1), v=0))
