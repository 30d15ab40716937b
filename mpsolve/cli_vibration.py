"""What the commands response and compare do: with a file in SI, and with a case of the paper."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from mpsolve.errors import EffortError, InputError, PrecisionError

if TYPE_CHECKING:
    from mpsolve.outcome import Reason
    from mpsolve.problem.casefile import InputFile
    from mpsolve.problem.inputfile import ProblemFile
    from mpsolve.proof.effort import Effort
    from mpsolve.vibration.case_motion import Response, Scale
    from mpsolve.vibration.forcing import Irregularity
    from mpsolve.vibration.liftoff import Event
    from mpsolve.vibration.motion import Vibration

    Rough = tuple[Irregularity, ...] | None

_FRAMES, _SHAPE_POINTS, _AROUND = 120, 161, 12


@dataclass(frozen=True)
class Shown:
    """What is to be said of a motion, its tables and pictures, made when they are asked for; whether it is whole."""

    said: list[str]
    columns: Callable[[], dict[str, Any]]
    picture: Callable[[Path, str], Any]
    arrays: Callable[[], dict[str, Any]] = dict
    whole: bool = True

    def write(self, output: Path, kind: str, title: str) -> None:
        """The columns as CSV or JSON, the arrays as NPZ, or the picture, with this title."""
        from mpsolve.files import save_arrays, save_columns, save_json

        if kind == ".csv":
            save_columns(self.columns(), output)
        elif kind == ".json":
            save_json(self.columns(), output, title, self.said)
        elif kind == ".npz":
            save_arrays(self.arrays(), output)
        else:
            self.picture(output, title)


def _short(reason: Reason | None, motion: Any) -> list[str]:
    """What is to be said where the effort ended; EffortError where nothing is known then."""
    import numpy as np

    if reason is None:
        return []
    if not np.isfinite(motion).any():
        raise EffortError(reason)
    return [f"Not all that was asked for: {reason}."]


def of_problem(
    source: ProblemFile, times: Any, places: list[str] | None, initial: str, rough: Rough, **work: Any
) -> Shown:
    """The motion in SI; work: effort and progress."""
    from mpsolve.report.figures_motion import save_motion
    from mpsolve.vibration.table import arrays, columns
    from mpsolve.vibration.vibrate import vibrate

    given: dict[str, Any] = {"initial": initial, "irregularities": rough, **work}
    found = vibrate(source.problem, source.loads, times=times, places=places, **given)
    said = [*_short(found.reason, found.rail), *_summary(found), *warnings(source)]
    made = partial(columns, found), partial(save_motion, found), partial(arrays, found)
    return Shown(said, *made, whole=found.reason is None)


def of_case(source: InputFile, tau: Any, places: list[str] | None, **work: Any) -> Shown:
    """The motion of a case of the paper, in its units, or in s, mm and kN."""
    from mpsolve.report.figures_motion import save_motion
    from mpsolve.vibration.of_case import motion_of_case
    from mpsolve.vibration.table import case_arrays, case_columns

    found, scale = motion_of_case(source.case, source.loads, places, tau, **work), _scale(source)
    made = partial(case_columns, found, scale), partial(save_motion, found, scale=scale)
    said = [*_short(found.reason, found.w), *_case_summary(found, scale)]
    return Shown(said, *made, partial(case_arrays, found, scale), whole=found.reason is None)


def _scale(source: InputFile) -> Scale:
    from mpsolve.problem.physical import PhysicalCase
    from mpsolve.vibration.case_motion import Scale

    return Scale.of(source.case if isinstance(source.case, PhysicalCase) else None)


def warnings(source: ProblemFile) -> list[str]:
    """What looks like a mistake in the file."""
    from mpsolve.problem.warned import titled, warned

    found = (*titled(source.problem, source.title), *warned(source.problem))
    return [f"Warning: {reason}." for reason in found]


def film(source: ProblemFile, path: Path, last: float, initial: str, rough: Rough, effort: Effort | None) -> None:
    """Writes the film of the rail's shape."""
    import numpy as np

    from mpsolve.files import write_whole
    from mpsolve.pictures.shape import film as drawn
    from mpsolve.problem.reduced import scale_guide
    from mpsolve.vibration.vibrate import vibrate

    contacts = [float(x) for x in source.problem.pencil.places]
    gap, unit = contacts[-1] - contacts[0], 2.0 ** scale_guide(source.problem).length
    around = min(_AROUND * unit, max(6 * gap, 4 * unit)) if gap else _AROUND * unit
    places = np.linspace(contacts[0] - around, contacts[-1] + around, _SHAPE_POINTS)
    times = np.linspace(0.0, last, _FRAMES)
    given: dict[str, Any] = {"initial": initial, "irregularities": rough, "effort": effort}
    found = vibrate(source.problem, source.loads, times=times, places=places, **given)
    _short(found.reason, found.rail)
    write_whole(path, drawn(found, source.title))


def _summary(found: Vibration) -> list[str]:
    rows = abs(found.rail).max(0)
    largest, known = float(rows[rows == rows].max()), float(found.times[rows == rows].max())
    lines = [
        "units: m, s, N, rad; the estimated errors are not proved.",
        f"rail: largest deflection {largest:.6g} m, estimated error {found.error.rail:.1e} m; "
        f"contact forces: estimated error {found.error.contact_force:.1e} N.",
    ]
    for part in found.induced:
        grows = "grows" if part.q.imag < 0 else "decays"
        swing = f"amplitude {abs(part.rail[0]):.6g} m at x = {found.places[0]:g} m"
        hertz = f"{abs(part.q.real) / 6.283185307179586:.6g} Hz {grows} at {abs(part.q.imag):.6g} 1/s"
        lines.append(f"induced frequency {hertz}: {swing}")
    lines += [f"contact {j}: no constant force presses it, so it cannot be judged." for j in found.unjudged]
    counts = len(found.unjudged), len(found.contact_force)
    return lines + _contact(found.lift_off, "contact", ("t", 1.0, " s"), counts, f" up to {known:.6g} s")


