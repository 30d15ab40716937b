"""The stability chart of one case: the number of unstable roots over velocity and mass, with the case marked."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.report.chart import legend_handles, paint
from mpsolve.report.figures import COLOUR, Look, scaling
from mpsolve.stability.chart import StabilityChart

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def stability_map(
    chart: StabilityChart, case: Case, ax: Axes, physical: PhysicalCase | None = None, look: Look = COLOUR
) -> Axes:
    """A `case_chart` of the case, with the case itself at factor 1; id case-mark; returns `ax`.

    physical: for a scale in km/h.
    """
    paint(chart, ax, look)
    for spine in ax.spines.values():
        spine.set_visible(True)
    if physical is not None:
        side: Any = ax.secondary_yaxis("right", functions=scaling(float(physical.v_cr) * 3.6))
        side.set_ylabel("velocity [km/h]")
    here = ax.plot(
        1.0, float(case.alpha), "*", markersize=15, color=look.ink, markeredgecolor="white", zorder=6, gid="case-mark"
    )
    here[0].set_label("this case")
    ax.figure.legend(handles=[*here, *legend_handles(chart, look)], loc="outside lower center", ncols=2, fontsize=9)
    return ax
