"""Cubics between nodes with values and slopes."""

from __future__ import annotations

from typing import Any

import numpy as np


def hermite(nodes: Any, values: Any, slopes: Any, times: Any) -> Any:
    """The piecewise cubic with these values and slopes (rows, nodes) at the nodes; (rows, times)."""
    i = np.clip(np.searchsorted(nodes, times, side="right") - 1, 0, len(nodes) - 2)
    h = nodes[i + 1] - nodes[i]
    s = (times - nodes[i]) / h
    left, right = values[:, i], values[:, i + 1]
    rise, start, end = right - left, h * slopes[:, i], h * slopes[:, i + 1]
    return left + s * (start + s * (3 * rise - 2 * start - end + s * (start + end - 2 * rise)))
