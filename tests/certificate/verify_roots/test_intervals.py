"""Tiles of certificates of real zeros: each check for its own reason."""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import Any

import pytest
from flint import acb
from forging import Content, as_file, put, stored

from mpsolve.certificate import verify_roots as vr
from mpsolve.certificate.verify2 import Refused


def reason(content: Content) -> str:
    return vr.verify_bytes(as_file(content)).reason


Z = ["z"]


def function(*steps: Any) -> vr.Function:
    return vr.Function(vr.read_steps(list(steps)), len(steps) - 1)


def _tiles(**changed: Any) -> Callable[[Content], None]:
    return lambda c: c["tiles"][0].update(changed)


def _marked(old: str, new: str, count: int = 1) -> Callable[[Content], None]:
    return lambda c: c["tiles"][0].update(kinds=c["tiles"][0]["kinds"].replace(old, new, count))


def _bracket(*ends: str) -> Callable[[Content], None]:
    return lambda c: c["tiles"][0]["brackets"].__setitem__(0, list(ends))


INTERVALS: dict[str, tuple[Callable[[Content], Any], str]] = {
    "turned": (put("interval", ["20", "1"]), "interval is empty"),
    "longer": (put("interval", ["1", "21"]), "do not cover"),
    "earlier": (put("interval", ["0", "20"]), "do not cover"),
    "no text": (_tiles(kinds=["."]), "do not fit"),
    "a kind less": (_marked(".", ""), "do not fit"),
    "another kind": (_marked(".", "2"), "kind of a tile is not known"),
    "a tile without its zero": (_marked("1", "."), "may hold a zero"),
    "a zero in a tile without": (_marked(".", "1"), "a tile"),
    "a bracket beyond its tile": (_bracket("4", "20"), "not in its tile"),
    "a bracket turned": (_bracket("9/2", "89/20"), "not in its tile"),
    "a bracket without a zero": (_bracket("4", "81/20"), "not proved to hold a zero"),
    "fewer": (put("claim", "zeros", 4), "claimed number"),
    "more at once": (put("claim", "multiplicities", [2, 1, 1, 1, 1]), "claimed multiplicities"),
    "over what vanishes": (lambda c: c["function"].update(denominator=c["function"]["numerator"]), "denominator"),
}


@pytest.mark.parametrize("name", INTERVALS)
def test_an_interval_is_refused(name: str) -> None:
    change, why = INTERVALS[name]
    content = stored("roots/tangent")
    assert reason(content) == ""
    change(content)
    assert why in reason(content)


@pytest.mark.parametrize(
    ("ends", "kind", "why"),
    [
        (("1/2", "2"), ".", "may hold a zero"),
        (("1/2", "3/4"), "1", "slope may vanish"),
        (("-1/2", "1/2"), "1", None),
        (("1/8", "1/2"), "1", "not proved to hold a zero"),
        (("0", "1/2"), "1", None),
        (("1/8", "1/4"), ".", None),
    ],
)
def test_one_tile(ends: tuple[str, str], kind: str, why: str | None) -> None:
    """Of z³ − z, whose slope is 0 at 0.577."""
    g = function(Z, ["pow", 0, 3], ["sub", 1, 0])
    low, high = (vr.rational(x, "an end") for x in ends)
    zero = "0" if low <= 0 else ends[0]
    row = {"bits": 64, "places": list(ends), "kinds": kind, "sharp": 64, "brackets": [[zero, zero]] * (kind == "1")}
    if why is None:
        assert len(vr.tiles_of(g, 1, low, high, copy.deepcopy(row), g)) == (kind == "1")
    else:
        with pytest.raises(Refused, match=why):
            vr.tiles_of(g, 1, low, high, row, g)


def test_zeros_of_two_factors_are_told_apart() -> None:
    """Of z and z − 2⁻⁷⁰, in brackets that hold both, or one each."""
    steps = [Z, ["number", f"1/{2**70}"], ["sub", 0, 1], ["mul", 0, 2]]
    tile = {"bits": 64, "places": ["-1", "1"], "kinds": "1", "sharp": 128}
    content = stored("roots/tangent") | {
        "function": {"steps": steps, "numerator": 3, "denominator": None},
        "interval": ["-1", "1"],
        "tiles": [tile | {"brackets": [["0", "0"]]}, tile | {"brackets": [[steps[1][1]] * 2]}],
        "claim": {"zeros": 2, "multiplicities": [1, 1]},
    }
    assert reason(content) == ""
    content["tiles"][0]["brackets"] = [["-1/2", "1/2"]]
    assert "not told apart" in reason(content)


def test_a_tile_on_which_the_function_is_not_finite_is_refused() -> None:
    with vr.precision(64), pytest.raises(Refused, match="not finite"):
        vr.tile_value(function(Z, ["exp", 0]), acb("inf"), 1)
