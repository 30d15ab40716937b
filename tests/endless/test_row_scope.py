"""Rows over ranges of velocities have one bound of the frequencies that are looked at."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from endless_rows import bogies, masses

from mpsolve import Effort, InputError, Problem, tracks, vehicles
from mpsolve.characteristic.boxes import Boxes
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.row import row_of
from mpsolve.endless.row_scope import RowScope, cover_row, judge_of, row_scope
from mpsolve.errors import PrecisionError
from mpsolve.proof.subdivide import subdivide
from mpsolve.ranges.judge import NONZERO, PASSIVE


def test_beyond_the_bound_every_motion_decays() -> None:
    row = masses("0.5")
    scope = row_scope(row, Fraction("0.1"), Fraction("0.5"))
    for v in ("0.1", "0.3", "0.5"):
        here = row.at_velocity(v)
        q = np.linspace(scope.X, 5 * scope.X, 200)
        ahead, back = Bloch(here).middle(1j * q)
        assert (np.abs(ahead) < 1).all()
        assert (np.abs(back) > 1).all()


def test_refusals() -> None:
    rayleigh = tracks.Rayleigh(EI=1, m=1, J="0.1", k=1, c="0.1")
    row = row_of(Problem(rayleigh, vehicles.Mass(3), v="0.3"), 2)
    with pytest.raises(PrecisionError):
        row_scope(row, Fraction("0.2"), Fraction("0.4"))
    string = tracks.String(T=1, m=1, k=1, c="0.1")
    row = row_of(Problem(string, vehicles.Mass(3), v="0.3"), 2)
    with pytest.raises(InputError, match="speed"):
        row_scope(row, Fraction("0.5"), Fraction("1.5"))


def test_passive_boxes_are_passive_and_those_of_slow_motions_are_not() -> None:
    """By floats: −Im Ĝ at points of each box that is told so, for one and for two contacts; never below v times some
    wavenumber, where the row gives."""
    rng = np.random.default_rng(3)
    for row, (a, b) in ((masses("0.3"), ("0.1", "0.3")), (bogies("0.4"), ("0.2", "0.5"))):
        scope = row_scope(row, Fraction(a), Fraction(b))
        judge, (low, high) = judge_of(scope), scope.corners(scope.ends[1])
        m = low[:, None] + (high - low)[:, None] * rng.uniform(0.02, 0.98, (3, 300))
        kind, _ = judge(m - 0.004, m + 0.004)
        assert (kind == PASSIVE).sum() > 50
        assert (kind == NONZERO).sum() > 5
        for k in np.flatnonzero(kind == PASSIVE):
            point = m[:, k] + rng.uniform(-0.004, 0.004, 3)
            G = scope.matrix.receptance(Boxes(point[:, None], np.full((3, 1), 1e-12))).G.a[0]
            assert np.linalg.eigvalsh((G - G.conj().T) * 0.5j)[0] > 0


LAYERS = tracks.TwoLayer(
    EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
)
BOGIE_SI = vehicles.Bogie(wheel=900, frame=1500, inertia=800, wheelbase="2.5", k="1.2e6", c="1e4", k_contact="1e9")
COACH = vehicles.Coach(body=30000, inertia="1e6", bogie=BOGIE_SI, pivots=17, k2="0.4e6", c2="2e4")


@pytest.mark.parametrize(
    ("vehicle", "spacing", "ends"), [(COACH, 25, (100, 105)), (BOGIE_SI, 8, (500, 520))], ids=["coach", "bogie"]
)
def test_boxes_of_a_row_of_coaches_are_few(vehicle: vehicles.Vehicle, spacing: int, ends: tuple[int, int]) -> None:
    """At resonances of the bodies the frequency has to be halved, and the whole circle of z before that."""
    scope = row_scope(row_of(Problem(LAYERS, vehicle, v=ends[0]), spacing), *map(Fraction, ends))
    found = subdivide(*scope.corners(scope.ends[1]), judge_of(scope), Effort(evaluations=8000))
    assert found.reason is None
    assert len(found.tree.open) == 0


THRESHOLD = Fraction("0.1901469010")  # in floats


def scope(low: str, high: str) -> RowScope:
    return row_scope(masses("0.15"), Fraction(low), Fraction(high))


def test_up_to_a_little_below_the_threshold() -> None:
    found = cover_row(scope("0.18", "0.192"), THRESHOLD, Effort(evaluations=100_000))
    assert found.reason is None
    assert found.top is not None
    assert 0 < THRESHOLD - found.top < Fraction("1e-8")


def test_not_beyond_it() -> None:
    found = cover_row(scope("0.1895", "0.192"), Fraction("0.1905"), Effort(evaluations=20_000))
    assert found.top is None or found.top < THRESHOLD


def test_a_box_with_a_real_root_stays_open() -> None:
    here = scope("0.18", "0.2")
    judge, unit = judge_of(here), float(here.family.units[0])
    root = np.array([0.2494775, float(THRESHOLD) / unit, 2.0502262])  # where it is real for the first time
    for size in (1e-2, 1e-4, 1e-6):
        kind, _ = judge((root - size)[:, None], (root + size)[:, None])
        assert kind[0] == 0
    away = root + np.array([0.0, -0.02, 0.0])
    assert judge((away - 1e-3)[:, None], (away + 1e-3)[:, None])[0][0] in (NONZERO, PASSIVE)


def test_spent_effort_is_said() -> None:
    found = cover_row(scope("0.1", "0.192"), THRESHOLD, Effort(evaluations=100))
    assert found.top is None
    assert found.reason is not None
    assert found.reason.code == "effort"


def test_what_was_covered_before_the_effort_ended_is_kept() -> None:
    found = cover_row(scope("0.1", "0.192"), THRESHOLD, Effort(evaluations=6000))
    assert found.reason is not None
    assert found.top is not None
    assert Fraction("0.105") < found.top < Fraction("0.189")
