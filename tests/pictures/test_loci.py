"""The picture of root loci: a curve for each line, in the user's unit, and a mark at each crossing."""

import xml.etree.ElementTree as ET

from free_cases import BEAM, PAIR

from mpsolve import Problem
from mpsolve.loci.lines import frequency_lines
from mpsolve.pictures.loci import loci_picture
from mpsolve.report.ranges_asked import asked


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
