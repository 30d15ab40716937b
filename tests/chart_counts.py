"""What floats count in the decided cells of a chart, independent of its proof."""

from __future__ import annotations

import numpy as np

from mpsolve import frequencies
from mpsolve.ranges.chart import Chart


def floats_agree(found: Chart, number: int = 80, least: float = 0.9) -> None:
    """In so many cells the number that floats count is that of the chart; they tell it in more than this share."""
    cells = np.random.default_rng(1).permutation(np.argwhere(found.detail >= 0))[:number]
    share = (cells + 0.37) / found.detail.shape
    x, y = (float(e[0]) + share[:, k] * float(e[-1] - e[0]) for k, e in enumerate((found.x, found.y)))
    seen = frequencies(found.problem, dict(zip(found.over, (x, y), strict=True)), roots=False)
    known = seen.status == "ok"
    assert known.mean() > least
    assert (seen.count == found.detail[tuple(cells.T)])[known].all()
