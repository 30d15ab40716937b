"""What the commands response and compare do with a file in SI: places in m, times in s, forces in N."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from mpsolve.cli_tools import seconds_of
from mpsolve.errors import InputError, PrecisionError

if TYPE_CHECKING:
    from mpsolve.problem.inputfile import ProblemFile
    from mpsolve.problem.problem import Problem
    from mpsolve.vibration.forcing import Irregularity
    from mpsolve.vibration.motion import Vibration

    Rough = tuple[Irregularity, ...] | None

_FRAMES, _SHAPE_POINTS, _AROUND = 120, 161, 12


def seconds(text: str) -> float | None:
    """A time with a unit, such as "2 s" or "300 ms", in seconds; None where the text has no unit."""
    from mpsolve.numbers.units import split

    return seconds_of(text, "--to") if split(text)[1] else None


def irregularities(problem: Problem, roughness: str | None, out_of_round: str | None) -> Rough:
    """What the options give: a wave on the rail, or uneven wheels, or nothing."""
    from mpsolve.numbers.units import in_unit
    from mpsolve.vibration import forcing as kinds

    def lengths(text: str, key: str, most: int) -> tuple[list[Any], list[int]]:
        parts = [part.strip() for part in text.split(",")]
        if not 2 <= len(parts) <= most or not all(part.isdecimal() for part in parts[2:]):
            raise InputError(
                key, f"is {text!r}: give two lengths such as '20 µm, 0.8 m', see mpsolve response --help"
            )
        return [in_unit(part, "m", key, "length") for part in parts[:2]], [int(part) for part in parts[2:]]

    if roughness is not None and out_of_round is not None:
        raise InputError("--roughness", "is given with --out-of-round: give one of them, the motion is linear")
    if roughness is not None:
        return kinds.rail_roughness(problem, *lengths(roughness, "--roughness", 2)[0])
    if out_of_round is not None:
        given, counts = lengths(out_of_round, "--out-of-round", 4)
        return kinds.out_of_round(problem, *given, *counts)
    return None


def respond(
    source: ProblemFile, output: Path | None, kind: str, times: Any, xi: str | None, initial: str, rough: Rough
) -> list[str]:
    """Writes the motion; what is to be said of it."""
    from mpsolve.vibration.vibrate import vibrate

    places = None if xi is None else [x.strip() for x in xi.split(",")]
    given: dict[str, Any] = {"initial": initial, "irregularities": rough}
    found = vibrate(source.problem, source.loads, times=times, places=places, **given)
    said = _summary(found)
    if output is not None:
        from mpsolve.report.figures_vibration import save_motion
        from mpsolve.vibration.table import arrays, columns

        made = partial(columns, found), partial(arrays, found), partial(save_motion, found, output, source.title)
        write(output, kind, source.title, said, *made)
    return [*said, *warnings(source)]


def write(
    output: Path,
    kind: str,
    title: str,
    said: list[str],
    columns: Callable[[], dict[str, Any]],
    arrays: Callable[[], dict[str, Any]],
    picture: Callable[[], Any],
) -> None:
    """Writes the motion: its columns as CSV or JSON, its arrays as NPZ, or its picture."""
    from mpsolve.files import save_arrays, save_columns, save_json

    if kind == ".csv":
        save_columns(columns(), output)
    elif kind == ".json":
        save_json(columns(), output, title, said)
    elif kind == ".npz":
        save_arrays(arrays(), output)
    else:
        picture()


def add(curves: dict[str, Any], others: Mapping[str, Callable[[], Any]], notes: list[str]) -> None:
    """The other curves too; where one cannot be computed, the rest stands without it, and a note says why."""
    for name, compute in others.items():
        try:
            curves[name] = compute()
        except (InputError, PrecisionError) as error:
            notes.append(f"{name}: left out, {error}")


def tell_apart(curves: Mapping[str, Any], within: Any, unit: str, notes: list[str], one: float = 1.0) -> None:
    """How far the curves are from the first one, in units of which the curves' own is `one`; then the notes."""
    complete, *others = curves.items()
    for name, curve in others:
        apart = abs(curve - complete[1])[within].max() * one
        click.echo(f"{name}: differs from the complete solution by at most {apart:.6g} {unit} while contact is kept")
    for note in notes:
        click.echo(note)


def warnings(source: ProblemFile) -> list[str]:
    """What looks like a mistake in the file."""
    from mpsolve.problem.titled import titled
    from mpsolve.problem.warned import warned

    found = (*titled(source.problem, source.title), *warned(source.problem))
    return [f"Warning: {reason}." for reason in found]


