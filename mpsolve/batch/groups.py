"""Entries of one structure as stacked arrays in scaled units: what the kernels of this package work on.

Scaled by powers of two as in problem/reduced.py: P = P̂/L, σ = σ̂/T, so that the coefficients of D̂ are near 1.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from functools import cached_property
from types import SimpleNamespace
from typing import Any

import numpy as np

from mpsolve.batch.entries import Entries, Formation
from mpsolve.batch.waveguides import expanded
from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.follow import eigenvalues
from mpsolve.numbers.arrays import Integers, Reals, Truths
from mpsolve.tracks.waveguide import carried

_APART = 1e-7
_LOST = 1e-11
_STARTS = (1.0, 0.5, 2.0, 0.25, 4.0)


@dataclass(frozen=True)
class Group:
    """Entries `index` of a batch (K of them), with the same degrees and the same pattern of their vehicles.

    D, N: coefficients of P^i σ^j of the moving track, shape (K, i, j). D_s, N_s: their slopes in σ.
    S0, S1, S2: the vehicle's pencil S₀ + S₁σ + S₂σ², (K, bodies, bodies), rows of neutral bodies divided by σ;
    B, h, x: (K, bodies, contacts), (K, contacts), ascending places. up: how many p-roots decay ahead. q = q̂ · unit.
    """

    index: Integers
    D: Any
    N: Reals
    D_s: Reals
    N_s: Reals
    v: Reals
    S0: Reals
    S1: Reals
    S2: Reals
    B: Any
    h: Reals
    x: Any
    neutral: Truths
    unit: Reals
    up: int

    def __len__(self) -> int:
        return len(self.index)

    def __getitem__(self, rows: Any) -> Group:
        shared = ("neutral", "up")
        return replace(self, **{f.name: getattr(self, f.name)[rows] for f in fields(self) if f.name not in shared})

    @property
    def bodies(self) -> int:
        return int(self.B.shape[1])

    @property
    def contacts(self) -> int:
        return int(self.B.shape[2])

    @cached_property
    def border(self) -> tuple[Bordering, Any]:
        """What stands in which entry of the matrix, and the coefficients of its polynomials, (K, 3, polynomials)."""

        def columns(a: Any) -> list[list[Column]]:
            return [[Column(a[:, i, j]) for j in range(a.shape[2])] for i in range(a.shape[1])]

        places = [2**k for k in range(self.contacts)]  # so that no two distances are equal: of some entries none are
        S, (h,) = [columns(a) for a in (self.S0, self.S1, self.S2)], columns(self.h[:, None])
        given: Any = SimpleNamespace(S=S, B=columns(self.B), h=h, places=places, index=range(self.contacts))
        border = Bordering.of(given)
        table = np.zeros((len(self), 3, len(border.polynomials)))
        for n, f in enumerate(border.polynomials[1:], 1):
            for k, c in enumerate(f):
                table[:, k, n] = c.values
        return border, table

    @property
    def direct(self) -> list[tuple[int, int]]:
        """(body, contact) of tight contacts alone on their body, which are eliminated."""
        return [(one.body, one.contact) for one in self.border[0].direct]


class Column:
    """A number of the vehicle, of each entry its own, in the place of an exact one."""

    def __init__(self, values: Any) -> None:
        self.values = values

    def __bool__(self) -> bool:
        return bool(np.any(self.values))

    def __neg__(self) -> Column:
        return Column(-self.values)

    def __truediv__(self, other: Column) -> Column:
        return Column(self.values / other.values)


def groups_of(entries: Entries, rows: Integers) -> tuple[list[Group], dict[int, str]]:
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


def _group(
    entries: Entries, some: Integers, D: dict[Any, Any], N: dict[tuple[int, int], Reals]
) -> tuple[Group, Truths]:
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
    group = Group(some, *moving, S[0], S[1], S[2], B, *contacts, first.neutral, rate, 0)
    return group, lost


def _stacked(formations: list[Formation], key: str) -> Reals:
    return np.stack([getattr(formation, key) for formation in formations])


def _units(D: dict[Any, Any]) -> tuple[Reals, Reals]:
    """Exponents of the powers of two for length and time that bring the coefficients nearest to one size."""
    rows = np.array([[1.0, i, j] for i, j in D])
    logs = np.stack([np.log2(np.abs(c)) for c in D.values()])
    fit = np.linalg.pinv(rows) @ logs
    return np.round(fit[1]), np.round(fit[2])


def _moving(a: dict[Any, Any], v: Reals) -> tuple[Reals, Reals]:
    """Coefficients of P^i σ^j with s = σ − vP, and the sums of the moduli that they are made of."""
    tables = []
    for part in (carried(a, v), carried({key: np.abs(c) for key, c in a.items()}, -np.abs(v))):
        table = np.zeros((len(v), max(i for i, _ in part) + 1, max(j for _, j in part) + 1))
        for (i, j), c in part.items():
            table[:, i, j] = c
        tables.append(table)
    return tables[0], tables[1]


def _trimmed(table: Reals) -> Reals:
    """Without powers of P that no entry has."""
    top = max((i for i in range(table.shape[1]) if table[:, i].any()), default=0)
    return table[:, : top + 1]


def _slope(table: Reals) -> Reals:
    out = table[:, :, 1:] * np.arange(1, table.shape[2])
    return out if out.shape[2] else np.zeros((*table.shape[:2], 1))


def _by_side(group: Group, refused: dict[int, str]) -> Iterator[Group]:
    """The group in parts with one number of p-roots with Re P < 0 far below the real axis."""
    left = np.arange(len(group))
    ups = np.full(len(group), -1)
    for sigma in _STARTS:
        if not len(left):
            break
        z = eigenvalues(np.einsum("kij,j->ki", group.D[left], sigma ** np.arange(group.D.shape[2])) + 0j)
        clear = (np.abs(z.real).min(1, initial=np.inf) > _APART * np.abs(z).max(1, initial=0)) & np.isfinite(z).all(1)
        ups[left[clear]] = (z.real < 0).sum(1)[clear]
        left = left[~clear]
    refused |= dict.fromkeys(group.index[left].tolist(), "the p-roots cannot be told apart far below the real axis")
    for up in np.unique(ups[ups >= 0]).tolist():
        yield replace(group[ups == up], up=up)
