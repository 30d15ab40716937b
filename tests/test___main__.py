"""`python -m mpsolve` is the command."""

from __future__ import annotations

import runpy
import sys

import pytest

from mpsolve import __version__


@pytest.mark.parametrize(
    ("words", "status", "said"), [(["--version"], 0, f"mpsolve {__version__}\n"), (["no"], 2, "")]
)
def test_the_module_is_the_command(
    words: list[str], status: int, said: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["mpsolve", *words])
    with pytest.raises(SystemExit) as ended:
        runpy.run_module("mpsolve", run_name="__main__")
    out, err = capsys.readouterr()
    assert (ended.value.code, out) == (status, said)
    assert err.startswith("mpsolve: no: is no command") or not status
