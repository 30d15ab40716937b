"""Specs of studies: read, written and compared exactly; every mistake under its key."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from mpsolve.errors import InputError
from mpsolve.spectrum.regions import Rectangle
from mpsolve.studies.spec import differences, read_spec, spec_of

EXAMPLES = Path(__file__).parents[2] / "examples"
PLAIN: dict[str, Any] = {
    "study": {"kind": "certified"},
    "parameters": {"alpha": [0.1, 0.2], "eta_b": 0.05, "eta_m": 70, "d": 1.5},
}
BOX = {"re_min": 0, "re_max": 1, "im_min": -1, "im_max": "0.01"}
DRAWN = {"kind": "random", "count": 10}


def changed(section: str, **values: Any) -> dict[str, Any]:
    """PLAIN with other values; None drops one."""
    table = {name: value for name, value in (PLAIN[section] | values).items() if value is not None}
    return PLAIN | {section: table}


def test_numbers_are_exact_as_written(tmp_path: Path) -> None:
    file = tmp_path / "study.toml"
    file.write_text('[study]\nkind = "certified"\n[parameters]\nalpha = 0.1\neta_b = "1/3"\neta_m = 70\nd = 1.5\n')
    assert read_spec(file).values(0) == {
        "alpha": Fraction(1, 10), "eta_b": Fraction(1, 3), "eta_m": Fraction(70), "d": Fraction(3, 2)
    }  # fmt: skip


@pytest.mark.parametrize(
    "spec",
    [
        EXAMPLES / "study_certified.toml",
        EXAMPLES / "study_float64.toml",
        changed("parameters", d=["one mass", 1], eta_n="root4(1/3)", eta_s={"start": 0, "stop": 1, "step": "1/7"}),
        changed("study", region=BOX, digits=50, certificates=True),
        changed("study", design={"kind": "list"}),
    ],
)  # fmt: skip
def test_the_canonical_text_gives_the_spec_back(spec: Any) -> None:
    first = read_spec(spec)
    second = spec_of(first.text)
    assert second.canonical == first.canonical
    assert (second.total, second.block) == (first.total, first.block)
    for index in {0, first.total // 2, first.total - 1}:
        assert second.values(index) == first.values(index)
    assert json.loads(first.text) == first.canonical


def test_a_region_is_a_rectangle() -> None:
    assert read_spec(changed("study", region=BOX)).region == Rectangle(0, 1, -1, "0.01")


def test_blocks_share_out_the_cases() -> None:
    for study in ({"kind": "certified"}, {"kind": "float64"}):
        spec = read_spec({"study": study, "parameters": PLAIN["parameters"] | {"alpha": list(range(7))}})
        assert [k for number in range(spec.blocks) for k in spec.indices(number)] == list(range(7))


@pytest.mark.parametrize(
    ("spec", "key", "said"),
    [
        ({"parameters": {}}, "study", "is missing"),
        ({"study": {"kind": "certified"}}, "parameters", "is missing"),
        (changed("study", kind=None), "study.kind", "is missing"),
        (changed("study", kind="certifed"), "study.kind", 'did you mean "certified"?'),
        (changed("study", digit=20), "study.digit", "did you mean digits?"),
        (changed("study", digits=10), "study.digits", "from 15 to 10000"),
        (changed("study", digits=True), "study.digits", "is True"),
        (changed("study", kind="float64", digits=20), "study.digits", "drop it"),
        (changed("study", kind="float64", masses=3), "study.masses", "is 3"),
        (changed("study", masses=4), "study.masses", "from 1 to 3"),
        (changed("study", masses=1), "parameters.d", "study.masses is 1"),
        (changed("study", region="shet"), "study.region", 'did you mean "sheet"?'),
        (changed("study", region={"re_min": 0}), "study.region.re_max", "is missing"),
        (changed("study", certificates="yes"), "study.certificates", "true or false"),
        (changed("study", design="grid"), "study.design", "not a section"),
        (changed("study", design={"kind": "radom", "count": 3}), "study.design.kind", 'did you mean "random"?'),
        (changed("study", design={"kind": "random"}), "study.design.count", "is missing"),
        (changed("study", design={"kind": "random", "count": 0}), "study.design.count", "whole number from 1"),
        (changed("study", design={"kind": "grid", "seed": 1}), "study.design.seed", "drop it"),
        (changed("study", design=DRAWN), "parameters.alpha", "is several values"),
        (changed("parameters", alpha=None), "parameters.alpha", "is missing"),
        (changed("parameters", d=None), "parameters.d", "is missing"),
        (changed("parameters", etam=1), "parameters.etam", "did you mean eta_m?"),
        (changed("parameters", alpha="fast"), "parameters.alpha", "is not a number"),
        (changed("parameters", alpha=[]), "parameters.alpha", "is empty"),
        (changed("parameters", alpha=[1, 2, "1.0"]), "parameters.alpha[3]", "is there already"),
        (changed("parameters", alpha={"low": 0, "high": 1}), "parameters.alpha", "a grid draws nothing"),
        (changed("parameters", alpha={"start": 0, "stop": 1}), "parameters.alpha.step", "is missing"),
        (changed("parameters", alpha={"start": 0, "stop": 1, "step": -1}), "parameters.alpha.step", "does not lead"),
        (changed("parameters", alpha=[0, -1]), "parameters.alpha", "reaches -1"),
        (changed("parameters", eta_m=0), "parameters.eta_m", "must be above 0"),
        (changed("parameters", eta_b="1e13"), "parameters.eta_b", "reaches beyond"),
        (changed("parameters", d="two masses"), "parameters.d", "is not a number"),
        (changed("parameters", alpha={"start": 0, "stop": 1, "step": "1e-13"}), "parameters", "at most"),
        (changed("parameters", alpha={"start": 0, "stop": 1, "step": "1e-300"}), "parameters", "at most"),
    ],
)
def test_a_mistake_is_named_by_its_key(spec: Any, key: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        read_spec(spec)
    assert caught.value.key == key
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("alpha", "key", "said"),
    [
        ({"low": 1, "high": 1}, "parameters.alpha.high", "not above low"),
        ({"low": 1}, "parameters.alpha.high", "is missing"),
        ({"low": -1, "high": 1}, "parameters.alpha", "reaches -1"),
        ({"low": 0, "high": "root4(1/2)"}, "parameters.alpha.high", "is irrational"),
    ],
)
def test_a_mistake_in_a_range(alpha: Any, key: str, said: str) -> None:
    spec = changed("parameters", alpha=alpha) | {"study": {"kind": "certified", "design": DRAWN}}
    with pytest.raises(InputError, match=said) as caught:
        read_spec(spec)
    assert caught.value.key == key


def test_lists_that_go_together_are_as_long_as_each_other() -> None:
    spec = changed("parameters", eta_m=[1, 2, 3]) | {"study": {"kind": "certified", "design": {"kind": "list"}}}
    with pytest.raises(InputError, match="has 2 values, and eta_m has 3"):
        read_spec(spec)


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (lambda: changed("study", digits=16), ("study.digits", 15, 16)),
        (lambda: changed("parameters", alpha=[0.1, 0.3]), ("parameters.alpha", ["1/10", "1/5"], ["1/10", "3/10"])),
        (lambda: changed("parameters", eta_n=0), ("parameters.eta_n", None, "0")),
    ],
)
def test_differences_are_named(change: Callable[[], Any], expected: tuple[str, Any, Any]) -> None:
    assert list(differences(read_spec(PLAIN).canonical, read_spec(change()).canonical)) == [expected]


def test_the_title_and_the_way_of_writing_make_no_difference() -> None:
    other = changed("parameters", alpha=["1/10", "0.20"], d="3/2") | {"title": "the same"}
    assert not list(differences(read_spec(PLAIN).canonical, read_spec(other).canonical))
