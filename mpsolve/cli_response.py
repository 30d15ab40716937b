"""The commands about the motion in time: response, compare."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from mpsolve import cli_vibration
from mpsolve.cli_tools import (
    FILE,
    PATH,
    UNDECIDED,
    checked_file,
    command,
    effort_of,
    output,
    progress,
    say,
    seconds_of,
)
from mpsolve.errors import InputError

if TYPE_CHECKING:
    from mpsolve.cli_vibration import Rough
    from mpsolve.problem.casefile import InputFile
    from mpsolve.problem.inputfile import ProblemFile
    from mpsolve.problem.problem import Problem

_END = click.option(
    "--to",
    "end",
    metavar="TIME",
    help='The last time, such as "500 ms"; a number is in s, or τ of the paper.  [default: 2 s, or τ = 100]',
)
_POINTS = click.option(
    "--points", type=click.IntRange(2, 1_000_000), default=1001, show_default=True, help="How many times, from 0 on."
)
_SUFFIXES = (".csv", ".json", ".npz", ".png", ".svg", ".pdf")


@command()
@FILE
@output(f"Write FILE{' or '.join(_SUFFIXES)}.")
@_END
@_POINTS
@click.option(
    "--xi",
    metavar="PLACES",
    help="Positions in the moving frame, as 0,1.5: ξ, or in m.  [default: those of the contacts]",
)
@click.option(
    "--initial",
    type=click.Choice(["rest", "steady"]),
    default="rest",
    show_default=True,
    help="In s: at t = 0 all loads come on at once, or the constant ones have acted for ever.",
)
@click.option(
    "--roughness",
    metavar="WAVE",
    help='In s: a wave on the rail under all contacts, AMPLITUDE,WAVELENGTH as "20 µm, 0.8 m".',
)
@click.option(
    "--out-of-round",
    metavar="WHEELS",
    help='In s: uneven wheels, AMPLITUDE,RADIUS[,TIMES A TURN[,CONTACT]] as "0.1 mm, 0.46 m, 3".',
)
@click.option("--animate", type=PATH, help="In s: write a film of the rail as this FILE.svg.")
@click.option("--effort", metavar="SECONDS", help="Processor time that the motion may take, and a film again.")
def response(
    file: Path,
    output: Path | None,
    end: str | None,
    points: int,
    xi: str | None,
    initial: str,
    roughness: str | None,
    out_of_round: str | None,
    animate: Path | None,
    effort: str | None,
) -> None:
    """Compute the motion of the vehicles in FILE (TOML), and when a wheel first lifts off, in float64.

    FILE in SI: m, s, N and rad, with estimated errors. The loads are those of the file, else the weights; they come
    on suddenly at t = 0, unless --initial steady.

    A case of the paper ([dimensionless], or [physical] without a unit in --to): τ and ξ of the paper, over certified
    frequencies. The loads are P, P_A, omega_f, phi_f of each [[mass]], or constant, amplitude, frequency, phase of
    each [[load]], else the weights, or one unit force each. [physical] gives s, mm and kN; [dimensionless]
    τ = √(k/m) t, displacements in units of w_st = χ/(2k) times the unit force, and forces in unit forces.

    Columns of a table: w is the sum of steady (what the loads keep up), harmonic (at the induced frequencies) and
    transient (the rest).

    Exit status 0: written. 1: it could not be computed or written, or not all of it within --effort. 2: the input
    cannot be used.
    """
    from mpsolve.problem.casefile import InputFile

    kind = checked_file(output, file, "the response", _SUFFIXES)
    source, end = _source(file, end)
    places = None if xi is None else [x.strip() for x in xi.split(",")]
    if isinstance(source, InputFile):
        _only_in_seconds(initial=None if initial == "rest" else initial, animate=animate, roughness=roughness,
                         out_of_round=out_of_round)  # fmt: skip
        with progress() as tell:
            work: dict[str, Any] = {"effort": effort_of(effort), "progress": tell}
            found = cli_vibration.of_case(source, _grid(_last(end), points), places, **work)
    else:
        last = _seconds(end) or _last(end)
        checked_file(animate, file, "the film", (".svg",), "animate")
        rough = _irregularities(source.problem, roughness, out_of_round)
        with progress() as tell:
            work = {"effort": effort_of(effort), "progress": tell}
            found = cli_vibration.of_problem(source, _grid(last, points), places, initial, rough, **work)
        if animate is not None:
            cli_vibration.film(source, animate, last, initial, rough, effort_of(effort))
    if output is not None:
        found.write(output, kind, source.title)
    say("\n".join([*found.said, *(str(path) for path in (output, animate) if path is not None)]))
    if not found.whole:
        sys.exit(UNDECIDED)


@command()
@FILE
@output("Write FILE.csv, .png, .svg, .pdf.")
@_END
@_POINTS
@click.option("--effort", metavar="SECONDS", help="Processor time that all of it may take; what is late is left out.")
def compare(file: Path, output: Path | None, end: str | None, points: int, effort: str | None) -> None:
    """Hold the motion of the rear contact point against superposition, one merged mass, and a finite track.

    Superposition: each mass alone, results added. Merged: one mass with the sum of all masses and loads at the
    position of the rear mass. Loads and units as for response. Exit status 0: written. 1: it could not be computed
    or written. 2: the input cannot be used.
    """
    from mpsolve.problem.casefile import InputFile
    from mpsolve.proof.effort import Effort

    kind = checked_file(output, file, "the comparison", (".csv", ".png", ".svg", ".pdf"))
    source, end = _source(file, end)
    budget = effort_of(effort) or Effort()
    with progress() as tell:
        if tell is not None:
            tell("comparing", 0.0)
        if isinstance(source, InputFile):
            found = cli_vibration.compared_case(source, _grid(_last(end), points), budget)
        else:
            found = cli_vibration.compared(source, _grid(_seconds(end) or _last(end), points), budget)
    if output is not None:
        found.write(output, kind, source.title)
    for sentence in (*found.said, *([] if output is None else [str(output)])):
        say(sentence)


def _source(file: Path, end: str | None) -> tuple[ProblemFile | InputFile, str]:
    """A problem in SI where the file has [track] or the last time is in s; else the paper's; and that time."""
    from mpsolve.problem.inputfile import ProblemFile, problem_file, read_source
    from mpsolve.problem.physical import PhysicalCase

    source = read_source(file)
    if end is None:
        end = "2" if isinstance(source, ProblemFile) else "100"
    if isinstance(source, ProblemFile) or _seconds(end) is None:
        return source, end
    if not isinstance(source.case, PhysicalCase):
        raise InputError("--to", f"is {end}, but the file is dimensionless: give τ, a number without a unit")
    return problem_file(source), end


