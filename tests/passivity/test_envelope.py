"""The bound of what short waves give, against exact samples; none where the load outruns them."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from passive_subjects import RAIL, TRACKS, TWO, family_and_envelope, reduced_and_envelope

from mpsolve import Problem, tracks, vehicles
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.subject import Subject
from mpsolve.problem.reduced import reduce_problem


def ratio(power: object, p: Fraction, omega: Fraction, x: tuple[Fraction, ...] = ()) -> float:
    """|W|/|D|², exactly."""
    out = []
    for terms in (power.w, power.real, power.imaginary):  # type: ignore[attr-defined]
        total = Fraction(0)
        for (i, j, *powers), c in terms.items():
            total += c * p ** (2 * i) * omega ** (2 * j) * math.prod(a**k for a, k in zip(x, powers, strict=True))
        out.append(total)
    return float(abs(omega * out[0]) / (out[1] ** 2 + omega**2 * out[2] ** 2))


@pytest.mark.parametrize("name", TRACKS)
def test_samples_stay_below(name: str) -> None:
    _, envelope = reduced_and_envelope(name)
    power, v, rng = envelope.subject.power, Fraction(sum(envelope.subject.v.values())), np.random.default_rng(2)
    k = next(k for k in range(-2, 8) if envelope.constant(k) < math.inf)
    C, largest = envelope.constant(k), 0.0
    for _ in range(300):
        p = Fraction(2.0**k * float(np.exp(rng.exponential(1.0))))
        value = ratio(power, p, -v * p * Fraction(float(rng.uniform()))) * float(p) ** power.alpha
        largest = max(largest, value)
    assert 0.05 * C < largest <= C


def test_over_parameters() -> None:
    pair = Problem(TWO, [vehicles.Mass(900), vehicles.Mass(900).at("2.5")], v=400)
    _, envelope = family_and_envelope(pair, {"track.k_pad": (2e8, 4e8), "track.c_pad": (1e4, 5e4), "v": (200, 600)})
    C, rng = envelope.constant(2), np.random.default_rng(3)
    low, high = np.array(envelope.low), np.array(envelope.high)
    for _ in range(200):
        x = tuple(map(Fraction, low + rng.uniform(0, 1, 3) * (high - low)))
        v = sum((c * math.prod(a**k for a, k in zip(x, powers, strict=True))
                 for powers, c in envelope.subject.v.items()), Fraction(0))  # fmt: skip
        p = Fraction(4 * float(np.exp(rng.exponential(1.0))))
        value = ratio(envelope.subject.power, p, -v * p * Fraction(float(rng.uniform())), x)
        assert value * float(p) ** envelope.subject.power.alpha <= C


def test_none_for_a_load_that_outruns_the_waves() -> None:
    wire = tracks.String(T=27000, m="1.07", k=500, c=2)
    slow, fast = (reduce_problem(Problem(wire, vehicles.Mass(9), v=v)) for v in (150, 170))
    assert Envelope(Subject.of_reduced(slow), (), ()).constant(6) < math.inf
    assert Envelope(Subject.of_reduced(fast), (), ()).constant(6) == math.inf


def test_bounds_of_many_places_at_once() -> None:
    envelope = Envelope(Subject.of_guide(reduce_problem(Problem(RAIL, vehicles.Mass(9), v=100)).guide), (), ())
    p = np.array([3.0, 4.0, 5.0, 100.0])
    found = envelope.constants(p)
    assert (found >= [envelope.constant(2), envelope.constant(2), envelope.constant(2), envelope.constant(7)]).all()
    assert found[2] == envelope.constant(2)
