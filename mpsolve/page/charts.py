"""The chart of the page: how many roots grow over velocity and masses, with all on it that is proved."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.page.parts import Parts, worth_drawing
from mpsolve.page.words import Speech, speech
from mpsolve.pictures.chart import Sure, chart_picture
from mpsolve.pictures.proved_chart import drawn, ends, proved_parts
from mpsolve.problem.case import Case
from mpsolve.ranges.chart import Chart
from mpsolve.ranges.margin import Margin
from mpsolve.ranges.onset import Kind


@dataclass(frozen=True)
class Picture:
    """A figure with its caption; name: of its element on the page."""

    name: str
    svg: str
    caption: str


def chart(parts: Parts) -> Picture | None:
    """Proved regions where there are any, else computed counts."""
    found, grid = _proved(parts), _computed(parts)
    if found is not None:
        counts = drawn(found)
        grid = ends(found.x, counts.shape[0]), ends(found.y, counts.shape[1]), counts
    if grid is None:
        return None
    speak = speech(parts)
    scale, (mass, y_title) = 3.6 if speak.si else 1.0, _masses(parts, speak)
    v, factors, counts = grid
    sure = sure_of(parts, scale, mass)
    svg = chart_picture(
        v * scale, factors * mass, counts, "velocity, km/h" if speak.si else "velocity ratio α", y_title,
        "How many roots grow, over velocity and masses", here=(float(parts.problem.v) * scale, mass), sure=sure,
        **({} if found is None else proved_parts(found, (scale, mass))),
    )  # fmt: skip
    how = "computed in floats"
    if found is not None:
        how = ("proved, and so are the curves between the areas" if found.traced else
               "proved, but for dotted strips, in which a boundary may run")  # fmt: skip
        how += f"; {100 * (1 - found.share):.2g} % of it, next to the curves, is drawn as what is beside it"
    outlined = " What is outlined, boxes and straight lines, is proved stable." if sure else ""
    said = f"How many roots grow at each velocity and size of all masses: {how}.{outlined} The cross is this case."
    return Picture("chart", svg, f"{said} Two roots, q and −q̄, are one vibration.")


def chart_status(parts: Parts) -> str:
    """Whether the regions on the chart are proved."""
    return "computed" if _proved(parts) is None else "proved"


def _proved(parts: Parts) -> Chart | None:
    found: Chart | None = parts.proved_chart.value
    return found if worth_drawing(found) else None


def _computed(parts: Parts) -> tuple[Reals, Reals, Integers] | None:
    found = parts.chart.value
    if found is None:
        return None
    over: dict[str, Any] = {path: np.asarray(values) for path, values in found.over.items()}
    return over["v"][:, 0], over["scale.mass"][0], found.count


def sure_of(parts: Parts, scale: float, mass: float) -> list[Sure]:
    """On the chart: the velocities and the masses through this case, and the box round it, that are proved stable."""
    v, out = float(parts.problem.v) * scale, []
    reach, margin, box = parts.reach.value, parts.mass.value, parts.box.value
    if reach is not None and reach.kind in (Kind.STABLE, Kind.CROSSES):
        end = reach.high if reach.value is None else _number(reach.value)
        out.append(Sure((float(reach.low) * scale, float(end) * scale), (mass, mass)))
    if margin is not None and margin.stable:
        low, high = _ends(margin)
        out.append(Sure((v, v), (low * mass, high * mass)))
    if box is not None:
        (a, b), (c, d) = ([float(x) for x in ends] for ends in (box["v"], box["scale.mass"]))
        out.append(Sure((a * scale, b * scale), (c * mass, d * mass)))
    return out


def _ends(margin: Margin) -> tuple[float, float]:
    low, high = margin.over
    below = low if margin.below is None else margin.below
    above = high if margin.above is None else margin.above
    return _number(below), _number(above)


def _number(x: Any) -> float:
    return float(x.mid()) if hasattr(x, "mid") else float(x)


def _masses(parts: Parts, speak: Speech) -> tuple[float, str]:
    """The mass that the axis tells, and its title: of all bodies together."""
    if isinstance(parts.given, Case) and len({eta.short() for eta in parts.given.eta_m}) == 1:
        return float(parts.given.eta_m[0]), "mass ratio η_M of each"
    pencil = parts.problem.pencil
    total = sum(float(pencil.M[k][k]) for k, name in enumerate(pencil.names) if "pitch" not in name)
    return (total / 1000, "mass of all bodies, t") if speak.si else (1.0, "factor on all masses")
