"""Colours are there in light and in dark, and pictures do not grow beyond their size."""

from __future__ import annotations

import re

from mpsolve.explorer.style import CSS


def test_the_same_colours_in_light_and_in_dark() -> None:
    light, dark = (set(re.findall(r"(--\w+):", part)) for part in re.findall(r"(?::root|body--dark) {([^}]*)}", CSS))
    assert light == dark


def test_every_picture_has_its_size() -> None:
    assert {"#plane", "#shape", "#chart", "#motion", "#moving"} <= set(re.findall(r"(#\w+) svg", CSS))
