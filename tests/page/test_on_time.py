"""The page comes back within its time, whatever the file holds: measured from outside, start and writing included."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from mpsolve.presets.written import input_file

pytestmark = pytest.mark.skipif(not hasattr(os, "wait4"), reason="processor time of another process")
ROOT = Path(__file__).parents[2]
SECONDS, START = 5.0, 2.5
BOGIE, RAIL, RATIOS = "two_layer_bogie", "rail_60e1", "dimensionless"
ODD = {
    "32 contacts": ("train_8_coaches", "", ""),
    "EI a million too small": (BOGIE, r"^EI = .*", "EI = 6.38"),
    "EI a million too large": (BOGIE, r"^EI = .*", "EI = 6.38e12"),
    "faster than any wave": (BOGIE, r"^v = .*", 'v = "36000 km/h"'),
    "a mass of a star": (RAIL, r"^M = .*", "M = 1e30"),
    "hardly a foundation": (RAIL, r"^k = .*", "k = 1"),
    "no damping": (RAIL, r"^c = .*", "c = 0"),
    "just below the critical damping": (RATIOS, r"^eta_b = .*", "eta_b = 0.999999999"),
}


def used(folder: Path, text: str, seconds: float) -> tuple[float, str, str]:
    """Processor seconds of the command, what it says, and the page."""
    (folder / "odd.toml").write_text(text, "utf-8")
    words = [sys.executable, "-m", "mpsolve", "report", "odd.toml", "--effort", f"{seconds:g} s", "-o", "odd.html"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    with (folder / "said").open("wb") as said:
        process = subprocess.Popen(words, cwd=folder, env=environment, stdout=said, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    spoken = (folder / "said").read_text("utf-8")
    assert process.returncode in (0, 1), spoken
    assert "Traceback" not in spoken
    assert "Warning" not in spoken
    return usage.ru_utime + usage.ru_stime, spoken, (folder / "odd.html").read_text("utf-8")


def text_of(name: str, was: str, now: str) -> str:
    text = (ROOT / f"examples/{name}.toml").read_text("utf-8")
    return re.sub(was, now, text, flags=re.MULTILINE) if was else text


def whole(page: str) -> None:
    """Every section is there; what is late is named."""
    for section in ("verdict", "limits", "model", "vibrations", "velocity", "motion", "proof", "certificates"):
        assert f'<section id="{section}"' in page
    assert page.rstrip().endswith("</html>")
    assert page.count("not in time") == 0 or "There was no time left for:" in page


@pytest.mark.slow
@pytest.mark.parametrize("odd", ODD.values(), ids=ODD)
def test_odd_files(tmp_path: Path, odd: tuple[str, str, str]) -> None:
    seconds, said, page = used(tmp_path, text_of(*odd), SECONDS)
    assert seconds < SECONDS + START, said
    whole(page)


@pytest.mark.slow
def test_two_masses_with_all_parts(tmp_path: Path) -> None:
    """All of it, as the budget of a minute leaves it, in 6 s."""
    seconds, said, page = used(tmp_path, text_of(RAIL, "", ""), 60.0)
    assert seconds < 6.0, said
    assert "There was no time left for" not in page


@pytest.mark.slow
@pytest.mark.parametrize("count", [1, 4])
def test_coaches_on_two_layers(tmp_path: Path, count: int) -> None:
    """One coach is decided in half a minute; four of them, 16 wheelsets, have a page by then."""
    seconds, _, page = used(tmp_path, input_file("ballasted", "manchester", None, count), 30.0)
    assert seconds < 30.0 + START
    whole(page)
    assert '<p class="word">STABLE' in page or count > 1


def test_a_long_train_in_a_second(tmp_path: Path) -> None:
    """The roots have 2 s whatever is asked; where they take more they are open, and the page is written."""
    seconds, said, page = used(tmp_path, text_of("train_8_coaches", "", ""), 1.0)
    assert seconds < 2.0 + START, said
    whole(page)
    assert "There was no time left for:" in page
