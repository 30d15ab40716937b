"""A hard end of work: on time, whatever runs, and with flint as it was."""

from __future__ import annotations

import gc
import signal
import sys
import threading
from collections.abc import Callable
from time import process_time

import flint
import pytest

from mpsolve.numbers.balls import precision
from mpsolve.proof.deadline import TimeUpError, deadline

pytestmark = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="there is no such timer here")


def _busy(seconds: float) -> None:
    end = process_time() + seconds
    while process_time() < end:
        try:
            sum(range(1000))
        except Exception:  # noqa: BLE001 — what a step may catch does not keep it going
            continue


def test_it_ends_a_step_that_never_looks_at_the_clock() -> None:
    before, start = flint.ctx.prec, process_time()
    with pytest.raises(TimeUpError), deadline(0.1), precision(999):
        _busy(3.0)
    assert process_time() - start < 1.5
    assert flint.ctx.prec == before


def test_what_is_ready_in_time_is_left_alone() -> None:
    with deadline(0.2):
        _busy(0.05)
    _busy(0.3)  # the timer is off


def test_the_handler_is_put_back() -> None:
    before = signal.getsignal(signal.SIGPROF)
    with pytest.raises(TimeUpError), deadline(0.01):
        _busy(1.0)
    assert signal.getsignal(signal.SIGPROF) is before


def test_the_first_of_two_in_each_other_ends_the_work() -> None:
    for outer, inner in ((0.1, 2.0), (2.0, 0.1), (0.1, None)):
        start = process_time()
        with pytest.raises(TimeUpError), deadline(outer), deadline(inner):
            _busy(3.0)
        assert process_time() - start < 1.0


def test_what_follows_an_inner_deadline_ends_with_the_outer_one() -> None:
    def twice() -> None:
        with pytest.raises(TimeUpError), deadline(0.1):
            _busy(3.0)
        _busy(3.0)

    start = process_time()
    with pytest.raises(TimeUpError), deadline(0.3):
        twice()
    assert 0.25 < process_time() - start < 1.5


class _Slow:
    def __del__(self) -> None:
        _busy(0.2)


def _dropped_by_a_finalizer() -> None:
    for _ in range(2):
        _Slow()


def _dropped_by_a_collection() -> None:
    def collected(phase: str, _info: dict[str, int]) -> None:
        if phase == "start":
            _busy(0.2)

    gc.callbacks.append(collected)
    try:
        gc.collect()
    finally:
        gc.callbacks.remove(collected)


@pytest.mark.parametrize("drop", [_dropped_by_a_finalizer, _dropped_by_a_collection])
def test_an_end_that_python_drops_comes_again(drop: Callable[[], None]) -> None:
    hook, start = sys.unraisablehook, process_time()

    def work() -> None:
        drop()
        _busy(3.0)

    with pytest.raises(TimeUpError), deadline(0.1):
        work()
    assert process_time() - start < 1.0
    assert sys.unraisablehook is hook


def test_what_else_python_drops_is_told_as_before(monkeypatch: pytest.MonkeyPatch) -> None:
    class Wrong:
        def __del__(self) -> None:
            raise ValueError

    told: list[type[BaseException]] = []
    monkeypatch.setattr("sys.unraisablehook", lambda what: told.append(what.exc_type))
    with deadline(0.2):
        Wrong()
    assert told == [ValueError]


def test_another_thread_runs_to_its_end() -> None:
    done: list[bool] = []

    def work() -> None:
        with deadline(0.01):
            _busy(0.1)
        done.append(True)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert done == [True]
