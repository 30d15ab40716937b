"""The pictures of a page, from its parts."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.page.charts import Picture
from mpsolve.page.parts import Parts, searched, worst
from mpsolve.page.words import contact_names, speech
from mpsolve.pictures.axes import COLOURS
from mpsolve.pictures.lines import Curve, Mark, lines_picture, motion_pictures
from mpsolve.pictures.model import model_picture
from mpsolve.pictures.plane import NO_CUT, spectrum_picture
from mpsolve.pictures.shape import moving_shape
from mpsolve.ranges.onset import Kind
from mpsolve.report.vibration import once

_BEYOND = 1.2
_BESIDE, _SAME = 1.5, 0.1
"""How near a line is to a root: in steps of the velocity, and of |q|."""


def drawing(parts: Parts) -> Picture:
    said = "The track and the vehicles of the file. Lengths along the track are to scale, heights are not."
    return Picture("model", model_picture(parts.problem, speech(parts).si), said)


def plane(parts: Parts) -> Picture | None:
    """The certified roots with the cuts; None where there is no root."""
    if not parts.spectrum.roots:
        return None
    picture, seen_cut = spectrum_picture(parts.spectrum)
    said = (
        "Each mark is a certified root q: a circle decays, a square grows. A vibration that swings has two, left and "
        "right, q and −q̄, and is one line of the table, whose number stands at the right one. "
    )
    said += (
        "Grey dashes are the branch cuts, where the waves of the track itself lie: computed." if seen_cut else NO_CUT
    )
    return Picture("plane", picture, said)


def shape(parts: Parts) -> tuple[Picture, list[tuple[str, str, str]]] | None:
    """The shape of the worst root, and its amplitudes: name, size, phase."""
    if parts.shape.value is None:
        return None
    contacts, (x, rail, bodies) = parts.problem.pencil.places, parts.shape.value
    table = [
        (name, f"{abs(a):.3g}", f"{np.degrees(np.angle(a)):.0f}°".replace("-", "−")) for name, a in bodies.items()
    ]
    root = worst(parts.spectrum)
    number = 1 + once(parts.spectrum).index(root) if root is not None else 0
    does = "grows most" if root is not None and root.growth > 0 else "decays least"
    said = (
        f"The shape of vibration {number}, which {does}: one period, slowed down, neither growing nor decaying. "
        "Below, the rail and its contacts; above, how each body moves, all boxes to one scale, the rail to its own."
    )
    return Picture(
        "shape", moving_shape(x, rail, contacts, bodies, 2.0, "x, m" if speech(parts).si else "χx"), said
    ), table


def lines(parts: Parts) -> list[Picture]:
    """Growth and frequency of all roots below the lowest cut, over the velocity."""
    found = parts.lines.value
    if found is None or found.roots is None:
        return []
    speak = speech(parts)
    v = np.asarray(found.over["v"], float)
    tracks = followed(np.where(found.roots.real >= -1e-9, found.roots, complex(np.nan, np.nan)))
    if not tracks:
        return []
    v = v * 3.6 if speak.si else v
    x_title = "velocity, km/h" if speak.si else "velocity ratio α"
    rate, swings = ("1/s", "Hz") if speak.si else ("1/τ", "1/τ")
    cycle = 2 * np.pi
    names = _numbers(parts, np.asarray(found.over["v"], float), tracks)
    growth = [Curve(v, -q.imag, name) for q, name in zip(tracks, names, strict=True)]
    hertz = [Curve(v, q.real / cycle, name) for q, name in zip(tracks, names, strict=True)]
    marks = _marks(parts, 3.6 if speak.si else 1.0)
    grown = lines_picture(
        growth, x_title, f"growth, {rate}", "Growth of each vibration over the velocity",
        name="growth", marks=marks, grows_above=0.0, y=_growth_range(_near(growth, marks)),
    )  # fmt: skip
    swung = lines_picture(
        hertz, x_title, f"frequency, {swings}", "Frequency of each vibration over the velocity",
        name="frequency", marks=marks, y=_hertz_range(hertz),
    )  # fmt: skip
    said = (
        f"How fast each vibration grows (above 0) or decays (below): computed in floats at many velocities."
        f"{_end(parts)} The numbers are those of the table{_others(names, len(once(parts.spectrum)))}."
        f"{' Marks on a line only tell it from another of its colour.' if len(tracks) > COLOURS else ''}"
    )
    return [Picture("growth", grown, said), Picture("frequency", swung, "The frequencies of the same vibrations.")]


def _end(parts: Parts) -> str:
    """Where the search for lines ended."""
    height = searched(parts.problem.track)
    if not height:
        return " Only vibrations that grow were searched."
    return f" A line ends where it decays faster than {speech(parts).rate(height)}: no such one was searched."


def _numbers(parts: Parts, v: Reals, tracks: list[Complexes]) -> list[str]:
    """Of each line the number of the vibration through which it runs at this case, else one beyond the table's."""
    own, roots = float(parts.problem.v), [complex(root.q.mid()) for root in once(parts.spectrum)]
    near = []
    for k, track in enumerate(tracks):
        good = np.isfinite(track)
        here = np.flatnonzero(good)[np.abs(v[good] - own) <= _BESIDE * (v[1] - v[0])]
        near += [(min(abs(track[j] - q) for j in here), k, number) for number, q in enumerate(roots) if len(here)]
    names: dict[int, int] = {}
    for apart, k, number in sorted(near):
        if k not in names and number not in names.values() and apart <= _SAME * abs(roots[number]):
            names[k] = number
    further = iter(range(len(roots), len(roots) + len(tracks)))
    return [str(1 + (names[k] if k in names else next(further))) for k in range(len(tracks))]


