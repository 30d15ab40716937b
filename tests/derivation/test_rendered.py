"""The derivation as text and as LaTeX."""

from __future__ import annotations

import unicodedata

import pytest

from mpsolve.derivation.paper import derivation
from mpsolve.derivation.rendered import render
from mpsolve.errors import InputError


def test_text_holds_each_step():
    text = render(derivation(2))
    assert all(f"{e.number} {e.title}" in text for e in derivation(2))
    assert unicodedata.normalize("NFC", "ŵ(ξ, τ)") in unicodedata.normalize("NFC", text)


def test_latex_is_ascii_and_balanced():
    source = render(derivation(2), style="latex")
    assert source.isascii()
    assert source.startswith("\\documentclass")
    assert source.rstrip().endswith("\\end{document}")
    assert source.count("\\begin{align*}") == source.count("\\end{align*}") == len(derivation(2))
    bare = source.replace("\\{", "").replace("\\}", "")
    assert bare.count("{") == bare.count("}")
    assert source.count("\\left") - source.count("\\leftarrow") == source.count("\\right")


def test_another_style_is_refused():
    with pytest.raises(InputError, match="style"):
        render(derivation(1), style="html")
