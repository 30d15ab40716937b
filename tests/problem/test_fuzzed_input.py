"""Damaged TOML: read_problem gives a problem or an InputError, soon."""

from __future__ import annotations

import contextlib
import tempfile
import time
import tomllib
from pathlib import Path
from typing import Any

from fuzzing import edited, flipped, fuzzed
from hypothesis import strategies as st

from mpsolve.errors import InputError
from mpsolve.problem.inputfile import read_problem

EXAMPLES = Path(__file__).parents[2] / "examples"
NAMES = ["two_layer_bogie", "train_8_coaches", "rail_60e1", "dimensionless", "loads"]
TEXTS = {name: (EXAMPLES / f"{name}.toml").read_text() for name in NAMES}
LONGEST = 20.0  # processor seconds


def toml(value: Any) -> str:
    """A TOML value in one line."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        return "{" + ", ".join(f"{quoted(str(k))} = {toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return quoted(value) if isinstance(value, str) else "nan" if value is None else str(value)


def quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def read(raw: bytes, folder: Path) -> None:
    path = folder / "input.toml"
    path.write_bytes(raw)
    began = time.process_time()
    with contextlib.suppress(InputError):
        read_problem(path)
    assert time.process_time() - began < LONGEST


def folder(name: str) -> Path:
    place = Path(tempfile.gettempdir()) / f"mpsolve-fuzz-{name}"
    place.mkdir(exist_ok=True)
    return place


@fuzzed(300, st.data(), st.sampled_from(NAMES))
def test_edited_inputs(data: st.DataObject, name: str) -> None:
    content = data.draw(edited(tomllib.loads(TEXTS[name])))
    if isinstance(content, dict):
        lines = [f"{quoted(str(k))} = {toml(v)}" for k, v in content.items()]
        read("\n".join(lines).encode("utf-8", "surrogatepass"), folder("edits"))


@fuzzed(300, st.data(), st.sampled_from(NAMES))
def test_flipped_inputs(data: st.DataObject, name: str) -> None:
    read(data.draw(flipped(TEXTS[name].encode())), folder("flips"))
