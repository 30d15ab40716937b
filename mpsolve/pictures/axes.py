"""Pictures as SVG text without any library: axes, ticks, lines. Colours are classes, so that a page in light, in dark
and on paper gives its own; marks differ in form too, so that grey is enough.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals

WIDE, HIGH = 480, 320  # a text of 12 is 9 px high on a telephone of 390 px
LEFT, RIGHT, TOP, BOTTOM = 70, 14, 14, 44

_MARKS = 55.0  # from one mark on a line to the next

STYLE = """
.picture { width: 100%; height: auto; font: 13px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; }
.picture text { fill: var(--ink, currentColor); }
.picture .frame { fill: none; stroke: var(--ink, currentColor); }
.picture .tick { stroke: var(--ink, currentColor); }
.picture .grid { stroke: var(--line, #8886); }
.picture .note { font-size: 12px; }
.picture .halo { paint-order: stroke; stroke: var(--card, Canvas); stroke-width: 4px; stroke-linejoin: round; }
.picture .grows { fill: var(--red, #c44e00); fill-opacity: 0.14; }
.picture .hatch { fill: none; stroke: var(--red, #c44e00); stroke-width: 1.3; }
.picture .border { fill: none; stroke: var(--ink, currentColor); stroke-width: 1; }
.picture .sure { fill: none; stroke: var(--green, #00805f); stroke-width: 2.5; }
.picture .cut { fill: none; stroke: var(--faint, #777); stroke-width: 4; stroke-dasharray: 9 4; }
.picture .root { fill: var(--blue, #0072b2); stroke: var(--ink, currentColor); }
.picture .unstable { fill: var(--red, #c44e00); }
.picture .ring { fill: none; stroke: var(--ink, currentColor); stroke-width: 2; }
.picture .curve { fill: none; stroke: var(--blue, #0072b2); stroke-width: 2.5; }
.picture .two { stroke: var(--red, #c44e00); stroke-dasharray: 8 3; }
.picture .three { stroke: var(--green, #00805f); stroke-dasharray: 2 3; }
.picture .four { stroke: var(--pink, #a8588a); stroke-dasharray: 8 3 2 3; }
.picture .dash0 { stroke-dasharray: none; }
.picture .dash1 { stroke-dasharray: 8 3; }
.picture .dash2 { stroke-dasharray: 2 3; }
.picture .dash3 { stroke-dasharray: 8 3 2 3; }
.picture .point { fill: var(--card, Canvas); stroke: var(--ink, currentColor); stroke-width: 1.5; }
.picture .end { fill: none; stroke: var(--ink, currentColor); stroke-width: 2; }
.picture .boundary { fill: none; stroke: var(--ink, currentColor); stroke-width: 2; }
.picture .zero { stroke-dasharray: 7 4; }
.picture .beyond { stroke: var(--soft, #777); stroke-opacity: 0.5; }
.picture .here { stroke: var(--ink, currentColor); stroke-width: 2; stroke-dasharray: 3 3; fill: none; }
.picture .body { fill: var(--card, Canvas); stroke: var(--ink, currentColor); stroke-width: 2; }
.picture .rail { fill: none; stroke: var(--blue, #0072b2); stroke-width: 3; }
.picture .solid { fill: var(--ink, currentColor); stroke: none; }
.picture .link { fill: none; stroke: var(--ink, currentColor); stroke-width: 1.5; }
"""


COLOURS = 4


def curve_class(k: int) -> str:
    """Of the k-th line of a picture: colour and dashes; from the fifth on dashes with another colour."""
    name = ("curve", "curve two", "curve three", "curve four")[k % COLOURS]
    return f"{name} dash{(k + k // 4) % 4}" if k > 3 else name


def mark_at(x: float, y: float, k: int) -> str:
    """A mark on the k-th line: none on the first four, then circles, squares, triangles."""
    kind = min(k // 4, 3)
    d = ("", "m-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0", "m-3.5 -3.5h7v7h-7z", "m0 -4.5l4.5 8h-9z")[kind]
    return f'<path class="point" d="M{x:.1f} {y:.1f}{d}"/>' if kind else ""


def end_mark(x: float, y: float) -> str:
    """A cross where a line ends at a cut."""
    return f'<path class="end" d="M{x:.1f} {y:.1f}m-4.5 -4.5l9 9m0 -9l-9 9"/>'


def marked(axes: Axes, x: Reals, y: Any, k: int) -> str:
    """Marks along the k-th line, shifted from line to line."""
    px, py = np.broadcast_arrays(axes.px(x), axes.py(y))
    out, last = [], -_MARKS + 11.0 * (k % 4)
    for a, b in zip(px.tolist(), py.tolist(), strict=True):
        if np.isfinite(b) and a - last >= _MARKS:
            out.append(mark_at(a, b, k))
            last = a
    return "".join(out)


@dataclass(frozen=True)
class Axes:
    """Where numbers stand on a picture."""

    x: tuple[float, float]
    y: tuple[float, float]
    high: int = HIGH

    def px(self, x: Any) -> Any:
        a, b = self.x
        return LEFT + (np.asarray(x, float) - a) / (b - a) * (WIDE - LEFT - RIGHT)

    def py(self, y: Any) -> Any:
        a, b = self.y
        return self.high - BOTTOM - (np.asarray(y, float) - a) / (b - a) * (self.high - TOP - BOTTOM)

    def titled(self, x_title: str, y_title: str) -> list[str]:
        """Frame, ticks, and the titles of both axes."""
        out = [frame(self.high)]
        for t in ticks(*self.x):
            x = float(self.px(t))
            low = self.high - BOTTOM
            out.append(f'<line class="tick" x1="{x:.1f}" x2="{x:.1f}" y1="{low}" y2="{low + 5}"/>')
            out.append(f'<text x="{x:.1f}" y="{low + 18}" text-anchor="middle">{label(t)}</text>')
        for t in ticks(*self.y):
            y = float(self.py(t))
            out.append(f'<line class="tick" x1="{LEFT - 5}" x2="{LEFT}" y1="{y:.1f}" y2="{y:.1f}"/>')
            out.append(f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{label(t)}</text>')
        middle = (LEFT + WIDE - RIGHT) / 2
        out.append(f'<text x="{middle}" y="{self.high - 4}" text-anchor="middle">{escape(x_title)}</text>')
        up = (TOP + self.high - BOTTOM) / 2
        out.append(f'<text transform="translate(12 {up}) rotate(-90)" text-anchor="middle">{escape(y_title)}</text>')
        return out


def frame(high: int = HIGH) -> str:
    size = f'width="{WIDE - LEFT - RIGHT}" height="{high - TOP - BOTTOM}"'
    return f'<rect class="frame" x="{LEFT}" y="{TOP}" {size}/>'


def ticks(a: float, b: float) -> list[float]:
    """Round numbers from a to b, some five of them."""
    step = (b - a) / 5
    power = 10.0 ** np.floor(np.log10(step))
    step = next(power * k for k in (1, 2, 5, 10) if power * k >= step * 0.999)
    first = np.ceil(a / step - 1e-9)
    return [float(k * step) + 0.0 for k in np.arange(first, np.floor(b / step + 1e-9) + 1)]


def label(x: float) -> str:
    return f"{x:.6g}".replace("-", "−")


def line(axes: Axes, x: Any, y: Any, name: str) -> str:
    """A line through points; where one is not finite it is broken."""
    px, py = np.broadcast_arrays(axes.px(x), axes.py(y))
    good = np.isfinite(px) & np.isfinite(py) & (np.abs(py) < 1e5) & (np.abs(px) < 1e5)
    runs = np.split(np.arange(len(px)), np.flatnonzero(~good))
    out = []
    for run in runs:
        kept = run[good[run]]
        if len(kept) > 1:
            points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(px[kept], py[kept], strict=True))
            out.append(f'<polyline class="{name}" points="{points}"/>')
    return "".join(out)


def clip(name: str, high: int = HIGH) -> str:
    """What is drawn in a group with clip-path="url(#name)" keeps inside the frame."""
    size = f'width="{WIDE - LEFT - RIGHT}" height="{high - TOP - BOTTOM}"'
    return f'<clipPath id="{name}"><rect x="{LEFT}" y="{TOP}" {size}/></clipPath>'


def text(x: float, y: float, said: str, anchor: str = "start", name: str = "note halo") -> str:
    return f'<text class="{name}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escape(said)}</text>'


def path(d: str, name: str = "link") -> str:
    return f'<path class="{name}" d="{d}"/>'


def box(x: float, y: float, wide: float, high: float, name: str = "body", title: str = "") -> str:
    told = f"<title>{escape(title)}</title>" if title else ""
    return f'<rect class="{name}" x="{x:.1f}" y="{y:.1f}" width="{wide:.1f}" height="{high:.1f}">{told}</rect>'


def disc(x: float, y: float, r: float, name: str = "body", title: str = "") -> str:
    told = f"<title>{escape(title)}</title>" if title else ""
    return f'<circle class="{name}" cx="{x:.1f}" cy="{y:.1f}" r="{r:g}">{told}</circle>'


def plain(colours: Mapping[str, str] | None = None) -> str:
    """The style for programs that know no variables, nor an order of painting, in which a halo covers its letters.

    colours: of variables, in place of those that stand beside them.
    """
    said = re.sub(r"var\((--\w+), (#?\w+)\)", lambda one: (colours or {}).get(one[1], one[2]), STYLE)
    said = re.sub(r"\.picture \.halo \{[^}]*\}\n", "", said)
    return said.replace("currentColor", "#000").replace("Canvas", "#fff").replace("#8886", "#ccc")


def alone(picture: str) -> str:
    """The picture as a file of its own, or in a notebook: with its style and its size, in the colours of paper."""
    head, rest = picture.split(">", 1)
    wide, high = (float(x) for x in re.findall(r'viewBox="0 0 (\S+) (\S+)"', head)[0])
    size = f'width="720" height="{720 * high / wide:.0f}"'
    space = f'xmlns="http://www.w3.org/2000/svg" {size} style="background:#fff;color:#000"'
    style = plain().replace("width: 100%; height: auto", "max-width: 100%")
    paper = '<path fill="#fff" d="M-9 -9h9999v9999h-9999"/>'
    return f"{head} {space}><style>{style}</style>{paper}{rest}\n"


def svg(parts: Sequence[str], title: str, high: int = HIGH) -> str:
    return (
        f'<svg class="picture" viewBox="0 0 {WIDE} {high}" role="img" aria-label="{escape(title, quote=True)}">'
        f"<title>{escape(title)}</title>{''.join(parts)}</svg>"
    )
