"""Lines of the whole sheet: floats find as many roots at random values, and each cut point is the end of a line."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from mpsolve import (
    Case,
    Effort,
    FrequencyLines,
    InputError,
    Problem,
    certify,
    cut_points,
    frequencies,
    frequency_lines,
    tracks,
)
from mpsolve import vehicles as bodies
from mpsolve.cuts.reached import all_reached
from mpsolve.loci import on_sheet
from mpsolve.outcome import Status
from mpsolve.spectrum.regions import Sheet


def twins(eta_m: object, d: str, eta_b: str = "0") -> Case:
    return Case(alpha="0.9", eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, d))  # type: ignore[arg-type]


def followed(case: Case, path: str, low: str, high: str, number: int = 6) -> FrequencyLines:
    """At random values, where floats must find the same roots, all of them."""
    values = np.sort(np.random.default_rng(11).uniform(float(low), float(high), number)).tolist()
    found = frequency_lines(case, over={path: (low, high)}, points=values, digits=15, check=False)
    assert found.status is Status.UNVERIFIED, found.reason
    assert isinstance(found.region, Sheet)
    seen = frequencies(case, {path: values}, region="sheet")
    assert (seen.count >= 0).sum() > number / 2  # what floats do not count lies next to a cut
    for value, row in zip(found.values, seen.roots, strict=True):
        roots = row[np.isfinite(row)]
        if not len(roots):
            continue
        mine = [complex(line.q[line.values.index(value)]) for line in found.lines if value in line.values]
        assert len(roots) == sum(line.weight for line in found.lines if value in line.values)
        assert all(np.abs(roots - q).min() < 1e-10 for q in mine)
    return found


def ends(found: FrequencyLines) -> list[tuple[object, str | None, bool]]:
    """(value, side, whether the line begins there) of all ends at cuts."""
    each = [(end, k == 0) for line in found.lines for k, end in enumerate(line.ends) if end.kind == "cut"]
    return sorted(((end.value, end.side, first) for end, first in each), key=lambda one: float(one[0]))


@pytest.mark.parametrize(
    ("case", "low", "high", "sides"),
    [
        (twins(70, "1.5", "0.05"), "0.96", "1.06", [("below", False), ("above", True)]),
        (twins(40, "0.5"), "0.7", "0.8", [("gap", False)]),
        pytest.param(twins(10, "1.5", "0.05"), "0.6", "1.1", [("below", False), ("above", True)],
                     marks=pytest.mark.slow),
        pytest.param(twins(40, "2.5"), "0.8", "0.95", [("gap", False)], marks=pytest.mark.slow),
        pytest.param(twins(70, "1.5"), "1.05", "1.4", [], marks=pytest.mark.slow),
    ],
)  # fmt: skip
def test_lines_end_at_the_cut_points(case: Case, low: str, high: str, sides: list[tuple[str, bool]]) -> None:
    """Figures 2 and 9: below α_C without damping, through the velocity at which cuts join with it, and beyond."""
    found = followed(case, "v", low, high)
    known = cut_points(case, over={"v": (low, high)})
    assert [one[1:] for one in ends(found)] == sides
    for (value, side, first), point in zip(ends(found), known.points, strict=True):
        assert value.overlaps(point.value)  # type: ignore[attr-defined]
        assert (side, first) == (point.side, point.appears)
    assert [event.side for event in found.events] == [side for side, _ in sides]
    assert json.loads(found.to_json())["lines"]


@pytest.mark.parametrize("path", ["scale.mass", pytest.param("gap[0]", marks=pytest.mark.slow)])
def test_any_parameter_leads_to_the_cut(path: str) -> None:
    """At α = 0.9640196 of Figure 9 b the line is on the cut for η_M = 10, d = 1.5."""
    case = Case(alpha="0.96401964508021", eta_b="0.05", eta_m=(10, 10), positions=(0, "1.5"))
    own = 1.0 if path == "scale.mass" else 1.5
    found = followed(case, path, str(own * 0.8), str(own * 1.2), 4)
    assert any(abs(float(value) - own) < 1e-9 for value, *_ in ends(found))  # type: ignore[arg-type]


def test_damping_moves_the_cut() -> None:
    case = Case(alpha="0.97909502330842", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    found = frequency_lines(case, over={"eta_b": ("0.049", "0.051")}, points=2, check=False)
    assert found.proved, found.reason
    ((value, side, begins),) = ends(found)
    assert abs(float(value) - 0.05) < 1e-9  # type: ignore[arg-type]
    assert (side, begins) == ("below", True)
    for k, eta_b in enumerate(("0.049", "0.051")):
        roots = certify(replace(case, eta_b=eta_b), digits=15, check=False).roots
        assert len(roots) == found.counts[k]  # type: ignore[index]
        for line in found.lines:
            if found.values[k] in line.values:
                assert any(root.q.overlaps(line.q[line.values.index(found.values[k])]) for root in roots)


def test_a_point_next_to_the_branch_point_is_on_the_line() -> None:
    """Section 4.2: the last velocity of the paper's grid with both pairs is 0.74 for η_M = 40, d = 0.5."""
    found = frequency_lines(twins(40, "0.5"), over={"v": ("0.73", "0.75")}, points=["0.74", "0.745"], check=False)
    assert found.proved
    assert [len(line.values) for line in found.lines] == [2, 1]
    truth = frequencies(twins(40, "0.5"), {"v": [0.74]}, region="sheet").roots[0]
    assert np.abs(truth - complex(found.lines[1].q[0])).min() < 1e-9


def test_what_is_left_open_is_said() -> None:
    found = frequency_lines(twins(70, "1.5", "0.05"), over={"v": ("0.9", "0.95")}, effort=Effort(evaluations=300))
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "effort"


def test_a_cut_point_that_is_lost_leaves_the_answer_open(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if the list along the cuts were wrong: the line is then followed to where nothing is proved of it."""

    def without(*args: Any) -> Any:
        found = all_reached(*args)
        return replace(found, points=found.points[1:])

    monkeypatch.setattr(on_sheet, "all_reached", without)
    found = frequency_lines(
        twins(70, "1.5", "0.05"), over={"v": ("0.97", "0.985")}, points=["0.971", "0.984"], check=False
    )
    assert found.status is Status.UNDECIDED
    assert found.counts is None


def test_other_tracks_have_no_sheet() -> None:
    string = Problem(tracks.String(T=1, m=1, k=1, c="0.1"), [bodies.Mass(1)], v="0.1")
    with pytest.raises(InputError, match="region"):
        frequency_lines(string, over={"v": ("0.1", "0.2")}, region="sheet")
