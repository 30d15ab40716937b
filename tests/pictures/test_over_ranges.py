"""The picture of a box under proof: a rectangle for each open part, a mark at the counterexample, a panel a pair."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from fractions import Fraction

import pytest
from free_cases import BEAM, PAIR

from mpsolve import Problem
from mpsolve.loci.lines import frequency_lines
from mpsolve.outcome import Reason, Status
from mpsolve.pictures.over_ranges import loci_picture, open_boxes
from mpsolve.ranges.robust_answer import Robust
from mpsolve.report.ranges_asked import asked

PROBLEM = Problem(BEAM, PAIR, v="0.5")
RANGES = ["v=1.8..2.16 km/h", "track.k=0.9..1.1", "track.c=0.05..0.15"]
OPEN = Reason("effort", "the effort is spent", {}, "")


def drawn(number: int, **known: object) -> tuple[ET.Element, list[str], list[ET.Element]]:
    question = asked(PROBLEM, "", RANGES[:number])
    found = Robust(PROBLEM, question.over, Status.UNDECIDED, OPEN, **known)  # type: ignore[arg-type]
    root = ET.fromstring(open_boxes(found, question))
    words = [one.text or "" for one in root.iter() if one.tag.endswith("text")]
    return root, words, [one for one in root.iter() if one.get("class") == "hatch"]


@pytest.mark.parametrize(("number", "panels"), [(1, 1), (2, 1), (3, 3)])
def test_a_part_stands_where_its_values_are(number: int, panels: int) -> None:
    part = {"v": (Fraction("0.55"), Fraction("0.6")), "track.k": (Fraction(1), Fraction("1.1"))}
    part |= {"track.c": (Fraction("0.05"), Fraction("0.15"))}
    root, words, parts = drawn(number, open=({path: part[path] for path in list(part)[:number]},))
    assert len(parts) == panels
    assert "v, km/h" in [word.replace("velocity", "v") for word in words]
    assert words.count("Open parts of the ranges: 1") == panels
    (frame, *_) = (one for one in root.iter() if one.get("class") == "frame")
    left, wide = float(frame.get("x") or 0), float(frame.get("width") or 0)
    assert float(parts[0].get("x") or 0) == pytest.approx(left + wide / 2, abs=0.1)
    assert float(parts[0].get("width") or 0) == pytest.approx(wide / 2, abs=0.1)
    assert words.count("this case") == panels


def test_the_counterexample_is_marked() -> None:
    point = {"v": Fraction("0.58"), "track.k": Fraction("0.95")}
    _, words, parts = drawn(2, stable=False, counterexample=point)
    assert not parts
    assert "unstable here" in words
    assert "Unstable at the point that is marked" in words


def test_lines_and_crossings_are_drawn() -> None:
    problem = Problem(BEAM, PAIR, v="0.7")
    question = asked(problem, "", ["v=2.16..2.88 km/h"])
    found = frequency_lines(problem, over=question.over, points=5, check=False)
    picture = loci_picture(found, question)
    root = ET.fromstring(picture)
    words = [element.text or "" for element in root.iter() if element.tag.endswith("text")]
    assert "v, km/h" in words
    assert sum(word.startswith("line ") for word in words) == len(found.lines) == 2
    (crossing,) = [one for line in found.lines for one in line.crossings]
    assert f"{float(crossing.value) * 3.6:.4g} km/h" in words
