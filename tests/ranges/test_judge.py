"""No box that holds the crossing is ever said to hold none; far from it, all boxes are decided."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ranges_of_a_pair import over_velocity

from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.judge import ABSORBING, KNOWN, NONZERO, PASSIVE
from mpsolve.ranges.search import Search


@pytest.fixture(scope="module")
def crossing() -> np.ndarray:
    search = Search(over_velocity(), 15)
    search.cover(Effort(), silent)
    (one,) = search.found
    return np.array([float(one.q.mid()), float(one.x.mid())])


SHARES = st.floats(0.001, 0.999)
SIZES = st.floats(-40, 0).map(lambda e: 2.0**e)


@settings(max_examples=60)
@given(st.tuples(SHARES, SHARES), st.tuples(SIZES, SIZES))
def test_the_crossing_is_never_excluded(
    crossing: np.ndarray, share: tuple[float, float], size: tuple[float, float]
) -> None:
    """Boxes of any size and shape with the crossing anywhere inside."""
    whole = np.array([0.3, 0.3]) * np.array(size)
    low = crossing - whole * np.array(share)
    low[0] = max(low[0], 0.0)
    judge = over_velocity().judge()
    kind, _ = judge(low[:, None], (low + whole)[:, None])
    assert kind[0] == 0


def test_small_boxes_elsewhere_are_decided(crossing: np.ndarray) -> None:
    scope, rng = over_velocity(), np.random.default_rng(3)
    low, high = scope.corners
    at = low[:, None] + rng.uniform(0.01, 0.99, (2, 200)) * (high - low)[:, None]
    at = at[:, (np.abs(at - crossing[:, None]) > 0.02).any(0)]
    kind, _ = scope.judge()(at - 1e-6, at + 1e-6)
    assert set(kind.tolist()) <= {NONZERO, PASSIVE, ABSORBING}
    assert NONZERO in kind
    assert ABSORBING in kind


def test_known_boxes_are_known(crossing: np.ndarray) -> None:
    judge = over_velocity().judge()
    judge.known.append((crossing - 1e-3, crossing + 1e-3))
    inside, across = (crossing - 1e-4)[:, None], (crossing + 2e-3)[:, None]
    assert judge(inside, inside + 2e-4)[0][0] == KNOWN
    assert judge(inside, across)[0][0] != KNOWN


def test_a_room_far_smaller_than_what_it_is_looked_for_in(crossing: np.ndarray) -> None:
    judge = over_velocity().judge()
    wide, tiny = (judge.room(crossing, np.array([size, size])) for size in (2.0**-4, 2.0**24))
    assert wide is not None
    assert tiny is not None
    for low, high in (wide, tiny):
        assert (low < crossing).all()
        assert (crossing < high).all()
    assert (tiny[1] - tiny[0] < wide[1] - wide[0]).any()
