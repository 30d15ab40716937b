"""The characteristic matrix of a family over boxes, as models: det is Δ̂ up to a constant (see `bordered`)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_receptance import FreeReceptance, Receptances
from mpsolve.numbers.forms import Forms
from mpsolve.numbers.quadratic import Quadratic, joined
from mpsolve.problem.family import Family


@dataclass(frozen=True)
class FreeMatrix:
    """A(q̂, x̂): rows of all bodies, then of contacts; columns of bodies, then of contact forces.

    A tight contact that is alone on a body which it touches by a constant is eliminated, as in `bordered`.
    push: B in the rows of bodies, where those are scaled; as it is if left out.
    """

    family: Family
    push: Any = None

    @cached_property
    def receptance(self) -> FreeReceptance:
        return FreeReceptance(self.family)

    @property
    def variables(self) -> int:
        return self.receptance.track.variables

    @cached_property
    def direct(self) -> tuple[tuple[int, int, float], ...]:
        """(body, contact, −1/b)."""
        out = []
        B, h = self.family.B, self.family.h
        for j in range(len(h)):
            bodies = [i for i, row in enumerate(B) if row[j]]
            if h[j] or len(bodies) != 1 or sum(map(bool, B[bodies[0]])) != 1:
                continue
            constant = [c for e, c in B[bodies[0]][j] if not any(e)]
            if len(constant) == len(B[bodies[0]][j].terms):
                out.append((bodies[0], j, float(-1 / constant[0])))
        return tuple(out)

    @cached_property
    def _forms(self) -> tuple[Forms, Forms, Forms, Forms]:
        """S (row by row), B as bodies feel it, B as contacts do, and h."""
        family, m = self.family, 1 + len(self.family.paths)
        n = len(family.B)
        entries = []
        for i in range(n):
            for j in range(n):
                each = [(k, family.S[k][i][j]) for k in range(3)]
                entries.append({(k, *e): c for k, several in each for e, c in several})
        push, B, h = (
            Forms.of([{(0, *e): c for e, c in x} for row in rows for x in row], m)
            for rows in (self.push or family.B, family.B, [family.h])
        )
        return Forms.of(entries, m), push, B, h

    def __call__(self, boxes: Boxes) -> tuple[Quadratic, Receptances]:
        """(A of shape (boxes, n, n), the receptances it is made of)."""
        found = self.receptance(boxes)
        y, rho = boxes.variables
        with np.errstate(all="ignore"):
            return self.assembled(found.G, y, rho), found

    def own(self, y: Any, rho: Any) -> tuple[Quadratic, Quadratic, Quadratic, Quadratic]:
        """S, B as bodies feel it, B as contacts do, h: shapes (boxes, n, n), (boxes, n, c) twice, (boxes, c)."""
        n, c, boxes = len(self.family.B), len(self.family.index), y.shape[1]
        shapes = ((boxes, n, n), (boxes, n, c), (boxes, n, c), (boxes, c))
        S, push, B, h = (_shaped(form(y, rho), shape) for form, shape in zip(self._forms, shapes, strict=True))
        return S, push, B, h

    def assembled(self, G: Quadratic, y: Any, rho: Any) -> Quadratic:
        """A from G between the places."""
        contact = np.array(self.family.index)
        G = G[:, contact[:, None], contact[None, :]]
        n, c = len(self.family.B), len(contact)
        S, push, B, h = self.own(y, rho)
        bodies = [body for body, _, _ in self.direct]
        gone = [j for _, j, _ in self.direct]
        rest = [i for i in range(n) if i not in bodies]
        indirect = [j for j in range(c) if j not in gone]
        right = -push
        if bodies:
            factors = np.array([factor for _, _, factor in self.direct])
            right = right + S[:, :, bodies].times(factors) @ G[:, gone, :]
        top = joined([S[:, :, rest], right], -1) if rest else right
        if not indirect:
            return top
        low = G[:, indirect, :] + _diagonal(h, c)[:, indirect, :]
        if rest:
            flipped = Quadratic(np.swapaxes(B.k, 2, 3), np.swapaxes(B.e, 1, 2), B.m)
            low = joined([flipped[:, indirect][:, :, rest], low], -1)
        return joined([top, low], -2)


def _shaped(model: Quadratic, shape: tuple[int, ...]) -> Quadratic:
    return Quadratic(model.k.reshape(len(model.k), *shape), model.e.reshape(shape), model.m)


def _diagonal(h: Quadratic, n: int) -> Quadratic:
    eye = np.eye(n)
    return Quadratic(h.k[..., None] * eye, h.e[..., None] * eye, h.m)
