"""The commands about the motion in time: response, compare."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from mpsolve import cli_vibration
from mpsolve.cli_tools import FILE, PATH, checked_output, command, output
from mpsolve.errors import InputError

if TYPE_CHECKING:
    from mpsolve.problem.casefile import InputFile
    from mpsolve.problem.inputfile import ProblemFile
    from mpsolve.vibration.case_motion import Response
    from mpsolve.vibration.case_units import Scale

_END = click.option(
    "--to",
    "end",
    show_default="2 s for a file with [track], else 100",
    help='The last time: τ of the paper, or "2 s"; in s for a file with [track].',
)
_POINTS = click.option("--points", type=click.IntRange(2, 1_000_000), default=1001, show_default=True, help="Times.")
_SUFFIXES = (".csv", ".json", ".npz", ".png", ".svg", ".pdf")


@command()
@FILE
@output(f"Write FILE{', '.join(_SUFFIXES)}.")
@_END
@_POINTS
@click.option("--xi", help="Positions in the moving frame, as 0,1.5: ξ, or in m.  [default: those of the contacts]")
@click.option(
    "--initial",
    type=click.Choice(["rest", "steady"]),
    default="rest",
    show_default=True,
    help="In s: all loads at once, or constant ones since ever.",
)
@click.option(
    "--roughness", help='In s: a wave on the rail under all contacts, AMPLITUDE,WAVELENGTH as "20 µm, 0.8 m".'
)
@click.option(
    "--out-of-round", help='In s: uneven wheels, AMPLITUDE,RADIUS[,TIMES A TURN[,CONTACT]] as "0.1 mm, 0.46 m, 3".'
)
@click.option("--animate", type=PATH, help="In s: write a film of the rail as this FILE.svg.")
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
) -> None:
    """Compute the motion from rest of the vehicles in FILE (TOML), in float64.

    A file with [track], or any file in SI where --to ends in s, gives m, s, N and rad, with errors estimated and the
    first lift-off. Else the file is a case of the paper, over certified frequencies, in its τ and ξ:
    The loads are those of the file: P, P_A, omega_f, phi_f of each [[mass]], or constant, amplitude, frequency, phase
    of each [[load]] beside [dimensionless]. Without any, each mass carries its weight, or one unit constant force. A
    physical file gives s, mm and kN; a dimensionless one τ = √(k/m) t, displacements in units of w_st = χ/(2k) times
    the unit force, and forces in unit forces. Exit status 0: written. 1: it could not be computed or written. 2: the
    input cannot be used.
    """
    from mpsolve.files import checked_suffix
    from mpsolve.problem.casefile import InputFile

    kind = "" if output is None else checked_suffix(checked_output(output, file, "the response"), _SUFFIXES)
    source, end = _source(file, end)
    if not isinstance(source, InputFile):
        last = cli_vibration.seconds(end) or _last(end)
        if animate is not None:
            checked_suffix(checked_output(animate, file, "the film", "animate"), (".svg",), "animate")
        rough = cli_vibration.irregularities(source.problem, roughness, out_of_round)
        said = cli_vibration.respond(source, output, kind, _grid(last, points), xi, initial, rough)
        if animate is not None:
            cli_vibration.film(source, animate, last, initial, rough)
        click.echo("\n".join([*said, *(str(path) for path in (output, animate) if path is not None)]))
        return
    _only_in_seconds(initial=None if initial == "rest" else initial, animate=animate, roughness=roughness,
                     out_of_round=out_of_round)  # fmt: skip
    from mpsolve.vibration.of_case import motion_of_case as respond

    places = None if xi is None else [x.strip() for x in xi.split(",")]
    found = respond(source.case, source.loads, places, _grid(_last(end), points))
    scale = _scale(source)
    if output is not None:
        _save(found, output, kind, source.title, scale)
    click.echo("\n".join(_summary(found, scale)))
    _tell(output)


@command()
@FILE
@output("Write FILE.csv, .png, .svg, .pdf.")
@_END
@_POINTS
def compare(file: Path, output: Path | None, end: str | None, points: int) -> None:
    """Hold the motion of the rear contact point against superposition, one merged mass, and a finite track.

    Superposition: each mass alone, results added. Merged: one mass with the sum of all masses and loads at the
    position of the rear mass. Loads and units as for response. Exit status 0: written. 1: it could not be computed
    or written. 2: the input cannot be used.
    """
    from mpsolve.files import checked_suffix
    from mpsolve.problem.casefile import InputFile

    suffixes = (".csv", ".png", ".svg", ".pdf")
    kind = "" if output is None else checked_suffix(checked_output(output, file, "the comparison"), suffixes)
    source, end = _source(file, end)
    if not isinstance(source, InputFile):
        cli_vibration.compare(source, output, kind, _grid(cli_vibration.seconds(end) or _last(end), points))
        _tell(output)
        return
    scale = _scale(source)
    whole, curves, notes = _curves(source, _grid(_last(end), points), scale)
    if output is not None:
        _save_curves(whole, curves, output, kind, source.title, scale)
    cli_vibration.tell_apart(curves, whole.within, scale.length_unit, notes, scale.length)
    _tell(output)


def _tell(output: Path | None) -> None:
    if output is not None:
        click.echo(str(output))


COMMANDS = (response, compare)


def _source(file: Path, end: str | None) -> tuple[ProblemFile | InputFile, str]:
    """A problem in SI where the file has [track] or the last time is in s; else the paper's; and that time."""
    from mpsolve.problem.inputfile import ProblemFile, problem_file, read_source
    from mpsolve.problem.physical import PhysicalCase

    source = read_source(file)
    if end is None:
        end = "2" if isinstance(source, ProblemFile) else "100"
    if isinstance(source, ProblemFile) or cli_vibration.seconds(end) is None:
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