def _others(names: list[str], known: int) -> str:
    """What is said of lines that are none of the table's."""
    beyond = sum(int(name) > known for name in names)
    if not beyond:
        return ""
    if beyond == 1:
        return f"; {known + 1} is not in it, as at this velocity it decays too fast, or there is none"
    return f"; {known + 1} to {known + beyond} are not in it, as at this velocity they decay too fast, or are none"


def _near(curves: list[Curve], marks: list[Mark]) -> list[Curve]:
    """As far as a little beyond the marks, if the onset is one of them: what grows far beyond leaves the picture."""
    if len(marks) < 2:
        return curves
    end = _BEYOND * max(mark.x for mark in marks)
    return [Curve(curve.x, np.where(curve.x <= end, curve.y, np.nan)) for curve in curves]


def _growth_range(curves: list[Curve]) -> tuple[float, float] | None:
    """A range in which the crossing of 0 is seen."""
    y = np.concatenate([np.asarray(curve.y)[np.isfinite(curve.y)] for curve in curves]) if curves else np.zeros(0)
    if not len(y):
        return None
    top = max(float(y.max()), 0.08 * float(-y.min()) if y.min() < 0 else 0.0)
    low = max(float(y.min()), -6 * top) if y.max() > 0 else float(y.min())
    return low * 1.05, top * 1.15 or 1.0


def _hertz_range(curves: list[Curve]) -> tuple[float, float]:
    """From 0 on, with room below it for the numbers of slow vibrations."""
    top = max(float(np.nanmax(curve.y)) for curve in curves) or 1.0
    return -0.14 * top, 1.06 * top


def _marks(parts: Parts, factor: float) -> list[Mark]:
    marks = [Mark(float(parts.problem.v) * factor, "this case")]
    found = parts.reach.value
    if found is not None and found.kind is Kind.CROSSES and found.value is not None:
        marks.append(Mark(float(found.value.mid()) * factor, "onset, proved"))
    return marks


def followed(roots: Complexes) -> list[Complexes]:
    """Rows of roots over a parameter as lines: each root goes on where the next row has the nearest one."""
    lines: list[Any] = []
    ends: list[tuple[int, complex]] = []
    for k, row in enumerate(roots):
        free = [complex(q) for q in row if np.isfinite(q)]
        for index, last in sorted(ends, key=lambda one: min((abs(one[1] - q) for q in free), default=np.inf)):
            if not free:
                break
            q = min(free, key=lambda x: abs(x - last))
            if abs(q - last) < 0.2 * abs(last) + 1e-9:
                lines[index][k] = q
                free.remove(q)
        for q in free:
            lines.append(np.full(len(roots), complex(np.nan, np.nan)))
            lines[-1][k] = q
        ends = [(j, complex(one[k])) for j, one in enumerate(lines) if np.isfinite(one[k])]
    return [one for one in lines if np.isfinite(one).sum() > 2]


def motion(parts: Parts) -> list[Picture]:
    """The rail under the contacts, and the forces there; grey after a wheel has lifted off."""
    found = parts.response.value
    if found is None:
        return []
    end, count, own = found.lift_off, len(found.rail), contact_names(parts.problem)
    names = {k: own[k] for k in range(0, count, max(1, count // 4))}
    some = f" ({len(names)} of {count} contacts)" if count > 4 else ""
    until = _until(found.times, None if end is None else float(end.time))
    bent, pressed = motion_pictures(found, names, speech(parts).si, until)
    grey = " After the lift-off the model no longer holds: grey." if end is not None else ""
    return [
        Picture("deflection", bent, f"The rail under the contacts{some}; down is positive.{grey}"),
        Picture("force", pressed, f"The contact forces{some}, weights included.{grey}"),
    ]


def _until(t: Reals, end: float | None) -> Any:
    """All times, or a little beyond the lift-off."""
    return slice(None) if end is None else t <= max(1.25 * end, t[min(20, len(t) - 1)])
