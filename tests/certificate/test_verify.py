"""The verifier accepts what `certify` proves, as a plain script that needs the standard library and flint only."""

from __future__ import annotations

import ast
import json
import subprocess
import sys
import threading
from functools import cache
from pathlib import Path

import oracle
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mpsolve import Case, Rectangle, read_case
from mpsolve.certificate import verify as module
from mpsolve.certificate.sheet import SheetSpectrum as Spectrum
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.certificate.verify import Verdict, verify
from mpsolve.fields import ball_arithmetic

ROOT = Path(__file__).parents[2]
SCRIPT = Path(module.__file__)
PAIR = {"eta_m": (70, 70), "positions": (0, "1.5")}

WHOLE_SHEET = {
    "subcritical damped": (Case(alpha="0.67", eta_b="0.05", **PAIR), 4),
    "supercritical damped": (Case(alpha="1.2", eta_b="0.05", **PAIR), 4),
    "supercritical, more roots": (Case(alpha="1.3", eta_b="0.5", **PAIR), 6),
    "subcritical undamped": (Case(alpha="0.5", eta_b=0, **PAIR), 4),
    "supercritical undamped": (Case(alpha="1.1", eta_b=0, **PAIR), 4),
    "at rest": (Case(alpha=0, eta_b="0.1", **PAIR), 4),
    "at rest, one mass": (Case(alpha=0, eta_b=0, eta_m=5), 2),
    "at rest, compressed": (Case(alpha=0, eta_b="0.1", eta_n="0.3", **PAIR), 4),
    "one mass": (Case(alpha="0.9", eta_b="0.05", eta_m=70), 2),
    "unequal masses": (Case(alpha="0.7", eta_b="0.1", eta_m=(3, 40), positions=(0, "0.8")), 2),
    "masses at one place": (Case(alpha="0.7", eta_b="0.1", eta_m=(3, 4, 5), positions=(0, 1, 1)), 2),
    "compressed": (Case(alpha="0.4", eta_b="0.2", eta_n="0.5", **PAIR), 4),
    "stretched": (Case(alpha="0.8", eta_b="0.2", eta_n="-0.3", eta_s="0.4", **PAIR), 4),
    "three masses": (Case(alpha="0.3", eta_b="0.5", eta_m=(10, 10, 10), positions=(0, 1, 2)), 6),
}


def verdict(spectrum: Spectrum, folder: Path) -> Verdict:
    assert spectrum.proved, spectrum.reason
    assert spectrum.certificate is not None
    return verify(spectrum.certificate.save(folder / "certificate.json"))


@cache
def pair_file(folder: Path) -> Path:
    certificate = certify(Case(alpha="0.67", eta_b="0.05", **PAIR)).certificate
    assert certificate is not None
    return certificate.save(folder / "pair.json")


@pytest.mark.parametrize("name", WHOLE_SHEET)
def test_the_whole_sheet_is_accepted(name: str, tmp_path: Path) -> None:
    case, count = WHOLE_SHEET[name]
    spectrum = certify(case)
    assert spectrum.count == count
    expected = f"exactly {count} induced frequencies on the whole physical sheet, {spectrum.unstable} of them"
    found = verdict(spectrum, tmp_path)
    assert found == Verdict(True, "", found.claim)
    assert found.claim.startswith(f"{expected} with Im q < 0; case alpha = ")


def test_a_physical_case_with_surds_is_accepted(tmp_path: Path) -> None:
    case = read_case(ROOT / "examples" / "rail_60e1.toml")
    assert verdict(certify(case), tmp_path).valid


OFF_THE_LINE = {
    "eta_b > 1": (Case(alpha="1.1", eta_b="1.7", **PAIR), 2),
    "eta_b = 1": (Case(alpha="1.1", eta_b=1, eta_m=70), 0),
    "N above beta": (Case(alpha="1.1", eta_b="0.9", eta_n="0.5", eta_m=70), 2),
}


