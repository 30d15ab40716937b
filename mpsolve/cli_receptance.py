"""The command for solvers that step the vehicle themselves: receptance."""

from __future__ import annotations

from pathlib import Path

import click

from mpsolve.cli_tools import FILE, checked_file, command, output
from mpsolve.errors import InputError


@command()
@FILE
@click.option(
    "--omega",
    required=True,
    metavar="FIRST,LAST,COUNT",
    help="Frequencies of the force, COUNT of them evenly from FIRST to LAST: rad/s for a file in SI, or with a unit, "
    "as in '1 Hz,100 Hz,400'.",
)
@click.option("--xi", default="0", show_default=True, help="Distances ahead of the force, in m in SI: -1.5,0,1.5.")
@click.option(
    "--contacts", is_flag=True, help="In JSON: the matrices between the contacts of FILE, and their inverses, too."
)
@click.option("--json", "as_json", is_flag=True, help="JSON instead of CSV, as -o FILE.json does.")
@output("Write this file, not the terminal.")
def receptance(file: Path, omega: str, xi: str, contacts: bool, as_json: bool, output: Path | None) -> None:
    """Tabulate the receptance G(ξ, ω) of the track in FILE (TOML) under a moving harmonic force, in float64.

    G is the displacement of the rail per unit force, at the velocity of FILE and in its units: m/N for a file in SI;
    EI = 1/4, m = k = 1 for a dimensionless one. The vehicles of FILE play no part but for --contacts, with the
    dynamic stiffness, the inverse of the receptances between them. Exit status 0: written. 1: it could not be
    written. 2: the input cannot be used.
    """
    from mpsolve.files import write_whole
    from mpsolve.problem.case import Case
    from mpsolve.problem.inputfile import read_problem
    from mpsolve.report.receptances import receptances

    given = read_problem(file)
    as_json = as_json or (output is not None and output.suffix.lower() == ".json")
    if contacts and not as_json:
        raise InputError("--contacts", "is for matrices, which CSV does not hold: add --json, or -o FILE.json")
    si = not isinstance(given.case, Case)
    checked_file(output, given.path, "the table", (".json",) if as_json else (".csv", ".json"))
    table = receptances(given.problem, given.title, _places(xi, si), _frequencies(omega, si), contacts, si)
    text = table.to_json() if as_json else table.to_csv()
    if output is None:
        click.echo(text, nl=False)
    else:
        click.echo(str(write_whole(output, text)))


_MOST = 1_000_000


def _places(text: str, si: bool) -> tuple[float, ...]:
    return tuple(_real(word, "m" if si else "", "--xi") for word in text.split(","))


def _real(word: str, unit: str, key: str) -> float:
    """A number that may have a unit of its own; cycles are what floats can turn into rad."""
    from math import pi

    from mpsolve.numbers.units import in_unit, split

    number, given = split(word)
    if given == "Hz" and unit == "rad/s":
        return 2 * pi * float(in_unit(number, unit, key))
    return float(in_unit(word.strip(), unit, key))


def _frequencies(text: str, si: bool) -> tuple[float, ...]:
    import numpy as np

    first, last, count = [*text.split(","), "", ""][:3]
    if text.count(",") != 2 or not (count.strip().isdecimal() and 1 <= int(count) <= _MOST):
        raise InputError("--omega", f"is {text!r}: give FIRST,LAST,COUNT, with a whole COUNT from 1 to {_MOST}")
    low, high = (_real(end, "rad/s" if si else "", "--omega") for end in (first, last))
    return tuple(np.linspace(low, high, int(count)).tolist())
