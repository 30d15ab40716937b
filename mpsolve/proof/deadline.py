"""A hard end: processor time after which whatever runs is left, wherever it is.

An `Effort` ends work at the next look at the clock, with what is known. A deadline is for steps that do not look.
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from mpsolve.numbers.balls import bits_now, precision, terms

_LEAST = 1e-3


class TimeUpError(BaseException):
    """The time of a deadline is up. It is no Exception, so that no step takes it for an answer of its own."""


@contextmanager
def deadline(seconds: float) -> Iterator[None]:
    """TimeUpError inside the block after so many seconds of processor time.

    Only in the main thread and where there is a timer for it (not on Windows); elsewhere the block runs to its end.
    What was set of flint before it is put back. Deadlines do not stand in each other.
    """
    if threading.current_thread() is not threading.main_thread() or not hasattr(signal, "setitimer"):
        yield
        return
    inside = True

    def end(_number: int, _frame: FrameType | None) -> None:
        if inside:
            raise TimeUpError

    with precision(bits_now()), terms(1):
        before = signal.signal(signal.SIGPROF, end)
        signal.setitimer(signal.ITIMER_PROF, max(seconds, _LEAST))
        try:
            yield
        finally:
            inside = False
            signal.setitimer(signal.ITIMER_PROF, 0)
            signal.signal(signal.SIGPROF, before)
