"""The tables of a study: what plain SQL reads, and that the rows give the results back."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from mpsolve import Problem, study, tracks, vehicles
from mpsolve.studies.blocks import Block, Result, Root, pack
from mpsolve.studies.columns import parameter_titles, read_block, tables, unit_of, write_block
from mpsolve.studies.spec import read_spec

TRACK = {"model": "euler-bernoulli", "EI": "6.4e6", "m": 60, "k": "1e6", "c": 770}
SPEC: dict[str, Any] = {
    "study": {"kind": "float64"},
    "v": 100,
    "track": TRACK,
    "vehicle": [{"model": "mass", "M": 10000}, {"model": "mass", "M": 10000, "position": "3.4"}],
    "parameters": {"v": {"start": 100, "stop": 240, "step": 20}, "vehicles.M": [8000, 12000]},
}


def test_a_study_is_asked_in_sql(tmp_path: Path) -> None:
    made = study(SPEC, store=tmp_path / "s.sqlite", workers=1)
    with closing(sqlite3.connect(made.path)) as connection:
        ask = lambda query: connection.execute(query).fetchall()  # noqa: E731
        rows = ask('SELECT "index", "v [m/s]", "vehicles.M [kg]", status, count, "growth [1/s]" FROM entries')
        growing = ask('SELECT max("v [m/s]") FROM entries WHERE unstable > 0')
        fastest = ask('SELECT max(-"im [1/s]") FROM roots WHERE "re [rad/s]" > 0')
    assert len(rows) == made.total == 16
    for (index, v, mass, status, count, growth), (place, values, result) in zip(rows, made.results(), strict=True):
        assert (index, v, mass, status, count) == (place, *map(float, values.values()), result.status, result.count)
        assert growth == max((-root.im for root in result.roots), default=None)  # type: ignore[operator]
    assert growing == [(240.0,)]
    assert fastest[0][0] == max(row[5] for row in rows if row[5] is not None)


def test_rows_give_the_block_back() -> None:
    spec = read_spec(SPEC)
    results = [
        Result("ok", "", 2, 2, (Root(-1.5, -0.1), Root(1.5, -0.1))),
        Result("proved", "ü", 1, 1, (Root("0.10", "-2", "1e-17", "0", 1, "imaginary"),)),
        *[Result("unresolved", "why", None, None, ())] * 14,
    ]
    block = Block(0, "key", pack(results), 2, "{}").sealed
    with closing(sqlite3.connect(":memory:")) as connection:
        for statement in tables(spec):
            connection.execute(statement)
        for _ in range(2):  # the second time in place of the first
            write_block(connection, spec, "this", block)
            assert read_block(connection, spec, "this", 0) == block
        assert read_block(connection, spec, "another", 0) is None
        assert read_block(connection, spec, "this", 1) is None
        connection.execute('UPDATE roots SET "im [1/s]" = 0 WHERE number = 1')
        spoilt = read_block(connection, spec, "this", 0)
    assert spoilt is not None
    assert not spoilt.whole


@pytest.mark.parametrize(
    ("path", "unit"),
    [
        ("v", "m/s"),
        ("track.k_pad", "N/m²"),
        ("vehicles[0].wheel", "kg"),
        ("vehicles[1].M", "kg"),
        ("vehicles[0].inertia", "kg m²"),
        ("gap[0]", "m"),
        ("scale.mass", ""),
    ],
)
def test_units(path: str, unit: str) -> None:
    track = tracks.TwoLayer(EI=1, m=1, k_pad=1, c_pad=1, m_sleeper=1, k_ballast=1, c_ballast=1)
    bogie = vehicles.Bogie(wheel=1, frame=1, inertia=1, wheelbase=2, k=1, c=1)
    problem = Problem(track, [vehicles.Mass(1).at(20), bogie.at(0)], v=1)
    assert unit_of(problem, path) == unit


def test_a_dimensionless_case_has_no_units() -> None:
    case = {"alpha": "0.5", "eta_b": "0.05", "eta_m": [40], "positions": [0]}
    spec = read_spec({"study": {"kind": "float64"}, "dimensionless": case, "parameters": {"v": [1, 2]}})
    assert parameter_titles(spec) == ("v",)
