"""FLINT's precision is one per process: it holds inside a block, comes back after it, and other threads wait."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import AbstractContextManager

import flint
import pytest

from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.balls import precision


def test_it_holds_inside_and_comes_back() -> None:
    before = flint.ctx.prec
    with precision(300):
        with precision(70):
            assert flint.ctx.prec == 70
        assert flint.ctx.prec == 300
        assert (flint.arb(1) / 3).rad() < flint.arb(2) ** -290
    assert flint.ctx.prec == before


def test_it_comes_back_after_an_error() -> None:
    before = flint.ctx.prec
    with pytest.raises(ZeroDivisionError), precision(300):
        raise ZeroDivisionError
    assert flint.ctx.prec == before


@pytest.mark.parametrize("other", [precision, ball_arithmetic])
def test_another_thread_waits_whichever_way_it_asks(other: Callable[[int], AbstractContextManager[object]]) -> None:
    seen, asking = [], threading.Event()

    def work() -> None:
        asking.set()
        with other(900):
            seen.append(flint.ctx.prec)

    thread = threading.Thread(target=work)
    with precision(70):
        thread.start()
        assert asking.wait(10)
        thread.join(0.2)
        assert (flint.ctx.prec, seen, thread.is_alive()) == (70, [], True)
    thread.join(10)
    assert seen == [900]
