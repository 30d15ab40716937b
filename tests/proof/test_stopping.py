"""Ctrl-C keeps what is known: long proofs come back undecided, with a reason; a second one ends them at once."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Problem, certify, crossings, frequency_lines, onset, tracks, vehicles, worst
from mpsolve.errors import EffortError
from mpsolve.outcome import Status
from mpsolve.proof import stopping
from mpsolve.proof.effort import Effort
from mpsolve.proof.stopping import listening, stoppable

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")


def row(count: int, v: str) -> Problem:
    return Problem(BEAM, vehicles.train(vehicles.Mass(40), count, "1.5"), v=v)


@contextmanager
def interrupted(*after: float) -> Iterator[None]:
    timers = [threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT)) for seconds in after]
    for timer in timers:
        timer.start()
    try:
        yield
    finally:
        for timer in timers:
            timer.cancel()


@pytest.mark.parametrize(
    "work",
    [
        lambda: certify(row(64, "0.5"), region="unstable", check=False),
        lambda: onset(row(16, "0.5"), over={"v": ("0.1", "0.6")}, check=False),
    ],
    ids=["64 contacts", "onset of 16"],
)
def test_a_long_proof_comes_back_with_what_it_has(work: Callable[[], Any]) -> None:
    started = time.monotonic()
    with interrupted(0.7):
        found = work()
    assert time.monotonic() - started < 60
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "interrupted"
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    Effort(evaluations=1).spend(1)  # other work goes on


@pytest.mark.parametrize("ask", [worst, frequency_lines, onset, crossings], ids=lambda one: one.__name__)
def test_every_proof_over_a_range_hears_it(ask: Callable[..., Any]) -> None:
    """`lines` and `worst` ended with nothing but "interrupted"."""
    found = ask(row(2, "0.5"), over={"v": ("0.3", "0.6")}, check=False,
                progress=lambda *_: signal.raise_signal(signal.SIGINT) if armed() else None)  # fmt: skip
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "interrupted"


def armed() -> bool:
    """Whether the next Ctrl-C is only listened for."""
    return signal.getsignal(signal.SIGINT) is stopping._first


def test_work_of_several_parts_hears_it_in_each_of_them() -> None:
    """`onset` over two ranges went on with the second where Ctrl-C came while the first was being verified."""

    @stoppable
    def complete() -> str:
        signal.raise_signal(signal.SIGINT)
        return "proved"

    with listening():
        assert complete() == "proved"
        second = onset(row(2, "0.5"), over={"v": ("0.3", "0.6")}, check=False)
    assert second.reason is not None
    assert second.reason.code == "interrupted"
    Effort().spend(1)


def test_what_is_proved_of_a_long_train_is_kept() -> None:
    with interrupted(0.7):
        found = certify(row(64, "0.5"), region="unstable", check=False)
    assert found.known["growth"] < Fraction(1, 100)


def test_a_second_one_ends_it_at_once() -> None:
    @stoppable
    def deaf() -> None:
        end = time.monotonic() + 20
        while time.monotonic() < end:
            time.sleep(0.01)

    with interrupted(0.1, 0.3), pytest.raises(KeyboardInterrupt):
        deaf()
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_effort_hears_of_it_only_inside() -> None:
    @stoppable
    def asked() -> None:
        signal.raise_signal(signal.SIGINT)
        Effort().spend(1)

    with pytest.raises(EffortError, match="interrupted"):
        asked()
    Effort().spend(1)


def test_other_threads_are_left_alone() -> None:
    seen: list[object] = []
    thread = threading.Thread(target=lambda: seen.append(stoppable(signal.getsignal)(signal.SIGINT)))
    thread.start()
    thread.join()
    assert seen == [signal.default_int_handler]


def test_ctrl_c_in_the_verifier_keeps_what_is_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    """The verifier looks at no effort; one Ctrl-C ends it, and the answer is proved, but not verified."""

    def slow(_content: bytes) -> None:
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(5)

    monkeypatch.setattr("mpsolve.certificate.verify2.verify_bytes", slow)
    started = time.monotonic()
    found = certify(row(1, "1.1"), region="unstable", digits=15)
    assert time.monotonic() - started < 5
    assert found.status is Status.UNVERIFIED
    assert found.count == found.unstable == 0  # kept: a single mass is stable at this velocity
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
