"""The splitting over boxes: p-roots of each side stay near their nodes, also where roots of one side meet."""

import numpy as np
from free_cases import inside, of_many, pair_over_velocity, random_boxes

from mpsolve.characteristic.boxes import FreeTrack
from mpsolve.characteristic.floats import Receptance


def test_the_roots_of_u_are_the_decaying_ones_all_over_the_box() -> None:
    for family in (pair_over_velocity(), of_many()):
        track = FreeTrack(family)
        boxes = random_boxes(family, 60, 5e-3)
        wave = track.split(boxes)
        assert wave.good.mean() > 0.7
        for n in np.flatnonzero(wave.good)[:25]:
            _, q, x = inside(boxes, int(n))
            roots = Receptance(family.guide(x)).roots(np.array([1j * q]))[0]
            for side in (slice(0, track.up), slice(track.up, None)):
                # Smith: each root lies within (number of nodes)·|a_k| of a node
                reach = len(wave.z[n, side]) * wave.tight[n, side] + 1e-9
                away = np.abs(roots[side][:, None] - wave.z[n, side][None, :])
                assert (away <= reach).any(1).all()


def test_boxes_that_are_too_wide_are_not_called_good() -> None:
    family = pair_over_velocity()
    assert not FreeTrack(family).split(random_boxes(family, 10, 0.4)).good.any()
