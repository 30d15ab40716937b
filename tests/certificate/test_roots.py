"""The whole way: zeros against mpmath and against numbers known by algebra; proved, verified, or a named reason."""

from __future__ import annotations

import pickle
import random
import sys
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import acb

from mpsolve import Cut, Disc, Effort, HalfPlane, InputError, Polygon, Rectangle, Status, roots

sys.path.insert(0, str(Path(__file__).parents[1] / "bench"))
from roots_cases import Trial, trials

BOX = Rectangle(-2, 2, -2, 2)


def found(answer: Any) -> list[complex]:
    return [complex(zero.q) for zero in answer.roots for _ in range(zero.multiplicity)]


@pytest.mark.parametrize("trial", trials(), ids=lambda trial: trial.name)
def test_the_literature(trial: Trial) -> None:
    answer = roots(trial.text, trial.region, cuts=trial.cuts)
    assert answer.status is Status.PROVED
    assert answer.count == trial.count
    for zero in answer.roots:
        assert float(zero.q.real.rad()) <= 1e-15 * max(abs(complex(zero.q)), 1e-15)


@pytest.mark.parametrize("name", ["graphene line", "cxroots #299", "annular combustion"])
def test_counts_of_the_literature_by_the_argument_in_floats(name: str) -> None:
    """Another way: the argument of numpy's own f along the boundary, in steps that are far too many."""
    trial = next(one for one in trials() if one.name == name)
    corners = [complex(*map(float, p)) for p in trial.region.polygon]
    path = np.concatenate(
        [a + (b - a) * np.linspace(0, 1, 200_000) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)]
    )
    f = trial.f(path)
    steps = np.angle(f[1:] / f[:-1])
    assert np.abs(steps).max() < 1
    assert round(float(steps.sum() / (2 * np.pi))) == trial.count


@pytest.mark.parametrize("seed", range(10))
def test_random_polynomials_times_an_exponential(seed: int) -> None:
    rng = random.Random(seed)
    zeros = [complex(rng.randint(-30, 30), rng.randint(-30, 30)) / 16 for _ in range(rng.randint(1, 8))]
    zeros += zeros[: rng.randint(0, 2)]
    text = "*".join(f"(z - ({z.real!r}) - ({z.imag!r})*i)" for z in zeros) + f"*exp({rng.randint(-3, 3)}*z)"
    answer = roots(text, Rectangle("-1.9", "1.91", "-1.92", "1.93"), digits=rng.choice([15, 30, 100]))
    assert answer.status is Status.PROVED
    assert answer.count == len(zeros)
    assert sorted(zeros, key=lambda z: (z.real, z.imag)) == pytest.approx(
        sorted(found(answer), key=lambda z: (round(z.real, 9), z.imag)), abs=1e-14
    )
    with mpmath.workdps(20):
        for zero in answer.roots:
            assert any(zero.q.contains(acb(z)) for z in zeros)


@pytest.mark.parametrize("digits", [15, 50, 1000])
def test_digits_are_as_many_as_asked_for(digits: int) -> None:
    answer = roots(lambda z: z.exp() - 2 - z, Rectangle(1, 2, -1, 1), digits=digits)
    with mpmath.workdps(digits + 10):
        truth = mpmath.findroot(lambda x: mpmath.exp(x) - 2 - x, 1.146)
        ball = answer.roots[0].q.real
        middle = mpmath.mpf(ball.str(digits + 5, radius=False))
        assert abs(middle - truth) < mpmath.mpf(10) ** (-digits)
        assert mpmath.mpf(ball.rad().str(10, radius=False)) < mpmath.mpf(10) ** (-digits) * 2
    assert answer.roots[0].real


def test_every_kind_of_region() -> None:
    for region, number in (
        (Disc(0, 7), 5),
        (Disc(7 + 0j, 4), 3),  # 2π − 7, π − 7 and 3π − 7 are −0.72, −3.86, 2.42
        (Polygon([-1 - 1j, 7 - 1j, 7 + 1j, 2 + 1j, 2 + 3j, -1 + 3j]), 3),
        (HalfPlane("right", 10, at=1), 3),
        (HalfPlane("upper", 10, at=1), 0),
    ):
        answer = roots("sin(z)", region)
        assert (answer.count, answer.status) == (number, Status.PROVED), region
        assert bool(answer.assumed) == isinstance(region, HalfPlane)


@pytest.mark.parametrize(
    ("f", "region", "cuts"),
    [
        ("z - (9 + 9*i)/10", HalfPlane("upper", 1), []),  # in the square, |z| = 1.27
        ("z - (1/10 + i)", HalfPlane("upper", 1), []),  # on its edge
        ("z - 1", HalfPlane("right", 1), []),  # on the circle
        ("(z - (9 + 9*i)/10)*(2 + sqrt((4*i - 3)*z))", HalfPlane("right", 1, at="-1/3"), [Cut.ray(0, 3 + 4j)]),
    ],
)
def test_a_zero_beyond_the_bound_of_a_half_plane_belies_the_users_word(f: str, region: HalfPlane, cuts: Any) -> None:
    answer = roots(f, region, cuts=cuts)
    assert (answer.status, answer.count, answer.certificate) == (Status.UNDECIDED, None, None)
    assert answer.reason is not None
    assert answer.reason.code == "bound"


