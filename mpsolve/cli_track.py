"""The commands about a track alone, and about rows of equal vehicles on it: critical, receptance, train."""

from __future__ import annotations

import sys
from fractions import Fraction
from pathlib import Path

import click

from mpsolve.cli_tools import (
    FILE,
    JSON,
    UNDECIDED,
    checked_file,
    command,
    echo_json,
    effort_of,
    output,
    progress,
    say,
)
from mpsolve.errors import InputError


@command()
@FILE
@click.option(
    "--omega", default="0", show_default=True, help='Frequency of the force: rad/s for a file in SI, or as "10 Hz".'
)
@click.option(
    "--from", "low", default="0", show_default=True, help='The lowest velocity: m/s in SI, or as "100 km/h".'
)
@click.option("--to", "high", default="2000", show_default=True, help="The highest velocity.")
@JSON
@output("Draw the chart as this FILE.png, .svg or .pdf.")
def critical(file: Path, omega: str, low: str, high: str, as_json: bool, output: Path | None) -> None:
    """Find all critical velocities of the track in FILE (TOML): a force that runs so fast runs with a wave.

    They are those of the track without its damping, proved to be all: at each of them two p-roots meet on the real
    axis, or one runs to infinity. The chart has the dispersion curves with the lines Ω = ω − vp on the left, and on
    the right the largest deflection under a unit force over its velocity, with the damping of FILE. The vehicles
    play no part. Exit status 0: all are proved. 1: one is undecided, or nothing could be written. 2: the input
    cannot be used.
    """
    from mpsolve.numbers.decimals import proved_digits
    from mpsolve.numbers.spoken import spoken
    from mpsolve.numbers.units import in_unit
    from mpsolve.problem.case import Case
    from mpsolve.problem.inputfile import read_problem
    from mpsolve.waves.critical import critical_velocities
    from mpsolve.waves.speeds import SLOW_WAVES, slow_waves

    source = read_problem(file)
    checked_file(output, file, "the chart", (".png", ".svg", ".pdf"))
    si = not isinstance(source.case, Case)
    unit = "m/s" if si else ""
    ends = [in_unit(end, unit, key, "velocity") for key, end in (("from", low), ("to", high))]
    if not 0 <= ends[0] < ends[1]:
        raise InputError("to", f"is {high}, with --from {low}: give velocities from 0 on, the lower one first")
    track = source.problem.track
    found = critical_velocities(track, _number(omega, "rad/s" if si else "", "omega"), over={"v": (ends[0], ends[1])})
    if as_json:
        echo_json({"format": "mpsolve critical velocities", "version": 1} | found.to_dict())
    else:
        for one in found:
            name = f" ({one.name})" if one.name else ""
            wave = "" if one.wavenumber is None else f", wavenumber {float(one.wavenumber.mid()):.8g}{' rad/m' * si}"
            value = f"{proved_digits(one.value, 15)} {unit}{f' ({spoken(one.value, unit)})' if si else ''}".strip()
            click.echo(f"v = {value}: {one.kind.value}{name}{wave}")
        if not found.omega and slow_waves(track):
            click.echo(SLOW_WAVES)
        for sentence in found.always:
            click.echo(sentence)
        click.echo(found.said(unit))
    if output is not None:
        from mpsolve.report.figures_critical import save_critical

        click.echo(str(save_critical(track, found, output, source.title)), err=as_json)
    if found.undecided:
        sys.exit(UNDECIDED)


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
    return tuple(float(_number(word, "m" if si else "", "--xi")) for word in text.split(","))


def _number(word: str, unit: str, key: str) -> Fraction | float:
    """A number that may have a unit of its own; cycles are what floats can turn into rad."""
    from math import pi

    from mpsolve.numbers.units import in_unit, split

    number, given = split(word)
    if given == "Hz" and unit == "rad/s":
        return 2 * pi * float(in_unit(number, unit, key))
    return in_unit(word.strip(), unit, key)


def _require_units_of_both(first: str, last: str, text: str) -> None:
    """So that "1 Hz,100,3" is no range from 1 Hz to 100 rad/s."""
    from mpsolve.numbers.units import split

    bare = [number for number, unit in map(split, (first, last)) if not unit]
    if len(bare) == 1 and bare[0].strip("0.- "):
        raise InputError("--omega", f"is {text!r}, where {bare[0]} stands without a unit: write it at both ends")


def _frequencies(text: str, si: bool) -> tuple[float, ...]:
    import numpy as np

    first, last, count = [*text.split(","), "", ""][:3]
    if text.count(",") != 2 or not (count.strip().isdecimal() and 1 <= int(count) <= _MOST):
        raise InputError("--omega", f"is {text!r}: give FIRST,LAST,COUNT, with a whole COUNT from 1 to {_MOST}")
    low, high = (float(_number(end, "rad/s" if si else "", "--omega")) for end in (first, last))
    _require_units_of_both(first, last, text)
    return tuple(np.linspace(low, high, int(count)).tolist())


@command()
@FILE
@click.option("--spacing", help="From each vehicle to the next, where FILE holds only one.")
@click.option(
    "--effort", default="30", show_default=True, metavar="SECONDS", help="Processor time that the proofs may take."
)
@JSON
def train(file: Path, spacing: str | None, effort: str, as_json: bool) -> None:
    """Prove whether disturbances grow along the train in FILE (TOML), as if it had no end, and how it amplifies.

    FILE holds equal vehicles at equal distances, or one vehicle with --spacing. The factors from one vehicle to the
    next, and what is said of long trains, are computed; the rest is proved. Where the time of a part ends early it
    says what is known by then. Exit status 0: proved. 1: undecided, with the reason. 2: the input cannot be used.
    """
    from mpsolve.endless.amplification import amplification
    from mpsolve.endless.infinite_train import infinite_train
    from mpsolve.endless.row import row_in
    from mpsolve.problem.case import Case
    from mpsolve.problem.inputfile import read_problem
    from mpsolve.proof.effort import begun
    from mpsolve.proof.stopping import listening
    from mpsolve.report.trains import train_data, train_text

    given = read_problem(file)
    row, count = row_in(given.problem if given.case is None else given.case, spacing)
    with progress() as tell, listening():
        budget, several = begun(effort_of(effort)), given.problem.pencil.contacts > 1
        found = infinite_train(row.problem, row.spacing, effort=budget.half(), progress=tell)
        ratios = amplification(given.problem, effort=budget.left(), progress=tell) if several else None
    told = (given.title, found, ratios, count)
    if as_json:
        echo_json(train_data(*told))
    else:
        say(train_text(*told, si=not isinstance(given.case, Case)))
    if not found.proved:
        sys.exit(UNDECIDED)
