"""The command `schema` prints the schemas that the library makes."""

from __future__ import annotations

import json

from click.testing import CliRunner

from mpsolve.cli import cli
from mpsolve.schemas.catalogue import CATALOGUE, listing


def test_all() -> None:
    for name, (_, make) in CATALOGUE.items():
        result = CliRunner().invoke(cli, ["schema", name])
        assert result.exit_code == 0
        assert json.loads(result.stdout) == make()
    assert CliRunner().invoke(cli, ["schema"]).stdout == listing()


def test_another() -> None:
    result = CliRunner().invoke(cli, ["schema", "poem"])
    assert (result.exit_code, result.stdout) == (2, "")
    assert "which is unknown" in result.stderr
