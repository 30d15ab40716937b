"""What is written can be read, means what the source says, and `certify` proves it or says why not."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from mpsolve import Effort, InputError, Problem, certify, read_problem, tracks, vehicles
from mpsolve.numbers.model import quantities
from mpsolve.presets.written import begun, input_file, listing, names, preset, problem_of

PAIRS = [(name, None) for name in names("track")]
PAIRS += [("ballasted", name) for name in ("shinkansen", "stem", "two-masses", "wheelset", "freight-bogie")]


def read(tmp_path: Path, text: str) -> Problem:
    file = tmp_path / "new.toml"
    file.write_text(text, "utf-8")
    return read_problem(file).problem


@pytest.mark.parametrize(("track", "vehicle"), PAIRS)
def test_certify_proves_it(tmp_path: Path, track: str, vehicle: str | None) -> None:
    text = input_file(track, vehicle)
    assert all(len(line) <= 150 for line in text.splitlines())
    found = certify(read(tmp_path, text), region="unstable", digits=15, effort=Effort(seconds=60))
    assert found.proved
    assert found.stable


def test_half_a_vehicle_is_on_one_rail(tmp_path: Path) -> None:
    """The same numbers as in examples/train_8_coaches.toml, which halves them by hand."""
    own = read(tmp_path, input_file("ballasted", "manchester", "252 km/h", 8, "25 m"))
    assert own == read_problem(Path(__file__).parents[2] / "examples" / "train_8_coaches.toml").problem


def test_the_whole_vehicle_is_on_both_rails(tmp_path: Path) -> None:
    whole = read(tmp_path, input_file("slab", "stem")).vehicles[0].vehicle
    assert isinstance(whole, vehicles.Coach)
    assert (whole.body, whole.bogie.wheel, whole.k2, whole.pivots) == (50_000, 3000, 5_416_000, Fraction(199, 10))


def test_the_track_of_zhai_is_that_of_its_rail_seats(tmp_path: Path) -> None:
    seat = Fraction(6, 10)
    track = read(tmp_path, input_file("zhai-2004")).track
    assert track == tracks.ThreeLayer(
        EI=Fraction("2.059e11") * Fraction("3.217e-5"),
        m="60.64",
        k_pad=Fraction("6.5e7") / seat,
        c_pad=Fraction("7.5e4") / seat,
        m_sleeper=Fraction("125.5") / seat,
        k_ballast=Fraction("137.75e6") / seat,
        c_ballast=Fraction("5.88e4") / seat,
        m_ballast=Fraction("531.4") / seat,
        k_ground=Fraction("77.5e6") / seat,
        c_ground=Fraction("3.115e4") / seat,
    )


def test_what_does_not_belong_together_is_refused() -> None:
    with pytest.raises(InputError, match="take another, such as pantograph"):
        input_file("contact-wire", "manchester")
    with pytest.raises(InputError, match="whose unit is m, but the velocity is in m/s"):
        input_file("ballasted", v="300 km")
    with pytest.raises(InputError, match="whole number from 1"):
        input_file("ballasted", count=0)


def test_the_list_names_everything() -> None:
    assert all(name in listing() for name in (*names("track"), *names("vehicle")))


def test_nothing_is_of_one_rail_where_both_are_meant() -> None:
    for track in ("slab", "embankment", "contact-wire", "ice-road"):
        assert "one rail" not in input_file(track), track
    assert "mass of one wheelset on one rail" in input_file("ballasted")


ALL = [(kind, name) for kind in ("track", "vehicle") for name in names(kind)]


def test_what_there_is() -> None:
    asked = {"ballasted", "slab", "embankment", "contact-wire", "crane", "ice-road", "paper", "zhai-2004"}
    assert set(names("track")) == asked
    assert {"manchester", "shinkansen", "stem", "pantograph", "two-masses"} <= set(names("vehicle"))


@pytest.mark.parametrize(("kind", "name"), ALL)
def test_each_says_where_its_numbers_come_from(kind: str, name: str) -> None:
    one = preset(kind, name)  # type: ignore[arg-type]
    assert one.title
    assert all(len(source) > 20 for source in one.sources)
    assert one.on in ("rail", "track", "wire", "ice")
    catalogue = tracks.CATALOGUE if kind == "track" else vehicles.CATALOGUE
    model = next(model for model in catalogue if model.name == one.model["model"])
    known = {"model", *quantities(model)}
    assert set(one.model) <= known
    for key in one.notes:
        section = one.model
        *inside, last = key.split(".")
        for part in inside:
            section = section[part]
        assert last in section, f"the note {key} belongs to nothing"
    if kind == "track":
        assert one.v
        assert preset("vehicle", one.vehicle).on in (one.on, "track", "rail")


def test_the_numbers_of_the_manchester_benchmark() -> None:
    """As printed in TTB-2D's TrainProp_Manchester_BenchMark.m: 1200e3*2, 430e3*2, 1.28*2, 9.5*2."""
    model = preset("vehicle", "manchester").model
    assert (model["body"], model["inertia"], model["pivots"]) == ("32000 kg", "1970000 kg m²", "19 m")
    assert (model["k2"], model["c2"]) == ("860 kN/m", "40 kN s/m")
    assert model["bogie"]["k"] == "2400 kN/m"


def test_a_name_that_there_is_not() -> None:
    with pytest.raises(InputError, match="did you mean ballasted"):
        preset("track", "balasted")
    with pytest.raises(InputError, match="there are freight-bogie, manchester"):
        preset("vehicle", "xyz")


def test_a_model_is_no_preset() -> None:
    with pytest.raises(
        InputError, match="vehicle: is 'bogie', which is a model, not a preset: see mpsolve models bogie"
    ):
        preset("vehicle", "bogie")
    with pytest.raises(InputError, match="track: is 'two-layer', which is a model"):
        preset("track", "two-layer")


def test_a_file_and_a_preset() -> None:
    problem, title = begun(Path("examples/two_layer_bogie.toml"))
    assert problem.v == 100
    assert "bogie" in title
    assert begun(None)[0].track.parameters


def test_a_file_that_is_none(tmp_path: Path) -> None:
    with pytest.raises(InputError):
        begun(tmp_path / "none.toml")


def test_a_preset_with_another_vehicle() -> None:
    usual, other = problem_of("ballasted")[0], problem_of("ballasted", "shinkansen")[0]
    assert usual.track == other.track
    assert usual.pencil.M != other.pencil.M


@pytest.mark.parametrize(("given", "said"), [({"v": "-300 km/h"}, "v: is -300 km/h: give"), ({"v": ""}, "v: ''"),
                                            ({"count": 2, "spacing": ""}, "spacing: ''")])  # fmt: skip
def test_no_file_is_written_that_cannot_be_used(given: dict[str, Any], said: str) -> None:
    """A negative velocity was written; an empty one was left out without a word."""
    with pytest.raises(InputError, match=said):
        input_file("ballasted", **given)