def film(source: ProblemFile, path: Path, last: float, initial: str, rough: Rough) -> None:
    """Writes the film of the rail's shape."""
    import numpy as np

    from mpsolve.problem.reduced import scale_guide
    from mpsolve.report.figures_vibration import save_film
    from mpsolve.vibration.vibrate import vibrate

    contacts = [float(x) for x in source.problem.pencil.places]
    gap, unit = contacts[-1] - contacts[0], 2.0 ** scale_guide(source.problem).length
    around = min(_AROUND * unit, max(6 * gap, 4 * unit)) if gap else _AROUND * unit
    places = np.linspace(contacts[0] - around, contacts[-1] + around, _SHAPE_POINTS)
    times = np.linspace(0.0, last, _FRAMES)
    given: dict[str, Any] = {"initial": initial, "irregularities": rough}
    save_film(vibrate(source.problem, source.loads, times=times, places=places, **given), path, source.title)


def _summary(found: Vibration) -> list[str]:
    size = float(abs(found.rail).max())
    lines = [
        "units: m, s, N, rad; the estimated errors are not proved.",
        f"rail: largest deflection {size:.6g} m, estimated error {found.error.rail:.1e} m; contact forces: estimated "
        f"error {found.error.contact_force:.1e} N.",
    ]
    for part in found.induced:
        grows = "grows" if part.q.imag < 0 else "decays"
        lines.append(
            f"induced frequency {abs(part.q.real) / 6.283185307179586:.6g} Hz {grows} at {abs(part.q.imag):.6g} 1/s: "
            f"amplitude {abs(part.rail[0]):.6g} m at x = {found.places[0]:g} m"
        )
    event = found.lift_off
    if event is None:
        lines.append("contact is kept.")
    else:
        lines.append(
            f"contact {event.contact} lifts off at t = {event.time:.8g} s (± {event.tolerance:.1e}): what comes "
            "later is beyond the model."
        )
    return lines


def curves(source: ProblemFile, times: Any) -> tuple[Vibration, dict[str, Any], list[str]]:
    """The motion under the rear contact by different ways, the complete solution first, and what is to be said."""
    from mpsolve.finite.finite_track import finite_track
    from mpsolve.vibration.studies import merged, superposition
    from mpsolve.vibration.vibrate import vibrate

    problem, loads = source.problem, source.loads
    rear = [problem.pencil.places[0]]
    whole = vibrate(problem, loads, times=times, places=rear)
    out = {"complete": whole.rail[0], "steady and harmonic": whole.steady[0] + whole.harmonic[0]}
    notes: list[str] = []

    def finite() -> Any:
        last = float(times[-1])
        gap = float(problem.pencil.places[-1] - problem.pencil.places[0])
        around = 40 * 2.0**whole.solution.image.guide.length
        length = gap + float(problem.v) * last + 2 * max(around, 0.25 * (gap + float(problem.v) * last))
        modes = max(100, min(4000, int(8 * length / 2.0**whole.solution.image.guide.length)))
        found = finite_track(problem, loads, length=length, modes=modes, times=times, places=rear, tolerance=1e-3)
        notes.append(f"finite track: {length:.4g} m, {modes} modes, estimated error {found.error.total:.2g} m")
        return found.rail[0]

    others: dict[str, Callable[[], Any]] = {
        "superposition": lambda: sum(
            part.rail[0] for part in superposition(problem, loads, times=times, places=rear)
        ),
        "one merged mass": lambda: merged(problem, loads, times=times, places=rear).rail[0],
        "finite track": finite,
    }
    if len(problem.vehicles) == 1:
        del others["superposition"]
    add(out, others, notes)
    return whole, out, notes


def compare(source: ProblemFile, output: Path | None, kind: str, times: Any) -> None:
    """Writes the comparison and says how far the curves are apart."""
    from mpsolve.files import save_columns

    whole, found, notes = curves(source, times)
    if output is not None:
        if kind == ".csv":
            table = {"t [s]": times} | {f"{name} [m]": row for name, row in found.items()}
            save_columns(table | {"within the model [1]": whole.within.astype(float)}, output)
        else:
            from mpsolve.report.figures_vibration import save_comparison

            save_comparison(whole, found, output, source.title)
    tell_apart(found, whole.within, "m", [*notes, *warnings(source)])
