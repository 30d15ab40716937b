"""The whole deflection of the rear contact point against what could stand for it, as in Figures A.1 to A.5."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from style import SINGLE, agree, page
from vibration import DIGITS, W_ST, vibration

from mpsolve import Case, Load, certify, envelope, finite_beam, merged, response, superposition, transient_importance
from mpsolve.problem.cases import as_problem

TAU: Any = np.linspace(0.0, 200.0, 801)
LAST_DOUBLED = 1.0  # the largest distance at which one doubled mass is shown
BEAM_TIMES = 41
BEAM_TOLERANCE = 1e-2  # in w_st, below what can be seen
START: Any = np.linspace(0.0, 60.0, 3 * BEAM_TIMES - 2)  # times for a check


@dataclass(frozen=True)
class Comparison:
    """Deflections at ξ = 0 in w_st for one unit constant force on each mass, shape (len(tau),).

    full: on the infinite beam, all three parts; harmonic: without the truly transient one; added: the superposition
    of each mass alone; doubled: one mass with both masses and loads, None beyond d = 1. beam: on the finite beam at
    beam_tau, a second way to `full`, with the error beam_error that it measures.
    """

    case: Case
    tau: Any
    full: Any
    harmonic: Any
    added: Any
    doubled: Any | None
    beam_tau: Any
    beam: Any
    beam_error: float


def comparison(case: Case, tau: Any = TAU, tolerance: float = BEAM_TOLERANCE) -> Comparison:
    """Five ways to one deflection; `tolerance` is that of the finite beam. Errors as for `response`."""
    problem, loads = as_problem(case), [Load(1 / W_ST)] * case.count
    asked: dict[str, Any] = {"times": tau, "places": [0]}
    found = response(problem, loads, spectrum=certify(case, digits=DIGITS), **asked)
    near = float(case.positions[-1]) <= LAST_DOUBLED
    beam_tau = np.linspace(0.0, float(tau[-1]), BEAM_TIMES)
    beam = finite_beam(case, None, beam_tau, tolerance=tolerance)
    return Comparison(
        case,
        tau,
        found.rail[0],
        (found.steady + found.harmonic)[0],
        sum(part.rail[0] for part in superposition(problem, loads, **asked)),
        merged(problem, loads, **asked).rail[0] if near else None,
        beam_tau,
        beam.displacement[0],
        beam.error.total,
    )


def checked_comparison(case: Case, tau: Any = START, tolerance: float = 1e-3) -> Comparison:
    """The curves of one panel after asserting what holds in each; `tau`: every few of them are those of the beam.

    All that is complete starts from rest, and the finite beam agrees with the infinite one within its own error.
    """
    found = comparison(case, tau, tolerance)
    complete = [found.full, found.added] if found.doubled is None else [found.full, found.added, found.doubled]
    agree([w[0] for w in complete], 0, 1e-8)
    agree(_at_beam_times(found.full), found.beam, found.beam_error)
    assert found.beam_error < BEAM_TOLERANCE
    return found


def check_late_beam(found: Comparison) -> None:
    """AssertionError unless the damped finite beam ends in the harmonic solution, and vibrates as certified."""
    late = slice(BEAM_TIMES // 2, None)  # the truly transient part has died out
    agree(_at_beam_times(found.harmonic)[late], found.beam[late], found.beam_error)
    q = vibration(found.case, [0]).q
    agree(read(found.beam_tau[4:], found.beam[4:], len(q)), q, 5e-5)


def _at_beam_times(w: Any) -> Any:
    return w[:: (len(w) - 1) // (BEAM_TIMES - 1)]


def read(tau: Any, w: Any, pairs: int) -> Any:
    """The q of so many waves Re(A e^{iqτ}), Re q > 0, of which a curve consists, from its samples alone (Prony).

    tau: evenly spaced; Re q below π over a step of 5, or of tau if that is longer. A constant part does not matter.
    """
    stride = max(1, round(5 / (tau[1] - tau[0])))
    change, order = np.diff(w), 2 * pairs
    rows = np.stack([change[k * stride : len(change) - (order - k) * stride] for k in range(order + 1)], axis=1)
    rule = np.linalg.lstsq(rows[:, :-1], -rows[:, -1], rcond=None)[0]
    q = np.log(np.roots([1, *rule[::-1]]).astype(complex)) / (1j * stride * (tau[1] - tau[0]))
    return np.array(sorted(q[q.real > 0], key=lambda z: z.real))


def missed(case: Case) -> float:
    """How far from rest the harmonic solution starts at the rear mass, over the sum of its amplitudes.

    The paper's measure (Section 4.1) of the truly transient part, which makes up for it.
    """
    spectrum = certify(case, digits=DIGITS)
    found = response(as_problem(case), [Load(1)] * case.count, times=[0], places=[0], spectrum=spectrum)
    return float(abs(transient_importance(found).displacement[0]) / sum(envelope(found).amplitudes))


def moving_forces(case: Case) -> float:
    """The steady deflection in w_st below the rear one of two unit forces, α < 1, η_N = η_S and no damping.

    The classic one of a moving force without inertia, e^{−aξ} (cos(bξ)/a + sin(bξ)/b), a² = 1 − α², b² = 1 + α².
    """
    alpha, d = float(case.alpha), float(case.positions[-1])
    a, b = np.sqrt(1 - alpha**2), np.sqrt(1 + alpha**2)
    return 1 / a + np.exp(-a * d) * (np.cos(b * d) / a + np.sin(b * d) / b)


def comparison_figure(path: Path | str, cases: Sequence[Case], tau: Any = TAU) -> Path:
    """One panel a case, three in a row; returns the path."""
    with page(path, -(-len(cases) // 3), 3, (2.6, 2.0), sharex=True) as axes:
        for case, ax in zip(cases, axes.flat, strict=False):
            draw_comparison(comparison(case, tau), ax)
        for ax in axes[-1]:
            ax.set_xlabel("$τ$")
        for ax in axes[:, 0]:
            ax.set_ylabel("$\\hat w$ at the rear mass")
        names = axes[0, 0].get_legend_handles_labels()
        axes[0, 0].figure.legend(*names, loc="outside upper center", ncols=len(names[0]))
    return Path(path)


def draw_comparison(found: Comparison, ax: Any) -> Any:
    """Grey: full; circles: finite beam; dotted: harmonic; thin black: superposition; dashed: doubled mass."""
    ax.plot(found.tau, found.full, color="0.7", linewidth=2.6, label="full solution")
    ax.plot(found.tau, found.harmonic, color="black", linestyle=":", linewidth=1.2, label="steady and harmonic")
    ax.plot(found.tau, found.added, color="black", linewidth=0.6, label="superposition")
    if found.doubled is not None:
        ax.plot(found.tau, found.doubled, **SINGLE, label="doubled mass")
    circles: dict[str, Any] = {"marker": "o", "markersize": 2.6, "markerfacecolor": "white", "markeredgewidth": 0.6}
    ax.plot(found.beam_tau, found.beam, color="0.35", linestyle="", label="finite beam", **circles)
    ax.set_title(f"$\\hat d = {float(found.case.positions[-1]):g}$")
    ax.set_xlim(found.tau[0], found.tau[-1])
    ax.invert_yaxis()  # displacements are positive downward
    return ax
