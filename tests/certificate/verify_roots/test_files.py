"""Functions, paths, discs and tiles of certificates of zeros: each check for its own reason."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from flint import fmpq
from forging import Content, as_file, put, stored

from mpsolve.certificate import verify_roots as vr
from mpsolve.certificate.verify2 import Refused


def reason(content: Content) -> str:
    return vr.verify_bytes(as_file(content)).reason


# --- the function ---------------------------------------------------------------------------------------------

Z = ["z"]
STEPS: dict[str, tuple[list[Any], str]] = {
    "no name": ([[1]], "no name"),
    "no number": ([["number"]], "right parts"),
    "a number too many": ([["z", "1"]], "right parts"),
    "a later step": ([Z, ["exp", 1]], "earlier step"),
    "one of two": ([Z, ["add", 0]], "in place of 2"),
    "not known": ([Z, ["gamma", 0, 1]], "the step gamma is not known"),
    "no order": ([Z, ["bessel_j", 0]], "is not known"),
    "no power": ([Z, ["pow", 0, 0]], "a power is not"),
    "half an order": ([Z, ["bessel_j", 0, "1/2"]], "an order is not"),
    "a pole of hyp0f1": ([Z, ["hyp0f1", 0, "0"]], "not above 0"),
    "another one": ([Z, ["hyp0f1", 0, "-1"]], "not above 0"),
}


@pytest.mark.parametrize("name", STEPS)
def test_steps_are_refused(name: str) -> None:
    value, why = STEPS[name]
    with pytest.raises(Refused, match=why):
        vr.read_steps(value)


ZERO = ["number", "0"]
FUNCTIONS: dict[str, tuple[list[Any], str]] = {
    "0": ([Z, ZERO], "may be 0"),
    "0·z": ([Z, ZERO, ["mul", 1, 0]], "may be 0"),
    "sin(π)·z": ([Z, ["pi"], ["sin", 1], ["mul", 2, 0]], "may be 0"),
    "z/0": ([Z, ZERO, ["div", 0, 1]], "may be 0 or infinite"),
    "z/rgamma(0)": ([Z, ZERO, ["rgamma", 1], ["div", 0, 2]], "may be 0 or infinite"),
    "z·log 0": ([Z, ZERO, ["log", 1], ["mul", 2, 0]], "may be 0 or infinite"),
    "z/log 0": ([Z, ZERO, ["log", 1], ["div", 0, 2]], "may be 0 or infinite"),
    "a high power": ([Z, *(["pow", k, 10_000] for k in range(3))], "too many factors"),
    "squares of squares": ([Z, *(["mul", k, k] for k in range(60))], "too many factors"),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_is_refused(name: str) -> None:
    steps, why = FUNCTIONS[name]
    with vr.precision(64), pytest.raises(Refused, match=why):
        vr.Function(vr.read_steps(steps), len(steps) - 1)


def function(*steps: Any) -> vr.Function:
    return vr.Function(vr.read_steps(list(steps)), len(steps) - 1)


# --- regions --------------------------------------------------------------------------------------------------


def _first_break(places: Callable[[list[int]], list[int]]) -> Callable[[Content], None]:
    return lambda c: c["breaks"][0].update(places=places(c["breaks"][0]["places"]))


def _a_disc(radius: str) -> Callable[[Content], None]:
    """About 0, through the zero at 0.39 or so, or with all but those of largest modulus."""
    return put("region", {"kind": "disc", "centre": ["0", "0"], "radius": radius})


def _disc_outside(content: Content) -> None:
    content["roots"].append(content["roots"][0] | {"re": "0x1", "im": "0x0", "exponent": 5, "radius": [1, -9]})


ENDS = "gone from end to end"
REGIONS: dict[str, tuple[str, Callable[[Content], Any], str]] = {
    "boxes of an entire function": ("sine", put("trees", ["."]), "needs no boxes"),
    "no text": ("slanting_cut", put("trees", 0, ["."]), "no text"),
    "another mark": ("slanting_cut", put("trees", 0, "x"), "does not fit its cell"),
    "more than its cell": ("slanting_cut", put("trees", 0, ".."), "does not fit its cell"),
    "less than its cell": ("slanting_cut", put("trees", 0, "|."), "before its cell is covered"),
    "no box": ("slanting_cut", put("trees", 0, ""), "before its cell is covered"),
    "left out": ("slanting_cut", put("trees", 0, "o"), "not outside the region"),
    "one cell less": ("slanting_cut", lambda c: c["trees"].pop(), "in place of 4"),
    "from later on": ("sine", _first_break(lambda m: m[1:]), ENDS),
    "to the last but one": ("sine", _first_break(lambda m: m[:-1]), ENDS),
    "nowhere": ("sine", put("breaks", 0, {"exponent": 0, "places": [0]}), ENDS),
    "no place": ("sine", put("breaks", 0, {"exponent": 0, "places": []}), ENDS),
    "back and forth": ("sine", _first_break(lambda m: [*m[:3], *m[1:]]), "not in order"),
    "a place twice": ("sine", _first_break(lambda m: [m[0], *m]), "not in order"),
    "a pole for a zero": ("sine", put("function", {"steps": [["z"]], "numerator": 0, "denominator": 0}), ""),
    "a disc far outside": ("sine", _disc_outside, "not inside the polygon"),
    "a disc across the circle": ("sine", _a_disc("0"), "the disc is empty"),
    "fewer than are inside": ("sine", put("claim", {"count": 6}), "the claimed count"),
    "another circle": ("sine", _a_disc("4"), "the claimed count"),
}


@pytest.mark.parametrize("name", REGIONS)
def test_a_region_is_refused(name: str) -> None:
    file, change, why = REGIONS[name]
    content = stored(f"roots/{file}")
    assert reason(content) == ""
    change(content)
    said = reason(content)
    assert said
    assert why in said


def test_a_zero_on_the_circle_of_a_region_is_refused() -> None:
    """One of sin z = z/2 is 1.8954942670339809: its disc has that on its left, or in it, or on its right."""
    content = stored("roots/sine")
    one = max(
        content["roots"], key=lambda r: int(r["re"], 16) * (abs(int(r["im"], 16)) * 2.0 ** r["exponent"] < 1e-9)
    )
    place = fmpq(int(one["re"], 16)) * vr.spectra.power_of_2(one["exponent"])
    content["region"] = {"kind": "disc", "centre": ["0", "0"], "radius": str(place)}
    assert "meets the boundary" in reason(content)


def test_a_turn_that_is_no_number_of_zeros_is_refused() -> None:
    """Round a pole, which only the boxes of the region would refuse."""
    f = function(Z, ["number", "1/16"], ["sub", 0, 1], ["number", "1"], ["div", 3, 2])
    corners = [(fmpq(x), fmpq(y)) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    breaks = [{"exponent": 4, "places": list(range(17))}] * 4
    with vr.precision(64):
        legs = vr.legs_round(corners, [])
        assert vr.count(function(Z), legs, breaks) == [1]
        with pytest.raises(Refused, match="not one number"):
            vr.count(f, legs, breaks)


BOUNDS = {"MAX_PIECES": 30, "MAX_WORK": 200}


@pytest.mark.parametrize("name", BOUNDS)
def test_the_pieces_of_a_path_are_bounded(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setattr(vr, name, BOUNDS[name])
    corners = [(fmpq(x), fmpq(y)) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    breaks = [{"exponent": 4, "places": list(range(17))}] * 4
    with vr.precision(64), pytest.raises(Refused, match="too many pieces"):
        vr.count(function(Z), vr.legs_round(corners, []), breaks)


def test_boxes_digits_and_tiles_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(vr, "MAX_WORK", 80)
    content = stored("roots/slanting_cut")
    assert "too many boxes" in reason(content | {"trees": ["." * 100, ".", ".", "."]})
    root = vr.read_root({"re": "0x0", "im": "0x0", "exponent": 0, "radius": [1, -200], "multiplicity": 1})
    with pytest.raises(Refused, match="too many digits"):
        vr.check_root(function(Z), None, root)
    assert "too many tiles" in reason(stored("roots/tangent"))
