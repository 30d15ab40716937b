"""Sentences about a range keep the user's unit, and their sides are decided in balls."""

from __future__ import annotations

from fractions import Fraction

from flint import arb

from mpsolve import Problem, tracks, vehicles
from mpsolve.problem.over import parse_over
from mpsolve.report.over_words import margin, onset_at, stable_throughout, unstable_from_start

PROBLEM = Problem(tracks.String(T=20000, m=1, k=1), vehicles.Mass(2), v="360 km/h")
OVER = parse_over("v=50..540km/h", PROBLEM)
VALUE = arb("128.76650396484716714906889295", "1e-20")


def test_verdicts() -> None:
    assert onset_at(OVER, VALUE, arb("12.140573863")) == (
        "STABLE for v from 50 km/h to 463.6 km/h, where a vibration at 1.932 Hz begins to grow."
    )
    assert onset_at(OVER, VALUE, arb(0)).endswith("where a deflection begins to grow.")
    assert stable_throughout(OVER) == "STABLE for every v from 50 km/h to 540 km/h."
    assert stable_throughout(parse_over("v=50km/h..", PROBLEM)) == "STABLE for every v from 50 km/h on."
    assert unstable_from_start(OVER) == "UNSTABLE already at v = 50 km/h, where the range begins."


def test_margins() -> None:
    assert margin(OVER, VALUE, Fraction(100)) == "v is 360 km/h, 103.6 km/h (22.3 %) below the onset."
    assert margin(OVER, VALUE, Fraction(139)).startswith(
        "v is 500.4 km/h, 36.84 km/h (7.95 %) above the onset: certify"
    )
    assert margin(OVER, arb(100, 1), Fraction(100)) == "v is 360 km/h, which cannot be told from the onset."
