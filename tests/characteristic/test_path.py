"""Discs hold their pieces and arcs."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.characteristic.path import Path, discs, on_arc

FLOATS = st.floats(-1e3, 1e3)


def squared(z: complex, w: complex) -> Fraction:
    return (Fraction(z.real) - Fraction(w.real)) ** 2 + (Fraction(z.imag) - Fraction(w.imag)) ** 2


@given(FLOATS, FLOATS, FLOATS, FLOATS)
def test_discs_hold_their_ends_with_room(x: float, y: float, u: float, w: float) -> None:
    a, b = complex(x, y), complex(u, w)
    m, r = discs(np.array([a]), np.array([b]))
    for end in (a, b):
        assert squared(1j * end, m[0]) * (1 + Fraction(1, 2**12)) ** 2 <= Fraction(r[0]) ** 2
    assert r[0] <= 0.5003 * abs(b - a) + 4e-12


@given(st.floats(0.01, 1e4), st.floats(0, 1.5), st.floats(1e-6, 0.3))
def test_discs_of_arcs_hold_the_arc(radius: float, angle: float, width: float) -> None:
    """Also where the ends are off the circle by nearly as much as is allowed."""
    ends = np.array([angle, min(angle + width, np.pi / 2)])
    length = radius * (ends[1] - ends[0])
    q = np.exp(-1j * ends) * (radius + np.array([0.9, -0.9]) * 2.0**-14 * length)
    path = Path("turn", q, radius)
    if not on_arc(path)[0]:
        return
    m, r = discs(q[:1], q[1:])
    t = np.linspace(*ends, 50)
    assert (np.abs(1j * radius * np.exp(-1j * t) - m) <= r * (1 + 1e-12)).all()


def test_points_off_the_circle_are_no_arc() -> None:
    q = 3 * np.exp(-1j * np.linspace(0, 1.5, 20))
    assert on_arc(Path("turn", q, 3.0)).all()
    off = q.copy()
    off[5] *= 1 + 1e-4
    assert np.flatnonzero(~on_arc(Path("turn", off, 3.0))).tolist() == [4, 5]
    chords = np.concatenate([q[:3], [(q[2] + q[3]) / 2], q[3:]])
    assert np.flatnonzero(~on_arc(Path("turn", chords, 3.0))).tolist() == [2, 3]
    assert not on_arc(Path("turn", np.array([3.0, -3j]), 3.0)).any()
    assert on_arc(Path("turn", np.array([0, 1, 3.0 + 0j]), 3.0)).all()  # the axis is straight
    assert on_arc(Path("turn", chords)).all()
