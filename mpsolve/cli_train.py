"""The command about rows of equal vehicles: train."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from mpsolve.cli_tools import FILE, JSON, UNDECIDED, command, effort_of, progress


@command()
@FILE
@click.option("--spacing", help="From each vehicle to the next, where FILE holds only one.")
@click.option("--effort", default="10", show_default=True, metavar="SECONDS", help="Time for each of the proofs.")
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
    from mpsolve.numbers.units import in_unit
    from mpsolve.problem.inputfile import read_problem
    from mpsolve.report.trains import train_json, train_text

    given = read_problem(file)
    distance = None if spacing is None else in_unit(spacing, "m", "spacing", "distance of the vehicles")
    row, count = row_in(given.problem, distance)
    with progress() as tell:
        budget, several = effort_of(effort), given.problem.pencil.contacts > 1
        found = infinite_train(row.problem, row.spacing, effort=budget, progress=tell)
        ratios = amplification(given.problem, effort=budget, progress=tell) if several else None
    write = train_json if as_json else train_text
    click.echo(write(given.title, found, ratios, count), nl=False)
    if not found.proved:
        sys.exit(UNDECIDED)
