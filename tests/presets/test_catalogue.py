"""Every preset is complete, says where its numbers come from, and has the numbers of its source."""

from __future__ import annotations

import pytest

from mpsolve import tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.numbers.model import quantities
from mpsolve.presets.catalogue import names, preset

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
