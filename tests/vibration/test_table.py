"""Columns with units, and arrays that come back."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Case, Load, Problem, response
from mpsolve.files import save_arrays, save_columns
from mpsolve.vibration.case_motion import Scale
from mpsolve.vibration.table import arrays, case_columns, columns, named, time_columns, unit_of

FOUND = response(Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=20), times=[0.01, 0.1], places=[0, "1.5"])


def test_every_row_has_a_column_with_its_unit() -> None:
    table = columns(FOUND)
    assert np.array_equal(table["w at x = 1.5 m [m]"], FOUND.rail[1])
    assert np.array_equal(table["contact force 2 [N]"], FOUND.contact_force[1])
    assert [unit_of(name) for name in ("frame pitch", "rear wheel")] == ["rad", "m"]
    assert {f"{name} [{unit_of(name)}]" for name in FOUND.vehicle} < set(table)


def test_files_hold_every_digit(tmp_path: Path) -> None:
    lines = save_columns(columns(FOUND), tmp_path / "motion.csv").read_text().splitlines()
    row = dict(zip(columns(FOUND), (float(x) for x in lines[-1].split(",")), strict=True))
    assert row["contact force 1 [N]"] == FOUND.contact_force[0, -1]
    with np.load(save_arrays(arrays(FOUND), tmp_path / "motion.npz")) as kept:
        assert np.array_equal(kept["rail"], FOUND.rail)
        assert list(kept["names"]) == list(FOUND.vehicle)


def test_every_part_has_its_column():
    found = response(Case(alpha="0.5", eta_b="0.05", eta_m=20), [Load(1)], [0, "1.5"], [0, 2])
    table = case_columns(found, Scale())
    assert list(table)[:3] == ["tau", "w[xi=0]", "steady[xi=0]"]
    assert np.array_equal(table["w[xi=1.5]"], found.w[1])
    assert named("w", "mm", Scale()) == "w"
    assert list(time_columns(found.tau, Scale())) == ["tau"]
