"""One thread for products of matrices, and as many as before after it."""

from __future__ import annotations

import numpy as np
import pytest
from threadpoolctl import threadpool_info

from mpsolve.parallel.threads import one_thread


def threads() -> list[int]:
    return [library["num_threads"] for library in threadpool_info() if library["user_api"] == "blas"]


def test_one_thread_while_it_lasts() -> None:
    np.ones((2, 2)) @ np.ones((2, 2))
    before = threads()
    assert before, "numpy has no BLAS here that can be asked"
    with one_thread():
        assert set(threads()) == {1}
    assert threads() == before


def test_threads_come_back_after_an_error() -> None:
    before = threads()
    with pytest.raises(ZeroDivisionError), one_thread():
        _ = 1 // 0
    assert threads() == before
