"""Words about roots and proofs."""

from __future__ import annotations

from fractions import Fraction

from mpsolve import certify, read_problem
from mpsolve.explorer.proving import Proving
from mpsolve.explorer.words import region_told, told, vibration

PROBLEM = read_problem("examples/two_layer_bogie.toml").problem


def test_a_vibration_grows_or_decays() -> None:
    assert vibration(62.831853 - 0.1j) == "10 Hz, doubles every 6.93 s"
    assert vibration(62.831853 + 0.1j) == "10 Hz, decays at 0.1 1/s"


def test_a_proof_and_its_region() -> None:
    answer = certify(PROBLEM, region="unstable", digits=15)
    assert told(answer).startswith("STABLE")
    assert "verifier confirms" in told(answer)
    assert len(told(answer).splitlines()) < 8  # no equations
    proving = Proving(PROBLEM)
    assert region_told(proving) == ""
    proving.region = {"v": (Fraction(50), Fraction(150)), "vehicles[0].wheel": (Fraction(1, 3), Fraction(2))}
    assert "v from 50 to 150 and vehicles[0].wheel from 0.33333 to 2: proved" in region_told(proving)
