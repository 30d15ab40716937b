"""The derivation as text and as LaTeX."""

from __future__ import annotations

import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.derivation.problem import derivation_of
from mpsolve.derivation.rendered import render
from mpsolve.errors import InputError

BEAM = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
STEPS = derivation_of(Problem(BEAM, vehicles.train(vehicles.Mass(40), 2, "1.5"), v="0.5"))


def test_text_holds_each_step():
    text = render(STEPS)
    assert all(f"{e.number} {e.title}" in text for e in STEPS)
    assert "Ω" in text


def test_latex_is_ascii_and_balanced():
    source = render(STEPS, style="latex")
    assert source.isascii()
    assert source.startswith("\\documentclass")
    assert source.rstrip().endswith("\\end{document}")
    assert source.count("\\begin{align*}") == source.count("\\end{align*}") == len(STEPS)
    bare = source.replace("\\{", "").replace("\\}", "")
    assert bare.count("{") == bare.count("}")
    assert source.count("\\left") - source.count("\\leftarrow") == source.count("\\right")


def test_another_style_is_refused():
    with pytest.raises(InputError, match="style"):
        render(STEPS, style="html")
