"""The whole sheet by paths: in SI units, in the paper's ratios, and against certified spectra."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve import Case, Problem, certify, frequencies, tracks, vehicles
from mpsolve.errors import InputError

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
PAIR = Problem(BEAM, vehicles.train(vehicles.Mass(70), 2, "1.5"), v="0.67")
RAIL = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c="770", N="1e5", kp="2e4")


def proved(problem: Any) -> list[complex]:
    spectrum = certify(problem, region="sheet", digits=15, check=False)
    return sorted((complex(root.q.mid()) for root in spectrum.roots), key=lambda q: (q.real, q.imag))


def test_si_units_are_those_of_the_problem() -> None:
    masses = [vehicles.Mass("8000").at(0), vehicles.Mass("12000").at("3.4")]
    problem = Problem(RAIL, masses, v=100)
    found = frequencies(problem, {"v": [100, 150, 190]}, region="sheet")
    expected = proved(problem.changed("v", 150))
    assert found.count[1] == len(expected)
    assert np.allclose(found.roots[1][: found.count[1]], expected, rtol=1e-9)


def test_an_irrational_case_is_no_problem_here_but_a_rational_one_is() -> None:
    case = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=(0, "1.5"))
    assert frequencies(case, region="sheet").unstable == 2


def test_a_draw_from_the_papers_study_is_what_is_proved() -> None:
    """With neighbours along α about it, so that roots are indeed followed."""
    rng = np.random.default_rng(20)
    for _ in range(3):
        eta_b, mass, d = float(rng.choice(np.arange(4, 100))) / 100, float(rng.choice([10, 40, 70])), 1.5
        over = {"v": np.arange(20, 60) / 50, "track.c": 2 * eta_b, "vehicles.M": mass, "gap[0]": d}
        line = frequencies(PAIR, over, "sheet")
        assert (line.status == "ok").all()
        k = int(rng.integers(1, 40))
        problem = PAIR
        for path, values in over.items():
            problem = problem.changed(path, float(np.broadcast_to(values, 40)[k]))
        assert np.allclose(line.roots[k][: line.count[k]], proved(problem), rtol=1e-11)


def test_shapes_order_and_padding() -> None:
    over = {"v": np.array([[0.5], [1.2]]), "track.c": np.array([0.1, 0.4, 0.8]), "gap[0]": 4.5}
    result = frequencies(PAIR, over, "sheet")
    assert result.count.shape == result.status.shape == (2, 3)
    assert result.roots.shape == (2, 3, result.count.max())
    for q, n in zip(result.roots.reshape(6, -1), result.count.ravel(), strict=True):
        assert np.isfinite(q[:n]).all()
        assert np.isnan(q[n:]).all()
    only = frequencies(PAIR, over, "sheet", roots=False)
    assert only.roots is None
    assert np.array_equal(only.count, result.count)
    assert frequencies(PAIR, {"v": []}, "sheet").roots.shape == (0, 0)


def test_the_order_of_the_entries_does_not_matter() -> None:
    rng = np.random.default_rng(3)
    over = {
        "v": rng.uniform(0.1, 1.3, 200),
        "track.c": rng.uniform(0.04, 1.2, 200),
        "gap[0]": rng.uniform(0.3, 4, 200),
    }
    shuffle = rng.permutation(200)
    first = frequencies(PAIR, over, "sheet")
    second = frequencies(PAIR, {path: values[shuffle] for path, values in over.items()}, "sheet")
    assert np.array_equal(first.count[shuffle], second.count)
    assert np.allclose(first.roots[shuffle], second.roots, rtol=1e-12, equal_nan=True)


def test_masses_at_one_place_are_one() -> None:
    alpha = np.linspace(0.3, 1.2, 10)
    together = Problem(BEAM, [vehicles.Mass(70).at(0), vehicles.Mass(70).at(0)], v="0.67")
    merged = frequencies(together, {"v": alpha}, "sheet")
    single = frequencies(Problem(BEAM, vehicles.Mass(140), v="0.67"), {"v": alpha}, "sheet")
    assert merged.count.tolist() == single.count.tolist()
    assert np.allclose(merged.roots, single.roots, rtol=1e-9, equal_nan=True)


def test_masses_far_apart_move_as_one_alone() -> None:
    """Damping uncouples them: every root of the single mass is double in the limit, here within e^{−…d}."""
    over = {"v": np.array([0.3, 0.31, 0.32]), "track.c": 0.8, "vehicles.M": 3.0}
    far = frequencies(PAIR, over | {"gap[0]": 15.0}, "sheet").roots[1]
    single = frequencies(Problem(BEAM, vehicles.Mass(3), v="0.67"), over, "sheet")
    near = [q for q in single.roots[1][: single.count[1]] if q.real > 0]
    assert near
    assert all(np.nanmin(np.abs(far - q)) < 1e-3 for q in near)


def test_two_processes_give_the_same() -> None:
    alpha = np.linspace(0.1, 1.4, 40)
    one, two = (frequencies(PAIR, {"v": alpha}, "sheet", workers=workers) for workers in (1, 2))
    assert np.array_equal(one.roots, two.roots, equal_nan=True)


@pytest.mark.parametrize("change", [{"vehicles.M": 1e300}, {"gap[0]": 1e-300}, {"v": 1e300}, {"track.kp": 1e300}])
def test_what_float64_does_not_hold_is_unresolved_without_a_warning(change: dict[str, float]) -> None:
    found = frequencies(PAIR, {"v": [0.5, 0.6], **change}, "sheet")
    assert (found.count[found.status != "ok"] == -1).all()
    assert not (found.status == "ok").any() or "gap[0]" in change


def test_what_has_no_line_is_refused_with_a_sentence() -> None:
    found = frequencies(PAIR, {"track.c": [0.1, 2.0]}, region="sheet")
    assert found.status.tolist() == ["ok", "refused"]
    assert "cuts leave their line" in found.reason[1]


@pytest.mark.parametrize(
    "problem",
    [
        Problem(BEAM, vehicles.Oscillator(wheel=1, body=1, k=1, c=1), v="0.5"),
        Problem(tracks.String(T=1, m=1, k=1, c=1), vehicles.Mass(1), v="0.5"),
    ],
)
def test_other_problems_have_no_sheet(problem: Any) -> None:
    with pytest.raises(InputError, match="Euler–Bernoulli beam with masses"):
        frequencies(problem, region="sheet")


@pytest.mark.slow
def test_forty_cases_of_the_papers_study() -> None:
    """Of 23,000 cases, every sixteenth of the study."""
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1)
    pair = Problem(beam, vehicles.train(vehicles.Mass(40), 2, 1), v="0.5")
    study = np.ix_(
        np.arange(1, 141, 4) / 100, np.r_[0, np.arange(4, 100, 4) / 100], [10.0, 40.0, 70.0], np.arange(1, 10) / 2
    )
    alpha, eta_b, mass, d = study
    over = {"v": alpha, "track.c": 2 * eta_b, "vehicles.M": mass, "gap[0]": d}
    result = frequencies(pair, over, "sheet", workers=2)
    assert (result.count >= 0).mean() > 0.9999
    rng = np.random.default_rng(21)
    for _ in range(40):
        at = tuple(int(rng.integers(0, n)) for n in result.count.shape)
        if result.count[at] < 0 or (not result.over["track.c"][at] and result.over["v"][at] == 1):
            continue
        problem = pair
        for path, values in result.over.items():
            problem = problem.changed(path, float(values[at]))
        assert np.allclose(result.roots[at][: result.count[at]], proved(problem), rtol=1e-11)
