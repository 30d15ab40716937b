"""The standalone verifier: what it accepts is what was asked; every changed certificate is refused, none hangs."""

from __future__ import annotations

import copy
import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from forging import Content, as_file, put

from mpsolve import Cut, Disc, HalfPlane, Rectangle, real_roots, roots
from mpsolve.certificate import verify_roots
from mpsolve.certificate.check import verify_bytes
from mpsolve.zeros.function import ExpressionFunction


def content_of(answer: Any) -> Content:
    return dict(json.loads(answer.certificate.text))


@pytest.fixture(scope="module")
def plain() -> Content:
    return content_of(roots("sin(z) - z/2", Rectangle(-3, 3, -1, 1)))


@pytest.fixture(scope="module")
def slit() -> Content:
    return content_of(roots("(sqrt(z) - 1/2)/(z + 2)", Rectangle(-1, 2, -1, 1), cuts=[Cut.ray(0, -1)]))


@pytest.fixture(scope="module")
def line() -> Content:
    return content_of(real_roots("(z - 1)**3*sin(z)/(z + 20)", -10, 10))


def verdict(content: Content) -> verify_roots.Verdict:
    return verify_roots.verify_bytes(as_file(content))


def test_what_is_proved_is_said(plain: Content, slit: Content, line: Content) -> None:
    assert "exactly 3 zeros" in verdict(plain).claim
    assert "sin(z)" in verdict(plain).claim
    assert "without the branch cuts from 0 + 0i along -1 + 0i" in verdict(slit).claim
    assert "exactly 8 real zeros" in verdict(line).claim
    assert verify_bytes(as_file(plain)).valid


def test_every_kind_of_region_is_accepted() -> None:
    for region in (Disc(1j, 3), HalfPlane("left", 4)):
        assert verdict(content_of(roots("exp(z) - 2*z**2", region))).valid


def test_it_runs_as_a_script(tmp_path: Path, plain: Content) -> None:
    good, bad = tmp_path / "good.json", tmp_path / "bad.json"
    good.write_bytes(as_file(plain))
    bad.write_bytes(as_file(plain).replace(b"sha256", b"sha257"))
    for file, code in ((good, 0), (bad, 1)):
        done = subprocess.run(
            [sys.executable, verify_roots.__file__, str(file)], capture_output=True, text=True, check=False
        )
        assert done.returncode == code


def changed(content: Content, change: Callable[[Content], Any]) -> Content:
    copied = copy.deepcopy(content)
    change(copied)
    return copied


CHANGES: dict[str, Callable[[Content], Any]] = {
    "count": lambda c: c["claim"].update(count=c["claim"]["count"] + 1),
    "fewer": lambda c: c["claim"].update(count=c["claim"]["count"] - 1),
    "root dropped": lambda c: c["roots"].pop(),
    "root twice": lambda c: c["roots"].append(c["roots"][0]),
    "root moved": lambda c: c["roots"][0].update(re=hex(int(c["roots"][0]["re"], 16) + 3)),
    "root off its disc": lambda c: c["roots"][0].update(re=hex(int(c["roots"][0]["re"], 16) + 1)),
    "root larger": lambda c: c["roots"][0].update(radius=[c["roots"][0]["radius"][0], 1]),
    "root doubled": lambda c: c["roots"][0].update(multiplicity=2),
    "root dropped and count": lambda c: (c["roots"].pop(), c["claim"].update(count=c["claim"]["count"] - 1)),
    "places left out": lambda c: c["breaks"].__setitem__(0, {"exponent": 0, "places": [0, 1]}),
    "leg left out": lambda c: c["breaks"].pop(),
    "leg not to its end": lambda c: c["breaks"][0]["places"].pop(),
    "leg backwards": lambda c: c["breaks"][0]["places"].reverse(),
    "other constant": lambda c: c["function"]["steps"].__setitem__(_number(c), ["number", "17/16"]),
    "other function": lambda c: c["function"]["steps"].__setitem__(
        _call(c), ["exp", c["function"]["steps"][_call(c)][1]]
    ),
    "loop of steps": lambda c: c["function"]["steps"].__setitem__(1, ["exp", 1]),
    "larger region": lambda c: c["region"].update(re=["-9", "9"]),
    "smaller region": lambda c: c["region"].update(re=["-1/8", "1/8"]),
    "polygon turned": lambda c: c["counted"].reverse(),
    "polygon crossed": lambda c: c["counted"].insert(1, c["counted"].pop()),
    "few bits": lambda c: c.update(bits=20),
    "float": lambda c: c["claim"].update(count=3.0),
    "unknown key": lambda c: c.update(more=1),
    "unknown version": lambda c: c.update(version=2),
    "true as a number": lambda c: c.update(bits=True),
}


def _number(content: Content) -> int:
    return next(k for k, step in enumerate(content["function"]["steps"]) if step == ["number", "1/2"])


def _call(content: Content) -> int:
    return next(k for k, step in enumerate(content["function"]["steps"]) if step[0] in ("sin", "sqrt"))


