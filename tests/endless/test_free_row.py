"""Models of the row's receptance hold what floats find at points of their boxes; the matrix is that of the row."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from endless_rows import bogies, masses

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.floats import Receptance
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.free_row import RowMatrix
from mpsolve.endless.lattice import Lattice
from mpsolve.endless.row import Row, row_of
from mpsolve.numbers.quadratic import Quadratic, pairs
from mpsolve.problem.family import family_of

CASES = [(masses("0.3"), ("0.1", "0.3")), (bogies("0.4"), ("0.1", "0.5"))]


def _matrix(row: Row, ends: tuple[str, str]) -> RowMatrix:
    family = family_of(row.problem, {"v": (Fraction(ends[0]), Fraction(ends[1]))})
    return RowMatrix(family, step=row.spacing / Fraction(2) ** family.base.guide.length)


def _value(f: Quadratic, box: int, u: Any) -> Any:
    k = f.k[:, box]
    return (
        k[0]
        + sum(k[1 + i] * u[i] for i in range(3))
        + sum(k[4 + n] * u[i] * u[j] for n, (i, j) in enumerate(pairs(3)))
    )


def _truth(row: Row, matrix: RowMatrix, point: Any) -> Any:
    """Ĝ between the places at (q̂, v̂, θ), in floats, in the scales of the family."""
    q, v, theta = point
    bloch = Bloch(row.at_velocity(Fraction(float(v)) * matrix.family.units[0]))
    bloch.__dict__["receptance"] = Receptance(matrix.family.guide((Fraction(float(v)),)))
    distances, which = matrix.receptance.row.distances
    lattice = Lattice(distances, matrix.step)
    z = np.exp(1j * np.array([theta]))
    G, _ = lattice.sums(bloch.terms(np.array([1j * q])), bloch.upper, z, float, np.exp)
    return np.array([g[0] for g in G])[which]


@pytest.mark.parametrize(("row", "ends"), CASES)
def test_boxes_hold_the_sum_over_the_row(row: Row, ends: tuple[str, str]) -> None:
    matrix, rng, count = _matrix(row, ends), np.random.default_rng(3), 60
    (low, high), seen = matrix.family.box[0], 0
    m = np.stack([
        rng.uniform(0.01, 2, count), rng.uniform(float(low), float(high), count) * 0.9 + 0.05 * float(low + high),
        rng.uniform(-3, 3, count),
    ])  # fmt: skip
    for size in (1e-3, 4e-3):
        found = matrix.receptance(Boxes(m, np.full((3, count), size)))
        u = rng.uniform(-1, 1, (3, count))
        for k in np.flatnonzero(found.good):
            truth = _truth(row, matrix, m[:, k] + size * u[:, k])
            error = np.abs(_value(found.G, k, u[:, k]) - truth)
            assert (error <= found.G.e[k] + 1e-10 * np.abs(truth)).all()
            seen += 1
        if size < 2e-3:
            assert found.good.all()
            assert (np.median(found.G.e / np.abs(found.G.a))) < 1e-4
    assert seen > count


def test_a_wave_that_fits_the_row_is_not_bounded() -> None:
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.01")
    faint = row_of(Problem(beam, vehicles.Mass(40), v="0.3"), "1.5")
    matrix = _matrix(faint, ("0.1", "0.3"))
    wide = Boxes(np.array([[1.5], [0.8], [0.0]]), np.array([[1e-6], [1e-6], [3.2]]))
    assert not matrix.receptance(wide).good[0]  # every z: some wave of the lightly damped track nearly fits
    assert matrix.receptance(Boxes(wide.m, np.full((3, 1), 1e-6))).good[0]


def test_a_whole_circle_is_bounded_where_waves_die_out_on_the_way_to_the_next_vehicle() -> None:
    row, ends = CASES[0]
    matrix, rng = _matrix(row, ends), np.random.default_rng(7)
    wide = Boxes(np.array([[0.4], [0.8], [0.0]]), np.array([[1e-3], [1e-3], [3.2]]))
    found = matrix.receptance(wide)
    assert found.good[0]
    for _ in range(20):
        u = rng.uniform(-1, 1, 3)
        truth = _truth(row, matrix, wide.m[:, 0] + wide.r[:, 0] * u)
        assert (np.abs(_value(found.G, 0, u) - truth) <= found.G.e[0]).all()


def test_where_roots_all_but_meet_circles_leave_out_less_than_residues() -> None:
    layers = tracks.TwoLayer(
        EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
    )
    matrix = _matrix(row_of(Problem(layers, vehicles.Mass(900), v=100), 3), ("50", "150"))
    near = np.array([[0.384963769], [0.6001139532], [0.5]])  # two roots of one side are 0.001 apart
    found = matrix.receptance(Boxes(near, np.array([[1e-8], [1e-8], [1e-6]])))
    assert found.good[0]
    assert found.G.e[0, 0, 0] < 1e-6 * abs(found.G.a[0, 0, 0])


def test_the_determinant_is_that_of_the_row() -> None:
    row, ends = CASES[1]
    matrix = _matrix(row, ends)
    point = np.array([0.7, 0.9, 0.4])
    A, found = matrix(Boxes(point[:, None], np.full((3, 1), 1e-9)))
    assert found.good[0]
    here = row.at_velocity(Fraction(0.9) * matrix.family.units[0])
    other = _matrix(here, ends)
    B, _ = other(Boxes(point[:, None], np.full((3, 1), 1e-9)))
    assert np.isclose(np.linalg.det(A.a[0]), np.linalg.det(B.a[0]), rtol=1e-9)
    bloch, z = Bloch(here), np.exp(1j * np.array([0.4]))
    ratio = [
        complex(bloch.delta(np.array([1j * q]), z)[0][0]) / complex(np.linalg.det(_at(matrix, (q, 0.9, 0.4))))
        for q in (0.7, 0.9, 1.3)
    ]
    assert np.allclose(ratio, ratio[0], rtol=1e-7)  # the same function of q up to a constant


def _at(matrix: RowMatrix, point: tuple[float, float, float]) -> Any:
    A, _ = matrix(Boxes(np.array(point)[:, None], np.full((3, 1), 1e-10)))
    return A.a[0]
