"""An order of entries in which neighbours are alike: along a Z-shaped curve through the ranks of their parameters."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np


def alike(over: Mapping[str, Any], size: int) -> Any:
    """The permutation that sorts the entries. Parameters with few values change least often."""
    ranks = []
    for column in over.values():
        values, rank = np.unique(column, return_inverse=True)
        if len(values) > 1:
            ranks.append(rank.reshape(-1) / (len(values) - 1))
    if not ranks:
        return np.arange(size)
    bits = max(1, min(31, 62 // len(ranks)))  # of each rank
    key = np.zeros(size, np.uint64)
    levels = [np.minimum((share * 2**bits).astype(np.uint64), np.uint64(2**bits - 1)) for share in ranks]
    for bit in range(bits - 1, -1, -1):
        for level in levels:
            key = (key << np.uint64(1)) | ((level >> np.uint64(bit)) & np.uint64(1))
    return np.argsort(key, kind="stable")
