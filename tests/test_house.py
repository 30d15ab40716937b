"""Every module has its twin test at the same place."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).parents[1]


def twin(module: Path) -> Path:
    return Path("tests") / module.parent / f"test_{module.name}"


def test_no_module_is_without_a_twin() -> None:
    package = ROOT / "mpsolve"
    modules = {path.relative_to(package) for path in package.rglob("*.py") if path.name != "__init__.py"}
    alone = {str(one) for one in modules if not (ROOT / twin(one)).exists()}
    assert sorted(alone) == [], "write a test beside each"


def test_twins_stand_at_the_same_place() -> None:
    assert twin(Path("spectrum/solve.py")) == Path("tests/spectrum/test_solve.py")
    assert twin(Path("errors.py")) == Path("tests/test_errors.py")
