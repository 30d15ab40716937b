"""Roots, logarithms and quotients of z are watched; entire steps and constants are not."""

from __future__ import annotations

import pytest

from mpsolve.zeros.guards import guards
from mpsolve.zeros.parse import parse
from mpsolve.zeros.program import Program


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("sin(z)*exp(z**2) + rgamma(z)/pi + sqrt(2)", []),
        ("sqrt(z) + log(z + 1)", ["sqrt", "log"]),
        ("1/z + atan(z)", ["div", "atan"]),
        ("z/sqrt(2) + log(3)*z", []),
        ("bessel_j(3, z) + cos_sqrt(z)", []),
    ],
)
def test_what_is_watched(text: str, names: list[str]) -> None:
    program = Program()
    parse(program, text)
    assert [program.steps[k][0] for k in guards(program.steps)] == names
