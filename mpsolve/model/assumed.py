"""What every result rests on and no proof shows."""

from __future__ import annotations

ASSUMED = (
    "The model: an infinite Euler–Bernoulli beam on a Pasternak viscoelastic foundation, and point masses "
    "that move at a constant velocity and never leave it. The software: Python, and FLINT's ball arithmetic."
)
