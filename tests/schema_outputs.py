"""What the program writes now, under the names of the schemas, and how a schema refuses what was broken."""

from __future__ import annotations

import copy
import json
import re
from pathlib import Path
from typing import Any

from click.testing import CliRunner
from schema_check import errors

from mpsolve.cli import cli
from mpsolve.schemas.catalogue import schema_of

ROOT = Path(__file__).parents[1]
EXAMPLES = ROOT / "examples"
PAIR, RAIL, BOGIE = (str(EXAMPLES / f"{name}.toml") for name in ("dimensionless", "rail_60e1", "two_layer_bogie"))
OUTPUTS = {
    "certify": f"certify {BOGIE} --region unstable --digits 15 --json",
    "onset": f"onset {PAIR} --over v=0.66..0.68 --json",
    "unstable_ranges": f"onset {PAIR} --all --over v=0.66..0.68 --json",
    "crossings": f"crossings {PAIR} --over scale.mass=0.5..2 --json",
    "lines": f"lines {PAIR} --over v=0.4..0.5 --points 3 --json",
    "worst": f"worst {RAIL} --over vehicles.M=8..12t --json",
    "robust": f"robust {PAIR} --over v=0.6..0.7 --json",  # with a counterexample
    "chart": f"chart {PAIR} --over v=0.6..0.7 --over scale.mass=0.8..1.1 --depth 3 --json",
    "train": f"train {EXAMPLES / 'endless_train.toml'} --json",
    "critical": f"critical {BOGIE} --json",
    "receptance": f"receptance {RAIL} --omega 1,2,3 --xi=-1,0 --json",
    "roots": "roots z^2-2 --rectangle -3 3 -1 1 --json",
    "audit": f"audit {ROOT / 'tests/claims/toy'} --workers 1 --json",
    "table": f"table {EXAMPLES / 'rail_table.toml'} --workers 1 -o table.json",
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


def checked(name: str) -> None:
    """The output of that name fits its schema; what has lost a key, gained one or changed its kind does not."""
    schema, found = schema_of(name), output(name)
    assert errors(found, schema) == []
    refused_mutants(found, schema)
