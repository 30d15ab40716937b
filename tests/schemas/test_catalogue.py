"""Real outputs fit their schemas; what has lost a key, gained one, or changed its kind does not."""

from __future__ import annotations

import copy
import json
import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from schema_check import errors

from mpsolve import InputError, seeds
from mpsolve.cli import cli
from mpsolve.schemas.catalogue import CATALOGUE, listing, schema_of

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"
PAIR, RAIL, BOGIE = (str(EXAMPLES / f"{name}.toml") for name in ("dimensionless", "rail_60e1", "two_layer_bogie"))
OUTPUTS = {
    "certify": f"certify {BOGIE} --region unstable --digits 15 --json",
    "onset": f"onset {PAIR} --over v=0..1 --json",
    "unstable_ranges": f"onset {RAIL} --all --json",
    "crossings": f"crossings {PAIR} --over scale.mass=0.5..2 --json",
    "worst": f"worst {RAIL} --over vehicles.M=8..12t --json",
    "robust": f"robust {PAIR} --over v=0.6..0.7 --json",  # with a counterexample
    "chart": f"chart {PAIR} --over v=0.3..0.6 --over scale.mass=0.5..1 --depth 3 --json",
    "train": f"train {EXAMPLES / 'endless_train.toml'} --json",
    "critical": f"critical {BOGIE} --json",
    "receptance": f"receptance {RAIL} --omega 1,2,3 --xi=-1,0 --json",
    "roots": "roots z^2-2 --rectangle -3 3 -1 1 --json",
    "audit": f"audit {ROOT / 'tests/claims/toy'} --workers 1 --json",
    "table": f"table {EXAMPLES / 'rail_table.toml'} --workers 1 -o table.json",
    "ratio-table": f"table {EXAMPLES / 'onset_table.toml'} --workers 1 -o ratios.json",
    "response": f"response {BOGIE} --to=0.1s --points 5 -o response.json",
    "page": f"report {PAIR} --effort 3 -o page.html",
    "zeros-certificate": "roots z^2-2 --rectangle -3 3 -1 1 -o zeros.json",
    "certificate": f"certify {BOGIE} --region unstable -o certificate.json",
}


def run(words: str) -> str:
    done = CliRunner().invoke(cli, words.split())
    assert done.exit_code in (0, 1), done.output
    return done.stdout


def output(name: str) -> Any:
    """What the program says now under that name."""
    command = OUTPUTS[name]
    said = run(command)
    if "--json" in command:
        return json.loads(said)
    text = Path(command.split()[-1]).read_text("utf-8")
    if name == "page":
        (text,) = re.findall(r'id="data">(.*?)</script>', text, flags=re.DOTALL)
    return json.loads(text)


def refused_mutants(value: Any, schema: dict[str, Any]) -> None:
    for key in value:
        fewer = {name: one for name, one in value.items() if name != key}
        if key in schema.get("required", ()):
            assert errors(fewer, schema), key
        other = copy.deepcopy(value)
        other[key] = [1] if isinstance(value[key], dict) else [{"no": "such"}]
        if isinstance(value[key], list):
            other[key] = 1.5
        assert errors(other, schema), key
    assert errors(value | {"one more": 1}, schema)


@pytest.mark.parametrize("name", sorted(OUTPUTS))
def test_outputs_fit(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    schema, found = schema_of(name), output(name)
    assert errors(found, schema) == []
    refused_mutants(found, schema)


def test_studies_fit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ("study_certified", "study_float64"):
        file = EXAMPLES / f"{name}.toml"
        if name == "study_float64":
            text = file.read_text("utf-8").replace("two_layer_bogie", str(EXAMPLES / "two_layer_bogie"))
            file = tmp_path / "few.toml"
            file.write_text(text.replace("count = 500", "count = 5"), "utf-8")
        run(f"study {file} -o {name}.sqlite --workers 1")
        run(f"export {name}.sqlite --to json")
        found = json.loads(Path(f"{name}.json").read_text("utf-8"))
        assert errors(found, schema_of("study")) == []
        refused_mutants(found, schema_of("study"))
        assert errors(json.loads(run(f"status {name}.sqlite --json")), schema_of("status")) == []


def test_seeds_fit(tmp_path: Path) -> None:
    file = seeds(["0.67"], ["0.05"], [70], ["1.5"]).save(tmp_path / "seeds.json")
    assert errors(json.loads(file.read_text("utf-8")), schema_of("seeds")) == []


COMMITTED = sorted(file for place in (".", "ranges", "roots") for file in (ROOT / "certs" / place).glob("*.json"))


@pytest.mark.parametrize("file", COMMITTED, ids=lambda file: file.stem)
def test_committed_certificates_fit(file: Path) -> None:
    content = json.loads(file.read_text("utf-8"))
    name = "certificate" if content["version"] == 2 else "range-certificate"
    if file.parent.name in ("ranges", "roots"):
        name = {"ranges": "ranges-certificate", "roots": "zeros-certificate"}[file.parent.name]
    assert errors(content, schema_of(name)) == []
    refused_mutants(content, schema_of(name))


@pytest.mark.parametrize(
    ("pattern", "name"),
    [("study_*.toml", "study-file"), ("rail_table.toml", "table-file"), ("onset_table.toml", "ratio-table-file")],
)
def test_files_that_ask_fit(pattern: str, name: str) -> None:
    for file in sorted(EXAMPLES.glob(pattern)):
        content = tomllib.loads(file.read_text("utf-8"))
        assert errors(content, schema_of(name)) == [], file
        assert errors(content | {"colour": "blue"}, schema_of(name))
        assert errors({key: value for key, value in content.items() if key in ("title", "problem")}, schema_of(name))


def keywords(schema: Any) -> None:
    """Each schema has an address that ends in its version, and references that lead somewhere."""
    assert re.fullmatch(r"https://mpsolve\.invalid/[\w-]+/\d+", schema["$id"])
    for target in re.findall(r'"\$ref": "#/\$defs/([^"]*)"', json.dumps(schema)):
        assert target in schema["$defs"]


def test_zeros_on_an_interval_and_with_a_cut_fit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    run("roots z^2-2 --real -3 3 -o real.json")
    run("roots sqrt(z)-1/2 --rectangle -3 3 -2 2 --cut 0 0 -1 0 -o cut.json")
    for file in ("real.json", "cut.json"):
        assert errors(json.loads(Path(file).read_text("ascii")), schema_of("zeros-certificate")) == []


def test_names_and_versions() -> None:
    ids = []
    for name in CATALOGUE:
        schema = schema_of(name)
        keywords(schema)
        ids.append(schema["$id"])
        assert name in listing()
    assert len(set(ids)) == len(ids)
    with pytest.raises(InputError, match="which is unknown: there are input"):
        schema_of("poem")


def test_no_schema_is_left_out() -> None:
    others = {
        "range-certificate",
        "ranges-certificate",
        "study",
        "status",
        "seeds",
        "study-file",
        "table-file",
        "ratio-table-file",
        "input",
    }
    assert {*OUTPUTS, *others} == set(CATALOGUE)
