"""An order of cases in which neighbours are alike: along a Z-shaped curve through the ranks of their parameters."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import numpy as np

from mpsolve.fast.cases import Cases


def alike(cases: Cases) -> Any:
    """The permutation that sorts the cases. Parameters with few values change least often."""
    ranks = []
    for f in fields(cases):
        values, rank = np.unique(getattr(cases, f.name), return_inverse=True)
        if len(values) > 1:
            ranks.append((rank / (len(values) - 1), len(values)))
    if not ranks:
        return np.arange(len(cases))
    bits = min(31, 62 // len(ranks))  # of each rank
    key = np.zeros(len(cases), np.uint64)
    levels = [np.minimum((share * 2**bits).astype(np.uint64), np.uint64(2**bits - 1)) for share, _ in ranks]
    for bit in range(bits - 1, -1, -1):
        for level in levels:
            key = (key << np.uint64(1)) | ((level >> np.uint64(bit)) & np.uint64(1))
    return np.argsort(key, kind="stable")
