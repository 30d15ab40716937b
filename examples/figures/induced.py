"""Induced frequencies over the velocity ratio, as lines: Figures 2 and 9.

The roots are those of the fast path, in float64; roots of neighbouring velocities are joined by extrapolation, which
is a way of drawing and no proof (`mpsolve.frequency_lines` proves). Without damping the velocities at which a line of
two masses meets q_lm are proved, by `cut_points`, and the line is drawn up to there; with damping it ends at the last
velocity of the grid.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from style import DOUBLED, LIMIT, SINGLE, agree, greys

from mpsolve import Case, CutPoint, Frequencies, Problem, certify, cut_points, frequencies, tracks, vehicles

ALPHA: Any = np.arange(1, 141) / 100
# Section 4.2, η_M and d: the last velocity ratio of the grid 0.01 with both pairs, all confirmed
LAST = {
    40: {"0.5": 0.74, "1": 0.86, "1.5": 0.87, "2": 0.87, "2.5": 0.88, "3": 0.89, "3.5": 0.9, "4": 0.9, "4.5": 0.9},
    10: {"0.5": 0.37, "1": 0.66, "1.5": 0.72},
}
_LEAP = 0.02  # a root farther from where its line points to belongs to another line


@dataclass(frozen=True)
class Line:
    """q[k] at alpha[k], Re q ≥ 0 (undamped also Im q ≥ 0: −q̄, and then q̄, −q, are induced frequencies too)."""

    alpha: tuple[float, ...]
    q: tuple[complex, ...]


@dataclass(frozen=True)
class Group:
    """The lines of one system, and how they are drawn."""

    name: str
    lines: tuple[Line, ...]
    look: dict[str, Any]


def groups(eta_m: int, distances: Sequence[str], eta_b: str = "0", alpha: Any = ALPHA) -> list[Group]:
    """One mass, one doubled mass, and two equal masses at each distance."""
    single = Group("single mass", tuple(lines(eta_m, None, eta_b, alpha)), SINGLE)
    doubled = Group("doubled mass", tuple(lines(2 * eta_m, None, eta_b, alpha)), DOUBLED)
    shades = zip(distances, greys(len(distances)), strict=True)
    pairs = [Group(f"$\\hat d = {d}$", tuple(lines(eta_m, d, eta_b, alpha)), {"color": grey}) for d, grey in shades]
    return [*pairs, single, doubled]


def lines(eta_m: int, d: str | None, eta_b: str = "0", alpha: Any = ALPHA) -> list[Line]:
    """The frequency lines of two equal masses at the distance d, or of one mass (d None)."""
    roots = on_sheet(alpha, float(eta_b), eta_m, None if d is None else float(d)).roots
    with np.errstate(invalid="ignore"):
        kept = (roots.real >= 0) & ((roots.imag >= 0) | (float(eta_b) > 0))
    joined = join(alpha, [row[keep] for row, keep in zip(roots, kept, strict=True)])
    return joined if d is None or float(eta_b) else _to_the_cut(joined, eta_m, d, alpha)


def on_sheet(alpha: Any, eta_b: Any, eta_m: Any, d: Any) -> Frequencies:
    """Every frequency of two equal masses, or of one (d None), in the paper's ratios; the arrays broadcast."""
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1)
    masses = vehicles.train(vehicles.Mass(1), 1 if d is None else 2, 1)
    over = {"v": alpha, "track.c": 2 * np.asarray(eta_b), "vehicles[0].M": eta_m}
    if d is not None:
        over |= {"vehicles[1].M": eta_m, "gap[0]": d}
    return frequencies(Problem(beam, masses, v=0), over, region="sheet")


def end_of_line(eta_m: int, d: str) -> float:
    """The proved velocity ratio at which the line of the higher pair meets q_lm, without damping."""
    (end,) = _ends(eta_m, d, 0.01, 0.99)
    return float(end.value.mid())


def _ends(eta_m: int, d: str, low: float, high: float) -> Sequence[CutPoint]:
    """All points at which a line meets q_lm, without damping."""
    case = Case(alpha="0.5", eta_b=0, eta_m=(eta_m, eta_m), positions=(0, d))
    found = cut_points(case, over={"v": (str(low), str(high))})
    if not found.proved:
        raise SystemExit(str(found.reason))
    return found.points


