"""The entries of a batch: arrays of parameters that broadcast over one problem, and what each entry is made of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Integers, Reals, Truths
from mpsolve.numbers.model import Model
from mpsolve.problem.cases import Given, as_problem, value_at
from mpsolve.problem.parameters import changed
from mpsolve.problem.problem import Problem
from mpsolve.vehicles.felt import split_felt
from mpsolve.vehicles.vehicle import AnyVehicle, Placed, checked_pencil

Signature = tuple[Any, ...]
_CLEAR = 1e-7


@dataclass(frozen=True)
class Formation:
    """All vehicles of an entry in float64, contacts from rear to front: M, C, K (bodies × bodies), B, h, places.

    neutral: which bodies are neutral motions, whose rows are divided by σ. signature: what formations that are
    computed together have in common.
    """

    M: Reals
    C: Reals
    K: Reals
    B: Reals
    h: Reals
    places: Reals
    neutral: Truths
    signature: Signature


@dataclass(frozen=True)
class Entries:
    """The entries of a batch, flat: v, the track's parameters (arrays or numbers by name), the formation of each."""

    problem: Problem
    shape: tuple[int, ...]
    over: dict[str, Reals]
    v: Reals
    track: dict[str, Any]
    formations: tuple[Formation, ...]
    which: Integers

    def __len__(self) -> int:
        return len(self.v)

    def exact(self, index: int) -> Problem:
        """One entry as a problem, its floats read as their shortest decimals."""
        problem = self.problem
        for path, values in self.over.items():
            problem = problem.changed(path, float(values[index]))
        return problem


def entries_of(given: Given, over: Mapping[str, Any]) -> Entries:
    """The entries for arrays by path; InputError names the path that cannot be."""
    problem = as_problem(given)
    arrays = {path: _floats(given, path, values) for path, values in over.items()}
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{path} {array.shape}" for path, array in arrays.items())
        raise InputError("over", f"has arrays that do not broadcast: their shapes are {shapes}") from None
    flat = {path: np.broadcast_to(array, shape).ravel() for path, array in arrays.items()}
    size = int(np.prod(shape, dtype=int))
    track: dict[str, Any] = {name: float(value) for name, value in _track_parameters(problem.track).items()}
    for path, values in flat.items():
        if path.startswith("track."):
            track[path.removeprefix("track.")] = values
    v = flat.get("v", np.full(size, float(problem.v)))
    formations, which = _formations(problem, flat, size)
    return Entries(problem, shape, flat, v, track, formations, which)


def _track_parameters(track: Any) -> dict[str, Fraction]:
    return dict(track.parameters) if isinstance(track, Model) else {}


def _floats(given: Given, path: str, values: Any) -> Reals:
    """An array within the bounds of the parameter; texts may have units of their own."""
    asked = as_problem(given).quantity(path)
    if np.ma.is_masked(values):
        raise InputError(path, "has masked entries: give a number everywhere, or leave those entries out")
    array = np.asarray(values)
    if array.dtype.kind in "OU":
        exact = [float(value_at(given, path, x)) for x in array.ravel().tolist()]
        array = np.array(exact).reshape(array.shape)
    if array.dtype.kind not in "iuf":
        raise InputError(path, "is no array of real numbers: give a number, a list or an array of them")
    array = array.astype(float)
    _require(path, array, np.isfinite(array), "not finite: give finite numbers")
    if asked.above is not None:
        _require(path, array, array > asked.above, f"but must be above {asked.above}: give the {asked.told}")
    if asked.at_least is not None:
        _require(
            path, array, array >= asked.at_least, f"but must not be below {asked.at_least}: give the {asked.told}"
        )
    return array


def _require(path: str, values: Any, holds: Any, stated: str) -> None:
    if not np.all(holds):
        first = tuple(int(k) for k in np.argwhere(~np.asarray(holds))[0])
        where = f"{list(first)} " if first else ""
        raise InputError(path, f"{where}is {values[first]:g}, {stated}")


def _formations(problem: Problem, flat: Mapping[str, Reals], size: int) -> tuple[tuple[Formation, ...], Integers]:
    """The different formations, and which of them each entry has."""
    paths = [path for path in flat if path != "v" and not path.startswith("track.")]
    each, which = different(problem, flat, paths, size)
    return tuple(formation(vehicles) for _, vehicles in each), which


