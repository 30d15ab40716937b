"""The listing shows every parameter of every model as its class describes it, and an example that runs."""

from __future__ import annotations

import re

import pytest
from click.testing import CliRunner

from mpsolve import tracks, vehicles
from mpsolve.cli import cli
from mpsolve.errors import InputError
from mpsolve.numbers.model import quantities
from mpsolve.report.models import listing

MODELS = [*tracks.CATALOGUE, *vehicles.CATALOGUE]


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.name)
def test_every_parameter_is_shown(model: type) -> None:
    text = listing(model.name)
    assert text.split("\nRail tracks:")[0] in listing()
    assert model.drawing.rstrip("\n") in text
    for name, quantity in quantities(model).items():
        (line,) = re.findall(rf"^  {name} .*(?:must be given|left out).*$", text, flags=re.MULTILINE)
        assert quantity.meaning in line
        assert (quantity.unit or "–") in line
    assert max(map(len, text.splitlines())) <= 118


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.name)
def test_the_drawing_names_the_parameters(model: type) -> None:
    """All but those that the other words of the drawing stand for."""
    words = set(re.findall(r"\w+", model.drawing))
    named = {name for name in quantities(model) if name in words}
    assert len(named) >= len(quantities(model)) / 3


def test_what_is_said_of_bounds() -> None:
    text = listing("two-layer")
    assert re.search(r"k_pad +N/m² +stiffness of the pads +must be given, above 0", text)
    assert re.search(r"N +N +axial force in the rail, compression positive +0 if left out\n", text)
    assert re.search(r"g +m/s² +acceleration of gravity +9.80665 if left out, above 0", listing("floating-ice"))


def test_rails_are_told_to_be_one() -> None:
    said = "everything for one rail and per metre of it: half a sleeper"
    assert said in listing()
    assert [model.name for model in MODELS if said in listing(model.name)] == [
        model.name for model in tracks.CATALOGUE if model.name not in ("string", "floating-ice")
    ]


def test_the_command() -> None:
    run = CliRunner().invoke
    assert run(cli, ["models"]).output == listing()
    assert run(cli, ["models", "bogie"]).output == listing("bogie")
    result = run(cli, ["models", "bogey"])
    assert (result.exit_code, "did you mean bogie?" in result.output) == (2, True)
    with pytest.raises(InputError, match="the models are string"):
        listing("?")
