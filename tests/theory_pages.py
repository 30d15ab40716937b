"""The theory pages as text, and what their tests share: the beam of the pages, its waves, integrals over them."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np

from mpsolve import Problem, certify, tracks, vehicles

THEORY = Path(__file__).parents[1] / "docs" / "theory"
MODEL, PLANE, PASSIVITY, COUNTING = (
    (THEORY / f"{name}.md").read_text("utf-8") for name in ("model", "plane", "passivity", "counting")
)
BEAM = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
V, GAP, MASS = 250, 3.4, 10000
PAIR = Problem(BEAM, [vehicles.Mass(MASS).at(0), vehicles.Mass(MASS).at("3.4")], v=V)


def displayed(page: str, beginning: str) -> str:
    """The displayed formula that begins so."""
    (found,) = [
        one.strip()
        for one in re.findall(r"\$\$(.*?)\$\$", page, flags=re.DOTALL)
        if one.strip().startswith(beginning)
    ]
    return found


def growing() -> complex:
    (root,) = [r for r in certify(PAIR, region="unstable", digits=15, check=False).roots if r.q.real > 0]
    return complex(root.q)


def integral(of: Any, reach: float = 200.0, points: int = 800_001) -> complex:
    wave = np.linspace(-reach, reach, points)
    return complex(np.trapezoid(of(wave), wave))


def dispersion(wave: Any, q: float) -> Any:
    at_rest = q - V * wave
    return 6.4e6 * wave**4 - 60 * at_rest**2 + 770j * at_rest + 1e6
