"""The zeros of Δ̂ to the right of a line below the cuts, in floats: counted by its argument, found by Newton.

Zeros that float64 cannot tell apart come as one, with their number. Nothing is proved here. The motion is a test: it
must vanish before the loads come, and a root that is left out shows there.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Complexes
from mpsolve.vibration.image import Image
from mpsolve.vibration.residues import Pole

_STEP = 0.5
"""The largest step of the argument that is believed."""
_HALVINGS = 40
_MOST = 20_000
_NEWTON = 30
_SAME = 2e-5
"""Relative: zeros that are nearer are taken together."""
_ROWS = (0.5, 0.15, 0.02, -0.02, -0.3)


def count_zeros(image: Image, floor: float, reach: float) -> tuple[int, Complexes]:
    """How many zeros have Re σ > floor, |σ| below the reach, by the turn of the argument; and the path walked.

    PrecisionError where floats lose Δ̂ on the path, as for very short waves far out.
    """
    up = floor + 1j * np.concatenate([[0.0], np.geomspace(1e-5, 1, 120) * reach])
    angle = np.linspace(float(np.angle(up[-1])), 0, 40)[1:]
    path = np.concatenate([up, abs(up[-1]) * np.exp(1j * angle)])
    with np.errstate(divide="ignore", invalid="ignore"):
        path, turn = _turned(image, path)
    if not np.isfinite(turn):
        raise PrecisionError(
            "float64 loses the determinant on the path round the induced frequencies: use response_mp"
        )
    return max(0, int(np.rint(-turn / np.pi))), path


def find_zeros(image: Image, floor: float, count: int, path: Complexes) -> list[Pole]:
    """The zeros with Re σ > floor and Im σ ≥ 0, up to `count` with their mirror images."""
    found: list[Pole] = []
    height = path.imag.max()
    starts = path[:: max(1, len(path) // 300)]
    rows = [starts] + [part * floor + 1j * np.geomspace(1e-5, 1, 80) * height for part in _ROWS]
    for starts in rows:
        if number(found) >= count:
            break
        found += [_counted(image, sigma) for sigma in _newton(image, starts, floor, [one.sigma for one in found])]
    return found


def number(poles: list[Pole]) -> int:
    """With multiplicity and mirror images."""
    return sum(pole.multiplicity * (1 if pole.sigma.imag == 0 else 2) for pole in poles)


def _newton(image: Image, starts: Complexes, floor: float, known: list[complex]) -> list[complex]:
    """New zeros, each once."""
    sigma = starts
    out: list[complex] = []
    with np.errstate(all="ignore"):
        for _ in range(_NEWTON):
            step = image.step(sigma, known)
            limit = 0.5 * np.abs(sigma) + abs(floor)
            size = np.abs(step)
            step = np.where(size > limit, step * limit / size, step)
            moved = sigma + step
            moved = np.where(moved.imag < 0, moved.conj(), moved)
            alive = np.isfinite(moved) & (moved.real > 2 * floor - 1e-9) & (np.abs(moved) < 4 * np.abs(starts).max())
            there = alive & (np.abs(step) < 1e-10 * np.abs(moved))
            for z in moved[there]:
                settled = complex(z.real, 0.0) if abs(z.imag) < 1e-8 * abs(z) else complex(z)
                new = all(abs(settled - other) > _SAME * abs(settled) for other in [*known, *out])
                if settled.real > floor and settled and new:
                    out.append(settled)
            sigma = moved[alive & ~there]
            if not len(sigma):
                break
    return out


def _counted(image: Image, sigma: complex) -> Pole:
    """With the number of zeros that are nearer than can be told."""
    radius = _SAME * abs(sigma)
    circle = sigma + radius * np.exp(2j * np.pi * np.arange(13) / 12)
    turn = _turned(image, circle)[1]
    return Pole(sigma, max(1, int(np.rint(turn / (2 * np.pi)))), radius)


def _turned(image: Image, path: Any) -> tuple[Complexes, float]:
    """The path with points put in where the argument turns fast, and the turn along it; twice as many confirm it."""
    phase, turn = image.phase(path), np.inf
    for _ in range(_HALVINGS):
        wide = np.flatnonzero(~(np.abs(np.angle(phase[1:] / phase[:-1])) <= _STEP))
        if not len(wide):
            last, turn = turn, float(np.angle(phase[1:] / phase[:-1]).sum())
            if abs(turn - last) < 1:
                break
            wide = np.arange(len(path) - 1)
        if len(path) > _MOST:
            break
        middle = (path[wide] + path[wide + 1]) / 2
        path = np.insert(path, wide + 1, middle)
        phase = np.insert(phase, wide + 1, image.phase(middle))
    return path, float(np.angle(phase[1:] / phase[:-1]).sum())
