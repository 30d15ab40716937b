"""The command `explore`: what it says before its page opens."""

from __future__ import annotations

import sys
from types import SimpleNamespace
from typing import Any

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli

BOGIE = "examples/two_layer_bogie.toml"


def test_the_file_is_read_and_served(monkeypatch: pytest.MonkeyPatch) -> None:
    served: list[Any] = []
    page = SimpleNamespace(serve=lambda *given: served.append(given))
    monkeypatch.setitem(sys.modules, "mpsolve.explorer.page", page)
    done = CliRunner().invoke(cli, ["explore", BOGIE, "--port", "8123", "--no-browser"])
    assert (done.exit_code, done.stdout) == (0, "http://127.0.0.1:8123  (Ctrl-C ends it)\n")
    ((problem, title, port, browser),) = served
    assert (problem.v, port, browser) == (100, 8123, False)
    assert title.startswith("A bogie")


def test_a_missing_extra_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(sys.modules, "mpsolve.explorer.page", raising=False)
    monkeypatch.setitem(sys.modules, "nicegui", None)
    done = CliRunner().invoke(cli, ["explore", BOGIE])
    assert done.exit_code == 2
    assert done.stderr == (
        "mpsolve: explore: needs NiceGUI, which is not installed: pip install 'mpsolve[explore]'\n"
    )


def test_a_port_that_is_none() -> None:
    done = CliRunner().invoke(cli, ["explore", BOGIE, "--port", "70000"])
    assert done.exit_code == 2
    assert done.stderr == "mpsolve: --port: is 70000: give a whole number from 1 to 65535\n"
