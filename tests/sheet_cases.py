"""Pairs of masses on the paper's beam, drawn at random, as entries of a batch."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from mpsolve import Case, Problem, tracks, vehicles
from mpsolve.batch.entries import Entries, entries_of
from mpsolve.batch.halves import Halves, halves_of

PAIR = Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1"), vehicles.train(vehicles.Mass(40), 2, 1), v="0.5")


def drawn(size: int, seed: int, change: Mapping[str, Any] | None = None) -> tuple[Entries, dict[str, Any]]:
    """Entries over velocity, damping, axial force, mass and distance; some of what is drawn is replaced."""
    rng = np.random.default_rng(seed)
    eta_b = rng.uniform(0, 0.95, size).round(3)
    axial = np.where(rng.random(size) < 0.5, 0, rng.uniform(-2, 0.95, size) * np.sqrt(1 - eta_b**2)).round(3)
    over = {
        "v": rng.uniform(0, 1.5, size).round(3),
        "track.c": 2 * eta_b,
        "track.N": np.maximum(axial, 0),
        "track.kp": np.maximum(-axial, 0),
        "vehicles.M": (10 ** rng.uniform(-1, 2, size)).round(3),
        "gap[0]": (10 ** rng.uniform(-1.3, 0.7, size)).round(3),
    }
    over |= {path: np.broadcast_to(values, size) for path, values in (change or {}).items()}
    return entries_of(PAIR, over), over


def halves(entries: Entries) -> list[Halves]:
    """All entries; their cuts lie on one line."""
    return list(halves_of(entries, np.arange(len(entries))))


def case(over: Mapping[str, Any], k: int) -> Case:
    """One entry in the paper's ratios, its floats read as their shortest decimals."""
    v, c, N, kp, M, d = (
        float(over[path][k]) for path in ("v", "track.c", "track.N", "track.kp", "vehicles.M", "gap[0]")
    )
    return Case(alpha=v, eta_b=c / 2, eta_n=N, eta_s=kp, eta_m=(M, M), positions=(0, d))
