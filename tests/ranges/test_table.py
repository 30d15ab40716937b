"""Entries of a table are the answers of single questions, rounded; what cannot be asked is refused by its name."""

from __future__ import annotations

from typing import Any

import pytest
from ranges_of_a_pair import PAIR

from mpsolve import InputError, Problem, Status, onset, stability_table, tracks, unstable_ranges, vehicles

OVER = {"v": (150, 230)}


@pytest.mark.parametrize("quantity", ["onset", "unstable ranges"])
def test_an_entry_is_the_answer_of_its_problem(quantity: str) -> None:
    rows, columns = {"track.c": [770, 7700]}, {"scale.mass": ["0.5", 1]}
    table = stability_table(PAIR, over=OVER, rows=rows, columns=columns, quantity=quantity, digits=8, workers=1)
    assert (table.status, table.reason) == (Status.UNVERIFIED, None)
    for row, c in zip(table.entries, rows["track.c"], strict=True):
        for entry, scale in zip(row, columns["scale.mass"], strict=True):
            problem = PAIR.changed("track.c", c).changed("scale.mass", scale)
            if quantity == "onset":
                found = onset(problem, over=OVER, check=False)
                truth = [] if found.value is None else [float(found.value)]
            else:
                spans = unstable_ranges(problem, over=OVER, check=False).intervals
                truth = [float(end) for one in spans for end in (one.start, one.end)]
            assert [float(ball) for ball in entry.balls] == pytest.approx(truth, rel=1e-12)
            assert entry.status == ("proved" if truth else "stable")
            if truth and quantity == "onset":
                assert float(entry.text) == pytest.approx(truth[0], rel=1e-7)


@pytest.mark.parametrize(
    ("changed", "key"),
    [
        ({"quantity": "mass"}, "quantity"),
        ({"digits": 0}, "digits"),
        ({"rows": {"v": [1]}}, "columns"),
        ({"rows": {"track.c": []}}, "rows"),
        ({"rows": {"track.c": [1, 1]}}, "rows.values[2]"),
        ({"columns": {"track.k": [-1]}}, "columns.values[1]"),
        ({"rows": {"track.c": [1], "track.k": [1]}}, "rows"),
    ],
)
def test_what_is_no_table_is_refused(changed: dict[str, Any], key: str) -> None:
    asked: dict[str, Any] = {"over": OVER, "rows": {"track.c": [770]}, "columns": {"scale.mass": [1]}, "workers": 1}
    with pytest.raises(InputError) as caught:
        stability_table(PAIR, **(asked | changed))
    assert caught.value.key == key


@pytest.mark.parametrize("quantity", ["onset", "unstable ranges"])
def test_an_entry_does_not_pass_over_what_is_left_out(quantity: str) -> None:
    wire = Problem(tracks.String(T=27000, m="1.07", k=500, c=2), [vehicles.Mass(20).at(0)], v=100)
    asked: dict[str, Any] = {"rows": {"track.k": [500]}, "columns": {"scale.mass": [1]}, "quantity": quantity}
    ((whole,),) = stability_table(wire, over={"v": (0, 300)}, workers=1, **asked).entries
    assert (whole.status, whole.reason.code) == ("undecided", "left-out")  # type: ignore[union-attr]
    ((below,),) = stability_table(wire, over={"v": (0, 150)}, workers=1, **asked).entries
    assert below.status == "stable"
