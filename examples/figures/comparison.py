"""The whole deflection of the rear contact point against what could stand for it, as in Figures A.1 to A.5."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from style import SINGLE, page

from mpsolve import Case
from mpsolve.motion import merged, response, superposition
from mpsolve.motion.beam import finite_beam

TAU: Any = np.linspace(0.0, 200.0, 801)
LAST_DOUBLED = 1.0  # the largest distance at which one doubled mass is shown
BEAM_TIMES = 41
BEAM_TOLERANCE = 1e-2  # in w_st, below what can be seen


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
    rear = [0]
    found = response(case, None, rear, tau)
    near = float(case.positions[-1]) <= LAST_DOUBLED
    beam_tau = np.linspace(0.0, float(tau[-1]), BEAM_TIMES)
    beam = finite_beam(case, None, beam_tau, tolerance=tolerance)
    return Comparison(
        case,
        tau,
        found.w[0],
        (found.steady + found.harmonic)[0],
        sum(part.w[0] for part in superposition(case, None, rear, tau)),
        merged(case, None, rear, tau).w[0] if near else None,
        beam_tau,
        beam.displacement[0],
        beam.error.total,
    )


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
