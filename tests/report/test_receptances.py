"""Tables of receptances hold what `receptance` gives, in CSV and JSON, and matrices that are inverses."""

from __future__ import annotations

import csv
import io
import json

import numpy as np
import pytest

from mpsolve import InputError, Problem, receptance, tracks, vehicles
from mpsolve.report.receptances import receptances

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c="1/3")
PROBLEM = Problem(TRACK, [vehicles.Mass(900).at(0), vehicles.Mass(900).at("2.5")], v=40)
XI, OMEGA = (0.0, 1.5), (10.0, 20.0, 30.0)


def test_csv_has_every_digit_and_its_units() -> None:
    table = receptances(PROBLEM, "", XI, OMEGA, si=True)
    rows = list(csv.DictReader(io.StringIO(table.to_csv())))
    G = receptance(TRACK, XI, OMEGA, v=40)
    assert [complex(float(row["re_G(1.5) [m/N]"]), float(row["im_G(1.5) [m/N]"])) for row in rows] == G[1].tolist()
    assert [float(row["omega [rad/s]"]) for row in rows] == list(OMEGA)


def test_json_names_the_track_exactly_and_has_the_matrices() -> None:
    content = json.loads(receptances(PROBLEM, "T", XI, OMEGA, contacts=True).to_json())
    assert content["track"] == {"model": "euler-bernoulli", "EI": "6.4e+6", "m": "60", "k": "1e+6", "c": "1/3",
                                "kp": "0", "N": "0", "eta": "0"}  # fmt: skip
    matrices = {name: np.array(content["contacts"][name]) for name in ("G_re", "G_im", "K_re", "K_im")}
    G, K = matrices["G_re"] + 1j * matrices["G_im"], matrices["K_re"] + 1j * matrices["K_im"]
    assert np.allclose(G @ K, np.eye(2), atol=1e-12)
    behind, own, ahead = receptance(TRACK, (-2.5, 0, 2.5), OMEGA, v=40)
    assert np.allclose(G[:, 0, 1], behind)
    assert np.allclose(G[:, 1, 0], ahead)
    assert np.allclose(G[:, 1, 1], own)


def test_two_contacts_at_a_place_have_no_matrix() -> None:
    twice = Problem(TRACK, [vehicles.Mass(900).at(0), vehicles.Mass(800).at(0)], v=40)
    with pytest.raises(InputError, match="no inverse"):
        receptances(twice, "", XI, OMEGA, contacts=True)
