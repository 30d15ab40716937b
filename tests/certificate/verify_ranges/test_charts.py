"""Charts in the verifier of ranges: what it does with cells, and files in which something was changed."""

from __future__ import annotations

import copy
import itertools
import json
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import acb, arb, fmpq
from forging import CERTS, as_file

from mpsolve import Problem, certify, frequencies, tracks, vehicles
from mpsolve.certificate import verify_ranges as checker
from mpsolve.certificate.check import verify
from mpsolve.certificate.verify_ranges import Form, Refused, Regions, verify_bytes

Change = Callable[[dict[str, Any]], None]
FILE = CERTS / "ranges" / "chart_over_damping.json"
CONTENT: dict[str, Any] = json.loads(FILE.read_text("ascii"))
"""One mass over velocity and damping: region 0 without, region 1 with two roots that grow, 16 by 16 cells."""
PROBLEM = Problem(tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.4"), vehicles.Mass(10), v="1.3")


def test_the_committed_chart_holds() -> None:
    verdict = verify(FILE)
    assert verdict.valid, verdict.reason
    assert "2 regions of a chart of 16 by 16 cells" in verdict.claim


def test_its_numbers_are_those_of_floats() -> None:
    """In each marked cell, at a corner and inside."""
    rows = CONTENT["claim"]["cells"]
    counts = [one["spectrum"]["claim"]["unstable"] for one in CONTENT["base"]]
    assert counts == [0, 2]
    ends = [[float(Fraction(x)) for x in one] for one in CONTENT["range"]]
    cells = [(i, j) for i, row in enumerate(rows) for j, mark in enumerate(row) if mark != "."]
    for share in ((0.0, 1.0), (0.3, 0.6)):
        x, y = ([a + (b - a) * (cell[k] + share[k]) / 16 for cell in cells] for k, (a, b) in enumerate(ends))
        seen = frequencies(PROBLEM, {"v": np.array(x), "track.c": np.array(y)}, roots=False)
        assert (seen.status == "ok").all()
        assert seen.count.tolist() == [counts[int(rows[i][j])] for i, j in cells]


def put(c: dict[str, Any], i: int, j: int, mark: str) -> None:
    rows = c["claim"]["cells"]
    rows[i] = rows[i][:j] + mark + rows[i][j + 1 :]


def _between(c: dict[str, Any]) -> None:
    i = next(i for i, row in enumerate(c["claim"]["cells"]) if "...0" in row)
    put(c, i, c["claim"]["cells"][i].index("...0") + 2, "0")
    put(c, i, c["claim"]["cells"][i].index("..0") + 1, "0")


def _all_between(c: dict[str, Any]) -> None:
    c["claim"]["cells"] = [row.replace(".", "1") for row in c["claim"]["cells"]]


def _one_region(c: dict[str, Any]) -> None:
    c["base"] = c["base"][:1]
    c["claim"]["cells"] = ["0" * 16] * 16


def _one_region_of_the_other_number(c: dict[str, Any]) -> None:
    """All cells that are marked get the mark of region 0: they do not hang together."""
    c["base"] = c["base"][:1]
    c["claim"]["cells"] = [row.replace("1", "0") for row in c["claim"]["cells"]]


def _exchanged(c: dict[str, Any]) -> None:
    c["claim"]["cells"] = [row.translate(str.maketrans("01", "10")) for row in c["claim"]["cells"]]


def _exchanged_spectra(c: dict[str, Any]) -> None:
    one, other = c["base"]
    one["spectrum"], other["spectrum"] = other["spectrum"], one["spectrum"]


def _a_cell_in_the_other(c: dict[str, Any]) -> None:
    i = next(i for i, row in enumerate(c["claim"]["cells"]) if "111" in row)
    put(c, i, c["claim"]["cells"][i].index("111") + 1, "0")


def _without_base(c: dict[str, Any]) -> None:
    c["base"] = c["base"][:1]


def _no_base(c: dict[str, Any]) -> None:
    c["base"], c["claim"]["cells"] = [], ["." * 16] * 16


def _a_base_too_many(c: dict[str, Any]) -> None:
    c["base"].append(c["base"][0])


def _a_base_beside(c: dict[str, Any]) -> None:
    i, j = 0, next(j for j, mark in enumerate(c["claim"]["cells"][0]) if mark != ".")
    c["base"][int(c["claim"]["cells"][i][j])]["at"] = ["1.25", "0.3"]


def _longer_range(c: dict[str, Any]) -> None:
    """The same cells are others then."""
    c["range"][0][1] = "1.38"


def _narrower_cells(c: dict[str, Any]) -> None:
    """Eight cells along the second parameter with the marks of sixteen."""
    c["claim"]["cells"] = [row[:8] for row in c["claim"]["cells"]]


def _other_mass(c: dict[str, Any]) -> None:
    c["equations"]["vehicle"]["M"][0][0] = "11"


def _closed_leaves(c: dict[str, Any]) -> None:
    c["tree"] = c["tree"].replace("o", "n")


def _cut_tree(c: dict[str, Any]) -> None:
    c["tree"] = c["tree"][:30]


def _a_room(c: dict[str, Any]) -> None:
    c["tree"] = c["tree"].replace("o", "z", 1)


def _stable(c: dict[str, Any]) -> None:
    """Open leaves say nothing of a whole box."""
    c |= {"kind": "stable", "claim": {"unstable": 0}, "base": c["base"][0]}


def _one_leaf(c: dict[str, Any]) -> None:
    """Not within a bounded work."""
    c["tree"] = "o"


def _ragged(c: dict[str, Any]) -> None:
    c["claim"]["cells"][3] += "0"


def _no_cells(c: dict[str, Any]) -> None:
    c["claim"]["cells"] = []


def _empty_rows(c: dict[str, Any]) -> None:
    c["claim"]["cells"] = [""] * 16


def _no_text(c: dict[str, Any]) -> None:
    c["claim"]["cells"][3] = ["0"] * 16


def _too_many(c: dict[str, Any]) -> None:
    c["claim"]["cells"] = ["." * 513] * 3


def _more_is_claimed(c: dict[str, Any]) -> None:
    c["claim"]["unstable"] = 0


@pytest.mark.parametrize(
    "change",
    [
        _between, _all_between, _one_region, _one_region_of_the_other_number, _exchanged, _exchanged_spectra,
        _a_cell_in_the_other, _without_base, _no_base, _a_base_too_many, _a_base_beside, _longer_range,
        _narrower_cells, _other_mass, _closed_leaves, _cut_tree, _a_room, _stable, _one_leaf, _ragged, _no_cells,
        _empty_rows, _no_text, _too_many, _more_is_claimed,
    ],
)  # fmt: skip
def test_a_changed_chart_is_refused(change: Change) -> None:
    changed = copy.deepcopy(CONTENT)
    change(changed)
    assert changed != CONTENT
    verdict = verify_bytes(as_file(changed), 150)
    assert not verdict.valid
    assert not verdict.reason.startswith("malformed"), verdict.reason


def test_another_number_needs_another_spectrum() -> None:
    """A certified spectrum of a lighter mass, without roots that grow, as the base of the region with two."""
    changed = copy.deepcopy(CONTENT)
    at = changed["base"][1]["at"]
    other = PROBLEM.changed("vehicles.M", "1/100").changed("v", at[0]).changed("track.c", at[1])
    found = certify(other, region="unstable")
    assert found.unstable == 0
    changed["base"][1]["spectrum"] = json.loads(found.certificate.text)
    assert "other equations" in verify_bytes(as_file(changed)).reason


def test_claiming_less_holds() -> None:
    """A cell without its mark, and a leaf that is open for nothing."""
    changed = copy.deepcopy(CONTENT)
    i = next(i for i, row in enumerate(changed["claim"]["cells"]) if ".0" in row)
    put(changed, i, changed["claim"]["cells"][i].index(".0") + 1, ".")
    changed["tree"] = changed["tree"].replace("n", "o", 3)
    verdict = verify_bytes(as_file(changed))
    assert verdict.valid, verdict.reason


@pytest.fixture
def regions() -> Regions:
    rows = ["00...", "0..11", "...11", "2.111"]
    return Regions(rows, ((fmpq(-1), fmpq(3)), (fmpq(0), fmpq(1))))


def test_cells_under_a_box_are_those_with_inner_points_in_it(regions: Regions) -> None:
    """By brute force; at edges that both share, too."""
    rng = np.random.default_rng(4)
    for _ in range(300):
        a, b = (fmpq(k, 6) - 1 for k in sorted(rng.choice(25, 2, replace=False).tolist()))
        c, d = (fmpq(k, 30) for k in sorted(rng.choice(31, 2, replace=False).tolist()))
        box = ((fmpq(0), fmpq(1)), (a, b), (c, d))
        met = {
            (i, j) for i, j in itertools.product(range(4), range(5))
            if a < i and i - 1 < b and c < fmpq(j + 1, 5) and fmpq(j, 5) < d
        }  # fmt: skip
        i, k, j, m = regions.under(box)
        assert {(x, y) for x in range(i, k) for y in range(j, m)} == met
        part = regions.shrunk((i, k, j, m))
        marked = {(x, y) for x, y in met if regions.rows[x][y] != "."}
        assert (part is None) == (not marked)
        if part is not None:
            i, k, j, m = part
            assert marked <= {(x, y) for x in range(i, k) for y in range(j, m)}
            assert (min(x for x, _ in marked), max(y for _, y in marked)) == (i, m - 1)
            for x, y in marked:
                (p, q), (r, s) = regions.over((x, x + 1, y, y + 1), box)[1:]
                assert max(a, fmpq(x - 1)) == p < q == min(b, fmpq(x))
                assert max(c, fmpq(y, 5)) == r < s == min(d, fmpq(y + 1, 5))


def test_a_point_lies_in_its_cell(regions: Regions) -> None:
    assert regions.at([fmpq(-1), fmpq(0)]) == (0, 0)
    assert regions.at([fmpq(3), fmpq(1)]) == (3, 4)
    assert regions.at([fmpq(1, 2), fmpq(1, 2)]) == (1, 2)


@pytest.mark.parametrize(
    ("rows", "bases"),
    [
        (["0.", ".0"], [("0", "0")]),  # they meet at a corner only
        (["0.1", "0.1"], [("0", "0"), ("0", "1/2")]),  # a base where nothing is said
        (["0.1", "0.1"], [("0", "0"), ("0", "0")]),
        (["0.2", "0.2"], [("0", "0"), ("0", "1")]),
    ],
)
def test_regions_hang_together_round_their_bases(rows: list[str], bases: list[tuple[str, str]]) -> None:
    box = ((fmpq(0), fmpq(1)), (fmpq(0), fmpq(1)))
    points = [[fmpq(*map(int, x.split("/"))) for x in base] for base in bases]
    with pytest.raises(Refused):
        checker.read_regions({"cells": rows}, box, points)
    assert checker.read_regions({"cells": ["0.1", "001"]}, box, [[fmpq(0), fmpq(0)], [fmpq(0), fmpq(1)]])


def test_a_form_over_a_part_is_the_same_function() -> None:
    rng = np.random.default_rng(6)
    k = [[acb(complex(*x))] for x in rng.normal(size=(10, 2))]
    form = Form(k, [arb("0.25")], 3)
    whole = tuple((fmpq(a), fmpq(b)) for a, b in ((0, 2), (-3, 5), (1, 2)))
    part = ((fmpq(1, 2), fmpq(1)), (fmpq(-1), fmpq(5)), (fmpq(1), fmpq(5, 4)))
    other = checker.over_part(form, whole, part)
    assert other.e == form.e
    for t in ((0, 0, 0), (1, -1, 1), (0.5, 0.25, -1)):
        point = [float(arb((p + q) / 2)) + float(arb((q - p) / 2)) * x for (p, q), x in zip(part, t, strict=True)]
        u = [(x - float(arb((a + b) / 2))) / float(arb((b - a) / 2)) for x, (a, b) in zip(point, whole, strict=True)]
        values = []
        for one, at in ((form, u), (other, t)):
            value = one.k[0][0] + sum(one.k[1 + i][0] * x for i, x in enumerate(at))
            values.append(value + sum(one.k[n][0] * at[i - 1] * at[j - 1] for n, i, j in one.second))
        assert abs(values[0] - values[1]) < 1e-12


def test_boxes_along_a_slope_over_two_parameters_hold_what_numpy_finds() -> None:
    """G at points of parallelepipeds q = t + slope·v: a tree may lay boxes of a chart along a slope, too."""
    box = tuple((fmpq(*map(int, Fraction(a).as_integer_ratio())), fmpq(b)) for a, b in ((1.25, 2), (0.25, 1)))
    read = checker.spectra
    track = read.read_track(CONTENT["equations"]["track"], CONTENT["equations"]["velocity"], box)
    waves = checker.Waves(track, read.read_bodies(CONTENT["equations"]["vehicle"], None, box, 24, 12), box)
    low, high = (0.2, 1.3, 0.375), (0.25, 1.375, 0.4375)
    middle, half = (np.array(high) + low) / 2, (np.array(high) - low) / 2
    here = tuple((fmpq(*a.as_integer_ratio()), fmpq(*b.as_integer_ratio())) for a, b in zip(low, high, strict=True))
    for slope in (-0.125, 0.5):
        with read.precision(64):
            form = checker.kernels_over(waves, checker.place_of(here, fmpq(*slope.as_integer_ratio())), False)
        assert form.e[0] < 0.05 * abs(form.k[0][0])
        for u in ((1, 1, 1), (-1, 1, -1), (1, -1, 1), (0.3, -0.7, 0.5)):
            t, v, c = middle + half * u
            s = 1j * (t + slope * v)
            d = np.array([0.25, 0, v * v, -v * (2 * s + c), s * s + c * s + 1])
            roots = np.roots(d)
            own = roots[roots.real < 0]
            got = form.k[0][0] + sum(form.k[1 + i][0] * u[i] for i in range(3))
            got = got + sum(form.k[n][0] * (u[i - 1] * u[j - 1]) for n, i, j in form.second)
            assert abs(got - complex((1 / np.polyval(np.polyder(d), own)).sum())) < form.e[0] + 1e-9


def test_a_chart_of_two_leaves_beside_is_refused() -> None:
    """Along any slope they hold frequencies in question."""
    verdict = verify_bytes(as_file(CONTENT | {"tree": "s-1e3;bb"}), 60)
    assert not verdict.valid
    assert "beside" in verdict.reason
