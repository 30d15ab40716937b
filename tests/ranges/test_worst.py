"""The lowest root of a range against certified spectra beside it, digits found another way, and old faults."""

from __future__ import annotations

import pickle
from fractions import Fraction

import numpy as np
import pytest
from flint import arb
from lowest_roots import assert_lowest, pair

from mpsolve import Case, Effort, InputError, Problem, Status, frequencies, tracks, vehicles, worst
from mpsolve.numbers.balls import precision


@pytest.mark.parametrize(
    ("eta_b", "distance", "least_im"),
    [
        # α = 0.99, η_M = 70: the paper's "from 1.25 to 1.05" over its range of damping is 1.2453 to 1.0431;
        # the digits were found by minimisation over followed roots in mpmath
        ("0.5", "1.12328854764", "-0.0378415422527"),
        pytest.param("0.04", "1.24525185012", "-0.00492265460905", marks=pytest.mark.slow),
        pytest.param("0.1", "1.21927931299", "-0.0148636000425", marks=pytest.mark.slow),
        pytest.param("0.99", "1.0431090128", "-0.0484667250189", marks=pytest.mark.slow),
    ],
)
def test_the_paper_s_critical_distances(eta_b: str, distance: str, least_im: str) -> None:
    case = pair("0.99", eta_b)
    found = worst(case, over={"gap[0]": ("0.5", 2)}, digits=20)
    assert found.proved, found.reason
    assert (found.where, found.reach) == ("inside", None)
    assert abs(float(found.value.mid()) - float(distance)) < 2e-11  # type: ignore[union-attr]
    assert abs(float(found.q.imag.mid()) - float(least_im)) < 2e-13  # type: ignore[union-attr]
    with precision(100):
        assert found.value.rad() < arb(10) ** -19  # type: ignore[union-attr]
        assert found.value >= arb(found.lower)
        assert found.value <= arb(found.upper)
    assert_lowest(case, "gap[0]", found, ["0.5", "0.9", "1.1", "1.15", "1.6", "2"], "unstable")


@pytest.mark.parametrize(
    ("path", "ends", "where"),
    [("v", ("0.5", "0.9"), "inside"), ("track.c", ("0.01", "0.5"), "end"), ("track.k", ("0.9", "1.1"), "start")],
)
def test_any_parameter(path: str, ends: tuple[str, str], where: str) -> None:
    case = pair("0.7", "0.05")
    found = worst(case, over={path: ends}, check=False)
    assert (found.proved, found.where) == (True, where), found.reason
    low, high = map(float, ends)
    grid = np.linspace(low, high, 41)
    seen = frequencies(case, {path: grid})
    lowest = np.nanmin(seen.roots.imag)
    assert lowest >= float(found.q.imag.mid()) - 1e-9  # type: ignore[union-attr]


@pytest.mark.slow
def test_three_masses_and_a_bogie_on_layers() -> None:
    three = Case(alpha="0.9", eta_b="0.1", eta_m=(40, 40, 40), positions=(0, "1.2", "2.4"))
    found = worst(three, over={"scale.gap": ("0.5", 2)}, check=False)
    assert (found.proved, found.where) == (True, "inside"), found.reason
    assert_lowest(three, "scale.gap", found, ["0.5", "1", "1.19", "1.21", "2"], "unstable")


def test_a_sprung_wheel_on_sleepers() -> None:
    layers = {"k_pad": "300e6", "c_pad": "3e4", "m_sleeper": "250", "k_ballast": "100e6", "c_ballast": "8e4"}
    track = tracks.TwoLayer(EI="6.38e6", m="60.2", **layers)
    problem = Problem(track, vehicles.Oscillator(wheel=900, body=2000, k="1.2e6", c=4000), v=100)
    found = worst(problem, over={"track.c_ballast": ("4e4", "2e5")}, check=False)
    assert found.proved, found.reason
    assert found.reach is not None
    assert found.growth < 0  # type: ignore[operator]
    limit = Fraction(float(found.q.imag.mid()) * 1.5)  # type: ignore[union-attr]
    assert_lowest(problem, "track.c_ballast", found, ["4e4", "8e4", "2e5"], ("below", limit))


def test_more_digits_lie_within_fewer() -> None:
    over = {"gap[0]": ("1", "1.3")}
    few, many = (worst(pair("0.99", "0.5"), over=over, digits=n, check=False) for n in (15, 200))
    with precision(900):
        assert few.value.overlaps(many.value)  # type: ignore[union-attr]
        assert few.q.overlaps(many.q)  # type: ignore[union-attr]
        assert many.value.rad() < arb(10) ** -198  # type: ignore[union-attr]
        assert many.q.imag.rad() < arb(10) ** -198  # type: ignore[union-attr]


def test_effort_and_input() -> None:
    found = worst(pair("0.99", "0.5"), over={"gap[0]": ("0.5", 2)}, effort=Effort(evaluations=20), check=False)
    assert (found.proved, found.value, found.reason.code) == (False, None, "effort")  # type: ignore[union-attr]
    with pytest.raises(InputError, match="give one path"):
        worst(pair("0.99", "0.5"), over={"gap[0]": (1, 2), "v": (0, 1)})
    with pytest.raises(InputError, match="unknown"):
        worst(pair("0.99", "0.5"), over={"gap[1]": (1, 2)})
    with pytest.raises(InputError, match="from 15"):
        worst(pair("0.99", "0.5"), over={"gap[0]": (1, 2)}, digits=3)


def test_it_is_handed_on() -> None:
    found = worst(pair("0.99", "0.5"), over={"gap[0]": ("1.3", "1.6")}, digits=np.int64(15))  # type: ignore[arg-type]
    assert found.proofs[0].base.status is Status.PROVED  # the verifier passed the one spectrum
    again = pickle.loads(pickle.dumps(found))
    assert again.where == found.where
    assert again.value.overlaps(found.value)
    assert {"value", "growth", "where", "reach"} <= set(found.to_dict())
    assert next(iter(found.rows()))["where"] == "start"
    with pytest.raises(TypeError):
        bool(found)
