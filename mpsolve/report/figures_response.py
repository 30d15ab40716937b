"""The motion in time: displacement of the contact points with its envelope, and the contact forces.

Ids in the pictures: w-K, envelope-K (of the K-th contact point from 1), force-K, loss-K (of the K-th mass).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.report.figures import COLOUR, Look
from mpsolve.vibration.case_motion import Response
from mpsolve.vibration.scale import Scale

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def displacements(response: Response, ax: Axes, scale: Scale | None = None, look: Look = COLOUR) -> Axes:
    """w at each ξ over time, downward on the page too; dotted: the steady part ± the envelope; returns `ax`."""
    scale = scale or Scale()
    order = np.argsort(response.tau)
    t, bounds = response.tau[order] * scale.time, response.envelope
    for k in range(len(response.xi)):
        style = look.line(k)
        ax.plot(t, response.w[k, order] * scale.length, **style, label=f"contact point {k + 1}", gid=f"w-{k + 1}")
        for sign in (1, -1):
            edge = (response.steady[k] + sign * bounds[k])[order] * scale.length
            name: dict[str, Any] = {"gid": f"envelope-{k + 1}"} if sign > 0 else {}
            ax.plot(t, edge, color=style["color"], linestyle=":", linewidth=1, **name)
    ax.plot([], [], color=look.ink, linestyle=":", linewidth=1, label="steady part ± envelope")
    ax.axhline(0, color=look.faint, linewidth=0.6)
    ax.invert_yaxis()
    unit = f"[{scale.length_name}]" if scale.physical else "w in units of $w_{st}$"
    return _over_time(ax, t, scale, f"displacement, downward\n{unit}")


def contact_forces(response: Response, ax: Axes, scale: Scale | None = None, look: Look = COLOUR) -> Axes:
    """The force of each mass on the beam over time; a cross where it first falls to zero; returns `ax`."""
    scale = scale or Scale()
    order = np.argsort(response.tau)
    t = response.tau[order] * scale.time
    for k, force in enumerate(response.contact_forces):
        ax.plot(t, force[order] * scale.force, **look.line(k), label=f"mass {k + 1}", gid=f"force-{k + 1}")
        loss = response.contact_loss[k]
        if loss is not None:
            mark: dict[str, Any] = {"color": look.ink, "markersize": 9, "markeredgewidth": 2, "zorder": 5}
            ax.plot(loss * scale.time, 0, "x", **mark, gid=f"loss-{k + 1}", label=f"mass {k + 1} would lift off")
    low, high = ax.get_ylim()
    if low < 0:
        ax.axhspan(low, 0, color=look.shade, linewidth=0, zorder=0)
        ax.set_ylim(low, high)
    ax.axhline(0, color=look.ink, linewidth=0.8)
    unit = f"[{scale.force_name}]" if scale.physical else "in unit forces"
    return _over_time(ax, t, scale, f"contact force, pressing\n{unit}")


def _over_time(ax: Axes, t: Any, scale: Scale, label: str) -> Axes:
    time = "time t [s]" if scale.physical else "time τ"
    ax.set(xlabel=time, ylabel=label)
    if len(t) and t[0] < t[-1]:
        ax.set_xlim(float(t[0]), float(t[-1]))
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, columnspacing=1.2, handlelength=1.8)
    return ax
