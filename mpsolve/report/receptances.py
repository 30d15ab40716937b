"""A table of receptances as CSV for text import and as JSON, with the track that it is of."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.characteristic.forced import receptance
from mpsolve.numbers.model import shown
from mpsolve.problem.problem import Problem
from mpsolve.tracks.waveguide import Track

FORMAT, VERSION = "mpsolve receptance", 2
MEANING = (
    "A force exp(i omega t) that moves along at the velocity v deflects the rail at the distance xi ahead of it by "
    "G(xi, omega) exp(i omega t); in the units of the track (m/N, m, rad/s for one in SI), computed in float64."
)


@dataclass(frozen=True)
class Receptances:
    """G[i, j] = G(xi[i], omega[j]), complex128: displacement of the rail per unit force, in the problem's units."""

    problem: Problem
    title: str
    xi: tuple[float, ...]
    omega: tuple[float, ...]
    G: Any

    def to_csv(self) -> str:
        """A row for each ω: omega, then re_G(ξ) and im_G(ξ) for each ξ."""
        stream = io.StringIO()
        rows = csv.writer(stream, lineterminator="\n")
        rows.writerow(["omega", *(f"{part}_G({xi:.10g})" for xi in self.xi for part in ("re", "im"))])
        for omega, column in zip(self.omega, self.G.T.tolist(), strict=True):
            rows.writerow([repr(omega), *(repr(part) for value in column for part in (value.real, value.imag))])
        return stream.getvalue()

    def to_json(self) -> str:
        """G_re[i][j], G_im[i][j] for xi[i], omega[j]; track: its model and its parameters, exactly."""
        content = {
            "format": FORMAT,
            "version": VERSION,
            "title": self.title,
            "meaning": MEANING,
            "track": _track(self.problem.track),
            "v": _number(self.problem.v),
            "xi": self.xi,
            "omega": self.omega,
            "G_re": self.G.real.tolist(),
            "G_im": self.G.imag.tolist(),
        }
        return json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def receptances(problem: Problem, title: str, xi: tuple[float, ...], omega: tuple[float, ...]) -> Receptances:
    """The table of the problem's track at its velocity; the vehicles play no part. Errors as of `receptance`."""
    return Receptances(problem, title, xi, omega, receptance(problem.track, xi, omega, v=problem.v))


def _track(track: Any) -> dict[str, str]:
    if not isinstance(track, Track):
        return {}
    return {"model": track.name, **{name: _number(value) for name, value in track.parameters.items()}}


def _number(value: Fraction) -> str:
    """As short as it is exact."""
    text = shown(value)
    return text if "…" not in text else str(value)