@pytest.mark.parametrize("name", OFF_THE_LINE)
def test_the_unstable_region_is_accepted_where_the_cuts_leave_the_line(name: str, tmp_path: Path) -> None:
    case, count = OFF_THE_LINE[name]
    spectrum = certify(case, digits=15, region="unstable")
    assert verdict(spectrum, tmp_path).claim.startswith(f"exactly {count} induced frequencies with Im q < 0")


@pytest.mark.parametrize(
    ("box", "count", "where"),
    [
        (("0", "0.4", "-0.01", "0.02"), 2, "0 < Re q < 2/5, -1/100 < Im q < 1/50"),
        (("0.1", "0.4", "0.06", "1"), 0, "1/10 < Re q < 2/5, 3/50 < Im q < 1"),
    ],
)
def test_a_rectangle_is_accepted(box: tuple[str, str, str, str], count: int, where: str, tmp_path: Path) -> None:
    spectrum = certify(Case(alpha="0.67", eta_b="0.05", **PAIR), region=Rectangle(*box))
    assert verdict(spectrum, tmp_path).claim.startswith(f"exactly {count} induced frequencies with {where}, ")


def test_a_thousand_digits_are_accepted(tmp_path: Path) -> None:
    spectrum = certify(Case(alpha="0.9", eta_b="0.05", eta_m=70), digits=1000)
    assert all(oracle.sharp(root.q, 3321) for root in spectrum.roots)
    assert verdict(spectrum, tmp_path).valid


def test_clusters_are_accepted(tmp_path: Path) -> None:
    """Masses so far apart that two roots agree to more digits than are asked for."""
    spectrum = certify(Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, 100)), digits=15)
    assert [root.multiplicity for root in spectrum.roots] == [1, 2, 2, 1]
    assert verdict(spectrum, tmp_path).claim.startswith("exactly 6 induced frequencies on the whole")


@settings(max_examples=12)
@given(st.data())
def test_any_case_is_proved_and_accepted_or_undecided_with_a_reason(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject
) -> None:
    eta_m = data.draw(st.lists(oracle.grid(0.5, 100), min_size=1, max_size=2))
    axial = data.draw(st.one_of(st.just(0.0), oracle.grid(-0.99, 0.8)))
    eta_b = data.draw(oracle.grid(0, min(0.95, 0.99 * (1 - max(axial, 0) ** 2) ** 0.5)))
    case = Case(
        alpha=data.draw(oracle.grid(0, 1.4)),
        eta_b=eta_b,
        eta_n=axial,
        eta_m=eta_m,
        positions=[0, data.draw(oracle.grid(0.2, 6))][: len(eta_m)],
    )
    spectrum = certify(case, digits=15)
    if not spectrum.proved:
        assert len(spectrum.reason) > 20
        return
    assert verdict(spectrum, tmp_path_factory.mktemp("case")).valid
    assert spectrum.radius is not None
    truth = oracle.Truth(case, 20)
    found = truth.search(spectrum.radius)
    seen = [*found, *(-q.conjugate() for q in found)]
    missed = [root for root in spectrum.roots if not any(abs(complex(root.q.mid()) - q) < 1e-6 for q in seen)]
    number = sum(1 if abs(q.real) < 1e-9 * abs(q) else 2 for q in found)
    assert number + sum(root.multiplicity for root in missed) == spectrum.count
    for root in missed:  # the search does not see roots that all but touch the cut: each is looked at by itself
        assert abs(float(root.q.imag.mid()) - eta_b) < 2e-2
        assert oracle.holds(root.q, truth.root(complex(root.q.mid())))


def run(*arguments: object) -> subprocess.CompletedProcess[str]:
    """The script by itself: -I keeps the working folder and the package out of sight."""
    command = [sys.executable, "-I", str(SCRIPT), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)


