"""A table of receptances as CSV for text import and as JSON, with the track that it is of."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.characteristic.forced import receptance
from mpsolve.errors import InputError
from mpsolve.files import csv_text
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.exact import Exact
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
    """G[i, j] = G(xi[i], omega[j]), complex128: displacement of the rail per unit force, in the problem's units.

    contacts: None, or the matrices G(x_i − x_j, omega) of the problem's contacts, shape (omega, i, j). si: whether
    the problem's units are SI.
    """

    problem: Problem
    title: str
    xi: tuple[float, ...]
    omega: tuple[float, ...]
    G: Complexes
    contacts: Any = None
    si: bool = False

    def to_csv(self) -> str:
        """A row for each ω: omega, then re_G(ξ) and im_G(ξ) for each ξ; in SI with the units behind them."""
        rate, unit = (" [rad/s]", " [m/N]") if self.si else ("", "")
        head = [f"omega{rate}", *(f"{part}_G({xi:.10g}){unit}" for xi in self.xi for part in ("re", "im"))]
        rows = (
            [repr(omega), *(repr(part) for value in column for part in (value.real, value.imag))]
            for omega, column in zip(self.omega, self.G.T.tolist(), strict=True)
        )
        return csv_text([head, *rows])

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
        } | ({} if self.contacts is None else {"contacts": self._matrices()})
        return json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False) + "\n"

    def _matrices(self) -> dict[str, Any]:
        """Receptances and dynamic stiffness K = G⁻¹ between the contacts, from rear to front, for each ω."""
        stiffness = np.linalg.inv(self.contacts)
        return {
            "places": [float(x) for x in self.problem.pencil.places],
            "G_re": self.contacts.real.tolist(),
            "G_im": self.contacts.imag.tolist(),
            "K_re": stiffness.real.tolist(),
            "K_im": stiffness.imag.tolist(),
        }


def receptances(
    problem: Problem,
    title: str,
    xi: tuple[float, ...],
    omega: tuple[float, ...],
    contacts: bool = False,
    si: bool = False,
) -> Receptances:
    """The table of the problem's track at its velocity. Errors as of `receptance`.

    contacts: the matrices between the contacts of the vehicles, too; else the vehicles play no part.
    """
    G = receptance(problem.track, xi, omega, v=problem.v)
    return Receptances(problem, title, xi, omega, G, _between(problem, omega) if contacts else None, si)


def _between(problem: Problem, omega: tuple[float, ...]) -> Complexes:
    places = np.array(problem.pencil.places, float)
    if len(set(places.tolist())) < len(places):
        raise InputError("--contacts", "asks for a matrix, but two contacts stand at one place: it has no inverse")
    gaps, index = np.unique(places[:, None] - places, return_inverse=True)
    table = receptance(problem.track, gaps.tolist(), omega, v=problem.v)
    return np.moveaxis(table[np.reshape(index, (len(places), len(places)))], -1, 0)


def _track(track: Any) -> dict[str, str]:
    if not isinstance(track, Track):
        return {}
    return {"model": track.name, **{name: _number(value) for name, value in track.parameters.items()}}


def _number(value: Fraction) -> str:
    """As short as it is exact."""
    text = shown(value)
    return text if Exact.parse(text) == value else str(value)
