"""Every result that a notebook can show has a card, and what has none says so."""

from __future__ import annotations

import pytest

import mpsolve
from mpsolve import display, notebook
from mpsolve.vibration.case_motion import Response


def test_every_result_that_shows_itself_has_a_card() -> None:
    public = [getattr(mpsolve, name) for name in mpsolve.__all__]
    shown = {one for one in public if isinstance(one, type) and hasattr(one, "_repr_html_")}
    assert Response in shown
    own = {one for one in shown if "_repr_html_" in vars(one)}  # other answers show their rows by themselves
    assert own <= set(notebook.card.registry)


def test_what_has_no_card_says_so() -> None:
    with pytest.raises(TypeError, match="a list has no card"):
        display.card([])
