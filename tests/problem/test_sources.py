"""Where the numbers of a file come from."""

from __future__ import annotations

from pathlib import Path

import pytest

from mpsolve.errors import InputError
from mpsolve.problem.inputfile import read_problem
from mpsolve.problem.sources import sources_of

RAIL = Path("examples/rail_60e1.toml")


def test_file_track_and_vehicles_each_once() -> None:
    vehicle = {"source": ["a paper", "measured\n  by us."]}
    content = {"source": "a book", "track": {"source": "a plan"}, "vehicle": [vehicle, {}, vehicle]}
    assert sources_of(content) == ("a book", "Track: a plan", "Vehicle: a paper", "Vehicle: measured by us")
    assert sources_of({"track": 3, "vehicle": {}}) == ()


@pytest.mark.parametrize("given", [3, [""], ["a", 1], {}])
def test_what_is_no_text(given: object) -> None:
    with pytest.raises(InputError, match=r"^vehicle\[2\]\.source: is .*: write source"):
        sources_of({"vehicle": [{}, {"source": given}]})


def test_a_file_of_the_papers_beam_has_one_too(tmp_path: Path) -> None:
    file = tmp_path / "rail.toml"
    file.write_text('source = "a catalogue of rails"\n' + RAIL.read_text("utf-8"), "utf-8")
    assert read_problem(file).sources == ("a catalogue of rails",)
    assert read_problem(RAIL).sources == ()