def drawn(found: Sequence[Line], alpha: float) -> Any:
    """q of each line at one velocity of the grid, by ascending Re q."""
    return np.sort([line.q[line.alpha.index(alpha)] for line in found if alpha in line.alpha])


def check_lines(found: Sequence[Line], case: Case) -> None:
    """AssertionError unless the lines at the velocity of the case are all its certified frequencies."""
    roots = [
        root.q for root in certify(case, digits=15).roots if root.q.real > 0 and (case.eta_b or root.q.imag >= 0)
    ]
    agree(drawn(found, float(case.alpha)), np.sort([complex(q) for q in roots]), 1e-12)


def join(alpha: Any, roots: Sequence[Any]) -> list[Line]:
    """Lines through the roots of each velocity: each line goes on at the nearest root to its extrapolation."""
    done: list[Line] = []
    alive: list[tuple[list[float], list[complex]]] = []
    for a, here in zip(alpha.tolist(), roots, strict=True):
        near = [
            (abs(_ahead(places, q, a) - z), k, m) for k, (places, q) in enumerate(alive) for m, z in enumerate(here)
        ]
        pairs: dict[int, int] = {}
        for gap, k, m in sorted(near):
            if gap < _LEAP and k not in pairs and m not in pairs.values():
                pairs[k] = m
        done += [Line(tuple(line[0]), tuple(line[1])) for k, line in enumerate(alive) if k not in pairs]
        fresh = [([a], [complex(z)]) for m, z in enumerate(here) if m not in pairs.values()]
        for k, m in pairs.items():
            alive[k][0].append(a)
            alive[k][1].append(complex(here[m]))
        alive = [line for k, line in enumerate(alive) if k in pairs] + fresh
    return done + [Line(tuple(line[0]), tuple(line[1])) for line in alive]


def _ahead(alpha: list[float], q: list[complex], a: float) -> complex:
    if len(q) < 2:
        return q[-1]
    return q[-1] + (q[-1] - q[-2]) * (a - alpha[-1]) / (alpha[-1] - alpha[-2])


def _to_the_cut(joined: list[Line], eta_m: int, d: str, alpha: Any) -> list[Line]:
    """The same lines, without damping, each with the proved point at which it ends or begins at q_lm."""
    last = min(float(alpha[-1]), 0.99)  # below α_C = 1, where q_lm = 0
    for point in _ends(eta_m, d, float(alpha[0]), last):
        a, q = float(point.value.mid()), complex(point.q)
        end = 0 if point.appears else -1
        k = int(np.argmin([abs(line.q[end] - q) + abs(line.alpha[end] - a) for line in joined]))
        line = joined[k]
        before, after = (((a,), (q,)), ((), ())) if point.appears else (((), ()), ((a,), (q,)))
        joined[k] = Line((*before[0], *line.alpha, *after[0]), (*before[1], *line.q, *after[1]))
    return joined


def limiting(eta_b: str, alpha: Any = ALPHA) -> Any:
    """q_lm over α, nan from α_C on."""
    velocity, beta = np.asarray(alpha, float), np.sqrt(1 - float(eta_b) ** 2)
    # stationary where z³ − α² z² = 4α²β², z = p²: one z > 0
    z = np.array([np.roots([1, -a * a, 0, -4 * (a * beta) ** 2]).real.max() for a in velocity.tolist()])
    return np.where(velocity < np.sqrt(beta), np.sqrt(z * z + 4 * beta**2) / 2 - velocity * np.sqrt(z), np.nan)


def draw_lines(ax: Any, part: str, drawn: Sequence[Group], eta_b: str = "0", alpha: Any = ALPHA) -> Any:
    """`part` ("real" or "imag") of all lines over α, with q_lm or the level of the cut, dotted; returns `ax`."""
    height = float(eta_b)
    for group in drawn:
        for k, line in enumerate(group.lines):
            # above the cut the physical sheet has roots too: thinner
            thin = {"linewidth": 0.4} if height and line.q[-1].imag > height else {}
            name = None if k else group.name
            ax.plot(line.alpha, [getattr(q, part) for q in line.q], label=name, **(group.look | thin))
    if part == "real":
        ax.plot(alpha, limiting(eta_b, alpha), label="$q_{lm}$", **LIMIT)
    elif height:
        ax.axhline(height, **LIMIT)
    ax.set(xlabel="$α$", ylabel=f"{'Re' if part == 'real' else 'Im'} $q$", xlim=(0, float(alpha[-1])))
    return ax
