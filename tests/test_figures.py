"""The gallery of the paper's figures: each asserts its numbers and is drawn, and what it asserts can fail."""

from __future__ import annotations

import importlib
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mpsolve import Case

FOLDER = Path(__file__).parents[1] / "examples" / "figures"
FIGURES = sorted(path.stem for path in FOLDER.glob("figure_*.py"))
FEW = np.linspace(0.0, 20.0, 5)
GRID = np.arange(60, 67, 2) / 100
SMALL: dict[str, dict[str, Any]] = {  # arguments that make each picture quick
    "figure_02": {"alpha": GRID},
    "figure_07": {"points": 4},
    "figure_09": {"alpha": GRID},
    "figure_10": {"eta_b": np.array([0.1]), "masses": np.array([20.0, 22.0])},
    "figure_12": {"masses": (20,), "distances": ("0.5",)},
}
FEWER: dict[str, dict[str, Any]] = {  # and named values
    "figure_02": {"CLOSE": ("0.5",), "FAR": ("2",)},
    "figure_07": {"DISTANCES": ("1", "4")},
    "figure_09": {"GROUPS": ((70, ("0.5",)), (10, ("1.5",)))},
    "figure_10": {"CURVES": (0.1,)},
    "figure_12": {"ALPHA": np.array([1.1, 1.2])},
}
HARMONIC = ("figure_03", "figure_04", "figure_05", "figure_06", "figure_08", "figure_11")
COMPARISONS = ("figure_a1", "figure_a2", "figure_a3", "figure_a4", "figure_a5")


