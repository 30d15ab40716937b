"""Points are spread evenly by hardness; ends and corners stay, and no point leaves the path."""

from __future__ import annotations

import numpy as np

from mpsolve.proof.even import evened


def test_pieces_become_equally_hard() -> None:
    points = np.concatenate([np.linspace(0, 1, 65), np.linspace(1, 2, 9)[1:]]) + 0j
    hardness = np.abs(np.diff(points)) * 20  # the same everywhere, per length
    found = evened(points, hardness)
    assert (found[0], found[-1]) == (0, 2)
    assert len(found) < len(points) - 20
    lengths = np.abs(np.diff(found))
    assert np.allclose(lengths * 20, 1, rtol=0.06)


def test_harder_parts_get_shorter_pieces() -> None:
    points = np.linspace(0, 1, 101) + 0j
    hardness = np.where(points.real[:-1] < 0.5, 0.4, 0.1)
    found = evened(points, hardness)
    lengths = np.abs(np.diff(found))
    assert np.isclose(lengths[-3] / lengths[2], 4, rtol=1e-6)


def test_corners_stay_and_so_does_what_is_oblique() -> None:
    h = 0.04j
    points = np.concatenate(
        [np.linspace(h, 1 + h, 41), np.linspace(1 + h, 1, 11)[1:], np.linspace(1, 2 - 1j, 21)[1:]]
    )
    found = evened(points, np.full(len(points) - 1, 0.3))
    assert {h, 1 + h, 1 + 0j, 2 - 1j} <= set(found)
    assert len(found) < len(points)
    assert ((found.imag == h.imag) | (found.real == 1) | np.isin(found, points)).all()
    assert (found[-20:] == points[-20:]).all()


def test_pieces_that_are_too_hard_are_cut_up() -> None:
    points = np.array([0, 1, 2, 2 - 1j])
    found = evened(points, np.array([0.3, 3.5, 0.4]))
    assert {0, 2, 2 - 1j} <= set(found)
    assert len(found) == 6
    assert np.abs(np.diff(found[1:4])).max() < 1 / 3.5