def test_zeros_near_the_boundary_are_told_and_zeros_on_it_move_it() -> None:
    near = roots("sin(z)", Rectangle("-1e-9", 1, -1, 1))
    assert (near.count, near.note) == (1, "")
    outside = roots("sin(z)", Rectangle("1e-9", 1, -1, 1))
    assert (outside.count, outside.note) == (0, "")
    on = roots("sin(z)", Rectangle(0, 1, -1, 1))
    assert on.count == 1
    assert "larger" in on.note
    assert on.region.re_min < 0
    disc = roots("z**2 - 1", Disc(0, 1))
    assert disc.count == 2
    assert "larger" in disc.note


def test_poles_are_told_from_zeros() -> None:
    answer = roots("tan(z) - z", Rectangle(-10, 10, -1, 1))
    assert answer.count == 7  # a triple one at 0
    assert roots(("sin(z)", "cos(z)"), Rectangle(-4, 4, -1, 1)).count == 3
    common = roots("sin(z)/z", Rectangle(-4, 4, -1, 1))
    assert common.status is Status.UNDECIDED
    assert common.reason is not None
    assert common.reason.code == "common-zero"
    inner = roots("sin(1/z)", BOX)
    assert inner.reason is not None
    assert inner.reason.code == "pole"


def test_branch_cuts_are_never_passed_over() -> None:
    hidden = roots("sqrt(z) - 1/2", BOX)
    assert hidden.reason is not None
    assert hidden.reason.code == "not-analytic"
    answer = roots("sqrt(z) - 1/2", BOX, cuts=[Cut.ray(0, -1)])
    assert found(answer) == pytest.approx([0.25])
    lips = roots("sin(sqrt(z**2 + 1)) - z", Rectangle(-5, 5, -5, 5), cuts=[Cut.ray(1j, 1j), Cut.ray(-1j, -1j)])
    assert lips.reason is not None
    assert lips.reason.code == "zero-on-boundary"
    assert float(lips.reason.numbers["im"]) == pytest.approx(-1.5999783, abs=1e-4)


def test_multiple_zeros_and_clusters() -> None:
    answer = roots("(z - 1)**3*(z**2 - 2*z - 24.11)", Rectangle(-10, 10, -1, 1))
    assert [zero.multiplicity for zero in answer.roots] == [1, 3, 1]
    hidden = roots("exp(z) - 1 - z - z**2/2", BOX)  # a triple zero that no factor shows
    assert [(zero.multiplicity, abs(complex(zero.q)) < 1e-15) for zero in hidden.roots] == [(3, True)]
    close = roots("(z - 1)*(z - 1) - 1e-30", BOX, digits=20)
    assert close.count == 2
    assert len(close.roots) == 2
    shared = roots("z*sin(z)", BOX)
    assert [zero.multiplicity for zero in shared.roots] == [2]


def test_python_functions_that_cannot_be_read_are_proved_on_a_word() -> None:
    answer = roots(lambda z: acb(z).sin() - acb(z) / 2, Rectangle(-3, 3, -1, 1), assume_analytic=True)
    assert answer.status is Status.UNVERIFIED
    assert answer.count == 3
    assert answer.certificate is None
    assert "without a certificate" in answer.note
    assert answer.assumed
    crossing = roots(lambda z, analytic: z.sqrt(analytic=analytic) - 2, BOX)
    assert crossing.status is Status.UNDECIDED


def test_bad_input_is_refused_in_a_sentence() -> None:
    for f, region, more in (
        ("z", "unstable", {}),
        ("conj(z)", BOX, {}),
        ("z", BOX, {"digits": 3}),
        ("z", BOX, {"cuts": [1]}),
        ("z", BOX, {"effort": 3}),
        ("z", BOX, {"cuts": [Cut.ray(-5, 1)]}),
    ):
        with pytest.raises(InputError):
            roots(f, region, **more)  # type: ignore[arg-type]


def test_effort_and_progress() -> None:
    seen: list[str] = []
    answer = roots("sin(z)", BOX, effort=Effort(evaluations=5), progress=lambda stage, _: seen.append(stage))
    assert answer.reason is not None
    assert answer.reason.code == "effort"
    assert seen == ["boundary"]


def test_an_answer_travels_and_has_no_truth_value() -> None:
    answer = roots("sin(z)", BOX)
    again = pickle.loads(pickle.dumps(answer))
    assert again.count == answer.count
    with pytest.raises(TypeError):
        bool(answer)