def test_as_a_script_it_prints_a_line_and_exits_with_0(tmp_path: Path) -> None:
    file = pair_file(tmp_path)
    result = run(file)
    assert (result.returncode, result.stderr) == (0, "")
    claim = (
        "exactly 4 induced frequencies on the whole physical sheet, 2 of them with Im q < 0; "
        "case alpha = 67/100, eta_b = 1/20, eta_n = 0, eta_s = 0, eta_m = 70, 70 at 0, 3/2"
    )
    assert result.stdout == f"{file}: valid: {claim}\n"


def test_the_verdict_names_the_case_and_the_rectangle(tmp_path: Path) -> None:
    case = Case(alpha="0.67", eta_b="0.05", eta_n="1/3", eta_m=(70, 70), positions=(0, "1.5"))
    said = verdict(certify(case, digits=15, region=Rectangle("0", "0.4", "-0.01", "0.02")), tmp_path).claim
    assert "with 0 < Re q < 2/5, -1/100 < Im q < 1/50" in said
    assert said.endswith("; case alpha = 67/100, eta_b = 1/20, eta_n = 1/3, eta_s = 0, eta_m = 70, 70 at 0, 3/2")


def test_long_numbers_are_named_by_a_digest() -> None:
    one, two = (module.said(f"1/{'3' * 100}{last}") for last in "12")
    assert one != two
    assert len(one) < 80


def test_as_a_script_it_exits_with_1_when_one_of_the_files_is_not_valid(tmp_path: Path) -> None:
    file = pair_file(tmp_path)
    other = tmp_path / "other.json"
    other.write_text(file.read_text().replace('"count": 4', '"count": 6'))
    result = run(file, other)
    assert (result.returncode, result.stderr) == (1, "")
    first, second = result.stdout.splitlines()
    assert ": valid: " in first
    assert second == f"{other}: INVALID: the digest does not fit the content"


def test_as_a_script_without_a_readable_file_it_exits_with_1(tmp_path: Path) -> None:
    assert run().returncode == 1
    missing = run(tmp_path / "missing.json")
    assert missing.returncode == 1
    assert "cannot be read" in missing.stdout
    assert run(tmp_path).returncode == 1


def test_it_imports_the_standard_library_and_flint_only() -> None:
    tree = ast.parse(SCRIPT.read_text())
    names = {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
    relative = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.level]
    names |= {str(node.module) for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    assert not relative
    assert {name.split(".")[0] for name in names} <= {*sys.stdlib_module_names, "flint"}
    calls = {
        node.func.id for node in ast.walk(tree) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    }
    assert not calls & {"__import__", "eval", "exec", "compile"}


def test_it_leaves_the_precision_of_flint_as_it_was(tmp_path: Path) -> None:
    before = module.flint.ctx.prec
    assert verify(pair_file(tmp_path)).valid
    assert module.flint.ctx.prec == before


def test_it_waits_for_the_precision_of_other_threads() -> None:
    """flint has one precision for the process: the verifier and the arithmetic of the proofs take turns."""
    inside, leave, seen = threading.Event(), threading.Event(), []

    def hold() -> None:
        with module.precision(777):
            inside.set()
            leave.wait(10)
            seen.append(module.flint.ctx.prec)

    def change() -> None:
        with ball_arithmetic(99):
            seen.append(module.flint.ctx.prec)

    before = module.flint.ctx.prec
    threads = [threading.Thread(target=hold), threading.Thread(target=change)]
    threads[0].start()
    assert inside.wait(10)
    threads[1].start()
    threads[1].join(0.2)
    assert not seen
    leave.set()
    for thread in threads:
        thread.join()
    assert seen == [777, 99]
    assert module.flint.ctx.prec == before


def test_the_file_is_json_that_holds_the_problem_in_exact_numbers(tmp_path: Path) -> None:
    content = json.loads(pair_file(tmp_path).read_text())
    assert content["case"]["alpha"] == "67/100"
    assert content["identity"] == [root["multiplicity"] for root in content["roots"]] == [1, 1, 1, 1]
