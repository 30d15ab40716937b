"""An effort that runs out anywhere leaves what is proved so far, and all of it agrees with the full answer."""

from __future__ import annotations

import json
from fractions import Fraction
from functools import cache
from itertools import pairwise
from time import process_time
from typing import Any

import pytest

from mpsolve import Effort, Problem, certify, tracks, vehicles
from mpsolve.certificate.solve import certify_problem
from mpsolve.outcome import Status
from mpsolve.report.spectrum_data import spectrum_data
from mpsolve.report.spectrum_words import proved, verdict
from mpsolve.spectrum.partial import Partial, _strips
from mpsolve.spectrum.regions import Rectangle
from mpsolve.spectrum.spectrum import Spectrum


@cache
def row(number: int, v: str = "0.5") -> Problem:
    track = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="1/10")
    return Problem(track, vehicles.train(vehicles.Mass(40), number, "3/2"), v=v)


@cache
def full(number: int, region: Any, v: str = "0.5") -> Spectrum:
    found = certify_problem(row(number, v), region=region, digits=20, check=False)
    assert found.proved
    assert found.count
    return found


def agrees(part: Spectrum, whole: Spectrum) -> None:
    """Every claim of `known` and every root, against roots that were found and enclosed without it."""
    roots = [complex(root.q.mid()) for root in whole.roots for _ in range(root.multiplicity)]
    known = part.known
    assert known.get("count", whole.count) == whole.count
    if "growth" in known:
        assert all(q.imag > -known["growth"] for q in roots)
    if "outside" in known:
        assert all(inside(known["outside"], q) for q in roots if q.imag < 0)
    strips, open_ = known.get("strips", ()), known.get("open", ())
    for strip, number in strips:
        assert sum(inside(strip, q) for q in roots) == number
    if strips or open_:  # they leave out no root, and do not overlap
        parts = [strip for strip, _ in strips] + list(open_)
        assert all(sum(inside(one, q) for one in parts) == 1 for q in roots)
        ends = sorted((one.re_min, one.re_max) for one in parts)
        assert all(a[1] == b[0] for a, b in pairwise(ends))
    for root in part.roots:
        assert sum(root.q.contains(other.q) or root.q.overlaps(other.q) for other in whole.roots) == 1


def inside(box: Rectangle, q: complex) -> bool:
    return bool(box.re_min < q.real < box.re_max and box.im_min < q.imag < box.im_max)


def stages(number: int, region: Any, efforts: list[int], v: str = "0.5") -> list[Spectrum]:
    out = []
    for evaluations in efforts:
        found = certify_problem(
            row(number, v), region=region, digits=20, effort=Effort(evaluations=evaluations), check=False
        )
        agrees(found, full(number, region, v))
        out.append(found)
    return out


def test_an_effort_that_ends_anywhere_leaves_what_is_proved() -> None:
    found = stages(16, "unstable", [1, 100, 400, 700, 1000, 1400, 1600, 100_000])
    assert found[-1].proved
    assert [one.status for one in found[:-1]] == [Status.UNDECIDED] * (len(found) - 1)
    assert all(one.reason is not None and one.reason.code == "effort" for one in found[:-1])
    counted = [sum(number for _, number in one.known.get("strips", ())) for one in found[:-1]]
    known = [len(one.known.get("strips", ())) for one in found[:-1]]
    assert known == sorted(known)
    assert (known[0], known[-1]) == (0, 7)
    assert 0 < known[3] < 7
    assert counted[-1] == found[-2].known["count"] == full(16, "unstable").count
    assert all("growth" in one.known for one in found[:-1])
    assert ["outside" in one.known for one in found[:-1]][:3] == [False, False, True]


@pytest.mark.parametrize(
    "region", [("below", "0.01"), Rectangle("0.05", "0.6", "-0.3", "-0.0001")], ids=["below", "box"]
)
def test_other_regions_are_counted_in_strips_too(region: Any) -> None:
    found = stages(8, region, [300, 600, 900], "0.75")
    assert any(one.known.get("strips") and one.known["open"] for one in found)


def test_terminal_and_json_say_it() -> None:
    part = stages(16, "unstable", [900])[0]
    text = " ".join((verdict(part), *proved(part)))
    assert "UNDECIDED" in text
    assert "Not counted yet: " in text
    assert "Nothing grows as fast as " in text
    known = json.loads(json.dumps(spectrum_data(part)))["known"]
    open_ = known["open"]
    assert Fraction(open_[-1]["re_min"]["exact"]) == part.known["open"][-1].re_min
    assert {"growth", "outside", "strips", "open"} == set(known)


def test_without_a_stated_effort_nothing_is_counted_twice() -> None:
    assert full(16, "unstable").cost.evaluations < 1500


def test_few_contacts_are_not_counted_twice_under_a_stated_effort() -> None:
    stated = certify_problem(row(4), region="unstable", digits=20, effort=Effort(evaluations=100_000), check=False)
    assert (
        stated.cost.evaluations == certify_problem(row(4), region="unstable", digits=20, check=False).cost.evaluations
    )


def test_strips_cover_evenly_and_name_mirrors() -> None:
    groups = list(_strips(Rectangle(-2, 2, -1, 0), Fraction(1, 3)))
    assert [len(group) for group in groups] == [2, 2, 2, 1]
    assert groups[-1] == (Rectangle("-1/2", "1/2", -1, 0),)
    assert groups[0] == (Rectangle("3/2", 2, -1, 0), Rectangle(-2, "-3/2", -1, 0))
    assert Partial().known == {}


@pytest.mark.slow
def test_sixty_four_contacts_leave_something_after_a_second() -> None:
    """And no effort is overrun by much."""
    certify(row(1), region="unstable", check=False)  # what is loaded and kept is no work of the others
    whole = full(64, "unstable")
    for seconds, key in ((1.0, "growth"), (6.0, "strips")):
        started = process_time()
        part = certify(row(64), region="unstable", digits=20, effort=Effort(seconds=seconds), check=False)
        assert process_time() - started < seconds + 1
        assert part.proved or part.known.get(key) or part.known.get("count") == whole.count  # which says more
        agrees(part, whole)
