"""The deformed contour of (32) in Re q ≥ 0: how high each of its paths runs, and the nodes on it, in float64.

Everything below the cut line Im q = η_b is left by residues, until the contour runs along the line from below. From
there each section of the line (sheets.py) is lifted on its own sheet: a finite one to (half) an ellipse between its
branch points, the last one to a parabola. On the sheet that continues the last section, Δ has an infinite chain of
zeros near Im p = ln 2/(2 × length), below which the parabola has to stay. What a mass does as if it were alone has
no such chain and is integrated along a steeper path, where it decays quickly; only what the masses do to each other
remains on the parabola. The half plane Re q < 0 gives the complex conjugate.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.model.branch import Track
from mpsolve.model.kernel import kernel_at_contact
from mpsolve.motion.field import images_at
from mpsolve.motion.forcing import Tone, image
from mpsolve.motion.paths import Lift, Place, Rise, ellipse, graded, lift
from mpsolve.motion.quadrature import adaptive_panels
from mpsolve.motion.sheets import Section, nearest, pairing_of, ranked
from mpsolve.motion.transform import contact_image, lone_image

ALL, MUTUAL, LONE = "all", "mutual", "lone"

MOST_PANELS = 60_000
_TOLERANCE = 1e-14  # of a panel, relative to the displacement of a unit force
_VELOCITY, _FORCE = 1e-3, 1e-6  # what velocity and force count beside the displacement
_REACH, _FAR = 250.0, 3e7  # where u ends on the parabola, and on the steep path
_GROWTH = 6.0  # of waves over all positions, as a power of e, where Im p is of the height of the path
_STEEP = (0.5, 0.25, 0.1)  # of the path of each mass alone
_FACTORS = (1.0, 0.5, 0.25, 0.12, 0.06, 0.03, 0.015, 0.007, 0.003)  # by which a path is lowered, in turn
_HEIGHTS = (1.5, 1.2, 1.0, 0.8, 0.6, 0.45, 0.3, 0.2)  # of the ellipse in the gap
_CIRCLE = 24  # points on the circle around a zero


@dataclass(frozen=True)
class Nodes:
    """Points q with s and the weights with which W̃ e^{iqτ} is summed there: all of W̃, or a part of it."""

    q: Any
    s: Any
    weights: Any
    part: str

    def __getitem__(self, key: slice) -> Nodes:
        return Nodes(self.q[key], self.s[key], self.weights[key], self.part)


@dataclass(frozen=True)
class Contour:
    """The nodes in Re q ≥ 0; the induced frequencies above the line that the contour passes below; the zeros of Δ on
    the continued sheets that it passes above, as nodes on a circle around each of them."""

    nodes: tuple[Nodes, ...]
    left_out: tuple[complex, ...]


def deformed_contour(
    track: Track, tones: Sequence[Tone], line: Sequence[Section], above: Sequence[complex], reach: tuple[float, float]
) -> Contour:
    """The contour for ξ within `reach`; above: the induced frequencies with Re q ≥ 0 above the line.

    Raises PrecisionError where no path close above the line can be taken, or where it takes too many nodes.
    """
    places = np.array(track.positions)
    probe = np.unique(np.concatenate([places, [x for x in reach if not places[0] <= x <= places[-1]]]))
    gap = line[0].gap
    height = _gap_height(track, line[0], above) if gap else 0.0
    nodes: list[Nodes] = []
    for section in line[:-1]:
        nodes += _finite(track, tones, section, height, probe)
    nodes += _infinite(track, tones, line[-1], probe)
    left_out = (q for q in above if not (gap and _radius(track, line[0], q, height) < 1))
    return Contour(tuple(nodes), tuple(left_out))


def images(track: Track, tones: Sequence[Tone], nodes: Nodes, xi: Any) -> tuple[Any, Any]:
    """W̃ at ξ, shape (len(xi), nodes), and S of the masses, shape (masses, nodes), for the part asked for."""
    pair, F = pairing_of(track, nodes.q, nodes.s), image(tones, track.field, nodes.q)
    if nodes.part == ALL:
        S = np.array(contact_image(track, pair, nodes.q, F))
        return images_at(track, pair, S, xi), S
    lone, contact = np.array(lone_image(track, pair, nodes.q, F)), kernel_at_contact(track, pair) / np.pi
    mutual = nodes.part == MUTUAL
    S = np.array(contact_image(track, pair, nodes.q, F)) if mutual else lone
    w = images_at(track, pair, S, xi) if mutual else np.zeros((len(xi), len(nodes.q)), complex)
    for own, place in zip(lone, track.positions, strict=True):
        w[xi == place] += -own * contact if mutual else own * contact
    return w, (S - lone if mutual else lone)


def _finite(track: Track, tones: Sequence[Tone], section: Section, height: float, probe: Any) -> Iterator[Nodes]:
    """A section between two branch points; of the first one its half with Re q ≥ 0, run from the top downward."""
    centre, radius = complex((section.start + section.end) / 2, track.eta_b), (section.end - section.start) / 2
    first = section.start <= 0
    half = graded(np.pi / 2)
    breaks = half if first else np.concatenate([half, np.pi - half[-2::-1]])
    if section.gap:
        place = ellipse(centre, radius, height)
        yield _nodes(track, tones, place, lambda _, q: ranked(track, q, section.sheet), breaks, ALL, probe, -1)
        return
    samples = np.linspace(1e-3, np.pi - 1e-3, 4000)
    extent = probe[-1] - probe[0]
    most = min(0.5 + radius, _GROWTH / extent) if extent else 0.5 + radius
    path = _lowered(track, section, lambda h: ellipse(centre, radius, h), most, samples)
    yield _nodes(track, tones, path.place, lambda u, q: path.sums_at(track, u, q), breaks, ALL, probe, -1)
    yield from _residues(track, path, ALL, _half if first else _whole)


def _infinite(track: Track, tones: Sequence[Tone], section: Section, probe: Any) -> Iterator[Nodes]:
    """The last section: each mass alone along a steep path, the rest along a parabola; all along it if need be."""
    start = complex(section.start, track.eta_b)
    span, extent = track.positions[-1] - track.positions[0], probe[-1] - probe[0]
    most = min(0.5, np.log(2) / (4 * span) if span else 0.5, _GROWTH / extent if extent else 0.5)
    rise = _rise(section, most)
    near, far = np.geomspace(1e-4, rise.bend + 1, 1500), rise.bend + 60
    samples = np.concatenate([near, np.arange(near[-1] + 0.02, far, 0.05 / (1 + span))])
    if 0 < span < 1:  # the masses act on each other through waves of length 1/span
        samples = np.concatenate([samples, np.geomspace(far, far + 20 / span, 2000)])
    path = _lowered(track, section, lambda scale: rise.place(start, scale), 1.0, samples)
    steep = _steep(track, section, start, rise)
    if steep is not None:
        breaks = np.union1d(graded(1.0, _FAR), rise.breaks)
        first = steep[0]
        yield _nodes(track, tones, first.place, lambda u, q: first.sums_at(track, u, q), breaks, LONE, probe, 1)
        alone = len(track.positions) == len(probe) == 1
        for own in steep:  # below the parabola the residues of LONE and MUTUAL cancel
            yield from _residues(track, own, LONE, lambda z: float(alone or not path.covers(z)))
        if alone:
            return
    part = ALL if steep is None else MUTUAL
    breaks = np.union1d(graded(1.0, _reach(track), 1.2), rise.breaks)
    yield _nodes(track, tones, path.place, lambda u, q: path.sums_at(track, u, q), breaks, part, probe, 1)
    yield from _residues(track, path, ALL, _whole)


def _reach(track: Track) -> float:
    """Where u ends on the parabola: a light mass governs the motion only at high frequencies, u > 1/η_M."""
    return _REACH * float(np.clip(4 / min(track.eta_m), 1, 40))


def _rise(section: Section, most: float) -> Rise:
    """Below every complex branch point of the continued sheet, and steeper beyond them."""
    first, bend, turn = most, 0.0, 0.0
    for r in section.obstacles:
        beyond = np.sqrt(2 * (r.real - section.start))
        turn = max(turn, 1.3 * beyond)
        if 0.5 * r.imag < first * beyond:
            first, bend = 0.5 * r.imag / beyond, max(bend, 1.3 * beyond)
    return Rise(first, bend, most, turn)


def _nodes(
    track: Track,
    tones: Sequence[Tone],
    place: Place,
    sums: Callable[[Any, Any], Any],
    breaks: Any,
    part: str,
    probe: Any,
    sign: int,
) -> Nodes:
    contacts = np.isin(probe, track.positions)

    def integrand(u: Any, q: Any, rate: Any) -> tuple[Any, Any]:
        s = sums(u, q)
        w, S = images(track, tones, Nodes(q, s, None, part), probe)
        return np.concatenate([w, _VELOCITY * q * w[contacts], _FORCE * S]) * rate, s

    panels = adaptive_panels(place, integrand, breaks, track.eta_b, _TOLERANCE, MOST_PANELS)
    q, rate = place(panels.nodes)
    return Nodes(q, panels.left, sign * panels.weights * rate, part)


def _residues(track: Track, path: Lift, part: str, share: Callable[[complex], float]) -> Iterator[Nodes]:
    """2πi times the residues at zeros that the path passes above, by the trapezoidal rule on small circles."""
    for z, s in path.zeros:
        if share(z):
            radius = 0.2 * path.clearance(z)
            turn = np.exp(2j * np.pi * np.arange(_CIRCLE) / _CIRCLE)
            q = z + radius * turn
            yield Nodes(q, nearest(track, q, s), share(z) * 2j * np.pi * radius * turn / _CIRCLE, part)


def _whole(_: complex) -> float:
    return 1.0


def _half(z: complex) -> float:
    """Of zeros that are symmetric about Re q = 0 those with Re q > 0 count, and half of one with Re q = 0."""
    return 0.5 if abs(z.real) < 1e-9 else float(z.real > 0)


def _lowered(track: Track, section: Section, family: Callable[[float], Place], most: float, samples: Any) -> Lift:
    """The highest path that can be followed."""
    for factor in _FACTORS:
        path = lift(track, family, factor * most, samples, section.sheet, closed=bool(np.isfinite(section.end)))
        if path is not None:
            return path
    raise PrecisionError(
        f"the truly transient part cannot be integrated: zeros or branch points on the continued sheet lie too close "
        f"above the cut, Re q > {max(section.start, 0):.6g}; change a parameter slightly, or ask for the harmonic "
        "solution only"
    )


def _steep(track: Track, section: Section, start: complex, rise: Rise) -> list[Lift] | None:
    """A steep path, followed for each mass alone; one without zeros of a single mass below it is preferred."""
    samples = np.concatenate([np.geomspace(1e-4, rise.turn + 1, 1500), np.geomspace(rise.turn + 1, 1e5, 1500)[1:]])
    fallback = None
    for steep in _STEEP:
        paths = _each(track, start, replace(rise, steep=steep), samples, section)
        if paths is not None and not any(path.zeros for path in paths):
            return paths
        fallback = fallback or paths
    return fallback


def _each(track: Track, start: complex, rise: Rise, samples: Any, section: Section) -> list[Lift] | None:
    paths = []
    for mass in range(len(track.positions)):
        path = lift(track, lambda scale: rise.place(start, scale), 1.0, samples, section.sheet, mass)
        if path is None:
            return None
        paths.append(path)
    return paths


def _gap_height(track: Track, first: Section, above: Sequence[complex]) -> float:
    """The height of the ellipse in the gap that keeps the largest distance from the induced frequencies."""

    def clearance(height: float) -> float:
        return min((abs(_radius(track, first, q, height) - 1) for q in above), default=1.0)

    return max(_HEIGHTS, key=lambda height: min(clearance(height), 0.1))


def _radius(track: Track, gap: Section, q: complex, height: float) -> float:
    """Below 1 inside the ellipse, above 1 outside."""
    return float(np.hypot(q.real / gap.end, (q.imag - track.eta_b) / height))
