"""The command for forces that run with a wave: critical."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from mpsolve.cli_tools import FILE, JSON, UNDECIDED, checked_file, command, echo_json, output
from mpsolve.errors import InputError


@command()
@FILE
@click.option("--omega", default="0", show_default=True, help="Frequency of the force, in rad/s for a file in SI.")
@click.option("--from", "low", default="0", show_default=True, help="The lowest velocity, in m/s.")
@click.option("--to", "high", default="2000", show_default=True, help="The highest velocity, in m/s.")
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
    from mpsolve.numbers.units import in_unit
    from mpsolve.problem.inputfile import read_problem
    from mpsolve.waves.critical import critical_velocities
    from mpsolve.waves.speeds import SLOW_WAVES, slow_waves

    source = read_problem(file)
    checked_file(output, file, "the chart", (".png", ".svg", ".pdf"))
    ends = [in_unit(end, "m/s", key, "velocity") for key, end in (("from", low), ("to", high))]
    if not 0 <= ends[0] < ends[1]:
        raise InputError("to", f"is {high}, with --from {low}: give velocities from 0 on, the lower one first")
    track = source.problem.track
    found = critical_velocities(track, omega, over={"v": (ends[0], ends[1])})
    if as_json:
        echo_json({"format": "mpsolve critical velocities", "version": 1} | found.to_dict())
    else:
        for one in found:
            name = f" ({one.name})" if one.name else ""
            where = "" if one.wavenumber is None else f", wavenumber {float(one.wavenumber.mid()):.8g} rad/m"
            kmh = 3.6 * float(one.value.mid())
            click.echo(f"v = {one.value.str(15)} m/s = {kmh:.6g} km/h: {one.kind.value}{name}{where}")
        if not found.omega and slow_waves(track):
            click.echo(SLOW_WAVES)
        for sentence in found.always:
            click.echo(sentence)
        click.echo(found.sentence)
    if output is not None:
        from mpsolve.report.figures_critical import save_critical

        click.echo(str(save_critical(track, found, output, source.title)), err=as_json)
    if found.undecided:
        sys.exit(UNDECIDED)