@pytest.mark.parametrize("name", CHANGES)
@pytest.mark.parametrize("which", ["plain", "slit"])
def test_no_changed_certificate_passes(which: str, name: str, request: pytest.FixtureRequest) -> None:
    content = request.getfixturevalue(which)
    found = verdict(changed(content, CHANGES[name]))
    assert not found.valid, found.claim
    assert found.reason


@pytest.mark.parametrize(
    "change",
    [
        lambda c: c["cuts"].clear(),
        lambda c: c["cuts"][0].update(origin=["-1/4", "0"]),
        lambda c: c["cuts"][0].update(origin=["1/8", "1/8"]),
        lambda c: c["cuts"][0].update(direction=["0", "1"]),
        lambda c: c["cuts"][0].update(direction=["1", "1"]),
        lambda c: c["trees"].__setitem__(0, ""),
        lambda c: c["trees"].__setitem__(0, "o"),
        lambda c: c["trees"].__setitem__(0, "..."),
        lambda c: c.update(trees=[]),
        lambda c: c["trees"].pop(),
        lambda c: c["function"].update(denominator=c["function"]["numerator"]),
        lambda c: c["cuts"].append({"origin": ["1", "-9"], "direction": ["0", "1"], "length": None}),
    ],
)
def test_no_changed_cut_or_cover_passes(slit: Content, change: Callable[[Content], Any]) -> None:
    assert not verdict(changed(slit, change)).valid


@pytest.mark.parametrize(
    "change",
    [
        lambda c: c["claim"].update(zeros=3),
        lambda c: (
            c["claim"]["multiplicities"].reverse()
            if c["claim"]["multiplicities"][0] != 1
            else c["claim"]["multiplicities"].sort()
        ),
        lambda c: c["tiles"][1].update(kinds=c["tiles"][1]["kinds"].replace("1", ".")),
        lambda c: c["tiles"][0].update(kinds="."),
        lambda c: c["tiles"][0]["places"].__setitem__(-1, "9"),
        lambda c: c["tiles"].reverse(),
        lambda c: c["tiles"][0]["brackets"].__setitem__(0, ["2", "3"]),
        lambda c: c["tiles"][0]["brackets"].clear(),
        lambda c: c.update(interval=["-10", "11"]),
        lambda c: c["function"].update(denominator=c["function"]["numerator"]),
    ],
)
def test_no_changed_interval_passes(line: Content, change: Callable[[Content], Any]) -> None:
    assert not verdict(changed(line, change)).valid


def test_a_function_with_complex_constants_is_not_taken_for_real(monkeypatch: pytest.MonkeyPatch) -> None:
    """The signs of its real part tell nothing: its only zero is 1 − 3.3·10⁻³¹ i."""
    monkeypatch.setattr(ExpressionFunction, "real", True)
    f = "z - 1 + sqrt(-1)/3 - 0.333333333333333333333333333333*sqrt(-1)"
    forged = real_roots(f, -3, 3, check=False)
    assert forged.count == 1
    assert "not known to be real" in verdict(content_of(forged)).reason


@pytest.mark.parametrize(
    "raw",
    [
        b"",
        b"[]",
        b"{}",
        b'{"format": "mpsolve zeros"}',
        b"\xff",
        b"[" * 100_000,
        b'{"format": "mpsolve zeros", "version": 1e9}',
    ],
)
def test_hostile_files_are_refused(raw: bytes) -> None:
    assert not verify_roots.verify_bytes(raw).valid


@pytest.mark.parametrize(
    "change",
    [
        put("function", "steps", 1, ["number", "1/0"]),
        put("function", "steps", 1, ["number", "9" * 5000]),
        put("function", "steps", 1, ["pow", 0, 10**9]),
        put("function", "steps", 1, ["__class__", 0]),
        put("function", "numerator", 10**9),
        put("roots", 0, "exponent", -(10**9)),
        put("roots", 0, "radius", [1, -(10**9)]),
        put("bits", 10**9),
        put("breaks", 0, {"exponent": 10**9, "places": [0, 1]}),
        put("counted", [["0", "0"]] * 1000),
        put("roots", [{}] * 100_000),
    ],
)
def test_hostile_numbers_are_refused_quickly(plain: Content, change: Callable[[Content], Any]) -> None:
    assert not verdict(changed(plain, change)).valid


def test_a_function_with_as_many_zeros_as_poles_is_not_taken_for_one_with_neither() -> None:
    answer = roots("z*(z - 1)", Rectangle(-3, 3, -1, 1))
    content = content_of(answer)
    steps = [["z"], ["number", "1/2"], ["sub", 0, 1], ["div", 0, 2]]  # z/(z − 1/2): turns by 0
    content["function"] = {"steps": steps, "numerator": 3, "denominator": None}
    content |= {"claim": {"count": 0}, "roots": [], "trees": ["."]}
    found = verdict(content)
    assert not found.valid
    assert "analytic" in found.reason
