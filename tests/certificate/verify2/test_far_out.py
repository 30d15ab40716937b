"""The verifier's theorem far out on the edge of a beam's cut (certs/SPEC2.md, 8.5): bounds, and what it refuses."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from flint import acb, arb, fmpq

from mpsolve import Problem, tracks, vehicles
from mpsolve.certificate import verify2 as v2
from mpsolve.certificate.spectrum_file import equations
from mpsolve.characteristic.floats import Floats
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem

MASSES = (vehicles.Mass(70).at(0), vehicles.Mass(70).at("1.5"))


def problem(*row: Any, c: str = "0.1", v: str = "0.67") -> Problem:
    return Problem(tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=c), list(row or MASSES), v=v)


def sheet_of(given: Problem) -> v2.Sheet:
    read = equations(reduce_problem(given))
    track = v2.read_track(read["track"], read["velocity"])
    return v2.Sheet.of(track, v2.read_vehicle(read["vehicle"], None))


def turn(given: Problem, rho: str) -> Any:
    """What the checker says of arg Δ̂ from ρ on, with the p-roots at ρ from numpy's companion matrix."""
    sheet, at = sheet_of(given), fmpq(*map(int, rho.split("/")))
    with v2.precision(64):
        waves = v2.Waves(sheet.track, sheet.lower.places)
        sigma = acb(0, arb(at))
        local = waves.near(v2.Place.disc(sigma, arb(0)))
        below = waves.near(v2.Place.disc(acb(1e-7, arb(at)), arb(0)))
        known = v2.sorted_roots(below)
        found = v2.apart_near(local, known)
        walker = SimpleNamespace(thin=lambda _: found, marks={(at, fmpq(0)): None})
        return v2.check_far(sheet, walker, at)  # type: ignore[arg-type]


@pytest.mark.parametrize("masses", [1, 2, 4])
@pytest.mark.parametrize("v", ["0", "0.67", "1.3"])
def test_the_turn_is_that_of_floats(v: str, masses: int) -> None:
    """Along the edge in small steps of the argument, and round a quarter of a circle to −iR."""
    given = problem(*(vehicles.Mass(60 + 5 * j).at(str(1.5 * j)) for j in range(masses)), v=v)
    found = turn(given, "25/1")
    line = on_line(reduce_problem(given))
    assert line is not None
    unit = float(line.lower.frequency_unit)
    R = 6000.0
    edge = np.linspace(5.0, np.sqrt(R), 15_000) ** 2 * (1 - 1e-9j)
    arc = R * np.exp(-1j * np.linspace(1e-9, np.pi / 2, 10_000))
    value = Floats(line.lower).delta(1j * np.concatenate([edge, arc[1:]]) / unit)[0]
    steps = np.angle(value[1:] / value[:-1])
    assert abs(steps).max() < 0.5
    assert abs(steps.sum() - float(found.mid())) < float(found.rad()) + 0.1  # of the waves' weights at R


@pytest.mark.parametrize(("steep", "pull", "stiff"), [(0, 0, 4), (1.8, 1.8, 4), (6.8, 5.9, 3.9), (1.8, 2.6, -1)])
def test_waves_on_the_edge_are_bounded(steep: float, pull: float, stiff: float) -> None:
    """x⁴ − g y x² + 2ν√y x + κ y² − 1 by numpy, at single y and over ranges of it."""
    with v2.precision(64):
        for low, high in ((0.02, 0.02), (0.0, 0.02), (0.02, 0.05)):
            bounds = v2.far_waves(arb(steep), arb(pull), arb(stiff), arb(low).union(arb(high)))
            for y in np.linspace(max(low, 1e-6), high, 7):
                x = np.roots([1, 0, -pull * y, 2 * np.sqrt(steep * y), stiff * y * y - 1])
                sizes = 1 / abs(np.polyval([4, 0, -2 * pull * y, 2 * np.sqrt(steep * y)], x))
                real = abs(x.imag) < 1e-9
                (alpha, beta), still = sizes[real], sizes[~real][0]
                shown = still**2 / alpha / beta, (alpha + beta) ** 2 / 4 / alpha / beta, abs(x[~real].imag).min()
                for value, bound in zip(shown, bounds, strict=True):
                    assert float(bound.lower()) - 1e-12 <= value <= float(bound.upper()) + 1e-12


