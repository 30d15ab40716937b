"""The first Ctrl-C ends work as a spent effort does, so that what is known is kept; a second one ends it at once."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from types import FrameType
from typing import ParamSpec, TypeVar

from mpsolve.errors import EffortError
from mpsolve.outcome import Reason

P = ParamSpec("P")
T = TypeVar("T")


class _Asked:
    """Whether the work that is under way is to end."""

    yes = False
    listening = False  # work inside other work leaves it to the outer one


def asked_to_end() -> bool:
    """Whether Ctrl-C was pressed while it was listened for."""
    return _Asked.yes


def end_if_asked() -> None:
    """EffortError where Ctrl-C was pressed."""
    if _Asked.yes:
        raise EffortError(Reason("interrupted", "the work was interrupted", {}, "start it again for the rest"))


def _first(_number: int, _frame: FrameType | None) -> None:
    _Asked.yes = True
    signal.signal(signal.SIGINT, signal.default_int_handler)


def _at_once(number: int, frame: FrameType | None) -> None:
    _first(number, frame)
    raise KeyboardInterrupt


def _heard_by(handler: object) -> bool:
    """In the main thread only."""
    return threading.current_thread() is threading.main_thread() and signal.getsignal(signal.SIGINT) is handler


@contextmanager
def listening() -> Iterator[None]:
    """For work of several parts: the first Ctrl-C ends each of them with what it has.

    Only in the main thread, and where Ctrl-C means what Python makes of it.
    """
    if _Asked.listening or not _heard_by(signal.default_int_handler):
        yield
        return
    _Asked.listening = True
    signal.signal(signal.SIGINT, _first)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        _Asked.yes = _Asked.listening = False


@contextmanager
def ended_at_once() -> Iterator[None]:
    """For a step that looks at no effort: the first Ctrl-C that is listened for is a KeyboardInterrupt."""
    if not _heard_by(_first):
        yield
        return
    signal.signal(signal.SIGINT, _at_once)
    try:
        yield
    finally:
        if _heard_by(_at_once):
            signal.signal(signal.SIGINT, _first)


def stoppable(verb: Callable[P, T]) -> Callable[P, T]:
    """The same function, which the first Ctrl-C ends with what it has, if its effort is asked on the way."""

    @wraps(verb)
    def heard(*args: P.args, **kwargs: P.kwargs) -> T:
        with listening():
            return verb(*args, **kwargs)

    return heard
