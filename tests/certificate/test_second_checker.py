"""The second checker: small certificates are valid, false ones are not, nor is what it leaves out."""

from __future__ import annotations

import copy
import json
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from forging import as_file

from mpsolve import Problem
from mpsolve.certificate.solve import certify_problem
from mpsolve.tracks import EulerBernoulli
from mpsolve.vehicles import Mass

ROOT = Path(__file__).parents[2]
CHECKER = ROOT / "certs" / "second_checker" / "check.py"
QUICK = ["single_mass", "contact_wire", "joined_masses", "kelvin_voigt_pair", "rectangle", "timoshenko_unstable"]
BEAM = EulerBernoulli(EI="1/4", m=1, k=1, c="1/10")


def run(*files: Path) -> tuple[int, list[str]]:
    """Exit status and lines of the checker, which runs apart from the package and everything that is installed."""
    command = [sys.executable, "-E", "-s", "-S", str(CHECKER), *map(str, files)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=500)
    assert not done.stderr, done.stderr
    return done.returncode, done.stdout.splitlines()


@cache
def one_mass() -> str:
    found = certify_problem(Problem(BEAM, [Mass(40)], v="7/5"), region="unstable", digits=20)
    assert (found.proved, found.count) == (True, 2)
    return str(found.certificate.text)


def written(folder: Path, content: dict[str, Any], name: str = "file.json") -> Path:
    """The content with its digest made anew."""
    path = folder / name
    path.write_bytes(as_file(content))
    return path


@pytest.mark.parametrize("name", QUICK)
def test_certificates_of_the_repository_are_valid(name: str) -> None:
    path = ROOT / "certs" / f"{name}.json"
    claim = json.loads(path.read_text())["claim"]
    code, (line,) = run(path)
    assert code == 0
    assert line.startswith(f"valid: {path}: exactly {claim['count']} induced frequencies")


def test_an_undamped_beam_that_is_passive_at_all_frequencies(tmp_path: Path) -> None:
    undamped = Problem(EulerBernoulli(EI="1/4", m=1, k=1), [Mass(40)], v="9/10")
    content = certify_problem(undamped, region="unstable", digits=15).certificate.content
    code, (line,) = run(written(tmp_path, content))
    assert (code, line.startswith("valid: ")) == (0, True)
    faster = copy.deepcopy(content)
    faster["equations"]["velocity"] = "11/10"
    damped = copy.deepcopy(content)
    damped["equations"]["track"]["matrix"][0][0].append([0, 1, "1/10"])
    claimed = copy.deepcopy(content)
    claimed["claim"]["count"] = 1
    for k, false in enumerate((faster, damped, claimed)):
        code, (line,) = run(written(tmp_path, false, f"{k}.json"))
        assert (code, line.startswith("invalid: ")) == (1, True)


def test_one_mass_on_a_beam(tmp_path: Path) -> None:
    path = tmp_path / "one.json"
    path.write_text(one_mass())
    assert run(path)[0] == 0


@pytest.mark.slow
def test_all_of_the_repository() -> None:
    """All are valid but one of a thousand digits, floating ice (SPEC2, 4.8), one sheet at rest (8.9): partly so."""
    spectra = []
    for path in sorted((ROOT / "certs").glob("*.json")):
        content = json.loads(path.read_text())
        if content["version"] == 2 and content["kind"] == "spectrum":
            spectra.append(path)
    for path in spectra:
        code, (line,) = run(path)
        known = path.stem not in ("thousand_digits", "floating_ice", "at_rest")
        assert line.startswith("valid" if known else "partly checked"), line
        assert code == (0 if known else 1)


def fewer(c: dict[str, Any]) -> None:
    c["claim"]["count"] = c["claim"]["unstable"] = 0
    c["roots"] = []


def heavier(c: dict[str, Any]) -> None:
    c["equations"]["vehicle"]["M"] = [["1/10"]]


def slower(c: dict[str, Any]) -> None:
    c["equations"]["velocity"] = "9/10"