def _case_summary(found: Response, scale: Scale) -> list[str]:
    lines = [f"units: {scale.said}.", f"estimated error {found.error:.1e} of the size of the parts (float64)."]
    for pair in found.harmonic_pairs:
        size = f"{abs(pair.amplitude[0]) * scale.length:.8g} {scale.length_unit} at ξ = {found.xi[0]:g}"
        lines.append(f"induced frequency {pair.q:.8g}: amplitude {size}")
    lines += [f"mass {j}: {note}." for j, note in enumerate(found.contact_note, 1) if note and "before" not in note]
    counts = sum("judged" in note for note in found.contact_note), len(found.contact_note)
    unit = ("t", scale.time, " s") if scale.physical else ("τ", 1.0, "")
    return lines + _contact(found.lift_off, "mass", unit, counts)


def _contact(
    event: Event | None, who: str, unit: tuple[str, float, str], counts: tuple[int, int], until: str = ""
) -> list[str]:
    """Whether contact is kept; unit: of time; counts: of contacts that cannot be judged, of all."""
    if event is not None:
        at = f"{unit[0]} = {event.time * unit[1]:.8g}{unit[2]} (± {event.tolerance * unit[1]:.1e})"
        return [f"{who} {event.contact} lifts off at {at}: what comes later is beyond the model."]
    which = "the other contacts are" if counts[0] else "contact is"
    return [f"{which} kept{until}."] if counts[0] < counts[1] else []


def compared(source: ProblemFile, times: Any, budget: Effort) -> Shown:
    """The motion under the rear contact in SI, against what could stand for it."""
    from mpsolve.finite.finite_track import finite_track
    from mpsolve.problem.reduced import track_guide

    problem, loads = source.problem, source.loads
    rear = {"times": times, "places": [problem.pencil.places[0]]}

    def finite(said: list[str]) -> Any:
        unit = 2.0 ** track_guide(problem.track, problem.v).length
        gap = float(problem.pencil.places[-1] - problem.pencil.places[0])
        run = gap + float(problem.v) * float(times[-1])
        length = run + 2 * max(40 * unit, 0.25 * run)
        modes = max(100, min(4000, int(8 * length / unit)))
        found = finite_track(problem, loads, length=length, modes=modes, tolerance=1e-3, **rear)
        said.append(f"finite track: {length:.4g} m, {modes} modes, estimated error {found.error.total:.2g} m")
        return found.rail[0]

    return _compared(problem, loads, rear, budget, ("finite track", finite), warnings(source))


def compared_case(source: InputFile, tau: Any, budget: Effort) -> Shown:
    """The same of a case of the paper."""
    from mpsolve.finite.beam import finite_beam
    from mpsolve.vibration.case_motion import units_of

    scale = _scale(source)
    rear = {"tau": tau, "xi": [float(units_of(source.case).case.positions[0])]}

    def finite(said: list[str]) -> Any:
        found = finite_beam(source.case, source.loads, tau=tau)
        said.append(f"finite beam: estimated error {found.error.total * scale.length:.2g} {scale.length_unit}")
        return found.displacement[0]

    return _compared(source.case, source.loads, rear, budget, ("finite beam", finite), [], scale)


def _compared(
    given: Any,
    loads: Any,
    rear: dict[str, Any],
    budget: Effort,
    finite: tuple[str, Callable[[list[str]], Any]],
    said: list[str],
    scale: Scale | None = None,
) -> Shown:
    """The complete solution, what could stand for it, and how far that is apart while contact is kept.

    Where one of them cannot be computed, the rest stands without it, and a sentence says why. finite: its name, and
    the curve on a finite piece of the track, which adds what is to be said of it.
    """
    from mpsolve.problem.cases import as_problem
    from mpsolve.proof.in_time import in_time
    from mpsolve.report.figures_motion import save_comparison
    from mpsolve.vibration.response import response
    from mpsolve.vibration.studies import merged, superposition
    from mpsolve.vibration.table import comparison, deflection

    whole, late, _ = in_time(lambda: response(given, loads, **rear), budget, "the motion was computed")
    if whole is None:
        raise EffortError(late)
    notes, (name, track) = list[str](), finite
    curves = {"complete": deflection(whole), "steady and harmonic": whole.steady[0] + whole.harmonic[0]}

    others: dict[str, Callable[[], Any]] = {
        "superposition": lambda: sum(map(deflection, superposition(given, loads, **rear))),
        "one merged mass": lambda: deflection(merged(given, loads, **rear)),
        name: lambda: track(notes),
    }
    if len(as_problem(given).vehicles) == 1:  # which is its own superposition
        del others["superposition"]
    for other, compute in others.items():
        try:
            row, why, _ = in_time(compute, budget, "it was computed")
        except (InputError, PrecisionError) as error:
            row, why = None, str(error)
        curves |= {} if row is None else {other: row}
        notes += [f"{other}: left out, {why}"] if why else []
    unit, one = ("m", 1.0) if scale is None else (scale.length_unit, scale.length)
    apart = {key: abs(row - curves["complete"])[whole.within].max() * one for key, row in curves.items()}
    ends = f"{unit} at these times, while contact is kept"
    told = [f"{key}: differs from the complete solution by at most {apart[key]:.6g} {ends}" for key in [*apart][1:]]
    drawn = partial(save_comparison, whole, curves, scale=scale)
    return Shown([*told, *notes, *said], partial(comparison, whole, curves, scale), drawn)