def _scale(source: InputFile) -> Scale:
    from mpsolve.problem.physical import PhysicalCase
    from mpsolve.vibration.case_units import Scale

    return Scale.of(source.case if isinstance(source.case, PhysicalCase) else None)


def _save(found: Response, path: Path, kind: str, title: str, scale: Scale) -> None:
    from mpsolve.report.figures_motion import save_history
    from mpsolve.vibration.table import case_arrays, case_columns

    made = partial(case_columns, found, scale), partial(case_arrays, found, scale)
    picture = partial(save_history, found, path, title, scale)
    cli_vibration.write(path, kind, title, _summary(found, scale), *made, picture)


def _summary(found: Response, scale: Scale) -> list[str]:
    lines = [f"units: {scale.said}.", f"estimated error {found.error:.1e} of the size of the parts (float64)."]
    for pair in found.harmonic_pairs:
        size = abs(pair.amplitude[0]) * scale.length
        lines.append(
            f"induced frequency {pair.q:.8g}: amplitude {size:.8g} {scale.length_unit} at ξ = {found.xi[0]:g}"
        )
    lines += [f"mass {j}: {note}." for j, note in enumerate(found.contact_note, 1) if note and "before" not in note]
    event = found.lift_off
    if event is None:
        return [*lines, "contact is kept."]
    at = f"t = {event.time * scale.time:.8g} s" if scale.physical else f"τ = {event.time:.8g}"
    off = f"(± {event.tolerance * scale.time:.1e})"
    return [*lines, f"mass {event.contact} lifts off at {at} {off}: what comes later is beyond the model."]


def _curves(source: InputFile, tau: Any, scale: Scale) -> tuple[Response, dict[str, Any], list[str]]:
    """The motion, the curves by name, the complete solution first, and what is to be said of them."""
    from mpsolve.finite.beam import finite_beam
    from mpsolve.vibration.of_case import motion_of_case as respond
    from mpsolve.vibration.studies import merged_case as merged
    from mpsolve.vibration.studies import superposition_of_case as superposition

    given = source.case, source.loads
    whole = respond(*given, None, tau)
    curves = {"complete": whole.w[0], "steady and harmonic": whole.steady[0] + whole.harmonic[0]}
    notes: list[str] = []

    def beam() -> Any:
        found = finite_beam(*given, tau=tau)
        notes.append(f"finite beam: estimated error {found.error.total * scale.length:.2g} {scale.length_unit}")
        return found.displacement[0]

    others: dict[str, Callable[[], Any]] = {
        "superposition": lambda: sum(part.w[0] for part in superposition(*given, whole.xi, tau)),
        "one merged mass": lambda: merged(*given, whole.xi, tau).w[0],
        "finite beam": beam,
    }
    cli_vibration.add(curves, others, notes)
    return whole, curves, notes


def _save_curves(whole: Response, curves: dict[str, Any], path: Path, kind: str, title: str, scale: Scale) -> None:
    if kind == ".csv":
        from mpsolve.files import save_columns
        from mpsolve.vibration.table import named, time_columns

        shown = {named(name, scale.length_name, scale): curve * scale.length for name, curve in curves.items()}
        shown[named("within the model", "1", scale)] = whole.within.astype(float)
        save_columns(time_columns(whole.tau, scale) | shown, path)
    else:
        from mpsolve.report.figures_motion import save_curves

        save_curves(whole, curves, path, title, scale)