def undamped(c: dict[str, Any]) -> None:
    c["equations"]["track"]["matrix"][0][0] = [t for t in c["equations"]["track"]["matrix"][0][0] if t[:2] != [0, 1]]


def softer(c: dict[str, Any]) -> None:
    c["equations"]["vehicle"]["K"] = [["-1"]]


def moved(c: dict[str, Any]) -> None:
    c["roots"][0]["re"] = hex(int(c["roots"][0]["re"], 16) + (1 << 60))


def absorbing(c: dict[str, Any]) -> None:
    c["theorem"]["blocks"][0][2][1] += 8


def enveloped(c: dict[str, Any]) -> None:
    c["theorem"]["envelope"][1] -= 12


def short(c: dict[str, Any]) -> None:
    c["paths"][1]["points"].pop()


def no_walls(c: dict[str, Any]) -> None:
    c["paths"][2] = c["paths"][3]


def second_root(c: dict[str, Any]) -> None:
    c["roots"].append(copy.deepcopy(c["roots"][0]))
    c["claim"]["count"] = c["claim"]["unstable"] = 4


CHANGES = [fewer, heavier, slower, undamped, softer, moved, absorbing, enveloped, short, no_walls, second_root]


@pytest.mark.parametrize("change", CHANGES, ids=lambda c: c.__name__)
def test_a_false_certificate_is_not_valid(change: Callable[[dict[str, Any]], None], tmp_path: Path) -> None:
    content = json.loads(one_mass())
    change(content)
    code, (line,) = run(written(tmp_path, content))
    assert code == 1
    assert not line.startswith("valid"), line


def nearer(c: dict[str, Any]) -> None:
    x, _, e = c["paths"][-1]["points"][0]
    c["paths"][-1]["points"][1:] = [[x * 2**20 + 2**10, 0, e - 20]]


def once_round(c: dict[str, Any]) -> None:
    loop = c["theorem"]["lower"][0]
    loop["points"] = loop["points"][: len(loop["points"]) // 2 + 1]


def turned_round(c: dict[str, Any]) -> None:
    c["theorem"]["lower"][0]["points"].reverse()


def without_loop(c: dict[str, Any]) -> None:
    c["theorem"]["lower"] = []
    c["paths"][1:] = [c["paths"][2] | {"points": c["paths"][1]["points"] + c["paths"][2]["points"]}]


def early(c: dict[str, Any]) -> None:
    c["theorem"]["end"] = c["theorem"]["begin"] = [1, -4]


ON_SHEET = [fewer, second_root, moved, heavier, nearer, once_round, turned_round, without_loop, early]


@pytest.mark.parametrize("change", ON_SHEET, ids=lambda c: c.__name__)
def test_a_false_sheet_is_not_valid(change: Callable[[dict[str, Any]], None], tmp_path: Path) -> None:
    content = json.loads((ROOT / "certs" / "single_mass.json").read_text())
    change(content)
    code, (line,) = run(written(tmp_path, content))
    assert code == 1
    assert not line.startswith("valid"), line


def test_what_is_no_certificate_is_invalid(tmp_path: Path) -> None:
    texts = [
        b"",
        b"{",
        b"[" * 100_000,
        b"\xff\xfe",
        b'{"a": 1, "a": 2}',
        b'{"a": NaN}',
        b"12",
        one_mass().encode()[:-2],
    ]
    for text in texts:
        path = tmp_path / "file.json"
        path.write_bytes(text)
        code, (line,) = run(path)
        assert code == 1
        assert line.startswith("invalid"), line
    changed = tmp_path / "changed.json"
    changed.write_text(one_mass().replace('"count":2', '"count":4').replace('"count": 2', '"count": 4'))
    assert "checksum" in run(changed)[1][0]
    assert run(tmp_path / "none.json")[1][0].startswith("invalid")
    assert run()[0] == 1


def test_it_imports_nothing_of_the_package() -> None:
    for path in CHECKER.parent.glob("*.py"):
        text = path.read_text()
        for name in ("mpsolve.", "import mpsolve", "flint", "numpy", "mpmath", "sympy"):
            assert name not in text, (path, name)
