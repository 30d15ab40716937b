"""The template escapes what it is given, and misses nothing silently."""

from __future__ import annotations

import pytest
from jinja2 import UndefinedError

from mpsolve.page.template import rendered


def test_what_is_missing_is_an_error() -> None:
    with pytest.raises(UndefinedError):
        rendered("page.html.j2", title="x")
