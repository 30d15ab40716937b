"""Batches against known counts of every model, certified spectra, symmetries, and themselves one by one."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle_general.package import as_problem, known
from oracle_general.problems import problems, stands

from mpsolve import Case, Problem, certify, frequencies, tracks, vehicles
from mpsolve.batch.frequencies import alike
from mpsolve.errors import InputError

ROOT = Path(__file__).parents[1]
TABLE = [row for row in json.loads((ROOT / "data" / "general_counts.json").read_text()) if known(row)]
BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
PAIR = Problem(BEAM, vehicles.train(vehicles.Mass(70), 2, "1.5"), v="0.67")
TWO_LAYER = tracks.TwoLayer(
    EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
)
COACH = vehicles.Coach(
    body=30000, inertia="1e6", pivots=17, k2="0.4e6", c2="2e4",
    bogie=vehicles.Bogie(wheel=900, frame=1500, inertia=800, wheelbase="2.5", k="1.2e6", c="1e4", k_contact="1e9"),
)  # fmt: skip


def near(roots: Any, q: complex) -> float:
    return float(np.nanmin(np.abs(roots - q)) / abs(q))


@pytest.mark.parametrize("part", range(8))
def test_known_counts_are_met_or_left_open(part: int) -> None:
    """Never a wrong number: counts that an independent program made, for every model; roots to 1e-7."""
    told = 0
    for row in TABLE[part::8]:
        found = frequencies(as_problem(row))
        if found.status == "unresolved":
            assert found.reason != ""
            assert found.count == -1
            continue
        told += 1
        assert found.count == row["count"], row
        assert all(near(found.roots, complex(float(re), float(im))) < 1e-7 for re, im in row["roots"])
    assert told > 0.5 * len(TABLE[part::8])  # many of these run faster than waves of their track


@given(problems())
@settings(max_examples=12, deadline=None)
def test_counts_are_the_proved_ones(plain: dict[str, Any]) -> None:
    if not (known(plain) and stands(plain)):
        return
    try:
        problem = as_problem(plain)
        proved = certify(problem, region="unstable", digits=15, check=False)
    except InputError:
        return
    found = frequencies(problem, roots=False)
    if found.status == "ok" and proved.count is not None and proved.stable is not None:
        assert found.count == proved.unstable


def test_roots_are_the_certified_ones_followed_over_the_velocity() -> None:
    v = np.linspace(100, 1500, 29)
    found = frequencies(Problem(TWO_LAYER, COACH, v=100), {"v": v})
    assert (found.status == "ok").all()
    for k in (13, 21, 28):
        proved = certify(Problem(TWO_LAYER, COACH, v=float(v[k])), region="unstable", digits=15, check=False)
        expected = [complex(root.q.mid()) for root in proved.roots]
        assert found.count[k] == len(expected)
        assert np.allclose(found.roots[k][: len(expected)], expected, rtol=1e-9)
    assert found.count.max() > 2


def test_below_a_height_roots_that_decay_slowly_are_told() -> None:
    found = frequencies(PAIR, {"v": [0.5, 0.67]}, region=("below", "0.04"))
    for k, v in enumerate(("0.5", "0.67")):
        proved = certify(PAIR.changed("v", v), region=("below", "0.04"), digits=15, check=False)
        assert (found.count[k], found.unstable[k]) == (proved.count, proved.unstable)
        for root in proved.roots:
            assert near(found.roots[k], complex(root.q.mid())) < 1e-9
    refused = frequencies(PAIR, {"track.c": [0.1, 0.01]}, region=("below", "0.04"))
    assert refused.status.tolist() == ["ok", "refused"]


def test_a_batch_is_its_entries_one_by_one() -> None:
    v, M = np.linspace(0.3, 1.2, 7)[:, None], np.array([5.0, 40.0, 90.0])
    whole = frequencies(PAIR, {"v": v, "vehicles.M": M})
    assert whole.shape == (7, 3)
    for i in range(7):
        for j in range(3):
            one = frequencies(PAIR.changed("v", float(v[i, 0])).changed("vehicles.M", float(M[j])))
            assert one.count == whole.count[i, j]
            assert np.allclose(one.roots, whole.roots[i, j][: one.count], rtol=1e-9)


@given(st.permutations(range(4)), st.integers(0, 3))
@settings(max_examples=6, deadline=None)
def test_the_order_in_which_vehicles_are_given_is_nothing(order: list[int], k: int) -> None:
    given_ = [
        vehicles.Mass(40).at(0),
        vehicles.Mass(30).at(2),
        vehicles.Oscillator(wheel=10, body=20, k=3, c="0.2").at("3.5"),
        vehicles.Bogie(wheel=5, frame=20, inertia=4, wheelbase=1, k=6, c="0.1").at(6),
    ]
    over = {"v": [0.5, 0.7, 0.9, 1.2][k]}
    one = frequencies(Problem(BEAM, given_, v=0), over)
    other = frequencies(Problem(BEAM, [given_[i] for i in order], v=0), over)
    assert one.count == other.count
    assert np.allclose(one.roots, other.roots, rtol=1e-9)


@given(st.sampled_from([3.0, 1e-3, 47.0]), st.sampled_from([7.0, 1e-2]), st.sampled_from([0.55, 0.8, 1.1]))
@settings(max_examples=8, deadline=None)
def test_units_change_nothing(length: float, time: float, v: float) -> None:
    """The same beam in other units of length and time (mass 1): q in the new unit of frequency."""
    force, line = length / time**2, 1 / length
    track = tracks.EulerBernoulli(
        EI=0.25 * force * length**2, m=line, k=force / length**2, c=0.1 * force * time / length**2, eta=0.01 * time
    )
    plain = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1", eta="0.01")
    scaled = frequencies(Problem(track, vehicles.train(vehicles.Mass(50), 3, 1.3 * length), v=v * length / time))
    usual = frequencies(Problem(plain, vehicles.train(vehicles.Mass(50), 3, "1.3"), v=v))
    assert scaled.count == usual.count
    assert np.allclose(scaled.roots * time, usual.roots, rtol=1e-8)


def test_at_rest_a_row_and_its_mirror_image_are_the_same() -> None:
    places, weights = [0, "1.1", "3.7"], [10, 50, 20]
    one = Problem(BEAM, [vehicles.Mass(M).at(x) for M, x in zip(weights, places, strict=True)], v=0)
    other = Problem(BEAM, [vehicles.Mass(M).at(f"-{x}") for M, x in zip(weights, places, strict=True)], v=0)
    found = [frequencies(problem, region=("below", "0.045")) for problem in (one, other)]
    assert found[0].count == found[1].count > 0
    assert np.allclose(found[0].roots, found[1].roots, rtol=1e-9)
    assert frequencies(one).count == 0


def test_tracks_that_cannot_be_are_refused_and_the_others_answered() -> None:
    found = frequencies(PAIR, {"track.N": [0, 1.2], "v": 0.67})
    assert (found.status.tolist(), found.count.tolist()) == (["ok", "refused"], [2, -1])
    assert "buckles" in found.reason[1]
    undamped = frequencies(PAIR, {"track.c": [0.1, 0]})
    assert undamped.status.tolist() == ["ok", "refused"]


def test_faster_than_short_waves_is_left_open() -> None:
    wire = tracks.String(T=27000, m="1.07", k=500, c=2)
    bogie = vehicles.Bogie(wheel=10, frame=20, inertia=4, wheelbase=1, k=6, c="0.1")
    found = frequencies(Problem(wire, bogie, v=100), {"v": [100, 158.8, 158.9]})
    assert found.status.tolist() == ["ok", "ok", "unresolved"]
    assert "faster than short waves" in found.reason[2]
    alone = Problem(wire, [vehicles.Mass(8).at(0), vehicles.Mass(9).at(3)], v=200)
    assert frequencies(alone).count == 0  # nobody feels himself, nor the other


def test_tables() -> None:
    found = frequencies(PAIR, {"v": [0.66, 0.67], "vehicles.M": 70})
    table = found.to_dict()
    assert list(table) == ["v", "vehicles.M", "status", "reason", "count", "re_1", "im_1", "re_2", "im_2"]
    assert table["count"] == [0, 2]
    assert table["re_1"][0] is None
    assert table["im_2"][1] < 0


def test_a_data_frame_needs_pandas(monkeypatch: pytest.MonkeyPatch) -> None:
    found = frequencies(PAIR, {"v": [0.66]})
    monkeypatch.setitem(sys.modules, "pandas", SimpleNamespace(DataFrame=lambda rows: ("frame", rows)))
    (row,) = found.records()
    assert found.to_frame() == ("frame", [row])
    assert {name: [value] for name, value in row.items()} == found.to_dict()
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(InputError, match="pip install pandas"):
        found.to_frame()


def test_counts_alone_need_no_roots() -> None:
    found = frequencies(PAIR, {"v": [0.66, 0.67]}, roots=False)
    assert found.roots is None
    assert found.unstable.tolist() == [0, 2]
    assert "re_1" not in found.to_dict()


def test_two_processes_give_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    over = {"v": np.linspace(0.2, 1.2, 30)}
    one = frequencies(PAIR, over)
    monkeypatch.setattr("mpsolve.batch.frequencies._CHUNK", 10)
    two = frequencies(PAIR, over, workers=2)
    assert np.array_equal(one.count, two.count)
    assert np.allclose(one.roots, two.roots, rtol=1e-9, equal_nan=True)


def test_texts_may_have_units() -> None:
    rail = Problem(TWO_LAYER, [vehicles.Mass(900).at(0), vehicles.Mass(900).at("2.5")], v=100)
    one = frequencies(rail, {"v": ["5112 km/h", "360 km/h"], "vehicles.M": "0.9 t"})
    assert one.over["v"].tolist() == [1420, 100]
    assert one.count.tolist() == frequencies(rail, {"v": [1420, 100]}).count.tolist()


def test_an_empty_batch() -> None:
    found = frequencies(PAIR, {"v": []})
    assert found.shape == (0,)


@pytest.mark.parametrize(
    ("over", "options", "key"),
    [
        ({"v": [-1.0]}, {}, "v"),
        ({"v": [float("nan")]}, {}, "v"),
        ({"v": ["fast"]}, {}, "v"),
        ({"track.kk": [1]}, {}, "track.kk"),
        ({"track.EI": [0.25, 0]}, {}, "track.EI"),
        ({"vehicles.M": [1, -1]}, {}, "vehicles.M"),
        ({"gap[5]": [1]}, {}, "gap[5]"),
        ({"v": [1, 2], "track.k": [1, 2, 3]}, {}, "over"),
        ({"v": np.ma.masked_array([1.0, 2.0], [False, True])}, {}, "v"),
        ({}, {"region": "everywhere"}, "region"),
        ({}, {"workers": 0}, "workers"),
    ],
)
def test_bad_arguments_are_named(over: dict[str, Any], options: dict[str, Any], key: str) -> None:
    with pytest.raises(InputError) as caught:
        frequencies(PAIR, over, **options)
    assert caught.value.key == key


def test_two_masses_are_one_case() -> None:
    """Lists of masses and places are those of one case; arrays are under their paths alone."""
    found = frequencies(Case(alpha=0.67, eta_b=0.05, eta_m=[70, 70], positions=[0, 1.5]))
    assert (found.count.shape, int(found.unstable)) == ((), 2)
    with pytest.raises(TypeError):
        frequencies(0.67, 0.05, [70, 70], [0, 1.5])  # type: ignore[arg-type,call-arg,misc]


def test_one_parameter_is_sorted() -> None:
    values = np.random.default_rng(1).permutation(20_000) / 20_000
    assert (np.diff(values[alike({"v": values, "track.k": np.ones(20_000)}, 20_000)]) > 0).all()


def test_two_parameters_leap_seldom() -> None:
    x, y = (part.ravel() for part in np.meshgrid(np.arange(64), np.arange(64)))
    order = alike({"x": x, "y": y}, 4096)
    leaps = np.abs(np.diff(x[order])) + np.abs(np.diff(y[order]))
    assert sorted(order.tolist()) == list(range(4096))
    assert leaps.mean() < 2.5


def test_nothing_to_sort() -> None:
    assert alike({}, 1).tolist() == [0]
    assert alike({"v": np.array([])}, 0).tolist() == []