def test_waves_that_are_not_two_and_two_are_refused() -> None:
    with v2.precision(64):
        for args in ((1.8, 1.8, 4, 0.6), (40, 40, 4, 0.05), (0, 0, 4, 0.5), (0, 60, 0, 0.05), (0, -60, 0, 0.05)):
            x = np.roots([1, 0, -args[1] * args[3], 2 * np.sqrt(args[0] * args[3]), args[2] * args[3] ** 2 - 1])
            try:
                v2.far_waves(*map(arb, args))
            except v2.Refused:
                continue
            assert (abs(x.imag) < 1e-9).sum() == 2


@pytest.fixture
def alone(monkeypatch: pytest.MonkeyPatch) -> pytest.MonkeyPatch:
    """Without what is taken from p-roots at ρ."""
    monkeypatch.setattr(v2, "far_argument", lambda *_: arb(0))
    return monkeypatch


def spread(given: Problem, rho: Any) -> Any:
    walker = SimpleNamespace(thin=lambda _: None, marks={(fmpq(rho), fmpq(0)): None})
    with v2.precision(64):
        return v2.check_far(sheet_of(given), walker, fmpq(rho))  # type: ignore[arg-type]


@pytest.mark.usefixtures("alone")
def test_where_the_theorem_holds_and_where_it_does_not() -> None:
    assert spread(problem(), 4).rad() < 1.5
    assert spread(problem(MASSES[0]), 4).rad() < 1e-9
    with pytest.raises(v2.Refused, match="damping is not small"):
        spread(problem(c="9/5"), fmpq(1, 2))
    with pytest.raises(v2.Refused, match="waves far out"):
        spread(problem(), 1)
    four = [vehicles.Mass(70).at(str(1.5 * j)) for j in range(4)]
    assert spread(problem(*four), 25).rad() < 1.5
    with pytest.raises(v2.Refused, match="evanescent waves"):
        spread(problem(*four), 9)
    with pytest.raises(v2.Refused, match="evanescent waves"):
        spread(problem(MASSES[0], vehicles.Mass(70).at("0.01")), 25)
    many = [vehicles.Mass(70).at(str(30 * j)) for j in range(12)]
    with pytest.raises(v2.Refused, match="may reflect more than they get"):
        spread(problem(*many, c="1.5"), 25)


def test_active_masses_reflect_more_than_passive_ones(alone: pytest.MonkeyPatch) -> None:
    """More damping of the beam makes masses below the line of the cuts more active: the bound is never smaller."""
    sizes = [
        float(spread(problem(*MASSES, vehicles.Mass(1).at("4.5"), c=c), 20).rad()) for c in ("0.1", "0.8", "1.6")
    ]
    assert sizes == sorted(sizes)
    assert sizes[0] < sizes[-1]
    alone.setattr(v2, "far_waves", lambda *_: (arb(1), arb("1.99"), arb(1)))
    assert spread(problem(c="0.1"), 20).rad() < 1.6
    with pytest.raises(v2.Refused, match="waves far out are not what they tend to"):
        spread(problem(c="1.6"), 20)


@pytest.mark.usefixtures("alone")
@pytest.mark.parametrize("change", ["M", "C", "K", "h", "B", "shared"])
def test_other_vehicles_are_not_known(change: str) -> None:
    M, C, K, B, h = [[70, 0], [0, 70]], [[0, 0], [0, 0]], [[0, 0], [0, 0]], [[1, 0], [0, 1]], None
    if change == "M":
        M = [[70, 1], [1, 70]]
    if change == "C":
        C = [[1, -1], [-1, 1]]
    if change == "K":
        K = [[1, -1], [-1, 1]]
    if change == "B":
        B = [[1, 1], [0, 1]]
    if change == "shared":
        B = [[1, 1], [1, -1]]
    if change == "h":
        h = 100
    car = vehicles.Vehicle(M=M, C=C, K=K, B=B, places=[0, "1.5"], k_contact=h)
    with pytest.raises(v2.Refused, match="tight masses only"):
        spread(problem(car), 25)


def test_waves_that_balls_do_not_tell_apart_are_refused() -> None:
    P = [acb(arb(0, 1e-9), 1), acb(-1), acb(arb(0, 1e-9), -1), acb(1)]
    found = SimpleNamespace(z=P, sides=[range(2), range(2, 4)])
    for k in (1, 3):
        z = [acb(arb(0, 2), 0) if i == k else x for i, x in enumerate(P)]
        form = SimpleNamespace(k=[z]), SimpleNamespace(k=[[acb(1)] * 4])
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(v2, "residues", lambda *_, form=form: form)
            with pytest.raises(v2.Refused, match="not told apart"):
                v2.far_argument(found, acb(0, 1), [(fmpq(0), fmpq(1))])  # type: ignore[arg-type]
