"""Ranges are checked and scaled, and a frequency is found beyond which no root can cross."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from ranges_of_a_pair import PAIR, TRACK, over_velocity

from mpsolve import InputError, Problem, crossings, receptance, tracks, vehicles
from mpsolve.presets.written import problem_of
from mpsolve.ranges import scope
from mpsolve.ranges.scope import checked_over, from_above_rest, one_path, scope_of


def test_the_corners_hold_the_range_and_the_band() -> None:
    scope = over_velocity()
    low, high = scope.corners
    unit = scope.family.units[0]
    assert Fraction(low[1].item()) * unit <= 150
    assert Fraction(high[1].item()) * unit >= 230
    assert (low[0], high[0]) == (0, scope.X)


def test_beyond_the_band_the_contacts_take_energy() -> None:
    """−Im G of both contacts is positive definite at frequencies from X on, in floats."""
    scope = over_velocity()
    for factor in (1.0, 1.3, 3.0, 10.0):
        omega = factor * scope.X * float(scope.family.frequency_unit)
        for v in (150, 190, 230):
            near, ahead, behind = receptance(TRACK, xi=[0, "3.4", "-3.4"], omega=[omega], v=v)[:, 0]
            G = np.array([[near, behind], [ahead, near]])
            assert np.linalg.eigvalsh((G - G.conj().T) * 0.5j).min() > 0


@pytest.mark.parametrize(
    ("over", "key", "said"),
    [
        ({}, "over", "empty"),
        ({"v": 3}, "v", "give a range"),
        ({"v": (3, 3)}, "v", "not above its start"),
        ({"speed": (1, 2)}, "speed", "unknown|no parameter|not"),
    ],
)
def test_what_is_no_range_is_refused(over: object, key: str, said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        checked_over(PAIR, over)
    assert caught.value.key == key


def test_one_path_alone() -> None:
    assert one_path({"v": (Fraction(1), Fraction(2))}) == "v"
    with pytest.raises(InputError, match="2 parameters"):
        one_path({"v": (Fraction(1), Fraction(2)), "track.k": (Fraction(1), Fraction(2))})


def test_a_range_from_rest_begins_a_little_later_only_where_waves_are_lost() -> None:
    ends = {"v": (Fraction(0), Fraction(10))}
    assert from_above_rest(PAIR, ends) == ends
    from mpsolve.tracks import Rayleigh

    rayleigh = Problem(Rayleigh(EI="6.4e6", m=60, J="0.2", k="1e6", c=770), vehicles.Mass(1).at(0), v=1)
    moved = from_above_rest(rayleigh, ends)["v"]
    assert 0 <= moved[0] < Fraction(1, 100)


def test_contacts_faster_than_short_waves_are_told_so() -> None:
    """Certify counts their roots within a radius: of ranges nothing is said."""
    track = tracks.Timoshenko(EI="6.38e6", m="60.2", S="2.4e8", J="0.24", k="1e6", c=770)
    found = crossings(Problem(track, [vehicles.Mass(3000)], v=2300), over={"v": (2100, 2600)}, check=False)
    assert found.reason is not None
    assert "faster than short waves" in str(found.reason)


def test_a_frequency_is_found_once_for_all_vehicles(monkeypatch: pytest.MonkeyPatch) -> None:
    """It depends on track, velocities and places; another velocity or place asks anew."""
    scope.forget()
    asked: list[Any] = []
    found = scope.passive_beyond
    monkeypatch.setattr(scope, "passive_beyond", lambda *a, **k: asked.append(a) or found(*a, **k))
    first = scope_of(PAIR, {"scale.mass": (Fraction(1, 2), Fraction(1))}).X
    assert first == scope_of(PAIR.changed("scale.mass", 3), {"scale.mass": (Fraction(1, 100), Fraction(40))}).X
    assert len(asked) == 1
    for path, value in (("v", 120), ("gap[0]", 3), ("track.c", 900)):
        scope_of(PAIR.changed(path, value), {"scale.mass": (Fraction(1, 2), Fraction(1))}).X  # noqa: B018
    assert len(asked) == 4


def test_slower_than_long_waves_the_reason_comes_at_once() -> None:
    """On shallow water √(gH), which boxes would take minutes to run into; faster than they, ranges are decided."""
    ice, _ = problem_of("ice-road")
    track: Any = ice.track
    for ends in ((1, 8), (4, 10)):
        found = crossings(ice, over={"v": ends})
        assert found.reason is not None
        assert found.reason.code == "long-waves"
        assert " m/s (" in found.reason.message
        assert float(found.reason.numbers["speed"]) == pytest.approx(float(track.g * track.depth) ** 0.5, rel=1e-5)
        assert "v = 8.16" in str(found.reason)
    assert scope_of(ice, {"v": (Fraction("8.5"), Fraction(9))}).X > 0


def test_ends_may_have_units() -> None:
    wire = Problem(tracks.String(T=1, m=1), vehicles.Mass(1), v=0)
    assert checked_over(wire, {"v": ("0 km/h", "36 km/h")}) == {"v": (0, 10)}
