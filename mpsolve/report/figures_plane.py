"""The complex q-plane of a spectrum: cuts, branch points, contour, certified roots, and each root's ball.

Ids in the pictures: root-K (the K-th of spectrum.roots, from 1), branch-point-left and -right, cut-left and -right.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.certificate.on_sheet import AnySpectrum, sheet_of
from mpsolve.fields import Float64
from mpsolve.model.limits import limiting_frequency
from mpsolve.model.parameters import Case
from mpsolve.numbers.decimals import proved_digits
from mpsolve.report.figures import COLOUR, Look
from mpsolve.report.vibration import Trend, Vibration

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_GAP = 0.018  # of the height: how far the contour is drawn from the cut on which it runs
_GUARD = 0.12  # of the extent, around what is shown
_CLOSE = 0.25  # of the half width: below it the labels of both branch points would meet


def centre(root: Any) -> tuple[float, float]:
    """The midpoint of the ball, in float64."""
    return float(root.q.real.mid()), float(root.q.imag.mid())


def gap_end(case: Case) -> float | None:
    """q_lm where the cuts are apart, 0 where they are joined, None where they leave the line Im q = η_b; float64."""
    return max(0.0, float(limiting_frequency(case, Float64()))) if case.cuts_on_line else None


def q_plane(spectrum: AnySpectrum, ax: Axes, look: Look = COLOUR) -> Axes:
    """The roots with the cuts, their branch points, the contour along them and the unstable half-plane; `ax`."""
    spectrum = sheet_of(spectrum)
    start = gap_end(spectrum.case)
    height = float(spectrum.case.eta_b)
    places = [centre(root) for root in spectrum.roots]
    reach = 1.5 * max([abs(x) for x, _ in places] + [start or 0.0, 0.3])
    low, high = (f([y for _, y in places] + [0.0, height if start is not None else 0.0]) for f in (min, max))
    extent = (high - low) or 0.1
    limits = low - 2 * _GUARD * extent, high + 2 * _GUARD * extent
    ax.set(xlim=(-reach, reach), ylim=limits, xlabel="Re q", ylabel="Im q")
    _halves(ax, look)
    if start is not None:
        _cuts(ax, start, height, look)
        _contour_at_cuts(ax, start, height, look)
    draw_roots(spectrum, ax, look, 7)
    return ax


def draw_roots(spectrum: AnySpectrum, ax: Axes, look: Look = COLOUR, size: float = 7) -> Axes:
    """A mark at the midpoint of each certified ball; a diamond where Im q < 0 is proved."""
    spectrum = sheet_of(spectrum)
    for k, root in enumerate(spectrum.roots, 1):
        x, y = centre(root)
        ax.plot(x, y, **look.root(root.q.imag < 0), markersize=size, markeredgewidth=0.8, zorder=5, gid=f"root-{k}")
    return ax


def roots_zoom(motions: tuple[Vibration, ...], seconds: bool, ax: Axes, look: Look = COLOUR) -> Axes:
    """The roots with Re q ≥ 0 enlarged, each with its frequency and the time in which it doubles or halves; `ax`.

    motions: of `vibrations`; seconds: whether in Hz and s, or else in units of τ. Ids: zoom-K.
    """
    places = [centre(motion.root) for motion in motions]
    (left, right), (low, high) = _window([x for x, _ in places]), _window([y for _, y in places] + [0.0])
    ax.set(xlim=(left, right), ylim=(low, high + 0.25 * (high - low)), xlabel="Re q", ylabel="Im q")
    _halves(ax, look, said=False)
    for k, (motion, (x, y)) in enumerate(zip(motions, places, strict=True), 1):
        ax.plot(x, y, **look.root(motion.trend is Trend.GROWS), markersize=9, zorder=5, gid=f"zoom-{k}")
        ax.annotate(
            _told(motion, seconds), (x, y), xytext=(0, 9), textcoords="offset points", ha="center", fontsize=9
        )
    return ax


def root_ball(motion: Vibration, ax: Axes, look: Look = COLOUR) -> Axes:
    """The proved box of one root, drawn to scale around its midpoint; `ax`."""
    q, units = motion.root.q, 0
    radii = [float(side.rad()) for side in (q.real, q.imag)]
    size = max(radii)
    if size:
        units = math.floor(math.log10(size))
    scaled = [radius / 10.0**units for radius in radii]
    reach = 2.2 * max(*scaled, 0.1)
    ax.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal")
    _box(scaled, ax, look.unstable if motion.trend is Trend.GROWS else look.stable)
    ax.plot(0, 0, "+", color=look.ink, markersize=8)
    unit = f"$10^{{{units}}}$"
    ax.set_xlabel(f"Re q − {proved_digits(abs(q.real), 6)}…, in {unit}", fontsize=9)
    ax.set_ylabel(f"Im q − ({proved_digits(q.imag, 4)}…), in {unit}", fontsize=9)
    ax.tick_params(labelsize=8)
    return ax


def whole_contour(spectrum: AnySpectrum, ax: Axes, look: Look = COLOUR) -> Axes:
    """The whole contour of the count to scale: both edges of the cuts and the far circle; `ax`.

    Where only Im q < 0 was counted: the real axis and the circle below it.
    """
    spectrum = sheet_of(spectrum)
    rho = 1.0 if spectrum.radius is None else spectrum.radius
    start = gap_end(spectrum.case)
    on_cuts = start is not None
    height = float(spectrum.case.eta_b)
    below = math.asin(min(1.0, height / rho))  # where the circle meets the real axis
    turn = np.linspace(0.0 if on_cuts else below - np.pi, 2 * np.pi if on_cuts else -below, 361)
    ax.plot(rho * np.cos(turn), height + rho * np.sin(turn), color=look.ink, linewidth=1.2, gid="far-circle")
    limit = 1.12 * rho
    ax.set(xlim=(-limit, limit), ylim=(height - limit, height + limit), aspect="equal", xlabel="Re q", ylabel="Im q")
    ax.axhspan(height - limit, 0, color=look.shade, linewidth=0, zorder=0)
    if on_cuts:
        for side in (-1, 1):
            ax.plot([side * (start or 0), side * limit], [height, height], color=look.cut, linewidth=2.2)
    else:
        ax.plot([-rho * math.cos(below), rho * math.cos(below)], [0, 0], color=look.ink, linewidth=1.2)
    ax.text(0, height + (0.5 if on_cuts else -0.5) * rho, f"|q − i$η_b$| = {rho:.6g}", ha="center", fontsize=9)
    return draw_roots(spectrum, ax, look, 3)


def _halves(ax: Axes, look: Look, said: bool = True) -> None:
    """The real axis and the half-plane below it, in which e^{iqτ} grows."""
    (left, _), (low, high) = ax.get_xlim(), ax.get_ylim()
    if low < 0:
        ax.axhspan(low, 0, color=look.shade, linewidth=0, zorder=0)
    ax.axhline(0, color=look.ink, linewidth=0.8)
    if said:
        ax.text(left * 0.97, low + 0.02 * (high - low), "Im q < 0: grows, unstable", va="bottom", fontsize=9)


def _cuts(ax: Axes, start: float, height: float, look: Look) -> None:
    """The rays Im q = η_b, |Re q| ≥ q_lm, from their branch points outward."""
    reach = ax.get_xlim()[1]
    for side, name in ((-1, "left"), (1, "right")):
        ax.plot([side * start, side * reach], [height, height], color=look.cut, linewidth=2.4, gid=f"cut-{name}")
        if not start:
            continue
        end: dict[str, Any] = {"markerfacecolor": "white", "markeredgewidth": 1.5, "markersize": 6, "zorder": 4}
        ax.plot(side * start, height, "o", color=look.cut, **end, gid=f"branch-point-{name}")
    if start:
        both = [(-start, "−"), (start, "")] if start > _CLOSE * reach else [(0.0, "±")]
        for x, sign in both:
            said = f"{sign}$q_{{lm}}$ + i$η_b$"
            ax.annotate(said, (x, height), (0, 9), textcoords="offset points", ha="center", fontsize=9)
    place = (reach + start) / 2
    ax.annotate("branch cut", (place, height), (0, -14), textcoords="offset points", ha="center", fontsize=9)


def _contour_at_cuts(ax: Axes, start: float, height: float, look: Look) -> None:
    """The contour of the count along both edges of each cut, drawn a little apart from it, and round its end."""
    (_, reach), (low, high) = ax.get_xlim(), ax.get_ylim()
    apart = _GAP * (high - low)
    round_end = _GAP * reach
    style: dict[str, Any] = {"color": look.faint, "linewidth": 0.9, "linestyle": (0, (3, 2))}
    for side in (-1, 1):
        if start:
            turn = np.linspace(np.pi / 2, 3 * np.pi / 2, 31)
            x = np.concatenate([[reach], start + round_end * np.cos(turn) * 1.6, [reach]])
            y = np.concatenate([[height + apart], height + apart * np.sin(turn), [height - apart]])
            ax.plot(side * x, y, **style)
        else:
            for edge in (-1, 1):
                ax.plot([0, side * reach], [height + edge * apart] * 2, **style)


def _window(values: list[float]) -> tuple[float, float]:
    """The range of the values, and some room on both sides."""
    low, high = min(values), max(values)
    room = 0.35 * (high - low) or 0.25 * abs(high) or 0.1
    return low - room, high + room


def _told(motion: Vibration, seconds: bool) -> str:
    hertz, unit = (" Hz", " s") if seconds else ("/τ", " τ")
    said = f"{float(motion.frequency):.4g}{hertz}"
    if motion.time is None:
        return f"{said}\n{motion.trend.value}"
    verb = "doubles" if motion.trend is Trend.GROWS else "halves"
    return f"{said}\n{verb} in {proved_digits(motion.time, 3)}{unit}"


def _box(radii: list[float], ax: Axes, colour: str) -> None:
    """The box [−r, r] × [−s, s]; a segment or a point where a radius is 0."""
    from matplotlib.patches import Rectangle

    r, s = radii
    ax.add_patch(Rectangle((-r, -s), 2 * r, 2 * s, facecolor=colour, alpha=0.25, edgecolor=colour, gid="ball"))
    if not (r and s):
        ax.plot([-r, r], [-s, s], color=colour, marker="" if r or s else "o")
