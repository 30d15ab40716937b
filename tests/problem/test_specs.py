"""The pieces of which tables and studies are read: exact numbers, and each mistake under its key."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from mpsolve import InputError
from mpsolve.problem.specs import choice, load, rationals, steps
from mpsolve.problem.toml import kind, section, title_of

KNOWN = {"title": "a text", "quantity": "what is asked"}
ENDS = {"start": "0.1", "stop": "0.7", "step": "0.2"}


def test_a_mapping_or_a_file(tmp_path: Path) -> None:
    file = tmp_path / "table.toml"
    file.write_text('title = "Onsets"\nquantity = 0.10\n', "utf-8")
    assert load(file, KNOWN) == {"title": "Onsets", "quantity": "0.10"} == load(load(str(file), KNOWN), KNOWN)
    assert (title_of(load(file, KNOWN)), title_of({})) == ("Onsets", "")


def test_steps_are_exact() -> None:
    assert steps(ENDS, "v") == (Fraction(1, 10), Fraction(1, 5), 4)  # 0.7 is one of them, unlike in floats
    assert steps({**ENDS, "stop": "0.69"}, "v")[2] == 3
    assert steps({"start": 5, "stop": 1, "step": "-2"}, "v") == (5, -2, 3)
    assert rationals(ENDS, "v", dict.fromkeys(ENDS, "a value"))["stop"] == Fraction(7, 10)


@pytest.mark.parametrize(
    ("read", "said"),
    [
        (lambda: load(3, KNOWN), "spec: is a number: give a mapping, or the path"),  # type: ignore[arg-type]
        (lambda: load({"quantiy": 1}, KNOWN), "quantiy: is unknown: did you mean quantity?"),
        (lambda: title_of({"title": 3}), "title: is a number, not a text"),
        (lambda: choice({}, "kind", ("grid", "random")), 'kind: is missing: give one of "grid", "random"'),
        (lambda: choice({"kind": "gird"}, "kind", ("grid", "random")), "kind: is 'gird': did you mean \"grid\"?"),
        (lambda: choice({"kind": [1]}, "kind", ("grid",)), 'kind: is a list: give one of "grid"'),
        (lambda: steps({**ENDS, "step": 0}, "v"), "v.step: is 0, which does not lead from start to stop"),
        (lambda: steps({**ENDS, "step": -1}, "v"), "v.step: is -1, which does not lead"),
        (lambda: rationals({"start": 1}, "v", {"start": "", "stop": "the end"}), "v.stop: is missing: give the end"),
        (lambda: rationals({"start": "root4(2)"}, "v", {"start": ""}), "v.start: is irrational"),
        (lambda: section([], "design", {"kind": ""}), "design: is a list, not a section: give kind in it"),
    ],
)
def test_mistakes(read: Callable[[], Any], said: str) -> None:
    with pytest.raises(InputError) as error:
        read()
    assert str(error.value).startswith(said)


def test_kinds_are_those_of_toml() -> None:
    assert [kind(x) for x in ({}, [], "", True, 1, 1j)] == [
        "a table", "a list", "a text", "a boolean", "a number", "of type complex",
    ]  # fmt: skip
