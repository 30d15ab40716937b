"""The complex plane of q: cuts, and induced frequencies that grow or decay."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from mpsolve.batch.view import cuts_in, fitting_window, free_height
from mpsolve.numbers.arrays import Complexes
from mpsolve.pictures.axes import BOTTOM, HIGH, LEFT, RIGHT, TOP, WIDE, Axes, box, clip, disc, line, svg, text
from mpsolve.problem.cases import as_problem
from mpsolve.report.spectrum_words import units_of
from mpsolve.report.vibration import once
from mpsolve.spectrum.spectrum import Spectrum


def plane_picture(
    roots: Complexes, cuts: Sequence[Complexes], width: float, depth: float, height: float, chosen: int | None = None,
    name: str = "plane", unit: str = "rad/s", numbers: Sequence[str] = (),
) -> str:  # fmt: skip
    """|Re q| ≤ width, −depth ≤ Im q ≤ height: circles decay, squares grow; the chosen one is ringed.

    numbers: a word beside each root.
    """
    axes = Axes((-width, width), (-depth, height))
    zero = float(axes.py(0))
    parts = [
        clip(f"{name}-inside"),
        box(LEFT, zero, WIDE - LEFT - RIGHT, max(HIGH - BOTTOM - zero, 0), "grows"),
        f'<g clip-path="url(#{name}-inside)">',
    ]
    for cut in cuts:
        near = np.abs(cut.real) < 3 * width
        parts.append(line(axes, np.where(near, cut.real, np.nan), cut.imag, "cut"))
    parts += [_mark(axes, k, complex(q), unit) for k, q in enumerate(roots)]
    if chosen is not None and chosen < len(roots):
        q = complex(roots[chosen])
        parts.append(disc(float(axes.px(q.real)), float(axes.py(q.imag)), 11, "ring"))
    parts.append("</g>")
    parts += _numbered(axes, roots, numbers)
    parts.append(text(LEFT + 8, HIGH - BOTTOM - 8, "Im q < 0: grows"))
    parts += axes.titled(f"Re q, {unit}", f"Im q, {unit}")
    grow = sum(1 for q in roots if q.imag < 0)
    return svg(parts, f"The complex plane of q: {len(roots)} roots in the window, {grow} of them grow")


_TALL = 6.0
NO_CUT = "The branch cuts, where the waves of the track itself lie, are higher up, out of this picture."


def spectrum_picture(spectrum: Spectrum, name: str = "plane") -> tuple[str, bool]:
    """The certified roots with the cuts, each vibration with its number; and whether a cut is in the picture."""
    problem = as_problem(spectrum.problem)
    q = np.array([complex(root.q.mid()) for root in spectrum.roots], complex)
    window = fitting_window(problem)
    width = max(1.25 * float(np.abs(q.real).max(initial=0.0)), 0.35 * window.width) or window.width
    low = free_height(problem, window) * 16 / 15
    seen = _TALL * float(np.abs(q.imag).max(initial=0.0))  # taller, and the roots seem to lie on the axis
    height = max([min(1.3 * low, seen or np.inf), *(1.2 * q.imag).tolist()]) or width / 4
    depth = max([height / 4, *(-1.3 * q.imag).tolist()])
    numbers = {id(root): str(k) for k, root in enumerate(once(spectrum), 1)}
    beside = [numbers.get(id(root), "") for root in spectrum.roots]
    cuts = cuts_in(problem, window)
    seen_cut = any(((cut.imag < height) & (np.abs(cut.real) < width)).any() for cut in cuts)
    unit = units_of(spectrum).q
    return plane_picture(q, cuts, width, depth, height, name=name, unit=unit, numbers=beside), seen_cut


_BESIDE = ((9, -6), (9, 16), (-18, -6), (-18, 16), (-4, -11), (-4, 21))


def _numbered(axes: Axes, roots: Complexes, numbers: Sequence[str]) -> list[str]:
    """The words beside the roots, those that would lie over another one left out."""
    marks = [(float(axes.px(q.real)), float(axes.py(q.imag))) for q in roots]
    taken: list[tuple[float, float]] = []
    out = []
    for q, said in zip(roots, numbers, strict=False):
        free = []
        for right, down in _BESIDE if said else ():
            x, y = float(axes.px(q.real)) + right, max(float(axes.py(q.imag)) + down, TOP + 12)
            if LEFT < x < WIDE - RIGHT - 8 and all(abs(x - a) > 16 or abs(y - b) > 14 for a, b in taken):
                free.append((sum(abs(x + 4 - a) < 11 and abs(y - 4 - b) < 11 for a, b in marks), x, y))
        if free:
            _, x, y = min(free, key=lambda one: one[0])  # the first of those that cover the fewest marks
            taken.append((x, y))
            out.append(text(x, y, said))
    return out


def _mark(axes: Axes, k: int, q: complex, unit: str) -> str:
    x, y = float(axes.px(q.real)), float(axes.py(q.imag))
    said = f"q = {q.real:.6g}{q.imag:+.6g}i {unit}"
    mark = box(x - 6, y - 6, 12, 12, "root unstable", said) if q.imag < 0 else disc(x, y, 6, "root", said)
    return f'<g data-root="{k}" data-re="{q.real:.9g}" data-im="{q.imag:.9g}">{mark}</g>'
