"""Cases at the edge of what is computed: each is answered, or refused with a true reason and a remedy that helps."""

from __future__ import annotations

from typing import Any

import pytest

from mpsolve import Case, Effort, InputError, PhysicalCase, Rectangle, Spectrum, Status, certify
from mpsolve.errors import PrecisionError
from mpsolve.spectrum.regions import Below, HalfPlane, Sheet

BEAM: dict[str, Any] = {"EI": "6.4e6", "m": 60, "k": "1e6", "c": 770}
PAIR = [(10_000, 0), (10_000, "3.4")]


def two(alpha: object, eta_b: object, eta_m: object = 10, d: object = 1, **more: Any) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, d), **more)


def proved(given: Any, region: Any = None) -> Spectrum:
    found = certify(given, region=region, digits=15)
    assert found.status is Status.PROVED, found.reason
    return found


AT_REST_FOUR = Case(alpha=0, eta_b="0.1", eta_m=[5] * 4, positions=range(4))


@pytest.mark.parametrize(
    ("case", "unstable"),
    [
        (two(0, "0.02", "0.01"), 0),
        (two(20, "0.1"), 14),
        (AT_REST_FOUR, 0),
        (two("1e-9", 0), 0),
        (two("1e-9", "0.1"), 0),
        (two("0.999999", 0), 0),
        (two("0.9999", 0, 70, "1.5"), 0),
        (two(0, "0.02", 10, "0.01"), 0),
        (two("0.5", "1e-30", 70, "1.5"), 0),
        (two("0.5", "0.05", 70, "1.5", eta_n="-1e6"), 0),
        (two("0.5", "0.999999999", 70, "1.5"), 2),
        (two("0.5", "0.05", 70, "1.5", eta_n="0.999999999"), 2),
        (two("0.5", "1", 70, "1.5"), 2),
        (two("0.5", "0.05", 70, 1000), 0),
    ],
    ids=lambda x: "" if isinstance(x, int) else f"{x.alpha} {x.eta_b} {x.eta_n} {x.eta_m[0]} {x.positions[1]}",
)
def test_stability_is_told(case: Case, unstable: int) -> None:
    assert proved(case, "unstable").unstable == unstable


@pytest.mark.parametrize(
    ("changed", "region", "unstable"),
    [
        ({"v": 10_000, "masses": PAIR}, "unstable", 34),
        ({"EI": "6.4", "v": 100, "masses": PAIR}, "unstable", 192),
        ({"v": 100, "masses": [("1e30", 0)]}, "unstable", 0),
        ({"v": 100, "masses": [("1e30", 0)]}, "sheet", 0),
        ({"c": "1.2e5", "v": 100, "masses": PAIR}, None, 0),
    ],
    ids=["36000 km/h", "a soft rail", "a heavy mass", "its whole sheet", "an overdamped track"],
)
def test_in_si(changed: dict[str, Any], region: Any, unstable: int) -> None:
    assert proved(PhysicalCase(**{**BEAM, **changed}), region).unstable == unstable


def test_what_is_left_out_where_the_whole_sheet_stays_open(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = proved(AT_REST_FOUR)
    assert (whole.region, whole.count) == (Sheet(), 6)

    def stays_open(*_: Any) -> None:
        raise PrecisionError("open")

    monkeypatch.setattr("mpsolve.spectrum.solve.count_sheet", stays_open)
    found = proved(AT_REST_FOUR)
    assert isinstance(found.region, Below)
    assert "left out" in found.note
    assert found.count == 6


@pytest.mark.parametrize(("alpha", "decided"), [("1.0001", True), ("1.0000001", False)])
def test_an_undamped_beam_hardly_faster_than_its_waves(alpha: str, decided: bool) -> None:
    """Next to the branch point roots are closer than floats tell; with some damping it is decided in any case."""
    found = certify(two(alpha, 0), digits=15)
    if decided:
        assert (found.status, found.unstable) == (Status.PROVED, 2)
    else:
        assert found.reason is not None
        assert found.reason.remedy == 'give some damping, and ask for "unstable"'
    assert proved(two(alpha, "1e-4"), "unstable").region == HalfPlane()


@pytest.mark.slow
def test_strong_tension_is_proved_on_the_whole_sheet() -> None:
    """Branch points lie far out there, with loops that are small beside their places."""
    found = certify(two("0.5", "0.05", 70, "1.5", eta_n="-1e6"), region="sheet", digits=15)
    assert (found.status, found.unstable) == (Status.PROVED, 0)


def test_strong_tension_lets_nothing_grow() -> None:
    assert proved(two("0.5", "0.05", 70, "1.5", eta_n="-1e6"), "unstable").count == 0


def test_a_rectangle_up_to_the_cut_and_one_that_is_large() -> None:
    case = two("0.5", "0.1", 70, "1.5")
    assert proved(case, Rectangle(0, "0.5", "-0.1", "0.0999999999999999")).count == 2
    with pytest.raises(InputError, match="take one rectangle below the line and one above it"):
        certify(case, region=Rectangle(0, 1, "-0.1", "0.11"))
    assert proved(case, Rectangle(0, 1, "-0.1", "0.0999")).count == 2
    assert proved(case, Rectangle(0, 1, "0.1001", "0.2")).count == 0
    far = certify(case, region=Rectangle("-1e9", "1e9", "-1e9", "0.04"), effort=Effort(evaluations=4000), digits=15)
    assert far.reason is not None
    assert str(far.reason).count("allow more effort") == 1
    assert "or ask for a Rectangle round what matters" in far.reason.remedy


def test_many_roots_are_all_found() -> None:
    found = proved(two("20", "0.1"), "sheet")
    assert (found.count, found.unstable) == (28, 14)
