"""Every example is a module with named values; the numbers that it names are held here."""

from __future__ import annotations

import importlib.util
import json
import sys
from pathlib import Path
from types import ModuleType

import pytest
from matplotlib.figure import Figure

from mpsolve import verify

EXAMPLES = Path(__file__).parents[1] / "examples"
MODULES = sorted(path.stem for path in EXAMPLES.glob("*.py"))


def load(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"examples_{name}", EXAMPLES / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = sys.modules[spec.name] = importlib.util.module_from_spec(spec)  # where dataclasses look for it
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("name", MODULES)
def test_it_can_be_imported(name: str) -> None:
    assert load(name).__doc__


def test_picture(tmp_path: Path) -> None:
    picture = load("picture")
    assert (picture.SPECTRUM.count, picture.SPECTRUM.stable) == (4, True)
    height, begin = picture.CUTS
    assert abs(begin / (1e6 / 60) ** 0.5 - 0.7678098053) < 1e-10
    assert abs(height - 770 / 120) < 1e-14
    assert [round(float(motion.frequency), 4) for motion in picture.VIBRATIONS] == [2.9393, 3.6425]
    assert [round(float(motion.time), 3) for motion in picture.VIBRATIONS] == [4.265, 6.047]
    ax = Figure().add_subplot()
    assert picture.draw(ax) is ax
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    for root in picture.SPECTRUM.roots:
        assert left < float(root.q.real.mid()) < right
        assert low < float(root.q.imag.mid()) < high
    first, second = picture.visualize(tmp_path / "a.svg"), picture.visualize(tmp_path / "b.svg")
    assert first.read_bytes() == second.read_bytes()
    assert first.read_text("utf-8").startswith("<?xml")


def test_endless_train(tmp_path: Path) -> None:
    """Its numbers, and a picture that is the same each time and stands in examples/."""
    example = load("endless_train")
    example.check()
    drawn = example.visualize(tmp_path / "a.svg")
    assert drawn.read_text("utf-8").startswith("<?xml")
    assert example.PICTURE.exists()


def test_certificates_are_those_of_the_cases_and_valid() -> None:
    """certs/ holds one file a case; each passes the verifier, and two of them are proved again, to the same roots."""
    certificates = load("certificates")
    files = {path.stem: path for path in certificates.FOLDER.glob("*.json")}
    assert files.keys() == certificates.CASES.keys()
    for path in files.values():
        verdict = verify(path)
        assert verdict.valid, f"{path.name}: {verdict.reason}"
    for name in ("rail_60e1", "unstable_d1.5_alpha0.67"):
        spectrum = certificates.prove(name)
        stored = json.loads(files[name].read_text("ascii"))
        assert spectrum.certificate.content["roots"] == stored["roots"]
        assert spectrum.certificate.content["claim"] == stored["claim"]


def test_certificates_of_zeros_are_those_of_the_cases_and_valid() -> None:
    zeros = load("zeros")
    files = {path.stem: path for path in zeros.FOLDER.glob("*.json")}
    assert sorted(files) == sorted(zeros.CASES)
    for name, path in files.items():
        assert verify(path).valid, name
        stored = json.loads(path.read_text("ascii"))
        assert zeros.prove(name).certificate.content["claim"] == stored["claim"], name


def test_certificates_of_ranges_are_made_anew() -> None:
    example = load("range_certificates")
    assert {path.stem for path in example.FOLDER.glob("*.json")} == example.RESULTS.keys()
    for name in ("crossing_over_velocity", "stable_over_damping", "windows_d1.5_eta50", "chart_over_damping"):
        stored = json.loads((example.FOLDER / f"{name}.json").read_text("ascii"))
        made = example.prove(name).certificate.content
        assert made["claim"] == stored["claim"]
        assert made["equations"] == stored["equations"]


def test_the_certificates_are_drawn(tmp_path: Path) -> None:
    file = load("certificates").visualize(tmp_path / "plane.svg", "stable_d1.5_alpha0.66")
    assert file.read_text("utf-8").count('data-root="') == 4


def test_the_unstable_velocities_are_drawn() -> None:
    """One onset and one window, at the velocity ratios that certs/ranges/ holds."""
    ax = load("range_certificates").draw(Figure().add_subplot(), ("onset_d1.0_eta70", "windows_d1.5_eta50"))
    bars = [bar for bar in ax.patches if bar.get_gid()]
    assert [bar.get_gid() for bar in bars] == ["onset_d1.0_eta70", *["windows_d1.5_eta50"] * 2]
    assert [round(bar.get_x(), 4) for bar in bars] == [0.9620, 0.6958, 0.9672]
