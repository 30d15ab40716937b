"""The tail theorem of one track: beyond X its matrix is passive by residue sums, and each bound holds."""

from __future__ import annotations

from fractions import Fraction
from time import process_time
from typing import Any

import numpy as np
import pytest
import sympy
from oracle_general import Floats
from oracle_general.package import as_problem

from mpsolve.errors import EffortError
from mpsolve.passivity.far import FarNumbers, prove_tail
from mpsolve.presets.written import problem_of
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.tracks.own import Waveguide
from mpsolve.vehicles import Mass

RAIL = {"model": "euler-bernoulli", "EI": "6.38e6", "m": "60.2", "k": "1e6", "c": "770"}
TRACKS = {
    "euler-bernoulli": (RAIL, "150"),
    "kelvin-voigt": ({**RAIL, "c": "0", "eta": "1e-4"}, "150"),
    "string": ({"model": "string", "T": "27000", "m": "1.07", "k": "500", "c": "2"}, "140"),
    "timoshenko": ({**RAIL, "model": "timoshenko", "S": "2.4e8", "J": "0.24"}, "300"),
    "two-layer": ({"model": "two-layer", "EI": "6.38e6", "m": "60.2", "k_pad": "300e6", "c_pad": "3e4",
                   "m_sleeper": "250", "k_ballast": "100e6", "c_ballast": "8e4"}, "400"),
    "ballast damped lightly": ({"model": "two-layer", "EI": "1.78e6", "m": "77.1", "k_pad": "2.39e7", "c_pad": "0",
                              "m_sleeper": "36.8", "k_ballast": "7.36e6", "c_ballast": "2450"}, "309.5"),
}  # fmt: skip


def plain(name: str, gap: str = "2.5", count: int = 2) -> dict[str, Any]:
    track, v = TRACKS[name]
    places = [str(float(gap) * k) for k in range(count)]
    return {"track": track, "v": v, "vehicles": [{"model": "mass", "M": "900", "at": x} for x in places]}


def proved(name: str, gap: str = "2.5") -> tuple[Any, FarNumbers]:
    reduced = reduce_problem(as_problem(plain(name, gap)))
    tail = prove_tail(reduced.guide, reduced.smallest_gap)
    assert tail is not None
    return reduced, tail


SLAB = {"model": "slab", "EI": "4.91e6", "m": "54.77", "k_pad": "6e7", "c_pad": "15384", "EI_slab": "88.4e6",
        "m_slab": "1100", "k": "8e7", "c": "3e4"}  # fmt: skip


def test_a_block_keeps_away_from_two_waves_that_are_nearly_one() -> None:
    """Rail and slab bend alike: there W and |D|² vanish together, and no block that holds the place is proved."""
    wheels = [{"model": "mass", "M": "900", "at": x} for x in ("0", "2.2")]
    problem = {"track": SLAB, "v": "27", "vehicles": wheels}
    reduced = reduce_problem(as_problem(problem))
    tail = prove_tail(reduced.guide, reduced.smallest_gap)
    assert tail is not None
    G = Floats(problem).receptance(tail.X * float(reduced.frequency_unit) * np.geomspace(1, 30, 60) + 0j)
    assert (np.linalg.eigvalsh(-(G - np.swapaxes(G.conj(), 1, 2)) / 2j)[:, 0] > 0).all()


def test_no_block_is_shorter_than_the_contacts_tell() -> None:
    """What is left of a block without its ends may be too short to absorb for sure: a verifier refuses it."""
    p, w = sympy.symbols("p Omega")
    rail = 342 * p**4 - sympy.Rational(43, 2) * p**2 - 3350 * w**2 + 246 * sympy.I * w + 1761
    slab = 392 * p**4 - 611 * w**2 + 483 * sympy.I * w + 2470
    wheels = [Mass("11.8").at(0), Mass("7.2").at(5)]
    reduced = reduce_problem(Problem(Waveguide([[rail, -115], [-115, slab]]), wheels, v="0.2035"))
    tail = prove_tail(reduced.guide, reduced.smallest_gap)
    assert tail is not None
    assert reduced.smallest_gap is not None
    least = 2 * np.pi / float(reduced.smallest_gap) / tail.X ** float(tail.gamma)
    assert min(z2 - z1 for z1, z2, _ in tail.blocks) > least


