"""The whole sheet of an Euler–Bernoulli beam with one or two masses, above and below its cuts: by its own kernel.

The ratios that the kernel takes are those of the track's parameters, of length (4EI/k)^¼ and time (m/k)^½.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.batch.entries import Entries
from mpsolve.errors import InputError
from mpsolve.fast.frequencies import frequencies
from mpsolve.progress import Progress
from mpsolve.tracks.euler_bernoulli import EulerBernoulli
from mpsolve.vehicles.mass import Mass

UNKNOWN = "float64 does not tell the roots of this case"
OFF_LINE = (
    "the cuts leave their line, or the beam buckles: damping from critical on, too much compression, or eta > 0"
)
_NAMES = ("EI", "m", "k", "c", "kp", "N", "eta")


def on_sheet(entries: Entries, workers: int, progress: Progress | None) -> tuple[Any, Any, Any]:
    """(q, count, inside): every root in the problem's units, sorted, nan-padded; −1 where open; inside: in bounds."""
    problem = entries.problem
    masses = [placed.vehicle for placed in problem.vehicles if isinstance(placed.vehicle, Mass)]
    if not isinstance(problem.track, EulerBernoulli) or len(masses) != len(problem.vehicles) or len(masses) > 2:
        stated = 'is "sheet", which is known for an Euler–Bernoulli beam with one or two masses'
        raise InputError("region", f'{stated}: give "unstable" or ("below", h)')
    ratios, time, inside = _ratios(entries)
    found = frequencies(*(ratio[inside] for ratio in ratios), workers=workers, tell=progress)
    q = np.full((len(entries), found.q.shape[-1]), np.nan, complex)
    count = np.full(len(entries), -1)
    q[inside], count[inside] = found.q, found.count
    return q / time[:, None], count, inside


def _ratios(entries: Entries) -> tuple[list[Any], Any, Any]:
    """The arguments of the kernel for all entries, the unit of time, and which of them are within its bounds."""
    EI, m, k, c, kp, N, eta = (np.broadcast_to(entries.track[name], len(entries)) for name in _NAMES)
    with np.errstate(all="ignore"):
        length, time = (4 * EI / k) ** 0.25, np.sqrt(m / k)
        weights = [np.einsum("ic,ij,jc->c", one.B, one.M, one.B) for one in entries.formations]
        first, others = (np.array([w[part].sum() for w in weights])[entries.which] for part in (_ONE, _REST))
        d = np.array([one.places[-1] for one in entries.formations])[entries.which]
        ratios = [
            entries.v * time / length,
            c / (2 * np.sqrt(m * k)),
            first / (m * length),
            d / length,
            (N - kp) / (2 * np.sqrt(EI * k)),
            np.zeros(len(entries)),
            others / first,
        ]
        inside = (eta == 0) & (k > 0) & (ratios[1] < 1) & (ratios[4] < np.sqrt(1 - ratios[1] ** 2))
    return ratios, time, inside & np.isfinite(ratios).all(0)


_ONE, _REST = slice(0, 1), slice(1, None)
