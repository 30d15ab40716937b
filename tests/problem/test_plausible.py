"""Values in kN, mm and t are told from those in SI; nothing that is shipped is doubted."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from mpsolve import Problem, read_problem, tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.presets.written import input_file, names
from mpsolve.problem.plausible import implausible
from mpsolve.problem.warned import warned
from mpsolve.report.ranges_asked import asked

TRACK: dict[str, Any] = {
    "EI": "6.4e6", "m": 60, "k_pad": "3e8", "c_pad": "3e4", "m_sleeper": 250, "k_ballast": "1e8", "c_ballast": "8e4",
}  # fmt: skip
BOGIE: dict[str, Any] = {"wheel": 650, "frame": 1000, "inertia": 700, "wheelbase": "1.8", "k": "1.2e6", "c": 5000}
EXAMPLES = Path(__file__).parents[2] / "examples"


def problem(track: dict[str, Any], bogie: dict[str, Any]) -> Problem:
    return Problem(tracks.TwoLayer(**{**TRACK, **track}), [vehicles.Bogie(**{**BOGIE, **bogie}).at(0)], v=50)


def keys(given: Problem) -> list[str]:
    return [key.removeprefix("track.") for reason in implausible(given) for key in reason.numbers]


def test_numbers_in_kilonewtons_millimetres_and_tonnes() -> None:
    assert keys(problem({}, {})) == []
    wrong = problem({"k_pad": 200, "k_ballast": 50}, {"wheel": "0.65", "frame": 1, "wheelbase": 1800, "k": 1200})
    assert keys(wrong) == ["k_pad", "k_ballast", "wheel", "frame", "wheelbase", "k"]
    assert {"track.k_pad", "track.k_ballast"} <= {key for reason in warned(wrong) for key in reason.numbers}


def test_masses_in_tonnes_and_layers_a_thousand_times_too_soft() -> None:
    assert keys(problem({"m": "0.06", "m_sleeper": "0.25"}, {})) == ["m", "m_sleeper"]
    soft = {key: str(float(TRACK[key]) / 1000) for key in ("EI", "k_pad", "c_pad", "k_ballast", "c_ballast")}
    assert keys(problem(soft, {})) == ["EI", "k_pad", "c_pad", "k_ballast", "c_ballast"]


@pytest.mark.parametrize(
    ("track", "bogie", "said"),
    [
        ({"k_pad": 120}, {}, 'write k_pad = "120 MN/m²", if that is meant; what one rail seat has is divided by'),
        ({}, {"wheelbase": 1800}, 'write wheelbase = "1800 mm"'),
        ({}, {"wheel": "0.65"}, "the bogie's wheel is 0.65 kg, but any mass of one wheelset on one rail known here"),
        ({}, {"k": 1200}, 'write k = "1200 kN/m"'),
    ],
)
def test_the_sentence_names_the_key_and_what_is_meant(track: Any, bogie: Any, said: str) -> None:
    (reason,) = implausible(problem(track, bogie))
    assert said in str(reason)


def test_a_parameter_that_is_left_free_is_not_doubted() -> None:
    """A range over it says what is meant."""
    wrong = problem({"k_pad": 200}, {})
    for path, doubted in (("v=10..20", True), ("track.k_pad=1e8..2e8", False)):
        codes = [reason.code for reason in asked(wrong, "", [path]).warnings]
        assert ("value-unlikely" in codes) is doubted


def test_the_bogie_under_a_coach_is_looked_at() -> None:
    coach = vehicles.Coach(
        body=20000, inertia="8e5", pivots="17.5", k2="4e5", c2="4e4", bogie=vehicles.Bogie(**{**BOGIE, "frame": 1})
    )
    (reason,) = implausible(Problem(tracks.TwoLayer(**TRACK), [coach.at(0)], v=50))
    assert str(reason).startswith("the coach's bogie.frame is 1 kg")


def test_no_preset_and_no_example_is_doubted(tmp_path: Path) -> None:
    looked = 0
    for track in names("track"):
        for vehicle in names("vehicle"):
            try:
                text = input_file(track, vehicle)
            except InputError:  # it does not run there
                continue
            file = tmp_path / f"{track}-{vehicle}.toml"
            file.write_text(text, "utf-8")
            assert not [*implausible(read_problem(file).problem)], file.stem
            looked += 1
    for file in EXAMPLES.rglob("*.toml"):
        try:
            given = read_problem(file)
        except InputError:  # a table or a study
            continue
        assert "value-unlikely" not in [reason.code for reason in warned(given.given)], file.stem
        looked += 1
    assert looked > 30
