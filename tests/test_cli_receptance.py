"""The options of receptance with units, against the same numbers without."""

from __future__ import annotations

import csv
import io
import json
from math import pi
from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli

EXAMPLES = Path(__file__).parents[1] / "examples"
BOGIE, PLAIN = EXAMPLES / "two_layer_bogie.toml", EXAMPLES / "dimensionless.toml"


def table(*arguments: str) -> list[dict[str, str]]:
    result = CliRunner().invoke(cli, ["receptance", *arguments])
    assert result.exit_code == 0, result.output
    lines = [line for line in result.stdout.splitlines() if not line.startswith("#")]
    return list(csv.DictReader(io.StringIO("\n".join(lines))))


def test_hertz_and_centimetres() -> None:
    spoken = table(str(BOGIE), "--omega", "10 Hz,20 Hz,3", "--xi", "0,150 cm")
    plain = table(str(BOGIE), "--omega", f"{20 * pi!r},{40 * pi!r},3", "--xi", "0,1.5")
    assert len(spoken) == len(plain)
    for a, b in zip(spoken, plain, strict=True):
        assert a.keys() == b.keys()
        for key in a:
            assert float(a[key]) == pytest.approx(float(b[key]), rel=1e-9)


@pytest.mark.parametrize(
    ("file", "omega", "xi", "said"),
    [
        (BOGIE, "1 m,2,3", "0", "--omega: is '1 m', whose unit is m"),
        (BOGIE, "1,2,3", "1 kg", "--xi: is '1 kg', whose unit is kg"),
        (PLAIN, "1 Hz,2,3", "0", "--omega: is '1 Hz'"),
    ],
)
def test_wrong_units(file: Path, omega: str, xi: str, said: str) -> None:
    result = CliRunner().invoke(cli, ["receptance", str(file), "--omega", omega, "--xi", xi])
    assert result.exit_code == 2
    assert said in result.stderr


def test_a_name_in_json_is_enough(tmp_path: Path) -> None:
    file = tmp_path / "contacts.json"
    words = ["receptance", str(BOGIE), "--omega", "10,20,2", "--contacts", "-o", str(file)]
    assert CliRunner().invoke(cli, words).exit_code == 0
    assert json.loads(file.read_text("utf-8"))["contacts"]["places"] == [-1.28, 1.28]
