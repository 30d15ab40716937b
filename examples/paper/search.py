"""Limiting masses, and the search for the damping ratio and distance that a printed one belongs to."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np

from mpsolve import Crossings
from mpsolve import crossings as proved_crossings
from mpsolve.characteristic.floats import Receptance
from mpsolve.claims import Claim
from mpsolve.claims.values import grid, places, rounds_to
from mpsolve.errors import PrecisionError

from .cases import pair
from .kernels import reduced_beam

_TRIED = grid("0.5:0.05:2")  # distances of the search
_FREQUENCIES = np.geomspace(0.02, 2, 800)


@lru_cache(maxsize=64)
def crossings(alpha: str, eta_b: str, d: str) -> Crossings:
    """All crossings of two equal masses, η_M from 0.001 to 10⁶, proved. PrecisionError if they are not."""
    found = proved_crossings(pair(alpha, eta_b, "1", d), over={"scale.mass": ("0.001", "1e6")}, digits=15)
    if not found.proved:
        raise PrecisionError(str(found.reason))
    return found


def limiting(alpha: str, eta_b: str, d: str) -> Any:
    """The least of the crossing masses, None where there is none."""
    found = crossings(alpha, eta_b, d).crossings
    return found[0].value if found else None


def exchanged(claim: Claim, search: list[tuple[str, str]]) -> tuple[str, ...]:
    """Whether this number and its companion both come out at one distance, with the damping ratios exchanged."""
    own, other, companion = claim.number("eta_b"), claim.number("other_eta_b"), claim.number("other_eta_m")
    there = reproductions(claim.number("alpha"), companion, (own,))
    common = sorted({d for b, d in search if b == other} & {d for _, d in there})
    return tuple(
        f"at d = {d} both numbers come out, exchanged: η_b = {other} gives {claim.number('eta_m')}, η_b = {own} "
        f"gives {companion}"
        for d in common
    )


def reproductions(alpha: str, printed: str, dampings: tuple[str, ...]) -> list[tuple[str, str]]:
    """(η_b, d) on a short-decimal grid whose proved limiting mass rounds to `printed`; float64 says where to look."""
    half = 0.5 * 10.0 ** -places(printed)
    hits = []
    for eta_b in dampings:
        for d in _TRIED:
            guess = _limit_guess(alpha, eta_b, d)
            if guess is not None and abs(guess - float(printed)) < 1.2 * half:
                found = limiting(alpha, eta_b, d)
                if found is not None and rounds_to(found, printed):
                    hits.append((eta_b, d))
    return hits


@lru_cache(maxsize=8192)
def _limit_guess(alpha: str, eta_b: str, d: str) -> float | None:
    """The least crossing mass in float64: where an eigenvalue λ of [K_ij] is real and positive, η = π/(2q²λ)."""
    q = _FREQUENCIES
    reduced, factor = reduced_beam(pair(alpha, eta_b, "1", d))
    apart = reduced.places[1] - reduced.places[0]
    sigma = 1j * q / float(reduced.frequency_unit)
    G, _ = Receptance(reduced.guide)(sigma, [0 * apart, apart, -apart], slope=False)
    contact, ahead, behind = (np.pi * float(factor) * one for one in G)
    root = np.sqrt(ahead * behind + 0j)
    root = root * np.cumprod(np.concatenate([[1.0], np.where((root[1:] * root[:-1].conj()).real < 0, -1.0, 1.0)]))
    least = None
    for value in (contact + root, contact - root):
        turns = np.flatnonzero((value.imag[1:] * value.imag[:-1] < 0) & (value.real[1:] > 0))
        for k in turns:
            t = value.imag[k] / (value.imag[k] - value.imag[k + 1])
            x, real = q[k] + t * (q[k + 1] - q[k]), value.real[k] + t * (value.real[k + 1] - value.real[k])
            eta = float(np.pi / (2 * x * x * real))
            least = eta if least is None else min(least, eta)
    return least
