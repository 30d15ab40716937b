"""The report on any problem: verdict first, vibrations in Hz, the problem by its models, cost and certificate."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest
from flint import acb, arb
from reported import SPRUNG, WIRE, fast, wire

from mpsolve import Case, Exact, PhysicalCase, Problem, Status, certify
from mpsolve.numbers.balls import precision
from mpsolve.numbers.result import Cost
from mpsolve.problem.problem import Problem as Asked
from mpsolve.report.spectrum_text import (
    cost_words,
    paper_rows,
    problem_rows,
    ratio_rows,
    root_rows,
    shown,
    spectrum_document,
    unit_rows,
)
from mpsolve.tracks import Slab
from mpsolve.vehicles import Mass, Vehicle


def test_the_whole_report() -> None:
    text = spectrum_document(wire(), "A wire", "a b.json").text()
    lines = text.splitlines()
    assert lines[:3] == ["A wire", "", "STABLE at 360 km/h (100 m/s): every vibration decays."]
    assert max(map(len, lines)) <= 88
    (row,) = (line.split() for line in lines if "decays, halves" in line)
    assert row == ["q1", "2.489", "-0.716", "decays,", "halves", "every", "0.9681", "s"]
    assert "q1 =  ±15.641876611743" in text
    assert ["T", "27000", "N", "(27", "kN)"] in [line.split()[:5] for line in lines]
    assert "at x = 0 m" in text
    assert "mpsolve verify 'a b.json'" in text
    assert text.index("Vibrations") < text.index("Problem") < text.index("Proved") < text.index("Cost")


def test_growing() -> None:
    text = spectrum_document(fast()).text()
    assert text.startswith("UNSTABLE at ")
    assert "GROWS, doubles" in text


def test_without_roots_there_is_a_sentence_for_the_table() -> None:
    empty = replace(wire(), roots=(), count=0)
    assert "Vibrations\n  None. Not looked at: vibrations that halve" in spectrum_document(empty).text()
    assert "Vibrations" not in spectrum_document(replace(empty, status=Status.UNDECIDED)).text()


def test_motions_that_no_contact_feels() -> None:
    text = spectrum_document(replace(wire(), unfelt=(acb(-2, 1), acb(2, 1), acb(0, 3)))).text()
    assert "±2 + 1 i" in text
    assert "0 + 3 i" in text


def test_a_case_is_shown_by_its_ratios() -> None:
    found = certify(Case(alpha="0.5", eta_b="0.05", eta_m=20), region="unstable", digits=15, check=False)
    assert "velocity ratio v/v_cr" in spectrum_document(found).text()


def test_rows_name_models_units_and_places_and_leave_out_what_is_not_given() -> None:
    rows = list(problem_rows(SPRUNG))
    assert ("v", "60 m/s (216 km/h)", "velocity") in rows
    assert ("track", "euler-bernoulli", "") in rows
    assert ("vehicle", "oscillator", "at x = 0 m") in rows
    assert any(row[0] == "  EI" and row[1] == "6400000 N m² (6.4 MN m²)" for row in rows)
    assert not any(row[0].strip() in ("kp", "N", "eta", "k_contact") for row in rows)
    own = Vehicle(M=[[1]], C=[[0]], K=[[0]], B=[[1]], places=[0])
    named = list(problem_rows(Problem(SPRUNG.track.waveguide, [own.at(2)], v=0)))
    assert ("track", "1 × 1 matrix of one's own", "") in named
    assert ("  M", "as given") in [row[:2] for row in named]
    slab = Slab(EI="6.4e6", m=60, k_pad="4e7", c_pad="3e4", EI_slab="5e7", m_slab=1500, k="5e7", c="1e5")
    assert isinstance(WIRE, Asked)
    assert ("track", "slab", "") in list(problem_rows(Problem(slab, WIRE.vehicles, v=0)))


def test_cost() -> None:
    assert cost_words(replace(wire(), cost=Cost(1.234, 0.5, 70, 12))) == (
        "1.23 s of processor time, 0.50 s to verify, 70 evaluations, 12 pieces of paths"
    )
    assert cost_words(replace(wire(), cost=Cost(0.1))) == "0.10 s of processor time"


def test_a_warning_follows_the_verdict() -> None:
    text = spectrum_document(replace(wire(), problem=Problem(WIRE.track, [Mass(8), Mass(9)], v=100))).text()
    lines = text.splitlines()
    assert lines[0].startswith("STABLE")
    assert lines[2].startswith("Warning: two vehicles, mass and mass, stand at one place, x = 0 m: give one of them")


def test_the_ratios_of_the_paper_are_folded_below() -> None:
    case = PhysicalCase(EI="6.4e6", m=60, k="1e6", c=770, v=100, masses=[(10000, 0)])
    text = spectrum_document(certify(case, digits=15, check=False)).text()
    assert "Roots q in rad/s" in text
    assert text.index("frequency [Hz]") < text.index("Proved") < text.index("velocity ratio v/v_cr")
    assert paper_rows(WIRE) == []


@pytest.mark.parametrize(("x", "said"), [("0.05", "0.05"), ("6.4e6", "6400000"), ("1/3", "≈ 0.33333333")])
def test_shown(x: str, said: str) -> None:
    assert shown(Exact(x)) == said


def test_a_beam_in_si_and_its_ratios() -> None:
    case = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=100, N=1000, masses=[(900, 0)])
    rows = {name: value for name, value, _ in unit_rows(case)}
    assert rows["v_cr"].startswith("≈ 290.39181")
    assert "v_cr′" in rows
    ratios = {name: value for name, value, _ in ratio_rows(Case(alpha="0.5", eta_b=0, eta_m=[3], positions=["1/3"]))}
    assert (ratios["α"], ratios["η_M1"]) == ("0.5", "3")


@pytest.mark.parametrize(
    ("q", "rows"),
    [(acb(2, -1), [("q1 =", "±2 - 1 i")]), (acb(0, 3), [("q1 =", "0 + 3 i")]), (acb(5, 0), [("q1 =", "±5")])],
)
def test_a_root_in_one_row(q: Any, rows: list[tuple[str, str]]) -> None:
    motion: Any = SimpleNamespace(root=SimpleNamespace(q=q))
    assert root_rows(1, motion, 15) == rows


def test_a_long_root_in_two() -> None:
    long = acb(arb(1) / 3, arb(1) / 7)
    motion: Any = SimpleNamespace(root=SimpleNamespace(q=long))
    assert [label for label, _ in root_rows(2, motion, 15)] == ["q2 ="]
    with precision(400):
        motion = SimpleNamespace(root=SimpleNamespace(q=acb(arb(1) / 3, arb(1) / 7)))
        assert [label for label, _ in root_rows(2, motion, 60)] == ["Re q2 =", "Im q2 ="]


def test_equal_vehicles_stand_there_once_with_their_places() -> None:
    """Eight coaches printed their fifteen parameters eight times."""
    track, one, other = SPRUNG.track, Mass(900), Mass(1000)
    rows = list(problem_rows(Problem(track, [one.at(0), other.at(4), one.at("2.5")], v=60)))
    assert [row for row in rows if row[0] == "vehicle"] == [
        ("vehicle", "mass", "at x = 0, 2.5 m"),
        ("vehicle", "mass", "at x = 4 m"),
    ]
    assert [row[1] for row in rows if row[0] == "  M"] == ["900 kg", "1000 kg (1 t)"]
