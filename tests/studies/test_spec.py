"""Specs of studies: read, written and compared exactly; every mistake under its key."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from mpsolve.errors import InputError
from mpsolve.problem.inputfile import problem_of, read_problem
from mpsolve.problem.toml import parsed
from mpsolve.spectrum.regions import Below, Rectangle
from mpsolve.studies.spec import differences, problem_tables, read_spec, spec_of

EXAMPLES = Path(__file__).parents[2] / "examples"
PAIR = {"alpha": "0.5", "eta_b": "0.05", "eta_m": [70, 70], "positions": [0, 1]}
PLAIN: dict[str, Any] = {
    "study": {"kind": "certified"},
    "dimensionless": PAIR,
    "parameters": {"v": [0.1, 0.2], "track.c": 0.1, "vehicles.M": 70},
}
BOX = {"re_min": 0, "re_max": 1, "im_min": -1, "im_max": "0.01"}
DRAWN = {"kind": "random", "count": 10}


def changed(section: str, **values: Any) -> dict[str, Any]:
    """PLAIN with other values; None drops one. In `parameters` track_c stands for track.c."""
    named = {name.replace("track_", "track."): value for name, value in values.items()}
    table = {name: value for name, value in (PLAIN[section] | named).items() if value is not None}
    return PLAIN | {section: table}


def test_numbers_are_exact_as_written(tmp_path: Path) -> None:
    (tmp_path / "rail.toml").write_text(
        'v = 50.5\n[track]\nmodel = "euler-bernoulli"\nEI = 6.4e6\nm = 60\nk = 1e6\n'
        '[[vehicle]]\nmodel = "mass"\nM = 0.1\n'
    )
    file = tmp_path / "study.toml"
    file.write_text(
        'problem = "rail.toml"\n[study]\nkind = "certified"\n'
        '[parameters]\nv = 0.1\ntrack.c = "1/3"\n"vehicles[0].M" = 1.5\n'
    )
    spec = read_spec(file)
    assert spec.values(0) == {"v": Fraction(1, 10), "track.c": Fraction(1, 3), "vehicles[0].M": Fraction(3, 2)}
    assert spec.base.v == Fraction(101, 2)
    assert spec.base.parameters["vehicles[0].M"] == Fraction(1, 10)
    assert spec.problem(0).parameters["track.c"] == Fraction(1, 3)


@pytest.mark.parametrize(
    "spec",
    [
        EXAMPLES / "study_certified.toml",
        EXAMPLES / "study_float64.toml",
        changed("parameters", track_kp={"start": 0, "stop": 1, "step": "1/7"}),
        changed("study", region=BOX, digits=50, certificates=True),
        changed("study", region={"below": "0.01"}),
        changed("study", design={"kind": "list"}),
    ],
)
def test_the_canonical_text_gives_the_spec_back(spec: Any) -> None:
    first = read_spec(spec)
    second = spec_of(first.text)
    assert second.canonical == first.canonical
    assert (second.total, second.block) == (first.total, first.block)
    for index in {0, first.total // 2, first.total - 1}:
        assert second.values(index) == first.values(index)
        assert second.problem(index) == first.problem(index)
    assert json.loads(first.text) == first.canonical


def test_values_may_have_units() -> None:
    problem = {
        "v": "360 km/h",
        "track": {"model": "string", "T": "27 kN", "m": 1, "k": 500, "c": 2},
        "vehicle": [{"model": "mass", "M": 8}],
    }
    parameters = {"v": {"start": "36 km/h", "stop": 20, "step": "5 m/s"}, "vehicles[0].M": ["8500 g", 9]}
    spec = read_spec({"study": {"kind": "float64"}, **problem, "parameters": parameters})
    assert [spec.values(k) for k in (0, 5)] == [
        {"v": Fraction(10), "vehicles[0].M": Fraction(17, 2)},
        {"v": Fraction(20), "vehicles[0].M": Fraction(9)},
    ]
    with pytest.raises(InputError, match=r"parameters\.v\[1\]"):
        read_spec({"study": {"kind": "float64"}, **problem, "parameters": {"v": ["3 kg"]}})


def test_a_region_is_a_rectangle_or_below_a_height() -> None:
    assert read_spec(changed("study", region=BOX)).region == Rectangle(0, 1, -1, "0.01")
    assert read_spec(changed("study", region={"below": "1/7"})).region == Below(Fraction(1, 7))
    assert read_spec(PLAIN).region == "unstable"


def test_blocks_share_out_the_entries() -> None:
    for study in ({"kind": "certified"}, {"kind": "float64"}):
        spec = read_spec(PLAIN | {"study": study, "parameters": {"v": list(range(7))}})
        assert [k for number in range(spec.blocks) for k in spec.indices(number)] == list(range(7))


@pytest.mark.parametrize(
    ("spec", "key", "said"),
    [
        ({"parameters": {}}, "study", "is missing"),
        ({"study": {"kind": "certified"}}, "parameters", "is missing"),
        ({"study": {"kind": "certified"}, "parameters": {"v": 1}}, "problem", "is missing"),
        (PLAIN | {"problem": "x.toml"}, "problem", "is given beside dimensionless"),
        ({**PLAIN, "dimensionless": {"alpha": 1}}, "dimensionless.eta_b", "is missing"),
        (PLAIN | {"masses": 2}, "masses", "is unknown"),
        (changed("study", kind=None), "study.kind", "is missing"),
        (changed("study", kind="certifed"), "study.kind", 'did you mean "certified"?'),
        (changed("study", digit=20), "study.digit", "did you mean digits?"),
        (changed("study", digits=10), "study.digits", "from 15 to 10000"),
        (changed("study", digits=True), "study.digits", "is True"),
        (changed("study", kind="float64", digits=20), "study.digits", "drop it"),
        (changed("study", roots=False), "study.roots", 'is for kind = "float64" only'),
        (changed("study", kind="float64", region=BOX), "study.region", "is a rectangle"),
        (changed("study", region="shet"), "study.region", 'did you mean "sheet"?'),
        (changed("study", region={"re_min": 0}), "study.region.re_max", "is missing"),
        (changed("study", region={"below": 0}), "study.region.below", "not above 0"),
        (changed("study", certificates="yes"), "study.certificates", "true or false"),
        (changed("study", design="grid"), "study.design", "not a section"),
        (changed("study", design={"kind": "radom", "count": 3}), "study.design.kind", 'did you mean "random"?'),
        (changed("study", design={"kind": "random"}), "study.design.count", "is missing"),
        (changed("study", design={"kind": "random", "count": 0}), "study.design.count", "whole number from 1"),
        (changed("study", design={"kind": "grid", "seed": 1}), "study.design.seed", "drop it"),
        (changed("study", design=DRAWN), "parameters.v", "is several values"),
        (PLAIN | {"parameters": {}}, "parameters", "is empty"),
        (changed("parameters", track_kk=1), "parameters.track.kk", "did you mean"),
        (changed("parameters", speed=1), "parameters.speed", "the parameters are"),
        (changed("parameters", v="fast"), "parameters.v", "is not a number"),
        (changed("parameters", v="root4(2)"), "parameters.v", "is irrational"),
        (changed("parameters", v=[]), "parameters.v", "is empty"),
        (changed("parameters", v=[1, 2, "1.0"]), "parameters.v[3]", "is there already"),
        (changed("parameters", v={"low": 0, "high": 1}), "parameters.v", "a grid draws nothing"),
        (changed("parameters", v={"start": 0, "stop": 1}), "parameters.v.step", "is missing"),
        (changed("parameters", v={"start": 0, "stop": 1, "step": -1}), "parameters.v.step", "does not lead"),
        (changed("parameters", v=[0, -1]), "parameters.v", "must not be below 0"),
        (changed("parameters", track_EI=0), "parameters.track.EI", "must be above 0"),
        (changed("parameters", v={"start": 0, "stop": 1, "step": "1e-13"}), "parameters", "at most"),
        (changed("parameters", v={"start": 0, "stop": 1, "step": "1e-300"}), "parameters", "at most"),
    ],
)
def test_a_mistake_is_named_by_its_key(spec: Any, key: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        read_spec(spec)
    assert caught.value.key == key
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("v", "key", "said"),
    [
        ({"low": 1, "high": 1}, "parameters.v.high", "not above low"),
        ({"low": 1}, "parameters.v.high", "is missing"),
        ({"low": -1, "high": 1}, "parameters.v", "must not be below 0"),
        ({"low": 0, "high": "root4(1/2)"}, "parameters.v.high", "is irrational"),
    ],
)
def test_a_mistake_in_a_range(v: Any, key: str, said: str) -> None:
    spec = changed("parameters", v=v) | {"study": {"kind": "certified", "design": DRAWN}}
    with pytest.raises(InputError, match=said) as caught:
        read_spec(spec)
    assert caught.value.key == key


def test_lists_that_go_together_are_as_long_as_each_other() -> None:
    spec = changed("parameters", track_c=[1, 2, 3]) | {"study": {"kind": "certified", "design": {"kind": "list"}}}
    with pytest.raises(InputError, match=r"has 2 values, and track\.c has 3"):
        read_spec(spec)


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (lambda: changed("study", digits=16), ("study.digits", 15, 16)),
        (lambda: changed("parameters", v=[0.1, 0.3]), ("parameters.v", ["1/10", "1/5"], ["1/10", "3/10"])),
        (lambda: changed("parameters", track_N=0), ("parameters.track.N", None, "0")),
    ],
)
def test_differences_are_named(change: Callable[[], Any], expected: tuple[str, Any, Any]) -> None:
    assert list(differences(read_spec(PLAIN).canonical, read_spec(change()).canonical)) == [expected]


def test_the_title_and_the_way_of_writing_make_no_difference() -> None:
    other = changed("parameters", v=["1/10", "0.20"], track_c="1/10") | {"title": "the same"}
    assert not list(differences(read_spec(PLAIN).canonical, read_spec(other).canonical))


EXAMPLE = Path(__file__).parents[2] / "examples" / "two_layer_bogie.toml"


def test_tables_are_plain_and_make_the_problem_of_the_file() -> None:
    named = problem_tables({"problem": EXAMPLE.name}, EXAMPLE.parent)
    own = problem_tables(parsed(EXAMPLE.read_text("utf-8"), "here"), Path())
    assert named == own
    assert named["track"]["EI"] == "6380430"
    assert "title" not in named
    assert problem_of(named, Path("x")).given == read_problem(EXAMPLE).given


def test_a_file_that_is_a_problem_is_named_as_such() -> None:
    """`mpsolve study mine.toml` said that [study] is missing, and not what the file is for."""
    with pytest.raises(InputError, match=r"is a problem, as its \[track\] shows: use mpsolve certify"):
        read_spec("examples/two_layer_bogie.toml")
