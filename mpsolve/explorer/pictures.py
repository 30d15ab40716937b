"""Pictures as SVG text: the plane of q, and the shape of a vibration, which moves by itself.

Colours are classes (site of the page's style sheet), so that light, dark and print look right; marks differ in form.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np

from mpsolve.explorer.live import View, Window

WIDE, HIGH = 640, 360
_LEFT, _RIGHT, _TOP, _BOTTOM = 58, 12, 12, 40
_FRAMES = 24
_BOXES = 8  # more coordinates than these have no room


@dataclass(frozen=True)
class Axes:
    """Where numbers stand on a picture."""

    x: tuple[float, float]
    y: tuple[float, float]
    high: int = HIGH

    def px(self, x: Any) -> Any:
        a, b = self.x
        return _LEFT + (np.asarray(x, float) - a) / (b - a) * (WIDE - _LEFT - _RIGHT)

    def py(self, y: Any) -> Any:
        a, b = self.y
        return self.high - _BOTTOM - (np.asarray(y, float) - a) / (b - a) * (self.high - _TOP - _BOTTOM)

    def frame(self, x_title: str, y_title: str) -> list[str]:
        out = [_frame(self.high)]
        for t in ticks(*self.x):
            x = float(self.px(t))
            low = self.high - _BOTTOM
            out.append(f'<line class="tick" x1="{x:.1f}" x2="{x:.1f}" y1="{low}" y2="{low + 5}"/>')
            out.append(f'<text x="{x:.1f}" y="{low + 18}" text-anchor="middle">{label(t)}</text>')
        for t in ticks(*self.y):
            y = float(self.py(t))
            out.append(f'<line class="tick" x1="{_LEFT - 5}" x2="{_LEFT}" y1="{y:.1f}" y2="{y:.1f}"/>')
            out.append(f'<text x="{_LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{label(t)}</text>')
        middle = (_LEFT + WIDE - _RIGHT) / 2
        out.append(f'<text x="{middle}" y="{self.high - 4}" text-anchor="middle">{escape(x_title)}</text>')
        up = (_TOP + self.high - _BOTTOM) / 2
        out.append(f'<text transform="translate(12 {up}) rotate(-90)" text-anchor="middle">{escape(y_title)}</text>')
        return out


def _frame(high: int) -> str:
    size = f'width="{WIDE - _LEFT - _RIGHT}" height="{high - _TOP - _BOTTOM}"'
    return f'<rect class="frame" x="{_LEFT}" y="{_TOP}" {size}/>'


def ticks(a: float, b: float) -> list[float]:
    """Round numbers from a to b, some five of them."""
    step = (b - a) / 5
    power = 10.0 ** np.floor(np.log10(step))
    step = next(power * k for k in (1, 2, 5, 10) if power * k >= step * 0.999)
    first = np.ceil(a / step - 1e-9)
    return [float(k * step) + 0.0 for k in np.arange(first, np.floor(b / step + 1e-9) + 1)]


def label(x: float) -> str:
    return f"{x:.6g}".replace("-", "−")


def svg(parts: Sequence[str], title: str, high: int = HIGH) -> str:
    return (
        f'<svg class="picture" viewBox="0 0 {WIDE} {high}" role="img" aria-label="{escape(title, quote=True)}">'
        f"<title>{escape(title)}</title>{''.join(parts)}</svg>"
    )


def plane(view: View, chosen: int | None = None) -> str:
    """The roots and cuts in the window: circles decay, squares grow; the chosen one is ringed."""
    window = view.window
    axes = Axes((-window.width, window.width), (-window.depth, window.height))
    zero = float(axes.py(0))
    parts = [
        f'<clipPath id="inside"><rect x="{_LEFT}" y="{_TOP}" width="{WIDE - _LEFT - _RIGHT}" '
        f'height="{HIGH - _TOP - _BOTTOM}"/></clipPath>',
        f'<rect class="grows" x="{_LEFT}" y="{zero:.1f}" width="{WIDE - _LEFT - _RIGHT}" '
        f'height="{max(HIGH - _BOTTOM - zero, 0):.1f}"/>',
        f'<text class="note" x="{_LEFT + 8}" y="{HIGH - _BOTTOM - 8}">Im q &lt; 0: grows</text>',
        '<g clip-path="url(#inside)">',
    ]
    parts += [_line(axes, cut, window, "cut") for cut in view.cuts]
    for k, q in enumerate(view.roots):
        x, y = float(axes.px(q.real)), float(axes.py(q.imag))
        grows = q.imag < 0
        name = escape(f"q = {q.real:.6g}{q.imag:+.6g}i rad/s", quote=True)
        mark = (
            f'<rect class="root unstable" x="{x - 6:.1f}" y="{y - 6:.1f}" width="12" height="12">'
            if grows
            else f'<circle class="root" cx="{x:.1f}" cy="{y:.1f}" r="6">'
        )
        end = "</rect>" if grows else "</circle>"
        parts.append(
            f'<g data-root="{k}" data-re="{q.real:.9g}" data-im="{q.imag:.9g}">{mark}<title>{name}</title>{end}</g>'
        )
        if k == chosen:
            parts.append(f'<circle class="ring" cx="{x:.1f}" cy="{y:.1f}" r="11"/>')
    parts.append("</g>")
    parts += axes.frame("Re q, rad/s", "Im q, rad/s")
    number = f"{len(view.roots)} induced frequencies in the window, {view.growing} of them grow"
    return svg(parts, f"The complex plane of q: {number}")


def _line(axes: Axes, z: Any, window: Window, name: str) -> str:
    near = np.abs(z.real) < 3 * window.width
    runs = np.split(np.flatnonzero(near), np.flatnonzero(np.diff(np.flatnonzero(near)) > 1) + 1)
    lines = []
    for run in runs:
        if len(run) > 1:
            points = zip(axes.px(z[run].real), axes.py(np.clip(z[run].imag, -1e6, 1e6)), strict=True)
            lines.append(f'<polyline class="{name}" points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in points)}"/>')
    return "".join(lines)


def moving_shape(places: Any, rail: Any, contacts: Any, bodies: dict[str, complex], seconds: float) -> str:
    """The rail and the bodies in one vibration: they move through one period, in `seconds`, without growth.

    places: of the rail, in m; rail: complex amplitudes there; contacts: places of the contacts. The rail is drawn
    with its own scale, and the picture says how much larger than the bodies.
    """
    high = 300
    largest = max((abs(x) for x in bodies.values()), default=0.0) or 1.0
    size = float(np.abs(rail).max()) or 1.0
    axes = Axes((float(places[0]), float(places[-1])), (-1.4, 4.2), high)
    turns = np.exp(2j * np.pi * np.arange(_FRAMES + 1) / _FRAMES)
    curves = [
        " ".join(
            f"{x:.1f},{y:.1f}" for x, y in zip(axes.px(places), axes.py(-(rail * turn).real / size), strict=True)
        )
        for turn in turns
    ]
    parts = [
        f'<polyline class="rail" points="{curves[0]}">{_animated("points", curves, seconds)}</polyline>',
        f'<text class="note" x="{_LEFT + 8}" y="{high - _BOTTOM - 8}">rail {largest / size:.3g} × larger</text>',
    ]
    for place in contacts:
        at = np.array([np.interp(float(place), places, (rail * turn).real) for turn in turns]) / size
        ys = [f"{y:.1f}" for y in axes.py(-at) - 9]
        x = float(axes.px(float(place)))
        parts.append(f'<circle class="wheel" cx="{x:.1f}" cy="{ys[0]}" r="7">{_animated("cy", ys, seconds)}</circle>')
    parts += _boxes(axes, dict(list(bodies.items())[:_BOXES]), largest, turns, seconds)
    parts += [_frame(high), f'<text x="{WIDE / 2}" y="{high - 4}" text-anchor="middle">x, m (ahead is right)</text>']
    for t in ticks(*axes.x):
        parts.append(
            f'<text x="{float(axes.px(t)):.1f}" y="{high - _BOTTOM + 18}" text-anchor="middle">{label(t)}</text>'
        )
    return svg(parts, "The shape of the chosen vibration: rail and bodies", high)


def _boxes(axes: Axes, bodies: dict[str, complex], largest: float, turns: Any, seconds: float) -> list[str]:
    """Each coordinate of the vehicles as a box that moves up and down, with its name, amplitude and phase."""
    parts = []
    width = (WIDE - _LEFT - _RIGHT) / max(len(bodies), 1)
    for k, (name, amplitude) in enumerate(bodies.items()):
        middle = _LEFT + (k + 0.5) * width
        ys = [f"{y - 7:.1f}" for y in axes.py(2.9 - 0.8 * (amplitude * turns).real / largest)]
        parts.append(
            f'<rect class="wheel" x="{middle - 0.35 * width:.1f}" y="{ys[0]}" width="{0.7 * width:.1f}" height="14">'
            f"{_animated('y', ys, seconds)}</rect>"
        )
        said = f"{abs(amplitude):.2g} ∠{np.degrees(np.angle(amplitude)):.0f}°"
        for line, (text, size) in enumerate(((name, 10), (said.replace("-", "−"), 10))):
            y = float(axes.py(1.75)) + 13 * line
            parts.append(
                f'<text x="{middle:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="middle">{escape(text)}</text>'
            )
    return parts


def _animated(attribute: str, values: Sequence[str], seconds: float) -> str:
    joined = ";".join(values)
    return f'<animate attributeName="{attribute}" dur="{seconds:g}s" repeatCount="indefinite" values="{joined}"/>'
