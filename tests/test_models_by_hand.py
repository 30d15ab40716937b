"""The package's tracks and vehicles against D, N, M, C, K, B typed by hand, exactly, on random parameters."""

from __future__ import annotations

import pytest
from oracle_general.package import as_problem, known
from oracle_general.problems import MAKERS, Dice, random_problem
from oracle_general.tracks import track
from oracle_general.vehicles import together

SEEDS = range(60)


@pytest.mark.parametrize("model", MAKERS)
def test_equations(model: str) -> None:
    """D and N as polynomials (p² = −P², X = s), and all matrices, places and compliances, are the same fractions."""
    compared = 0
    for seed in SEEDS:
        data = random_problem(Dice(seed), model)
        if not known(data):
            continue
        problem, by_hand = as_problem(data), together(data["vehicles"])
        guide, pencil = problem.track.waveguide, problem.pencil
        for theirs, ours in zip((guide.dispersion, guide.numerator), track(data["track"]), strict=True):
            factor = getattr(problem.track, "rho_water", 1)  # of the second equation of ice, which the hand left out
            assert {(i, j): c * (-1) ** (i // 2) / factor for (i, j), c in theirs.items()} == ours
        for name in ("M", "C", "K", "B"):
            assert [list(row) for row in getattr(pencil, name)] == getattr(by_hand, name), name
        assert (list(pencil.places), list(pencil.h)) == (by_hand.x, by_hand.h)
        compared += 1
    if not compared:
        pytest.skip(f"the package has no model {model}")