@pytest.fixture
def load(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Imports a module of the gallery as it is when run as a script: its folder comes first."""
    monkeypatch.syspath_prepend(str(FOLDER))
    return importlib.import_module


def test_every_figure_is_there_and_its_import_draws_nothing() -> None:
    assert len(FIGURES) == 16
    code = f"import sys; sys.path.insert(0, {str(FOLDER)!r})\n"
    code += "\n".join(
        f"import {name} as f; assert f.__doc__ and f.visualize.__doc__ and f.check.__doc__" for name in FIGURES
    )
    code += "\nassert not {'matplotlib', 'scipy'} & sys.modules.keys()"
    subprocess.run([sys.executable, "-W", "error", "-c", code], check=True, timeout=120)


@pytest.mark.parametrize("name", FIGURES)
def test_its_numbers(name: str, load: Any) -> None:
    load(name).check()


@pytest.mark.parametrize("name", FIGURES)
def test_it_is_drawn(name: str, load: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="pictures need the extra `plot`")
    module = load(name)
    for key, value in FEWER.get(name, {}).items():
        monkeypatch.setattr(module, key, value)
    if name in HARMONIC:
        monkeypatch.setattr(module, "CASES", [module.CASES[0][:1]])
    if name in COMPARISONS:
        monkeypatch.setattr(module, "CASES", module.CASES[:1])
    path = module.visualize(tmp_path / f"{name}.svg", **SMALL.get(name, {"tau": FEW}))
    assert path.read_text("utf-8").rstrip().endswith("</svg>")


@pytest.mark.slow
@pytest.mark.parametrize("name", FIGURES)
def test_it_is_drawn_in_full(name: str, load: Any, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="pictures need the extra `plot`")
    path = load(name).visualize(tmp_path / f"{name}.pdf")
    assert path.read_bytes().startswith(b"%PDF")


def test_a_suffix_without_a_picture_is_refused(load: Any, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"give .svg, .pdf or .png"), load("style").page(tmp_path / "a.txt", 1, 1):
        pass
    assert not list(tmp_path.iterdir())


def test_lines_that_cross_in_their_real_parts_are_not_swapped(load: Any) -> None:
    alpha = np.arange(21) / 20
    roots = [np.array([0.3 + 0.2 * a, 0.5 - 0.2 * a + 0.01j])[:: -1 if k % 2 else 1] for k, a in enumerate(alpha)]
    roots[15] = roots[15][:0]
    first, second, *rest = load("induced").join(alpha, roots)
    assert [len(line.q) for line in (first, second, *rest)] == [15, 15, 5, 5]
    assert {max(q.imag for q in line.q) - min(q.imag for q in line.q) for line in (first, second)} == {0.0}


def test_a_line_that_ends_where_another_begins_far_off_is_not_joined_to_it(load: Any) -> None:
    alpha = np.arange(10) / 100
    roots = [np.array([0.3 + a + (0.1 if k > 5 else 0.0)]) for k, a in enumerate(alpha)]
    assert [len(line.q) for line in load("induced").join(alpha, roots)] == [6, 4]


def test_a_check_that_fails_leaves_no_picture(load: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    run = load("style").run
    monkeypatch.setattr(sys, "argv", ["figure.py", str(tmp_path / "a.svg")])
    drawn: list[Any] = []

    def check() -> None:
        assert drawn, "nothing yet"

    with pytest.raises(AssertionError, match="nothing yet"):
        run(check, drawn.append, "figure")
    assert not drawn
    run(lambda: None, drawn.append, "figure")
    assert drawn == [str(tmp_path / "a.svg")]


@pytest.mark.parametrize(
    ("found", "truth"), [(1.1, 1.0), ([1.0, np.nan], 1.0), ([1.0], [1.0, 1.0]), ([1.0, 1.0], [1.0, 1.0 + 0.2j])]
)
def test_numbers_that_do_not_agree(found: Any, truth: Any, load: Any) -> None:
    load("style").agree(truth, truth, 0)
    with pytest.raises(AssertionError, match=re.escape(str(np.asarray(truth)))):
        load("style").agree(found, truth, 0.05)


def test_frequencies_are_read_off_a_curve(load: Any) -> None:
    tau, q = np.linspace(0, 100, 401), np.array([0.11 + 0.01j, 0.14 - 0.002j])
    w = 3 + (np.array([1.4, 0.3j]) @ np.exp(1j * q[:, None] * tau)).real
    assert load("comparison").read(tau, w, 2) == pytest.approx(q, abs=1e-10)
    assert load("comparison").read(tau[::20], w[::20], 2) == pytest.approx(q, abs=1e-10)


@pytest.mark.parametrize("part", ["amplitude", "frequency", "envelope"])
def test_a_vibration_that_is_slightly_off_fails(part: str, load: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    vibration, case = load("vibration"), load("figure_08").CASES[0][2]
    right, changed = vibration.vibration, {"amplitude": 1.00001, "frequency": 1.0001, "envelope": 0.99}

    def wrong(case: Any, tau: Any, spectrum: Any) -> Any:
        found = right(case, tau * (changed[part] if part == "frequency" else 1), spectrum)
        if part == "amplitude":
            return replace(found, w=changed[part] * found.w)
        if part == "envelope":
            return replace(found, envelope=replace(found.envelope, modulus=changed[part] * found.envelope.modulus))
        return replace(found, tau=tau)

    vibration.checked_vibration(case)
    monkeypatch.setattr(vibration, "vibration", wrong)
    with pytest.raises(AssertionError):
        vibration.checked_vibration(case)


def test_a_comparison_that_is_slightly_off_fails(load: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    comparison, case = load("comparison"), load("figure_a3").CASES[1]
    found = comparison.checked_comparison(case)
    for part in ("full", "added", "doubled", "beam"):
        wrong = replace(found, **{part: getattr(found, part) + 1e-4})
        monkeypatch.setattr(comparison, "comparison", lambda *_, wrong=wrong: wrong)
        with pytest.raises(AssertionError):
            comparison.checked_comparison(case)


def test_lines_that_are_slightly_off_fail(load: Any) -> None:
    induced, case = load("induced"), Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    found = induced.lines(70, "1.5", "0.05", np.array([0.66, 0.67]))
    induced.check_lines(found, case)
    for wrong in (found[:1], [replace(line, q=tuple(q + 1e-9 for q in line.q)) for line in found]):
        with pytest.raises(AssertionError):
            induced.check_lines(wrong, case)
