"""Entries of one structure as stacked arrays in scaled units: what the kernels of this package work on.

Scaled by powers of two as in problem/reduced.py: P = P̂/L, σ = σ̂/T, so that the coefficients of D̂ are near 1.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from functools import cached_property
from math import comb
from typing import Any

import numpy as np

from mpsolve.batch.entries import Entries
from mpsolve.batch.waveguides import expanded
from mpsolve.batch.waves import by_companions

_APART = 1e-7
_LOST = 1e-11
_STARTS = (1.0, 0.5, 2.0, 0.25, 4.0)


@dataclass(frozen=True)
class Group:
    """Entries `index` of a batch (K of them), with the same degrees and the same pattern of their vehicles.

    D, N: coefficients of P^i σ^j of the moving track, shape (K, i, j). D_s, N_s: their slopes in σ.
    S0, S1, S2: the vehicle's pencil S₀ + S₁σ + S₂σ², (K, bodies, bodies), rows of neutral bodies divided by σ;
    B, h, x: (K, bodies, contacts), (K, contacts), ascending places. direct: (body, contact) of tight contacts alone
    on their body, which are eliminated. up: how many p-roots decay ahead. q = q̂ · unit.
    """

    index: Any
    D: Any
    N: Any
    D_s: Any
    N_s: Any
    v: Any
    S0: Any
    S1: Any
    S2: Any
    B: Any
    h: Any
    x: Any
    neutral: Any
    unit: Any
    direct: tuple[tuple[int, int], ...]
    up: int

    def __len__(self) -> int:
        return len(self.index)

    def __getitem__(self, rows: Any) -> Group:
        shared = ("neutral", "direct", "up")
        return replace(self, **{f.name: getattr(self, f.name)[rows] for f in fields(self) if f.name not in shared})

    @property
    def bodies(self) -> int:
        return int(self.B.shape[1])

    @property
    def contacts(self) -> int:
        return int(self.B.shape[2])

    @cached_property
    def cells(self) -> list[tuple[int, int]]:
        """The places in S that are not 0 everywhere."""
        some = ((self.S0 != 0) | (self.S1 != 0) | (self.S2 != 0)).any(0)
        return [(int(i), int(j)) for i, j in np.argwhere(some)]

    @cached_property
    def pencil(self) -> tuple[Any, Any, Any]:
        """S₀, S₁, S₂ at the cells, each (K, cells)."""
        i, j = ([cell[k] for cell in self.cells] for k in (0, 1))
        return self.S0[:, i, j], self.S1[:, i, j], self.S2[:, i, j]

    @cached_property
    def through(self) -> dict[int, tuple[int, int, int]]:
        """For the number of each cell whose column is a body that is eliminated: (row, its contact, the body)."""
        contact = dict(self.direct)
        return {k: (i, contact[j], j) for k, (i, j) in enumerate(self.cells) if j in contact}

    @property
    def kept(self) -> list[int]:
        """Bodies whose motions stay unknowns."""
        gone = {body for body, _ in self.direct}
        return [i for i in range(self.bodies) if i not in gone]

    @property
    def indirect(self) -> list[int]:
        """Contacts whose equations stay."""
        gone = {contact for _, contact in self.direct}
        return [j for j in range(self.contacts) if j not in gone]


def groups_of(entries: Entries, rows: Any) -> tuple[list[Group], dict[int, str]]:
    """The entries `rows` in groups; and those that fit in none, with the reason."""
    D, N = expanded(entries.problem.track)
    size = len(entries)
    D_rest, N_rest = D.at(entries.track, size), N.at(entries.track, size)
    keys = np.stack([D_rest[key] != 0 for key in D_rest] + [N_rest[key] != 0 for key in N_rest], 1)
    signatures = [formation.signature for formation in entries.formations]
    numbers = {signature: k for k, signature in enumerate(dict.fromkeys(signatures))}
    number = np.array([numbers[signature] for signature in signatures])[entries.which]
    label = np.column_stack([keys, number, entries.v == 0])[rows]
    _, place = np.unique(label, axis=0, return_inverse=True)
    place = place.reshape(-1)
    groups: list[Group] = []
    refused: dict[int, str] = {}
    for k in range(int(place.max(initial=-1)) + 1):
        some = rows[place == k]
        parts = [{key: c[some] for key, c in a.items() if c[some[0]] != 0} for a in (D_rest, N_rest)]
        one, lost = _group(entries, some, parts[0], parts[1])
        refused |= dict.fromkeys(one.index[lost].tolist(), "a power of p is lost: the velocity is a wave speed")
        groups += list(_by_side(one[~lost], refused))
    return groups, refused


def _group(entries: Entries, some: Any, D: dict[Any, Any], N: dict[Any, Any]) -> tuple[Group, Any]:
    length, time = _units(D)
    D, N = ({(i, j): c * np.exp2(-length * i - time * j) for (i, j), c in a.items()} for a in (D, N))
    e, f = (np.round(np.max([np.log2(np.abs(c)) for c in a.values()], 0)) for a in (D, N))
    v = entries.v[some] * np.exp2(time - length)
    D_table, sizes = _moving({key: c * np.exp2(-e) for key, c in D.items()}, v)
    N_table = _trimmed(_moving({key: c * np.exp2(-f) for key, c in N.items()}, v)[0])
    D_table = _trimmed(D_table)
    top = D_table.shape[1] - 1
    lost = np.abs(D_table[:, top]).max(1) < _LOST * sizes[:, top].max(1)
    lost |= (v > 0) & (top < max(i + j for i, j in D))
    g = np.exp2(f - e - length)
    formations = [entries.formations[k] for k in entries.which[some].tolist()]
    first = formations[0]
    M, C, K, B, h, places = (_stacked(formations, key) for key in ("M", "C", "K", "B", "h", "places"))
    rate = np.exp2(-time)
    S = [rows * (g * rate**k)[:, None, None] for k, rows in enumerate((K, C, M))]
    diagonal = sum(np.abs(np.einsum("kii->ki", rows)) for rows in S)
    scale = np.exp2(-np.round(np.log2(np.where(diagonal > 0, diagonal, 1)) / 2))
    S = [rows * scale[:, :, None] * scale[:, None, :] for rows in S]
    B = B * scale[:, :, None]
    for k in range(3):  # row i of S₀ and so on is divided by σ for a neutral i
        S[k][:, first.neutral] = S[k + 1][:, first.neutral] if k < 2 else 0.0
    moving = (D_table, N_table, _slope(D_table), _slope(N_table), v)
    contacts = (h / g[:, None], places * np.exp2(-length)[:, None])
    group = Group(some, *moving, S[0], S[1], S[2], B, *contacts, first.neutral, rate, _direct(first), 0)
    return group, lost


def _stacked(formations: list[Any], key: str) -> Any:
    return np.stack([getattr(formation, key) for formation in formations])


def _direct(formation: Any) -> tuple[tuple[int, int], ...]:
    out = []
    for j in range(len(formation.h)):
        bodies = np.flatnonzero(formation.B[:, j])
        if formation.h[j] == 0 and len(bodies) == 1 and np.count_nonzero(formation.B[bodies[0]]) == 1:
            out.append((int(bodies[0]), j))
    return tuple(out)


def _units(D: dict[Any, Any]) -> tuple[Any, Any]:
    """Exponents of the powers of two for length and time that bring the coefficients nearest to one size."""
    rows = np.array([[1.0, i, j] for i, j in D])
    logs = np.stack([np.log2(np.abs(c)) for c in D.values()])
    fit = np.linalg.pinv(rows) @ logs
    return np.round(fit[1]), np.round(fit[2])


def _moving(a: dict[Any, Any], v: Any) -> tuple[Any, Any]:
    """Coefficients of P^i σ^j with s = σ − vP, and the sums of the moduli that they are made of."""
    top_i, top_j = max(i + j for i, j in a), max(j for _, j in a)
    out, sizes = (np.zeros((len(v), top_i + 1, top_j + 1)) for _ in range(2))
    for (i, j), c in a.items():
        for k in range(j + 1):
            term = c * comb(j, k) * (-v) ** k
            out[:, i + k, j - k] += term
            sizes[:, i + k, j - k] += np.abs(term)
    return out, sizes


def _trimmed(table: Any) -> Any:
    """Without powers of P that no entry has."""
    top = max((i for i in range(table.shape[1]) if table[:, i].any()), default=0)
    return table[:, : top + 1]


def _slope(table: Any) -> Any:
    out = table[:, :, 1:] * np.arange(1, table.shape[2])
    return out if out.shape[2] else np.zeros((*table.shape[:2], 1))


def _by_side(group: Group, refused: dict[int, str]) -> Iterator[Group]:
    """The group in parts with one number of p-roots with Re P < 0 far below the real axis."""
    left = np.arange(len(group))
    ups = np.full(len(group), -1)
    for sigma in _STARTS:
        if not len(left):
            break
        z = by_companions(np.einsum("kij,j->ki", group.D[left], sigma ** np.arange(group.D.shape[2])) + 0j)
        clear = (np.abs(z.real).min(1, initial=np.inf) > _APART * np.abs(z).max(1, initial=0)) & np.isfinite(z).all(1)
        ups[left[clear]] = (z.real < 0).sum(1)[clear]
        left = left[~clear]
    refused |= dict.fromkeys(group.index[left].tolist(), "the p-roots cannot be told apart far below the real axis")
    for up in np.unique(ups[ups >= 0]).tolist():
        yield replace(group[ups == up], up=up)
