"""Points are spread evenly by hardness; ends and corners stay, and no point leaves the path."""

from __future__ import annotations

import numpy as np

from mpsolve.proof.even import evened


def test_pieces_become_equally_hard() -> None:
    points = np.concatenate([np.linspace(0, 1, 65), np.linspace(1, 2, 9)[1:]]) + 0j
    hardness = np.abs(np.diff(points)) * 16  # the same everywhere, per length
    found = evened(points, hardness, 0.8)
    assert (found[0], found[-1]) == (0, 2)
    assert len(found) < len(points) - 20
    lengths = np.abs(np.diff(found))
    assert np.allclose(lengths * 16, 0.8, rtol=0.06)


def test_harder_parts_get_shorter_pieces() -> None:
    points = np.linspace(0, 1, 101) + 0j
    hardness = np.where(points.real[:-1] < 0.5, 0.4, 0.1)
    found = evened(points, hardness, 0.8)
    lengths = np.abs(np.diff(found))
    assert np.isclose(lengths[-3] / lengths[2], 4, rtol=1e-6)


def test_corners_stay_and_so_does_what_is_oblique() -> None:
    h = 0.04j
    points = np.concatenate(
        [np.linspace(h, 1 + h, 41), np.linspace(1 + h, 1, 11)[1:], np.linspace(1, 2 - 1j, 21)[1:]]
    )
    found = evened(points, np.full(len(points) - 1, 0.3), 0.9)
    assert {h, 1 + h, 1 + 0j, 2 - 1j} <= set(found)
    assert len(found) < len(points)
    assert ((found.imag == h.imag) | (found.real == 1) | np.isin(found, points)).all()
    assert (found[-20:] == points[-20:]).all()


def test_what_is_hard_enough_is_left() -> None:
    points = np.linspace(0, 1, 11) + 0j
    assert (evened(points, np.full(10, 0.9), 0.8) == points).all()
