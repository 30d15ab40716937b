"""A hard end: processor time after which whatever runs is left, wherever it is.

An `Effort` ends work at the next look at the clock, with what is known. A deadline is for steps that do not look.

`in_time` has such steps, a verifier for one, within an effort.
"""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import process_time
from types import FrameType
from typing import TypeVar

from mpsolve.numbers.balls import bits_now, precision, terms
from mpsolve.proof.effort import MORE_EFFORT, Effort
from mpsolve.proof.stopping import asked_to_end, ended_at_once

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


T = TypeVar("T")


def in_time(
    step: Callable[[], T], budget: Effort, done: str = "the verifier was through"
) -> tuple[T | None, str, float]:
    """(what the step gives, or why it gives nothing, processor seconds).

    It has what is left of the effort, and the first Ctrl-C ends it too. done: what did not come about, in words.
    """
    started, left = process_time(), budget.rest()
    found, why = None, ""
    try:
        with ended_at_once(), deadline(None if left is None else left.seconds):
            found = step()
    except TimeUpError:
        asked = (budget.whole or budget).seconds
        limit = "all the time" if asked is None else f"the effort of {asked:g} s of processor time"
        why = f"{limit} was spent before {done}: {MORE_EFFORT}"
    except KeyboardInterrupt:
        if not asked_to_end():
            raise
        why = f"the work was interrupted before {done}"
    return found, why, process_time() - started
