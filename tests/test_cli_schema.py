"""The command `schema` prints the schemas that the library makes."""

from __future__ import annotations

import json

from click.testing import CliRunner

from mpsolve.cli import cli
from mpsolve.problem.schema import input_schema
from mpsolve.report.schema import certify_schema


def test_both() -> None:
    for what, made in (("input", input_schema()), ("certify", certify_schema())):
        result = CliRunner().invoke(cli, ["schema", what])
        assert result.exit_code == 0
        assert json.loads(result.stdout) == made


def test_another() -> None:
    assert CliRunner().invoke(cli, ["schema", "poem"]).exit_code == 2
