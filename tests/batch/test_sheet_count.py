"""Float64 counts on the whole sheet against proved ones, and where there is none."""

from __future__ import annotations

import numpy as np
import pytest
from oracle import Truth
from sheet_cases import PAIR, case, drawn, halves

from mpsolve import Problem, certify, tracks, vehicles
from mpsolve.batch.entries import entries_of
from mpsolve.batch.sheet_count import count_sheet, edge_logs, edge_roots, far_arguments, turned


def counts(size: int, seed: int, change: dict[str, object] | None = None) -> list[int]:
    entries, _ = drawn(size, seed, change)
    out = np.full(size, -9)
    for part in halves(entries):
        out[part.index] = count_sheet(part).count
    return out.tolist()


def test_counts_are_the_proved_ones() -> None:
    over = drawn(5, 5)[1]
    found = counts(5, 5)
    for k in range(5):
        problem = PAIR
        for path, values in over.items():
            problem = problem.changed(path, float(values[k]))
        assert found[k] == certify(problem, region="sheet", digits=15, check=False).count


@pytest.mark.parametrize("number", [1, 3, 4])
def test_any_number_of_masses(number: int) -> None:
    """Masses are given out of their order along the track."""
    places = [0.0, 2.9, 1.3, 4.7][:number]
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
    masses = [vehicles.Mass(20 + k).at(str(place)) for k, place in enumerate(places)]
    problem = Problem(beam, masses, v="0.7")
    velocities = [0.4, 0.95] if number < 4 else [1.25]
    (part,) = halves(entries_of(problem, {"v": velocities}))
    expected = [certify(problem.changed("v", v), region="sheet", digits=15, check=False).count for v in velocities]
    assert count_sheet(part).count.tolist() == expected


@pytest.mark.parametrize("mass", [1e-3, 0.01, 0.1])
def test_a_light_mass_keeps_its_roots_next_to_the_branch_point(mass: float) -> None:
    """Without damping a light mass has one pair, at a distance like M² from the tip of the cut."""
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1)
    (part,) = halves(entries_of(Problem(beam, vehicles.Mass(1), v="0.5"), {"vehicles.M": [mass]}))
    assert count_sheet(part).count.tolist() == [2]


def test_cuts_that_touch_are_counted() -> None:
    """α = α_C = 1 without damping: the pair of real roots has gone into q = 0, and nothing else is there."""
    change = {"v": np.array([0.99, 1.0]), "track.c": 0.0, "track.N": 0.0, "track.kp": 0.0}
    assert counts(2, 1, change | {"vehicles.M": 10.0, "gap[0]": 0.5}) == [2, 0]


def test_roots_beside_the_edge_that_cancel_a_step_are_counted() -> None:
    """Between 32 equal nodes two of these sixteen roots are stepped over."""
    change = {"v": 2.3704776386334965, "track.c": 1.4596773502505687, "track.kp": 0.5174434686615302, "track.N": 0.0}
    assert counts(1, 1, change | {"vehicles.M": 21.216126341667046, "gap[0]": 4.400845903562968}) == [16]


def test_a_phase_that_is_too_long_is_no_count() -> None:
    change = {"v": 0.5, "track.c": 0.2, "track.N": 0.0, "track.kp": 0.0, "gap[0]": 1e5}
    with np.errstate(all="ignore"):
        assert counts(1, 1, change) == [-1]


def test_angles() -> None:
    assert np.allclose(turned(np.array([0.5, 2 * np.pi + 0.5, -7.0])), [0.5, 0.5, -7 + 2 * np.pi])


def test_values_on_the_edge_are_limits_from_the_sheet() -> None:
    """Ratios of R·Δ at two points of an edge: a constant factor of the entry is left open."""
    entries, over = drawn(40, 2)
    seen = 0
    for part in halves(entries):
        rows = np.arange(len(part))
        z = np.maximum(part.limit, 0) + np.random.default_rng(3).uniform(0.05, 3, (2, len(part)))
        logs = np.stack([edge_logs(part, rows, one) for one in z])
        for row, k in enumerate(part.index.tolist()):
            truth = Truth(case(over, k), 40)
            unit = part.unit[row]
            for side, sign in enumerate((-1, 1)):
                ends = []
                for one in z[:, row] * unit:
                    q = truth.mp.mpc(one, truth.eta_b + sign * truth.mp.mpf(10) ** -12)
                    ends.append(complex(truth.delta(q) * truth.resultant(q)))
                value = np.exp(logs[1, side, row] - logs[0, side, row])
                expected = ends[1] / ends[0]
                assert abs((value.conj() if sign > 0 else value) - expected) < 1e-7 * abs(expected)
                seen += 1
    assert seen == 80


def test_p_roots_on_the_edge_are_those_just_below() -> None:
    entries, over = drawn(12, 8)
    for part in halves(entries):
        rows = np.arange(len(part))
        z = np.maximum(part.limit, 0) + 0.7
        found = edge_roots(part, rows, z)
        for row, k in enumerate(part.index.tolist()):
            truth = Truth(case(over, k), 30)
            q = truth.mp.mpc(z[row] * part.unit[row], truth.eta_b - truth.mp.mpf(10) ** -12)
            upper, lower = truth.p_roots(q)
            scale = np.abs(found[row]).max()
            ratio = scale / max(abs(complex(p)) for p in (*upper, *lower))
            for mine, theirs in ((found[row, :2], upper), (found[row, 2:], lower)):
                expected = np.array([1j * complex(p) * ratio for p in theirs])
                distance = np.abs(mine[:, None] - expected[None, :]).min(1)
                assert (distance < 1e-5 * scale).all()


def test_far_out_the_arguments_are_small_and_known() -> None:
    entries, _ = drawn(30, 9)
    for part in halves(entries):
        total = far_arguments(part, np.arange(len(part)), part.far)
        assert np.isfinite(total).all()
        assert (np.abs(total) < 8 * np.pi / 2).all()
        assert np.isnan(far_arguments(part, np.arange(len(part)), np.full(len(part), 1e-9))).any()
