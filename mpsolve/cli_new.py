"""The command `new`: an input file from the presets."""

from __future__ import annotations

from pathlib import Path

import click

from mpsolve.cli_tools import command, output
from mpsolve.errors import InputError


@command()
@click.argument("track", required=False)
@click.option("--vehicle", metavar="NAME", help="Another vehicle than the one that the track is tried with.")
@click.option("--v", "velocity", metavar="VELOCITY", help='Another velocity, such as "300 km/h".')
@click.option("--count", type=int, help="How many of the vehicles run in a row.")
@click.option("--spacing", metavar="DISTANCE", help='From one vehicle to the next, such as "25 m".')
@output("Write this new file, not the terminal.")
def new(
    track: str | None,
    vehicle: str | None,
    velocity: str | None,
    count: int | None,
    spacing: str | None,
    output: Path | None,
) -> None:
    """Write an input file with comments from presets: TRACK and a vehicle. Without TRACK: list the presets.

    Each preset says where its numbers come from.

    Exit status 0: written. 1: the file could not be written. 2: there is no such preset, or the file exists.
    """
    from mpsolve.files import write_whole
    from mpsolve.presets.written import input_file, listing

    if track is None:
        click.echo(listing(), nl=False)
        return
    text = input_file(track, vehicle, velocity, count, spacing)
    if output is None:
        click.echo(text, nl=False)
        return
    if output.exists():
        raise InputError("output", f"{output} exists: give the path of a new file")
    click.echo(str(write_whole(output, text)))
