"""Every example is a module with named values; the numbers that it names are held here."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

EXAMPLES = Path(__file__).parents[1] / "examples"
MODULES = sorted(path.stem for path in EXAMPLES.glob("*.py"))


def load(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"examples_{name}", EXAMPLES / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("name", MODULES)
def test_it_can_be_imported(name: str) -> None:
    assert load(name).__doc__


def test_picture(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="the picture needs the extra `plot`")
    picture = load("picture")
    assert (picture.SPECTRUM.count, picture.SPECTRUM.stable) == (4, True)
    assert abs(picture.Q_LM - 0.7678098053) < 1e-10
    assert [round(float(motion.frequency), 4) for motion in picture.VIBRATIONS] == [2.9393, 3.6425]
    assert [round(float(motion.time), 3) for motion in picture.VIBRATIONS] == [4.265, 6.047]
    low, high = picture.IM_MIN, picture.IM_MAX
    for root in picture.SPECTRUM.roots:
        assert abs(float(root.q.real.mid())) < picture.RE_LIMIT
        assert low < float(root.q.imag.mid()) < high
    first, second = picture.visualize(tmp_path / "a.svg"), picture.visualize(tmp_path / "b.svg")
    assert first.read_bytes() == second.read_bytes()
    assert first.read_text("utf-8").startswith("<?xml")
