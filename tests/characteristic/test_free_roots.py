"""Roots over boxes: each point's root lies in its model, of third order; roots that meet are not told apart."""

import numpy as np
import pytest
from free_cases import inside, of_many, pair_over_velocity, random_boxes

from mpsolve.characteristic.boxes import Boxes, FreeTrack
from mpsolve.characteristic.floats import Receptance
from mpsolve.characteristic.free_roots import Roots, roots_over
from mpsolve.numbers.quadratic import pairs
from mpsolve.problem.family import Family


def found(family: Family, boxes: Boxes) -> tuple[FreeTrack, Roots]:
    track = FreeTrack(family)
    y, rho = boxes.variables
    D, N = track.D(y, rho), track.N(y, rho)
    z, low = track.nodes(D)
    with np.errstate(all="ignore"):
        return track, roots_over(D, N, z, low, track.up)


@pytest.mark.parametrize("share", [1e-3, 1e-2])
def test_the_root_of_each_point_is_in_its_model(share: float) -> None:
    for family in (pair_over_velocity(), of_many()):
        boxes = random_boxes(family, 60, share)
        track, roots = found(family, boxes)
        whole = roots.good.all(1)
        assert whole.mean() > 0.3
        for n in np.flatnonzero(whole)[:25]:
            u, q, x = inside(boxes, int(n))
            weights = np.array([1.0, *u, *(u[i] * u[j] for i, j in pairs(roots.P.m))])
            model = np.tensordot(weights, roots.P.k[:, n], 1)
            truth = Receptance(family.guide(x)).roots(np.array([1j * q]))[0]
            for side in (slice(0, track.up), slice(track.up, None)):
                off = np.abs(truth[side][:, None] - model[side][None, :])
                assert (off.min(0) <= roots.P.e[n, side] + 1e-8 * np.abs(model[side])).all()
                assert sorted(off.argmin(0)) == list(range(off.shape[1]))  # each root once


def test_what_a_model_leaves_out_is_of_third_order() -> None:
    family = pair_over_velocity("0.2", "0.6")
    middles = random_boxes(family, 20, 1e-3).m
    errors = []
    for share in (1e-2, 1e-3):
        r = share * np.ones_like(middles) * np.array([[1.0], [0.4]])
        _, roots = found(family, Boxes(middles, r))
        assert roots.good.all()
        errors.append(roots.P.e)
    ratio = errors[0] / errors[1]
    assert np.median(ratio) > 800


def test_roots_that_may_meet_are_not_good() -> None:
    family = pair_over_velocity()
    _, roots = found(family, random_boxes(family, 10, 0.4))
    assert not roots.good.all(1).any()
