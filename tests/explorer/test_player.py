"""A player is one picture with a button and a slider that have names."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

from mpsolve.explorer.player import CSS, player


def test_a_player_has_controls_and_says_where_the_model_ends() -> None:
    tree = ET.fromstring(player("<svg/>", 2.0, 8.0, 0.5))
    assert [(tree.get(f"data-{name}")) for name in ("lasts", "played", "end")] == ["2", "8", "0.5"]
    assert tree.find("svg") is not None
    assert [e.text for e in tree.iter("button")] == ["Pause"]
    (slider,) = tree.iter("input")
    assert (slider.get("max"), slider.get("aria-label")) == ("2", "Time, s")
    assert ET.fromstring(player("<svg/>", 2.0, 8.0, None)).get("data-end") is None


def test_the_same_colours_in_light_and_in_dark() -> None:
    light, dark = (set(re.findall(r"(--\w+):", part)) for part in re.findall(r"(?::root|body--dark) {([^}]*)}", CSS))
    assert light == dark


def test_every_picture_has_its_size() -> None:
    assert {"#plane", "#shape", "#chart", "#motion", "#moving"} <= set(re.findall(r"(#\w+) svg", CSS))