def _only_in_seconds(**options: Any) -> None:
    for name, given in options.items():
        if given is not None:
            key = f"--{name.replace('_', '-')}"
            raise InputError(key, 'is for a motion in s: give --to "2 s", and a file in SI')


def _last(end: str) -> float:
    from mpsolve.numbers.exact import Exact

    last = Exact.parse(end, "--to")
    if not last > 0:
        raise InputError("--to", f"is {end}: give a time above 0")
    return float(last)


def _grid(last: float, points: int) -> Any:
    import numpy as np

    return np.linspace(0.0, last, points)


def _seconds(text: str) -> float | None:
    """A time with a unit, such as "2 s" or "300 ms", in seconds; None where the text has no unit."""
    from mpsolve.numbers.units import split

    return seconds_of(text, "--to") if split(text)[1] else None


def _irregularities(problem: Problem, roughness: str | None, out_of_round: str | None) -> Rough:
    """What the options give: a wave on the rail, or uneven wheels, or nothing."""
    from mpsolve.vibration import forcing as kinds

    def parts(text: str, most: int) -> tuple[list[str], list[int]]:
        words = [word.strip() for word in text.split(",")]
        if not 2 <= len(words) <= most or not all(word.isdecimal() for word in words[2:]):
            raise InputError(
                "length", f"is {text!r}: give two lengths such as '20 µm, 0.8 m', see mpsolve response --help"
            )
        return words[:2], [int(word) for word in words[2:]]

    if roughness is not None and out_of_round is not None:
        raise InputError("--roughness", "is given with --out-of-round: give one of them, the motion is linear")
    try:
        if roughness is not None:
            (size, length), _ = parts(roughness, 2)
            return kinds.rail_roughness(problem, size, length)
        if out_of_round is not None:
            (size, radius), counts = parts(out_of_round, 4)
            return kinds.out_of_round(problem, size, radius, *counts)
    except InputError as error:
        key = "--roughness" if out_of_round is None else "--out-of-round"
        raise InputError(key, f"{error.key} {error.said}".removeprefix("length ")) from None
    return None
