"""The figures of a page, each with a caption for all readers and a description in numbers for screen readers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from mpsolve.certificate.sheet import SheetSpectrum
from mpsolve.errors import known
from mpsolve.fields import ball_arithmetic
from mpsolve.motion.scale import Scale
from mpsolve.numbers.decimals import proved_digits, working_bits
from mpsolve.report.figures import SIZE, figure_of
from mpsolve.report.figures_chart import stability_map
from mpsolve.report.figures_lines import line_frequencies, line_growth
from mpsolve.report.figures_plane import gap_end, q_plane, root_ball, roots_zoom, whole_contour
from mpsolve.report.figures_response import contact_forces, displacements
from mpsolve.report.figures_svg import inline_svg
from mpsolve.report.page_parts import Parts
from mpsolve.report.statement import radius_text
from mpsolve.report.vibration import Vibration, vibrations
from mpsolve.stability.chart import StabilityChart
from mpsolve.stability.lines import FrequencyLines

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_SMALL = (2.7, 2.5)
_ROUND = (3.4, 3.3)
_TALL = (5.2, 4.3)


@dataclass(frozen=True)
class Picture:
    """An inline SVG with its caption, which stands below it."""

    name: str
    svg: str
    caption: str


def plane_pictures(parts: Parts) -> list[Picture]:
    """The q-plane, its roots enlarged, and the whole contour."""
    spectrum, physical = parts.spectrum, parts.source.physical
    motions = vibrations(spectrum, physical)
    pictures = [
        _picture(
            "plane",
            "The complex q-plane with cuts, branch points, contour and roots",
            f"{_roots_said(motions, spectrum)} {_cuts_said(spectrum)}",
            _plane_caption(spectrum),
            lambda ax: q_plane(spectrum, ax),
        )
    ]
    if motions:
        pictures.append(
            _picture(
                "zoom",
                "The roots enlarged",
                _roots_said(motions, spectrum),
                "The roots with Re q ≥ 0 enlarged; each other one is the mirror image −q̄ of one of these.",
                lambda ax: roots_zoom(motions, physical is not None, ax),
            )
        )
    if spectrum.radius is not None:
        pictures.append(
            _picture(
                "contour",
                "The whole contour to scale",
                f"{_contour_said(spectrum)}. {_roots_said(motions, spectrum)}",
                f"{_contour_said(spectrum)}, beyond which there is proved to be no root"
                f"{'' if spectrum.region == 'sheet' else ' with Im q < 0'}.",
                lambda ax: whole_contour(spectrum, ax),
                _ROUND,
            )
        )
    return pictures


def ball_pictures(parts: Parts) -> list[Picture]:
    """A zoom on the proved box of each root with Re q ≥ 0."""
    motions = vibrations(parts.spectrum, parts.source.physical)
    return [_ball(k, motion) for k, motion in enumerate(motions, 1)]


def _ball(k: int, motion: Vibration) -> Picture:
    q = motion.root.q
    sides = f"{2 * float(q.real.rad()):.2g} by {2 * float(q.imag.rad()):.2g}"
    held = "exactly one root" if motion.root.multiplicity == 1 else f"exactly {motion.root.multiplicity} roots"
    return _picture(
        f"ball{k}",
        f"The box of root q{k}",
        f"A box of {sides} around the midpoint that is proved to hold {held}.",
        f"q{k}: the box of {sides} holds {held}.",
        lambda ax: root_ball(motion, ax),
        _SMALL,
    )


def line_pictures(lines: FrequencyLines, parts: Parts) -> list[Picture]:
    """Re q and Im q over the velocity ratio."""
    spectrum, physical = parts.spectrum, parts.source.physical
    ends = f"{lines.alpha[0].short()} to {lines.alpha[-1].short()}"
    said = f"{len(lines)} frequency lines for velocity ratios from {ends}. {_lines_said(lines)}"
    return [
        _picture(
            "frequency",
            "Frequencies over the velocity ratio",
            said,
            "Re q of every induced frequency over the velocity. Points are certified roots; two are joined only "
            f"where one is proved to continue to the other. {_ends_said(lines)}",
            lambda ax: line_frequencies(lines, ax, spectrum, physical),
            _TALL,
        ),
        _picture(
            "growth",
            "Imaginary parts over the velocity ratio",
            said,
            "Im q of the same lines. Below the axis the vibration grows. Between the points the lines are straight.",
            lambda ax: line_growth(lines, ax, spectrum, physical),
            _TALL,
        ),
    ]


def chart_picture(chart: StabilityChart, parts: Parts) -> Picture:
    """The stability chart with the case marked."""
    case = parts.source.case
    columns = (
        f"at {label} times the masses: "
        + (", ".join(f"α = {point.alpha}" for point in column.points) or "no crossing")
        for label, column in zip(chart.x.labels, chart.columns, strict=True)
    )
    return _picture(
        "chart",
        "Stability over velocity and mass, with this case marked",
        f"This case: α = {case.alpha.short()}, factor 1. Where stability changes: {'; '.join(columns)}.",
        f"The number of unstable roots over the velocity, for all masses together scaled up or down. {chart.guide}",
        lambda ax: stability_map(chart, case, ax, parts.source.physical),
        _TALL,
    )


def response_pictures(parts: Parts) -> list[Picture]:
    """Displacements with envelopes, and contact forces; none where there is no response."""
    motion = parts.response.value
    if motion is None:
        return []
    scale = Scale.of(parts.source.physical)
    w, bound = motion.w * scale.length, motion.envelope * scale.length
    force, unit = motion.contact_forces * scale.force, scale.length_name
    ends = f"to {motion.tau[-1] * scale.time:.4g} {scale.time_name}".removesuffix(" τ")
    said = " ".join(
        f"Contact point {k + 1}: from {w[k].min():.4g} to {w[k].max():.4g} {unit}, steady part at the end "
        f"{motion.steady[k][-1] * scale.length:.4g}, envelope at the end {bound[k][-1]:.3g}."
        for k in range(len(w))
    )
    pressed = " ".join(f"Mass {k + 1}: from {row.min():.4g} to {row.max():.4g}." for k, row in enumerate(force))
    return [
        _picture(
            "displacement",
            "Displacement of the contact points over time",
            f"Time from 0 {ends}. {said}",
            "Displacement of the beam under each mass, downward. Dotted: the steady part ± the envelope of the "
            "unsteady harmonic part; outside of it the motion is still transient.",
            lambda ax: displacements(motion, ax, scale),
        ),
        _picture(
            "contact",
            "Contact forces over time",
            f"Time from 0 {ends}. {pressed}",
            "The force with which each mass presses on the beam. Below zero (shaded) a real wheel lifts off, and the "
            "model no longer holds.",
            lambda ax: contact_forces(motion, ax, scale),
        ),
    ]


def _picture(
    name: str,
    title: str,
    description: str,
    caption: str,
    draw: Callable[[Axes], Axes],
    size: tuple[float, float] = SIZE,
) -> Picture:
    return Picture(name, inline_svg(figure_of(draw, size), name, title, description), caption)


def _roots_said(motions: tuple[Vibration, ...], spectrum: SheetSpectrum) -> str:
    said = "; ".join(_root_said(motions))
    if said:
        return f"Roots: {said}."
    if not spectrum.proved:
        return "No root is certified."
    return "There is no root." if spectrum.region == "sheet" else "There is no root with Im q < 0."


def _root_said(motions: tuple[Vibration, ...]) -> Iterator[str]:
    for k, motion in enumerate(motions, 1):
        q = motion.root.q
        yield f"q{k}: Re q = {'±' if q.real else ''}{_few(abs(q.real))}, Im q = {_few(q.imag)}"


def _contour_said(spectrum: SheetSpectrum) -> str:
    """The contour of the count, as in figures_plane.whole_contour."""
    rho = radius_text(known(spectrum.radius, "the radius"))
    if spectrum.region == "sheet":
        return f"The whole contour to scale: both edges of the cuts, and the circle |q − iη_b| = {rho}"
    return f"The whole contour to scale: the real axis, and the circle |q − iη_b| = {rho} below it"


def _lines_said(lines: FrequencyLines) -> str:
    """Where each line begins and ends."""
    return " ".join(
        f"Line {k}: from α = {line.alpha[0].short()} with {_place(line.q[0])} "
        f"to α = {line.alpha[-1].short()} with {_place(line.q[-1])}."
        for k, line in enumerate(lines, 1)
    )


def _ends_said(lines: FrequencyLines) -> str:
    """What the rings mean, and that an end without one is open."""
    kinds = {end.kind for line in lines for end in line.ends}
    ring = "A ring: proved to begin or end at the cut within the step beyond it." if "cut" in kinds else ""
    bare = "How a line goes on that ends within the range without a ring is not proved." if "open" in kinds else ""
    return f"{ring} {bare}".strip()


def _place(q: Any) -> str:
    return f"Re q = {_few(q.real)}, Im q = {_few(q.imag)}"


def _cuts_said(spectrum: SheetSpectrum) -> str:
    start, height = gap_end(spectrum.case), spectrum.case.eta_b.short()
    if start is None:
        return "The cuts leave the line Im q = η_b and are not shown."
    if not start:
        return f"The cuts are joined to the whole line Im q = {height}."
    return f"Branch points at ±{start:.6g} + {height} i, with cuts outward from them."


def _plane_caption(spectrum: SheetSpectrum) -> str:
    start = gap_end(spectrum.case)
    contour = (
        ""
        if start is None
        else " Dashed: the contour of the count, which runs along both edges of each cut (drawn apart from it)."
    )
    looked = "" if spectrum.region == "sheet" else " Only those with Im q < 0 were looked for."
    return f"Induced frequencies q in the complex plane; the shaded half is unstable.{looked}{contour}"


def _few(ball: object) -> str:
    with ball_arithmetic(working_bits(6)):
        return proved_digits(ball, 6)
