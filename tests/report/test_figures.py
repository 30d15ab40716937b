"""Figures in files: the same each time, whatever the user's settings are, and none where none can be."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from mpsolve.errors import CertificateError, InputError
from mpsolve.report.figures import COLOUR, save_figure


def _lines(ax: Any) -> Any:
    for k in range(3):
        ax.plot([0, 1], [k, 2 - k], **COLOUR.line(k), label=f"line {k}")
    ax.plot(0.5, 0.5, **COLOUR.root(True))
    return ax


@pytest.mark.parametrize("kind", ["svg", "pdf", "png"])
def test_files_are_the_same_each_time(kind: str, tmp_path: Path) -> None:
    first, second = (save_figure(_lines, tmp_path / f"{name}.{kind}").read_bytes() for name in "ab")
    assert first == second
    assert len(first) > 2000


def test_names_that_cannot_be_written(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"does not end in \.svg, \.pdf, \.png"):
        save_figure(lambda ax: ax, tmp_path / "a.gif")
    with pytest.raises(CertificateError, match="cannot be written"):
        save_figure(lambda ax: ax, tmp_path / "none" / "a.svg")


def test_the_user_s_settings_change_nothing(tmp_path: Path) -> None:
    import matplotlib as mpl

    plain = save_figure(_lines, tmp_path / "a.svg").read_bytes()
    with mpl.rc_context({"font.size": 20, "lines.linewidth": 9, "axes.facecolor": "red"}):
        assert save_figure(_lines, tmp_path / "b.svg").read_bytes() == plain
        assert mpl.rcParams["font.size"] == 20
