"""A hard end: processor time after which whatever runs is left, wherever it is.

An `Effort` ends work at the next look at the clock, with what is known. A deadline is for steps that do not look.
"""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from time import process_time
from types import FrameType

from mpsolve.numbers.balls import bits_now, precision, terms

_LEAST = 1e-3


class TimeUpError(BaseException):
    """The time of a deadline is up. It is no Exception, so that no step takes it for an answer of its own."""


@contextmanager
def deadline(seconds: float | None) -> Iterator[None]:
    """TimeUpError inside the block after so many seconds of processor time; None: no limit.

    Only in the main thread and where there is a timer for it (not on Windows); elsewhere the block runs to its end.
    What was set of flint before it is put back. Of deadlines in each other the first one ends the block. Where Python
    itself drops an exception (in a finalizer, or a callback of the garbage collector) it comes once more after it.
    """
    here = threading.current_thread() is threading.main_thread() and hasattr(signal, "setitimer")
    around = signal.getitimer(signal.ITIMER_PROF)[0] if here else 0.0
    if not here or seconds is None or 0 < around <= seconds:
        yield
        return
    inside, started = True, process_time()

    def end(_number: int, _frame: FrameType | None) -> None:
        if inside:
            raise TimeUpError

    def dropped(what: sys.UnraisableHookArgs) -> None:
        if inside and issubclass(what.exc_type, TimeUpError):
            signal.setitimer(signal.ITIMER_PROF, _LEAST)
        else:
            hook(what)

    with precision(bits_now()), terms(1):
        before, hook = signal.signal(signal.SIGPROF, end), sys.unraisablehook
        sys.unraisablehook = dropped
        signal.setitimer(signal.ITIMER_PROF, max(seconds, _LEAST))
        try:
            yield
        finally:
            inside = False
            signal.setitimer(signal.ITIMER_PROF, 0)
            signal.signal(signal.SIGPROF, before)
            sys.unraisablehook = hook
            if around:
                signal.setitimer(signal.ITIMER_PROF, max(around - (process_time() - started), _LEAST))
