"""A hard end of work: on time, whatever runs, and with flint as it was."""

from __future__ import annotations

import signal
import threading
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
    assert process_time() - start < 0.4
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
    for outer, inner in ((0.1, 0.5), (0.5, 0.1), (0.1, None)):
        start = process_time()
        with pytest.raises(TimeUpError), deadline(outer), deadline(inner):
            _busy(3.0)
        assert process_time() - start < 0.3


def test_what_follows_an_inner_deadline_ends_with_the_outer_one() -> None:
    def twice() -> None:
        with pytest.raises(TimeUpError), deadline(0.1):
            _busy(3.0)
        _busy(3.0)

    start = process_time()
    with pytest.raises(TimeUpError), deadline(0.3):
        twice()
    assert 0.25 < process_time() - start < 0.6


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
