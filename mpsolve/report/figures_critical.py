"""The chart of critical velocities: dispersion curves with the lines of the force, the damped deflection beside."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.characteristic.forced import receptance
from mpsolve.errors import InputError
from mpsolve.files import write_whole
from mpsolve.problem.reduced import track_guide
from mpsolve.report.figures import rendered, require_matplotlib
from mpsolve.tracks.undamped import undamped
from mpsolve.waves.dispersion import dispersion
from mpsolve.waves.velocity import CriticalVelocities

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from mpsolve.tracks.euler_bernoulli import EulerBernoulli

_POINTS, _SPEEDS, _PLACES = 401, 121, 81
_COLOURS = ("#D55E00", "#0072B2", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")


def save_critical(track: Any, found: CriticalVelocities, path: Path, title: str = "") -> Path:
    """Both panels as .png, .svg or .pdf, written whole or not at all."""
    kind = path.suffix.lower()[1:]
    if kind not in ("png", "svg", "pdf"):
        raise InputError("output", f"{path} does not end in .png, .svg, .pdf: give a name that does")
    require_matplotlib()
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10.0, 4.2), layout="constrained")
    draw_dispersion(track, found, figure.add_subplot(1, 2, 1))
    draw_deflection(track, found, figure.add_subplot(1, 2, 2))
    if title:
        figure.suptitle(title, fontsize=11)
    return write_whole(path, rendered(figure, kind))


def draw_dispersion(track: EulerBernoulli, found: CriticalVelocities, ax: Axes) -> Axes:
    """All undamped branches, and for each critical velocity the line Ω = ω − vp that touches one of them."""
    guide, omega = undamped(track), float(found.omega)
    known = [abs(float(one.wavenumber.mid())) for one in found if one.wavenumber is not None]
    reach = 2.5 * max((x for x in known if x), default=_wavelength(track))
    p = np.linspace(-reach, reach, _POINTS)
    branches = dispersion(guide, p).real
    ax.plot(p, branches, color="black", linewidth=1.0)
    for k, one in enumerate(found):
        v = float(one.value.mid())
        colour = _COLOURS[k % len(_COLOURS)]
        ax.plot(p, omega - v * p, color=colour, linewidth=0.9, linestyle="--", label=f"$v$ = {v:.5g} m/s")
        if one.wavenumber is not None:
            touch = float(one.wavenumber.mid())
            ax.plot([touch], [omega - v * touch], "o", color=colour, markersize=4)
    positive = branches[branches > 0]
    high = 1.15 * float(np.median(positive)) * 2 if len(positive) else 1.0
    ax.set(xlabel="$p$ [rad/m]", ylabel="$Ω$ [rad/s]", ylim=(-high, high), title="dispersion curves and $Ω = ω − vp$")
    if len(found):
        ax.legend(fontsize=7, frameon=False)
    return ax


def draw_deflection(track: EulerBernoulli, found: CriticalVelocities, ax: Axes) -> Axes:
    """The largest deflection under a unit force of frequency ω over its velocity, with the track's own damping."""
    low, high = float(found.lower), float(found.upper)
    critical = [float(one.value.mid()) for one in found]
    top = min(high, 2 * max(critical)) if critical else high
    speeds = np.linspace(low, top, _SPEEDS)
    around = 3.0 / _wavelength(track)
    xi, size = np.linspace(-around, around, _PLACES), []
    for v in speeds:
        try:
            size.append(float(np.abs(receptance(track, xi, float(found.omega), float(v))).max()))
        except InputError:  # where the undamped deflection has no bound
            size.append(np.nan)
    ax.plot(speeds, size, color="black", linewidth=1.0)
    for k, v in enumerate(critical):
        if v <= top:
            ax.axvline(v, color=_COLOURS[k % len(_COLOURS)], linewidth=0.9, linestyle="--")
    ax.set(
        xlabel="$v$ [m/s]",
        ylabel="largest deflection [m/N]",
        title="under a unit force, with damping",
        ylim=(0, None),
    )
    return ax


def _wavelength(track: EulerBernoulli) -> float:
    """A wavenumber that is typical of the track: where inertia or bending begins to count."""
    return float(2.0 ** -track_guide(track, Fraction(0)).length)
