"""What is known of the entries of a batch, as columns."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.result import Frequencies
from mpsolve.errors import InputError

PROBLEM = Problem(tracks.String(T=1, m=1, k=1, c=1), vehicles.Mass(1), v=1)


def made(region: str, roots: object) -> Frequencies:
    status, reason = np.array(["ok", "unresolved"]), np.array(["", "why"])
    return Frequencies(PROBLEM, region, {"v": np.array([1.0, 2.0])}, np.array([2, -1]), status, reason, roots)


def test_columns_and_what_is_not_told() -> None:
    found = made("below 1", np.array([[-1 - 2j, 1 + 2j], [np.nan, np.nan]]))
    assert found.shape == (2,)
    assert found.unstable.tolist() == [1, -1]
    assert found.to_dict() == {
        "v": [1, 2], "status": ["ok", "unresolved"], "reason": ["", "why"], "count": [2, None],
        "re_1": [-1, None], "im_1": [-2, None], "re_2": [1, None], "im_2": [2, None],
    }  # fmt: skip


def test_it_prints_a_row_for_each_entry() -> None:
    headline, names, first, second = str(made("unstable", None)).splitlines()
    assert headline == (
        "Frequencies of 2 entries, shape (2,): 1 of them with roots in Im q < 0, 1 not told; float64, not proved"
    )
    assert (names.split(), first.split(), second.split()) == (
        ["v", "status", "reason", "count"], ["1", "ok", "2"], ["2", "unresolved", "why"]
    )  # fmt: skip
    assert "<td>unresolved</td>" in made("unstable", None)._repr_html_()


def test_without_roots_only_the_half_plane_tells_what_grows() -> None:
    assert made("unstable", None).unstable.tolist() == [2, -1]
    with pytest.raises(InputError, match="were not asked for"):
        _ = made("below 1", None).unstable
