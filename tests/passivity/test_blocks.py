"""Boxes of q and parameters that are told to be passive are so, by residue sums; and most that are so are told."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from passive_subjects import RAIL, TRACKS, TWO, family_and_envelope, least, reduced_and_envelope

from mpsolve import Problem, vehicles
from mpsolve.numbers.affine import between
from mpsolve.passivity.blocks import densities, passive_on
from mpsolve.passivity.subject import cells


@pytest.mark.parametrize("count", [1, 2, 3])
@pytest.mark.parametrize("name", TRACKS)
def test_against_residue_sums(name: str, count: int) -> None:
    reduced, envelope = reduced_and_envelope(name, count)
    q = np.geomspace(0.05, 30, 60)
    truth = least(reduced.guide, reduced.places, q)
    points = passive_on(envelope, q[:, None], q[:, None], 27)
    boxes = passive_on(envelope, q[:-1, None], q[1:, None], 27)
    assert (truth[points] > -1e-13).all()
    assert (truth[:-1][boxes] > -1e-13).all()
    assert (truth[1:][boxes] > -1e-13).all()
    clear = truth > 1e-2
    assert not clear.any() or points[clear].mean() > 0.85
    assert boxes.sum() >= points.sum() - 12


@pytest.mark.parametrize(
    ("track", "v", "over"),
    [
        (RAIL, 150, {"track.k": (800000, 1200000), "track.c": (600, 900), "v": (120, 160)}),
        (RAIL, 150, {"gap[0]": ("2.2", "2.9"), "v": (120, 160)}),
        (TWO, 600, {"track.k_ballast": (90 * 10**6, 110 * 10**6), "track.c_pad": (20000, 40000), "v": (550, 620)}),
    ],
)
def test_boxes_of_parameters(track: object, v: int, over: dict[str, tuple[object, object]]) -> None:
    pair = Problem(track, [vehicles.Mass(900), vehicles.Mass(900).at("2.5")], v=v)
    family, envelope = family_and_envelope(pair, over)
    rng = np.random.default_rng(1)
    low, high = np.array(envelope.low), np.array(envelope.high)
    corners = rng.uniform(0, 1, (150, len(low)))
    size = (high - low) * 0.03
    a = low + corners * (high - low - size)
    q = np.exp(rng.uniform(np.log(0.1), np.log(5), 150))
    told = passive_on(envelope, np.column_stack([q, a]), np.column_stack([q * 1.02, a + size]))
    wrong, clear = 0, []
    for k in range(150):
        share = rng.uniform(0, 1, len(low))
        x = [Fraction(float(t)) for t in a[k] + share * size]
        places = [place.at(x) for place in family.places]
        value = least(family.guide(x), places, np.array([q[k] * rng.uniform(1, 1.02)]))[0]
        wrong += bool(told[k] and value < -1e-13)
        clear += [told[k]] if value > 0.1 else []
    assert not wrong
    assert np.mean(clear) > 0.8


def test_a_density_is_below_the_exact_one() -> None:
    _, envelope = reduced_and_envelope("two layers")
    subject = envelope.subject
    low, high = np.array([[0.7], [2.0]]), np.array([[0.72], [2.3]])
    ends = cells(subject, (low + high)[:, 0] / 2, np.zeros((2, 0)), np.array([0.02, 0.1]), 9)
    density = densities(subject, between(low, high, "q"), subject.speed([]), [], ends)
    rng, v = np.random.default_rng(0), Fraction(sum(subject.v.values()))
    power = subject.power
    for row in range(2):
        for cell in rng.choice(ends.shape[1] - 1, 60, replace=False):
            if not ends[row, cell + 1] > ends[row, cell]:
                continue
            t, s = rng.uniform(-1, 1, 2)
            p = Fraction(float(density.middle[row, cell])) + Fraction(
                float(density.half[row, cell] * 0.999)
            ) * Fraction(t)
            q = Fraction(float(low[row, 0] + high[row, 0])) / 2 + Fraction(
                float(high[row, 0] - low[row, 0])
            ) / 2 * Fraction(s) * Fraction(999, 1000)
            omega = q - v * p
            w, re, im = (sum(c * p ** (2 * i) * omega ** (2 * j) for (i, j), c in a.items())
                         for a in (power.w, power.real, power.imaginary))  # fmt: skip
            exact = float(omega * w / (re**2 + omega**2 * im**2))
            bound = density.a[row, cell] + density.turn[row, cell] * t * 0.999
            bound += density.b["q"][row, cell] * s * 0.999
            assert bound <= exact + 1e-9 * abs(exact) + 1e-14 * abs(density.a[row]).max()
