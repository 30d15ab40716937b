"""Balls at an explicit precision: the one module of the package that sets FLINT's precision, one per process.

The standalone verifier, which imports nothing of the package, sets it too, under the same lock.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager

import flint
from flint import ctx

_LOCK: threading.RLock = vars(flint).setdefault("_precision_lock", threading.RLock())


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Work at `bits` bits; other threads wait, and the precision before is restored."""
    with _LOCK:
        before = ctx.prec
        ctx.prec = bits
        try:
            yield
        finally:
            ctx.prec = before
