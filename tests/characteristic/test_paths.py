"""Paths: discs hold their pieces and arcs, joins are asked for, turns and passivity agree with dense samples."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from track_models import DAMPED

from mpsolve import vehicles
from mpsolve.characteristic.bordered import Arrays
from mpsolve.characteristic.discs import split
from mpsolve.characteristic.paths import Path, Paths, discs, on_arc, positive
from mpsolve.characteristic.start import start
from mpsolve.errors import PrecisionError
from mpsolve.numbers.jets import Jet
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort

BEAM = DAMPED["euler-bernoulli"]
REDUCED = reduce_problem(Problem(BEAM, [vehicles.Mass(900), vehicles.Mass(400).at("2.5")], v=40))
FLOATS = st.floats(-1e3, 1e3)


def some_paths() -> Paths:
    return Paths(Arrays(REDUCED), start(REDUCED.guide))


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


def test_halved_pieces_of_an_arc_stay_on_the_circle() -> None:
    paths = some_paths()
    arc = 3.0 * np.exp(-1j * np.linspace(0, np.pi / 2, 4))
    arc[-1] = -3j
    path = paths.plan("turn", np.concatenate([[0j, 1.5], arc]), Effort(), arc=3.0)
    assert path.pieces > 12
    assert on_arc(path).all()
    down = path.points[path.points.imag < 0]
    assert np.abs(down) == pytest.approx(np.full(len(down), 3.0), rel=1e-14)


def test_a_path_that_cuts_its_arc_short_is_not_proved() -> None:
    paths = some_paths()
    link, _ = chain(paths)
    arc = 3.0 * np.exp(-1j * np.linspace(0, np.pi / 2, 200))
    arc[0], arc[-1] = 3.0, -3j
    points = np.concatenate([np.linspace(0, 3, 200)[:-1], arc])
    assert paths.prove((link, Path("turn", points, 3.0)), Effort()).pieces > 398
    points[-20] *= 1 - 1e-5
    with pytest.raises(PrecisionError):
        paths.prove((link, Path("turn", points, 3.0)), Effort())
    paths.prove((link, Path("turn", points)), Effort())  # as a polygon it is


def chain(paths: Paths) -> tuple[Path, Path]:
    depth = paths.start.depth
    link = paths.plan("link", np.array([-1j * depth, -0.5j * depth, 0]), Effort())
    return link, paths.plan("turn", np.linspace(0, 2, 9) + 0j, Effort())


def delta(q: Any) -> Any:
    """Δ̂ in floats."""
    arrays = Arrays(REDUCED)
    _, G, good = arrays.evaluate(1j * q, np.zeros(len(q)), 2)
    assert good.all()
    return np.linalg.det(arrays.matrix(G, 1j * q).a)


def test_the_turn_is_that_of_many_small_steps() -> None:
    paths = some_paths()
    proved = paths.prove(chain(paths), Effort())
    values = delta(np.linspace(1e-9, 2, 4000) + 0j)
    assert proved.turns[0] == (0.0, 0.0)
    turn, error = proved.turns[1]
    assert error < 1e-5
    assert turn == pytest.approx(float(np.angle(values[1:] / values[:-1]).sum()), abs=1e-6)
    assert abs(turn) > 0.5


def test_paths_must_join_and_begin_at_the_start() -> None:
    paths = some_paths()
    link, turn = chain(paths)
    with pytest.raises(ValueError, match="begins"):
        paths.prove((turn,), Effort())
    with pytest.raises(ValueError, match="begins"):
        paths.prove((link, replace(turn, points=turn.points[1:])), Effort())


def test_the_splitting_at_the_start_must_be_the_one_told_apart() -> None:
    paths = some_paths()
    s = paths.start.splitting
    other = replace(paths.start, splitting=replace(s, z=s.z[:, [2, 1, 0, 3]]))
    with pytest.raises(PrecisionError, match="start"):
        Paths(paths.arrays, other).prove(chain(paths), Effort())


def test_a_wrong_pair_is_not_linked_along_a_path(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where nodes of the two sides are exchanged on some discs, the joins fail."""
    from mpsolve.characteristic import bordered
    from mpsolve.characteristic import paths as module

    whole = some_paths()
    link, turn = chain(whole)

    def exchanged(table: Any, m: Any, r: Any, up: int, _nodes: Any = None) -> Any:
        s = split(table, m, r, up)
        z = np.where((s.m.imag > 1)[:, None], s.z[:, [2, 1, 0, 3]], s.z)
        return replace(s, z=z)

    monkeypatch.setattr(bordered, "split", exchanged)
    monkeypatch.setattr(module, "split", exchanged)
    with pytest.raises(PrecisionError):
        whole.prove((link, turn), Effort())


def test_where_it_is_proved_positive_the_hermitian_part_is() -> None:
    rng = np.random.default_rng(4)
    count, n = 300, 4
    base = rng.normal(size=(count, n, n)) + 1j * rng.normal(size=(count, n, n))
    a = base @ np.swapaxes(base.conj(), 1, 2) + 1j * (base + np.swapaxes(base.conj(), 1, 2))
    b = rng.normal(size=a.shape) + 1j * rng.normal(size=a.shape)
    e = 1e-3 * rng.uniform(size=a.shape)
    r, way = 10.0 ** rng.uniform(-3, 0, count), np.exp(2j * np.pi * rng.uniform(size=count))
    good = positive(Jet(a, b, e, r), way, np.zeros(count))
    assert 20 < good.sum() < 280
    least = np.full(count, np.inf)
    for t in np.linspace(-1, 1, 21):
        for _ in range(4):
            noise = e * np.exp(2j * np.pi * rng.uniform(size=a.shape))
            V = a + b * (way * t * r)[:, None, None] + noise
            least = np.minimum(least, np.linalg.eigvalsh(V + np.swapaxes(V.conj(), 1, 2))[:, 0])
    assert (least[good] > 0).all()
    thin = positive(Jet(a, b, 0 * e, 0 * r), way, np.zeros(count))
    H = np.linalg.eigvalsh(a + np.swapaxes(a.conj(), 1, 2))
    assert (thin == (H[:, 0] > 0)).all()


@pytest.mark.parametrize("t", [0.89, 0.91])
def test_at_the_edge_of_being_positive(t: float) -> None:
    one = np.ones((1, 1, 1), complex)
    wide = positive(Jet(one, one, np.zeros((1, 1, 1)), np.array([t])), np.ones(1), np.zeros(1))
    rest = positive(Jet(one, 0 * one, np.full((1, 1, 1), t), np.zeros(1)), np.ones(1), np.zeros(1))
    across = positive(Jet(one, one, np.zeros((1, 1, 1)), np.array([t])), np.array([1j]), np.zeros(1))
    drift = positive(Jet(one, one, np.zeros((1, 1, 1)), np.array([t])), np.array([1j]), np.array([t]))
    assert [wide[0], rest[0], drift[0]] == [t < 0.9] * 3
    assert across[0]


def test_negative_and_endless_matrices_are_not_positive() -> None:
    zero = np.zeros((1, 2, 2))
    for a in (-np.eye(2), np.zeros((2, 2)), np.full((2, 2), np.nan), np.full((2, 2), np.inf), np.diag([1.0, -1e-9])):
        assert not positive(Jet(a[None] + 0j, 0j * zero, zero, np.zeros(1)), np.ones(1), np.zeros(1))[0]