@pytest.mark.parametrize("name", TRACKS)
def test_the_matrix_is_passive_beyond(name: str) -> None:
    reduced, tail = proved(name)
    unit = float(reduced.frequency_unit)
    for count in (2, 3):
        floats = Floats(plain(name, count=count))
        q = tail.X * unit * np.geomspace(1, 30, 60) + 0j
        G = floats.receptance(q)
        H = -(G - np.swapaxes(G.conj(), 1, 2)) / 2j
        values = np.linalg.eigvalsh(H)
        assert (values[:, 0] > -1e-13 * np.abs(G).max((1, 2))).all()
        if "ballast" not in name:
            assert (values[:, 0] > 0).all()


@pytest.mark.parametrize("name", TRACKS)
def test_each_bound_holds_where_it_is_sampled(name: str) -> None:
    reduced, tail = proved(name)
    guide, v = reduced.guide, reduced.guide.v

    def power(p: Fraction, omega: Fraction) -> Fraction:
        """W/|D|², exactly."""
        (a, b), (c, d) = (parts(polynomial, p, omega) for polynomial in (guide.D_rest, guide.N_rest))
        return -(d * a - c * b) / (a * a + b * b)

    rng = np.random.default_rng(3)
    for _ in range(60):
        q = Fraction(tail.X * 10 ** rng.uniform(0, 3))
        for z1, z2, kappa in tail.blocks:
            p = Fraction(rng.uniform(z1, z2) * float(q) ** float(tail.gamma))
            assert q > v * p
            assert float(power(p, q - v * p)) > kappa * float(q) ** -float(tail.e) * (1 - 1e-9)
    for k in range(400):
        p = Fraction(tail.X / float(v) * 10 ** rng.uniform(0, 2))
        omega = -v * p * Fraction(rng.uniform() if k % 2 else 10 ** rng.uniform(-6, 0))
        assert abs(float(power(p, omega))) < tail.constant * float(p) ** -tail.alpha * (1 + 1e-9)


def parts(polynomial: Any, p: Fraction, omega: Fraction) -> tuple[Fraction, Fraction]:
    """Real and imaginary part of a polynomial at P = ip, s = iΩ."""
    sums = [Fraction(0)] * 4
    for (i, j), c in polynomial.items():
        sums[(i + j) % 4] += c * p**i * omega**j
    return sums[0] - sums[2], sums[1] - sums[3]


def test_the_frequency_is_not_far() -> None:
    limits = {"euler-bernoulli": 2, "kelvin-voigt": 8, "string": 30, "timoshenko": 2, "two-layer": 2}
    found = {name: proved(name, "20" if name == "string" else "2.5")[1].X for name in limits}
    assert all(found[name] <= limit for name, limit in limits.items()), found


@pytest.mark.parametrize(("name", "v"), [("string", "170"), ("timoshenko", "2100")])
def test_faster_than_waves_there_is_none(name: str, v: str) -> None:
    reduced = reduce_problem(as_problem({**plain(name), "v": v}))
    assert prove_tail(reduced.guide, reduced.smallest_gap) is None


def test_the_last_theorem_is_kept_for_its_own_track_alone() -> None:
    first = proved("euler-bernoulli")[1]
    assert proved("euler-bernoulli")[1] is first
    assert proved("euler-bernoulli", "1.25")[1] != first
    assert proved("euler-bernoulli")[1] == first


def test_the_search_ends_with_its_effort() -> None:
    """Four fields: the whole search takes some seconds."""
    p, omega = sympy.symbols("p Omega")
    rows = [
        [p**4 / 4 + p**2 + 1 - 3 * omega**2, 0, -sympy.I * p**3 / 9, p**4 / 5],
        [0, 4 * p**4 + 9 * p**2 + 2 - omega**2, 2 * p**4 + p**2, 0],
        [sympy.I * p**3 / 9, 2 * p**4 + p**2, 20 * p**4 + 14 * p**2 + 8 + 90 * sympy.I * omega - omega**2 / 40, 0],
        [p**4 / 5, 0, 0, 2 * p**4 + 13 * p**2 + 1 - 5 * omega**2],
    ]
    reduced = reduce_problem(Problem(Waveguide(rows, loaded=1), [Mass(1).at(0), Mass(1).at(1)], v=6))
    started = process_time()
    with pytest.raises(EffortError):
        prove_tail(reduced.guide, reduced.smallest_gap, Effort(seconds=0.1))
    assert process_time() - started < 4


def test_absurd_velocities_are_planned_without_a_warning() -> None:
    """At 3·10⁹ m/s short floats overflowed, which users saw as a line of the source."""
    reduced = reduce_problem(problem_of("ballasted", "wheelset")[0].changed("v", "3e9"))
    found = prove_tail(reduced.guide, reduced.smallest_gap)
    assert found is None or all(np.isfinite(kappa) for *_, kappa in found.blocks)
