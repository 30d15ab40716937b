"""The templates escape what they are given, lower subscripts, and miss nothing silently."""

from __future__ import annotations

import pytest
from jinja2 import UndefinedError

from mpsolve.report.template import rendered, with_subscripts


@pytest.mark.parametrize("name", ["page.html.j2", "card.html.j2"])
def test_what_is_missing_is_an_error(name: str) -> None:
    with pytest.raises(UndefinedError):
        rendered(name)


def test_symbols_get_subscripts_and_all_else_is_escaped() -> None:
    assert with_subscripts("η_b < 1, re_max") == "η<sub>b</sub> &lt; 1, re_max"
