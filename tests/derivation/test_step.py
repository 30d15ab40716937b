"""A step is what is printed of a derivation."""

from __future__ import annotations

import sympy as sp

from mpsolve.derivation.rendered import render
from mpsolve.derivation.step import Step


def test_a_step_is_printed_with_its_number_and_note() -> None:
    x = sp.Symbol("x")
    text = render([Step("(7)", "A square", sp.Eq(x**2, 4), "Two roots.")])
    assert text.splitlines()[:3] == ["(7) A square", "------------", "Two roots."]
    assert "x  = 4" in text
