"""Bands against the eigenvalues of −Im G, and that no root of heavy vehicles lies beyond."""

from __future__ import annotations

import pickle

import pytest
from passive_subjects import RAIL, TWO, problem

from mpsolve import InputError, Problem, Status, certify, passivity_band, tracks, vehicles


@pytest.mark.parametrize(
    ("name", "count", "tight"), [("rail", 2, 1.3), ("two layers", 3, 2.0), ("timoshenko", 1, 1e9)]
)
def test_a_band(name: str, count: int, tight: float) -> None:
    given = problem(name, count)
    band = passivity_band(given)
    assert band.proved
    assert band.status is Status.UNVERIFIED
    assert band.least <= float(band.value) <= max(tight * band.least, 1e9 * (tight == 1e9))
    assert "proved" in band.sentence
    again = pickle.loads(pickle.dumps(band))
    assert again.to_dict() == band.to_dict()


def test_no_unstable_root_lies_beyond() -> None:
    pair = Problem(RAIL, [vehicles.Mass(20000), vehicles.Mass(20000).at(3)], v=290)
    band, roots = passivity_band(pair), certify(pair, region="unstable").roots
    assert roots
    assert all(root.q.real < band.value for root in roots)


def test_at_rest_and_faster_than_waves() -> None:
    assert passivity_band(Problem(TWO, vehicles.Mass(900), v=0)).value == 0
    wire = tracks.String(T=27000, m="1.07", k=500, c=2)
    fast = passivity_band(Problem(wire, [vehicles.Mass(9), vehicles.Mass(9).at(20)], v=170))
    assert fast.value is None
    assert fast.reason is not None
    assert fast.reason.code == "no-band"
    with pytest.raises(TypeError):
        bool(fast)


def test_bad_input() -> None:
    undamped = tracks.EulerBernoulli(EI=6.4e6, m=60, k=1e6)
    with pytest.raises(InputError, match="damping"):
        passivity_band(Problem(undamped, vehicles.Mass(900), v=50))
    with pytest.raises(InputError, match="Problem"):
        passivity_band(RAIL)  # type: ignore[arg-type]
