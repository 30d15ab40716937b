"""Certificates over ranges: tracks, bases, cells and trees that one check alone stands against."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest
from flint import fmpq
from forging import Content, as_file, put, sealed, stored

from mpsolve.certificate import verify_ranges as vr

CROSSING, STABLE, CHART = "crossing_over_velocity", "stable_over_damping", "chart_over_damping"
SLOPED = "nearly_undamped_d1.5"


def reason(content: Content) -> str:
    return vr.verify_bytes(as_file(content), 300).reason


# --- the track ------------------------------------------------------------------------------------------------

BOX = ((fmpq(1), fmpq(2)),)


def track(matrix: list[Any], velocity: Any) -> vr.spectra.Track:
    return vr.spectra.read_track({"matrix": matrix, "loaded": 0}, velocity, BOX)


BEAM = [[4, 0, "1"], [0, 2, "1"], [0, 1, "1"], [0, 0, "1"]]
V = [[1, "1"]]
TRACKS: dict[str, tuple[list[Any], Any, str]] = {
    "at rest": ([[BEAM]], "0", "velocity is 0"),
    "as fast as its shortest waves": ([[[*BEAM, [2, 2, "-1"]]]], "1", "on the frequency"),
    "a string as fast as its waves somewhere": (
        [[[[2, 0, "-3"], [0, 2, "1"], [0, 1, "1"], [0, 0, "1"]]]], V, "a wave speed"
    ),
    "undamped": ([[[t for t in BEAM if t[1] != 1]]], V, "not proved stable and damped"),
    "rotatory inertia": ([[[*BEAM, [2, 2, "-1/9"], [2, 1, "-1/9"]]]], V, "depends on the wavenumber"),
    "no inertia": ([[[[4, 0, "1"], [0, 1, "1"], [0, 0, "1"]]]], V, "as a mass's"),
}  # fmt: skip


@pytest.mark.parametrize("name", TRACKS)
def test_a_track_is_refused(name: str) -> None:
    matrix, velocity, why = TRACKS[name]
    vr.check_track(track([[BEAM]], V), BOX)
    with pytest.raises(vr.Refused, match=why):
        vr.check_track(track(matrix, velocity), BOX)


def test_an_inertia_of_both_signs_is_refused() -> None:
    P, s, x = vr.spectra.read_rows({"matrix": [[BEAM]], "loaded": 0}, 1)[0].gens()
    for big, fine in ((x, True), (x - 1, False), (2 * x - 3, False), (-x, False)):
        some = SimpleNamespace(D=big * s**2 + P**4 + 1, N=P * 0 + 1)
        if fine:
            vr.check_inertia(some, BOX)  # type: ignore[arg-type]
        else:
            with pytest.raises(vr.Refused, match="may vanish"):
                vr.check_inertia(some, BOX)  # type: ignore[arg-type]


# --- the file -------------------------------------------------------------------------------------------------


def _as_stable(content: Content) -> None:
    """Roots cross the real axis in their rooms, and the claim says that none does."""
    content["kind"], content["claim"] = "stable", {"unstable": 0}


def _base(**changed: Any) -> Callable[[Content], None]:
    def change(content: Content) -> None:
        spectrum = content["base"]["spectrum"] | changed
        content["base"]["spectrum"] = sealed(spectrum)

    return change


def _of_a_disc(content: Content) -> None:
    """The base counts within a radius alone. Whether the file holds is not asked here."""
    _base(claim=content["base"]["spectrum"]["claim"] | {"region": {"kind": "disc", "radius": "1"}})(content)


def _other_basis(content: Content) -> None:
    content["basis"] = {"matrix": [["1", "0"], ["0", "1"]], "neutral": 0, "unfelt": 0}


def _overlapping(content: Content) -> None:
    content["beyond"] = [content["tail"]["Q"], content["X"]]


FILES: dict[str, tuple[str, Callable[[Content], Any], str]] = {
    "a range turned": (CROSSING, lambda c: c["range"][0].reverse(), "range is empty"),
    "a range of one point": (STABLE, put("range", 0, ["1", "1"]), "range is empty"),
    "crossings over two": (STABLE, put("kind", "crossings"), "crossings are over one"),
    "a chart over one": (CROSSING, put("kind", "chart"), "a chart is over two"),
    "a chart without a base": (CHART, put("base", []), "without a base"),
    "crossings in a stable range": (CROSSING, _as_stable, "to be stable"),
    "no frequency": (CROSSING, put("X", [0, 0]), "not between 0 and Q"),
    "frequencies beyond the theorem": (CROSSING, put("X", [1, 40]), "not between 0 and Q"),
    "cells in another order": (CROSSING, _overlapping, "not in order"),
    "no text": (CROSSING, put("tree", ["n"]), "no text"),
    "no leaf": (CROSSING, put("tree", ""), "no text, or too long"),
    "an open leaf": (STABLE, put("tree", "o"), "a leaf is open"),
    "a leaf beside": (CROSSING, put("tree", "b"), "does not lie beside"),
    "a leaf after the last": (CROSSING, lambda c: c.update(tree=c["tree"] + "b"), "goes on beyond"),
    "a leaf that is missing": (CROSSING, put("tree", "0b"), "does not lie beside"),
    "absorbing at rest": (CROSSING, put("tree", "g"), "begins at q = 0"),
    "absorbing in cells at rest": (CROSSING, put("tree", "p"), "begins at q = 0"),
    "absorbing along a slope": (SLOPED, put("tree", "s-1e-10;p"), "has a slope"),
    "another mark": (CROSSING, put("tree", "x"), "not known"),
    "another variable": (CROSSING, put("tree", "2nn"), "not known"),
    "a base outside": (CROSSING, lambda c: c["base"].update(at=["1"]), "outside the ranges"),
    "a base with another number": (
        CROSSING,
        lambda c: _base(claim=c["base"]["spectrum"]["claim"] | {"count": 4, "unstable": 4})(c),
        "the spectrum at the base",
    ),
    "another basis": (CROSSING, _other_basis, "another basis"),
}


@pytest.mark.parametrize("name", FILES)
def test_a_file_is_refused(name: str) -> None:
    file, change, why = FILES[name]
    content = stored(f"ranges/{file}")
    change(content)
    assert why in reason(content)


def test_a_base_counts_all_of_the_lower_half_plane(monkeypatch: pytest.MonkeyPatch) -> None:
    content = stored(f"ranges/{CROSSING}")
    _of_a_disc(content)
    valid = vr.spectra.Verdict(True)
    monkeypatch.setattr(vr.spectra, "verify_bytes", lambda _: valid)
    assert "all of Im q < 0" in reason(content)


# --- work, and cells ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("left", "why"), [(10, "asks for more work"), (1000, "q and parameters 0.99.*: a box is open")]
)
def test_a_box_that_stays_open_is_not_halved_for_ever(monkeypatch: pytest.MonkeyPatch, left: int, why: str) -> None:
    def never(*_: Any) -> None:
        raise vr.Wide("a box is open")

    some = vr.Family(None, None, BOX, None, None, None, left)  # type: ignore[arg-type]
    monkeypatch.setattr(vr.Family, "nonzero", never)
    with pytest.raises(vr.Refused, match=why):
        some.prove("n", ((fmpq(0), fmpq(1)), *BOX))
    assert some.pieces == min(left, vr.DEPTH + 1)


def test_the_work_of_cells_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: Any) -> None:
        raise vr.Wide("a box is open")

    some = vr.Family(None, None, PLANE, None, None, None, 12)  # type: ignore[arg-type]
    monkeypatch.setattr(vr.Family, "scalar", never)
    regions = vr.Regions(["0" * 64] * 64, PLANE)
    with pytest.raises(vr.Refused, match="asks for more work"):
        vr.check_regions(some, regions, ((fmpq(0), fmpq(1)), *PLANE))
    assert some.pieces <= 13


PLANE = ((fmpq(0), fmpq(3)), (fmpq(0), fmpq(2)))
CELLS: dict[str, tuple[Any, list[tuple[Any, Any]], str]] = {
    "right": (["00", "0.", "11"], [("1/2", 1), ("5/2", 1)], ""),
    "a base in an open cell": (["00", "0.", "11"], [("3/2", "3/2"), ("5/2", 1)], "outside of its region"),
    "a base in the other region": (["00", "0.", "11"], [("5/2", 1), ("1/2", 1)], "outside of its region"),
    "a mark without a base": (["00", "0.", "11"], [("1/2", 1)], "unknown mark"),
    "another mark": (["00", "0?", "11"], [("1/2", 1), ("5/2", 1)], "unknown mark"),
    "cells that touch in a corner": (["0.", ".0", ".."], [("1/2", "1/2")], "hang together"),
    "rows of two lengths": (["00", "0", "11"], [("1/2", 1), ("5/2", 1)], "rows of one length"),
    "no row": ([], [], "rows of one length"),
    "rows without cells": (["", ""], [], "rows of one length"),
    "numbers": ([[0, 0], [0, 0]], [], "rows of one length"),
}


@pytest.mark.parametrize("name", CELLS)
def test_regions_of_cells(name: str) -> None:
    rows, bases, why = CELLS[name]
    points = [[vr.rational(str(x), "x") for x in base] for base in bases]
    if not why:
        assert vr.read_regions({"cells": rows}, PLANE, points).sums[-1][-1] == 5
    else:
        with pytest.raises(vr.Refused, match=why):
            vr.read_regions({"cells": rows}, PLANE, points)
