"""What a certificate of version 2 carries: the equations as they are meant, and exact numbers in the user's units."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Problem, certify, tracks, vehicles
from mpsolve.certificate.verify2 import verify_bytes

LAYERS = tracks.TwoLayer("6380430", "60.2", "300e6", "3e4", "250", "100e6", "8e4")
PAIR = Problem(LAYERS, [vehicles.Mass(900), vehicles.Mass(900).at("2.5")], v=680)


@pytest.fixture(scope="module")
def content() -> dict[str, Any]:
    return json.loads(certify(PAIR, region="unstable", digits=20, check=False).certificate.text)


def dyadic(value: list[int]) -> Fraction:
    return Fraction(value[0]) * Fraction(2) ** value[1]


def point(value: list[int]) -> tuple[Fraction, Fraction]:
    m, n, e = value
    return Fraction(m) * Fraction(2) ** e, Fraction(n) * Fraction(2) ** e


def test_the_equations_are_those_of_the_problem(content: dict[str, Any]) -> None:
    found = content["equations"]
    matrix = LAYERS.waveguide.matrix
    for row, given in zip(found["track"]["matrix"], matrix, strict=True):
        for entry, polynomial in zip(row, given, strict=True):
            assert {(i, j): Fraction(c) for i, j, c in entry} == polynomial
    assert Fraction(found["velocity"]) == 680
    assert [[Fraction(x) for x in row] for row in found["vehicle"]["M"]] == [[900, 0], [0, 900]]
    assert [Fraction(x) for x in found["vehicle"]["places"]] == [0, Fraction(5, 2)]
    assert "two-layer" not in json.dumps(content)


def test_paths_join_and_roots_are_near_what_is_known(content: dict[str, Any]) -> None:
    kinds = [path["kind"] for path in content["paths"]]
    assert kinds == ["link", "turn", "passive", "passive"]
    ends = [(Fraction(0), -dyadic(content["start"]))]
    for path in content["paths"]:
        points = [point(value) for value in path["points"]]
        assert points[0] in ends
        ends.append(points[-1])
    assert content["claim"]["count"] == content["claim"]["unstable"] == 2
    root = content["roots"][0]
    scale = Fraction(2) ** root["exponent"]
    assert root["pair"]
    assert float(int(root["re"], 16) * scale) == pytest.approx(501.2, rel=1e-3)
    assert float(int(root["im"], 16) * scale) == pytest.approx(-1.57, rel=1e-2)
    assert 0 < dyadic(root["radius"]) < Fraction(1, 10**17)


def test_units_do_not_matter(content: dict[str, Any]) -> None:
    """The theorem's numbers belong to the equations: with kN for N only stiffness against force changes, by 1000."""
    kilo = tracks.TwoLayer("6380.430", "0.0602", "300e3", "30", "0.25", "100e3", "80")
    light = Problem(kilo, [vehicles.Mass("0.9"), vehicles.Mass("0.9").at("2.5")], v=680)
    other = json.loads(certify(light, region="unstable", digits=20, check=False).certificate.text)
    assert other["claim"] == content["claim"]
    root, same = content["roots"][0], other["roots"][0]
    assert int(root["re"], 16) * Fraction(2) ** root["exponent"] == pytest.approx(
        float(int(same["re"], 16) * Fraction(2) ** same["exponent"]), rel=1e-15
    )


BEAM = {"EI": "1/4", "m": 1, "k": 1}
CLOSE: dict[str, tuple[Any, str, list[object], list[object]]] = {  # contacts that the track hardly tells apart
    "a beam": (
        tracks.EulerBernoulli(**BEAM, c="0.9569"), "1.594",
        ["12.52", "2.534", "0.7774"], [0, "4.351", "5.36"],
    ),
    "a damped rail": (
        tracks.EulerBernoulli(**BEAM, c="0.8045", eta="0.001592"), "0.5049",
        [70, 29, "3.5"], [0, "0.205", "0.5814"],
    ),
    "a Rayleigh beam": (
        tracks.Rayleigh(**BEAM, c="0.7697", J="0.3446"), "0.8464",
        ["0.2236", "0.1134", "37.47", "98.44"], [0, "0.4346", "0.6386", "1.7896"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CLOSE)
def test_what_is_proved_without_the_verifier_passes_it(name: str) -> None:
    track, v, masses, places = CLOSE[name]
    found = certify(
        Problem(track, [vehicles.Mass(M).at(x) for M, x in zip(masses, places, strict=True)], v=v),
        region="unstable", digits=15, check=False,
    )  # fmt: skip
    assert found.certificate is not None
    verdict = verify_bytes(found.certificate.text.encode("ascii"))
    assert verdict.valid, verdict.reason