def different(
    problem: Problem, flat: Mapping[str, Reals], paths: Sequence[str], size: int
) -> tuple[list[tuple[Any, tuple[Placed, ...]]], Integers]:
    """Track and vehicles for the different values of the parameters at these paths, and which each entry has."""
    if not paths or not size:
        return [(problem.track, problem.vehicles)], np.zeros(size, int)
    rows, which = np.unique(np.stack([flat[path] for path in paths], 1), axis=0, return_inverse=True)
    out = []
    for row in rows.tolist():
        track, vehicles = problem.track, problem.vehicles
        for path, value in zip(paths, row, strict=True):
            track, vehicles, *_ = changed(track, vehicles, problem.v, path, value)
        out.append((track, vehicles))
    return out, which.reshape(-1)


def formation(vehicles: tuple[Placed, ...]) -> Formation:
    """The vehicles in float64. Modes that no contact feels are left out, by exact algebra vehicle by vehicle."""
    parts = [(placed, _matrices(placed.vehicle)) for placed in vehicles]
    spots = [
        (placed.position + place, k, j)
        for k, (placed, one) in enumerate(parts)
        for j, place in enumerate(one.pencil_places)
    ]
    spots.sort()
    bodies = sum(len(one.M) for _, one in parts)
    M, C, K = (np.zeros((bodies, bodies)) for _ in range(3))
    B, first = np.zeros((bodies, len(spots))), 0
    starts = []
    for _, one in parts:
        part = slice(first, first + len(one.M))
        M[part, part], C[part, part], K[part, part] = one.M, one.C, one.K
        starts.append(part)
        first += len(one.M)
    for i, (_, k, j) in enumerate(spots):
        B[starts[k], i] = parts[k][1].B[:, j]
    h = np.array([parts[k][1].h[j] for _, k, j in spots])
    origin = spots[0][0]
    places = np.array([float(x - origin) for x, _, _ in spots])
    neutral = np.concatenate([one.neutral for _, one in parts])
    together = np.array([a[0] == b[0] for a, b in pairwise(spots)], bool)
    masks = (((M != 0) | (C != 0) | (K != 0)), B != 0, h != 0, neutral, together)
    return Formation(M, C, K, B, h, places, neutral, (bodies, len(spots), *(m.tobytes() for m in masks)))


@dataclass(frozen=True)
class _Matrices:
    M: Reals
    C: Reals
    K: Reals
    B: Reals
    h: Reals
    neutral: Truths
    pencil_places: tuple[Fraction, ...]


@lru_cache(maxsize=512)
def _matrices(vehicle: AnyVehicle) -> _Matrices:
    pencil = checked_pencil(vehicle.pencil)
    M, C, K, B = (np.array(rows, float) for rows in (pencil.M, pencil.C, pencil.K, pencil.B))
    neutral = np.zeros(len(M), bool)
    if not _clearly_felt(M, C, K, B):
        parts = split_felt(pencil)
        M, C, K, B = (np.array(rows, float) for rows in (parts.M, parts.C, parts.K, parts.B))
        neutral = np.arange(len(M)) >= len(M) - parts.neutral
    return _Matrices(M, C, K, B, np.array(pencil.h, float), neutral, pencil.places)


def _clearly_felt(M: Any, C: Any, K: Any, B: Any) -> bool:
    """Whether floats show beyond doubt that the contacts feel every motion, and that none is neutral.

    As vehicles/felt.py decides exactly. The space that grows from H⁻¹B by H⁻¹M, H⁻¹C, H⁻¹K is the same for every
    positive combination H of the three.
    """
    rate = np.sqrt(np.trace(K) / np.trace(M)) if np.trace(K) > 0 else 1.0
    parts = (M * rate**2, C * rate, K)
    size = 1 / np.sqrt(np.maximum(np.diag(parts[0] + parts[1] + parts[2]), 1e-300))
    parts = tuple(a * size[:, None] * size for a in parts)
    touch = B * size[:, None]
    touch = touch / np.maximum(np.abs(touch).max(0), 1e-300)
    if np.linalg.eigvalsh(parts[2] + touch @ touch.T)[0] < _CLEAR:
        return False
    H = parts[0] + parts[1] + parts[2]
    space = np.linalg.solve(H, touch)
    for _ in range(len(M)):
        left, sizes, _ = np.linalg.svd(space, full_matrices=False)
        space = left[:, sizes > _CLEAR * sizes[0]]
        if space.shape[1] == len(M):
            return True
        space = np.hstack([space, *(np.linalg.solve(H, a @ space) for a in parts)])
    return False
