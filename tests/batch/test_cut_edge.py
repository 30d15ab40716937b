"""R·Δ on the edge of the cut against residue sums in mpmath next to it, on both sides."""

from __future__ import annotations

import numpy as np
from oracle import Truth
from sheet_cases import case, drawn, halves

from mpsolve.batch.cut_edge import edge_logs, edge_roots, far_arguments


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
