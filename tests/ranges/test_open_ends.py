"""A range without an end, of every kind of path and in every function: a proof, an open answer, or one sentence."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve import (
    Case,
    Effort,
    InputError,
    Problem,
    certify,
    crossings,
    cut_points,
    frequency_lines,
    onset,
    prove_stable,
    stability_chart,
    tracks,
    unstable_ranges,
    vehicles,
    worst,
)
from mpsolve.problem.cases import as_problem
from mpsolve.ranges.margin import margin

BEAM = Problem(
    tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770), vehicles.train(vehicles.Mass(900), 2, 3), v=100
)
WIRE = Problem(tracks.String(T=27000, m=1, k=500, c=2), [vehicles.Mass(8).at(0)], v=50)
CASE = Case(alpha="0.5", eta_b="0.05", eta_m=[40, 40], positions=[0, "1.5"])
LITTLE = Effort(seconds=2)
MAY: dict[str, Any] = {"crossings": crossings, "onset": onset, "unstable_ranges": unstable_ranges}
MAY_NOT: dict[str, Any] = {
    "worst": worst,
    "prove_stable": prove_stable,
    "lines": frequency_lines,
    "chart": lambda problem, over, effort: stability_chart(problem, over={**over, OTHER: (1, 2)}, effort=effort),
    "cut_points": lambda problem, over, effort: cut_points(problem, over=over, effort=effort),
    "at the worst": lambda problem, over, effort: onset(problem, over={OTHER: (1, 2)}, worst=over, effort=effort),
}
OTHER = "scale.mass"
PATHS = {
    BEAM: ["v", "track.k", "track.c", "track.EI", "track.N", "vehicles[0].M", "gap[0]", "scale.gap", "vehicles.M"],
    WIRE: ["v", "track.k", "track.c", "track.T", "scale.mass"],
    CASE: ["alpha", "eta_b", "eta_n", "eta_m", "d"],
}
EACH = [(problem, path) for problem, paths in PATHS.items() for path in paths]
NAMES = [f"{type(as_problem(problem).track).__name__}-{path}" for problem, path in EACH]
DECIDED = ("vehicles.M", "scale.mass", "eta_m")


@pytest.mark.parametrize(("problem", "path"), EACH, ids=NAMES)
def test_an_upper_end_may_be_left_out_or_is_asked_for(problem: Any, path: str) -> None:
    answers, refused = {}, []
    for name, ask in MAY.items():
        try:
            answers[name] = ask(problem, over={path: (1, None)}, effort=LITTLE, check=False)
        except InputError as error:
            refused.append((error.key, "has no upper end" in str(error)))
    assert refused in ([], [(path, True)] * len(MAY)), "they differ"
    assert bool(answers) == (path in DECIDED or (problem is WIRE and path in ("track.k", "track.c")))
    for found in answers.values():
        assert found.over == {path: (Fraction(1), None)}
        assert found.proved or found.reason is not None
        assert found.certificate is None
    for name, ask in MAY_NOT.items():
        if path != OTHER or name not in ("chart", "at the worst"):
            with pytest.raises(InputError, match="has no upper end") as caught:
                ask(problem, over={path: (1, None)}, effort=LITTLE)
            assert caught.value.key == path


@pytest.mark.parametrize(("problem", "path"), EACH, ids=NAMES)
def test_a_lower_end_is_asked_for(problem: Any, path: str) -> None:
    for ask in (*MAY.values(), worst, prove_stable, frequency_lines):
        with pytest.raises(InputError, match="has no lower end: give one") as caught:
            ask(problem, over={path: (None, 1)})
        assert caught.value.key == path


@pytest.mark.parametrize(("problem", "path"), [(WIRE, "track.k"), (WIRE, "scale.mass"), (CASE, "eta_m")])
def test_a_margin_without_end(problem: Any, path: str) -> None:
    found = margin(problem, path, (Fraction("0.5"), None), effort=Effort(seconds=20))  # type: ignore[arg-type]
    assert (found.stable, found.below, found.above) == (True, None, None)
    assert certify(as_problem(problem).changed(path, 10**6), region="unstable", check=False).unstable == 0


def test_a_margin_of_a_ratio_knows_its_own_value() -> None:
    assert margin(CASE, "alpha", (Fraction(0), Fraction("0.6")), effort=Effort(seconds=20)).own == Fraction("0.5")
    unequal = Problem(BEAM.track, [vehicles.Mass(1).at(0), vehicles.Mass(2).at(3)], v=1)
    with pytest.raises(InputError, match=r"vehicles\.M: has several values"):
        margin(unequal, "vehicles.M", (Fraction(1), Fraction(2)))
    with pytest.raises(InputError, match=r"track\.none"):
        margin(CASE, "track.none", (Fraction(1), Fraction(2)))
