"""Floating ice, where two waves come to p = 0 at q = 0: counts and roots of an independent table, verified."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from forging import as_file
from oracle_general.package import as_problem

from mpsolve import Problem, Status, certify, tracks, vehicles
from mpsolve.certificate.verify2 import verify_bytes

TABLE = json.loads((Path(__file__).parents[1] / "data" / "general_counts.json").read_text())
ROWS = {str(row.get("seed", row.get("name"))): row for row in TABLE if "within" not in row}
ICE = {name: row for name, row in ROWS.items() if "ice" in row["track"]["model"]}
OPEN = {"31", "111"}
"""Left open: the velocity is within 2e-5 of √(g·depth); three contacts a few centimetres apart on one rigid body."""
QUICK = {"ice, below the wave speed", "79", "95", "103", "127", "159", "183"}


@pytest.mark.parametrize(
    "name", [name if name in QUICK else pytest.param(name, marks=pytest.mark.slow) for name in ICE]
)
def test_counts_and_roots_are_those_of_the_table(name: str) -> None:
    row = ICE[name]
    found = certify(as_problem(row), region="unstable", digits=15)
    if name in OPEN and not found.proved:
        assert found.reason is not None
        return
    assert (found.status, found.count) == (Status.PROVED, row["count"]), found.reason
    mine = sorted((root.q for root in found.roots if root.q.real > 0), key=lambda q: float(q.real))
    table = sorted((float(re), float(im)) for re, im in row["roots"] if float(re) > 1e-9)
    assert len(mine) == len(table)
    for q, (re, im) in zip(mine, table, strict=True):
        assert abs(complex(q) - complex(re, im)) < 1e-7 * abs(complex(re, im))


def test_a_piece_that_ends_at_zero_must_be_short_enough() -> None:
    """The verifier tells the p-roots apart on the disc round q = 0 by itself."""
    ice = tracks.FloatingIce(B="5e7", h="0.6", rho_ice=917, rho_water=1025, depth="6.8", g="9.8", c=10, eta="0.01")
    problem = Problem(ice, vehicles.Oscillator(wheel=1000, body=50000, k="1e5", c=1000), v=20)
    found = certify(problem, region="unstable", digits=15)
    assert (found.status, found.unstable) == (Status.PROVED, 2)
    assert found.certificate is not None
    content = found.certificate.content
    link, turn, *rest = content["paths"]
    assert link["points"][-1] == turn["points"][0] == [0, 0, 0]
    far_link = link | {"points": [link["points"][0], link["points"][-1]]}
    far_turn = turn | {"points": [turn["points"][0], *turn["points"][len(turn["points"]) // 2 :]]}
    for paths in ([far_link, turn, *rest], [link, far_turn, *rest]):
        verdict = verify_bytes(as_file(content | {"paths": paths}))
        assert not verdict.valid
        assert "p-roots are not told apart" in verdict.reason
