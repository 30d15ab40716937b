"""Paths: joins are asked for, turns agree with dense samples."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from track_models import DAMPED

from mpsolve import vehicles
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import split
from mpsolve.characteristic.path import Path, on_arc
from mpsolve.characteristic.paths import Paths
from mpsolve.characteristic.start import start
from mpsolve.errors import PrecisionError
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort

BEAM = DAMPED["euler-bernoulli"]
REDUCED = reduce_problem(Problem(BEAM, [vehicles.Mass(900), vehicles.Mass(400).at("2.5")], v=40))


def some_paths() -> Paths:
    return Paths(Arrays(REDUCED), start(REDUCED.guide))


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


def test_turns_that_are_planned_together_all_pass() -> None:
    """A part of one point is no piece; each begins and ends where it is asked to."""
    paths, parts = some_paths(), [np.linspace(0, 1.2, 3) + 0j, np.array([1.5 + 0j]), np.array([1.6, 2.4 + 0j])]
    found = paths.plan_turns(parts, Effort())
    assert [(one.points[0], one.points[-1]) for one in found] == [(part[0], part[-1]) for part in parts]
    assert found[1].pieces == 0
    link = paths.plan("link", np.array([-1j * paths.start.depth, 0]), Effort())
    for part, one in ((0, found[0]), (2, found[2])):
        whole = paths.prove((link, Path("turn", one.points)), Effort(), (complex(parts[part][0]),))
        assert whole.paths[1].pieces <= 1.5 * paths.plan("turn", parts[part], Effort()).pieces


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
    from mpsolve.characteristic import disc_matrix
    from mpsolve.characteristic import paths as module

    whole = some_paths()
    link, turn = chain(whole)

    def exchanged(table: Any, m: Any, r: Any, up: int, _nodes: Any = None) -> Any:
        s = split(table, m, r, up)
        z = np.where((s.m.imag > 1)[:, None], s.z[:, [2, 1, 0, 3]], s.z)
        return replace(s, z=z)

    monkeypatch.setattr(disc_matrix, "split", exchanged)
    monkeypatch.setattr(module, "split", exchanged)
    with pytest.raises(PrecisionError):
        whole.prove((link, turn), Effort())
