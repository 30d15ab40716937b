"""The unsteady harmonic part at the rear contact point between its envelopes, as in Figures 3 to 8 and 11."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from style import LIMIT, greys, page

from mpsolve import Case, certify
from mpsolve.motion import Envelope, envelope, harmonic_solution

TAU: Any = np.linspace(0.0, 400.0, 2001)
DIGITS = 15  # of the certified induced frequencies


@dataclass(frozen=True)
class Vibration:
    """w: the unsteady harmonic part (36) at ξ = 0, shape (len(tau),), in w_st, for one unit constant force on each
    mass. q: the certified induced frequency of each pair, in float64, Re q > 0."""

    case: Case
    tau: Any
    w: Any
    envelope: Envelope
    q: tuple[complex, ...]


def pair_of_masses(alpha: str, eta_m: int, d: str, eta_b: str = "0") -> Case:
    """Two equal masses at the distance d (rear one at ξ = 0), η_N = η_S = 0."""
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, d))


def vibration(case: Case, tau: Any = TAU) -> Vibration:
    """From one certificate of all induced frequencies; errors as for `harmonic_solution`."""
    spectrum = certify(case, DIGITS)
    found = harmonic_solution(case, None, [0], tau, spectrum)
    q = tuple(pair.q for pair in found.harmonic_pairs)
    return Vibration(case, tau, found.harmonic[0], envelope(case, None, 0, tau, spectrum), q)


def harmonic_figure(path: Path | str, panels: Sequence[Sequence[Case]], tau: Any = TAU) -> Path:
    """One panel a case, in the rows given; the darker the line, the greater the distance. Returns the path."""
    rows, columns = len(panels), len(panels[0])
    distances = sorted({float(case.positions[-1]) for row in panels for case in row})
    shade = dict(zip(distances, greys(len(distances)), strict=True))
    with page(path, rows, columns, sharex=True, sharey=True) as axes:
        for cases, row in zip(panels, axes, strict=True):
            for case, ax in zip(cases, row, strict=True):
                draw_vibration(vibration(case, tau), ax, shade[float(case.positions[-1])])
        for ax in axes[-1]:
            ax.set_xlabel("$τ$")
        for ax in axes[:, 0]:
            ax.set_ylabel("$\\hat w$ at the rear mass")
        axes[0, 0].invert_yaxis()  # displacements are positive downward
    return Path(path)


def draw_vibration(found: Vibration, ax: Any, shade: str) -> Any:
    """One line and, dotted, ± the modulus of the envelope; returns `ax`."""
    ax.plot(found.tau, found.w, color=shade)
    for sign in (1, -1):
        ax.plot(found.tau, sign * found.envelope.modulus, **LIMIT)
    ax.set_title(f"$\\hat d = {float(found.case.positions[-1]):g}$, $α = {float(found.case.alpha):g}$")
    ax.set_xlim(found.tau[0], found.tau[-1])
    return ax
