"""The characteristic matrix of a family over boxes, as models: det is Δ̂ up to a constant (see `bordering`)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_receptance import FreeReceptance, Receptances
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.forms import Forms
from mpsolve.numbers.quadratic import Quadratic, joined
from mpsolve.problem.family import Family

if TYPE_CHECKING:
    from mpsolve.numbers.several import Several


@dataclass(frozen=True)
class FreeMatrix:
    """A(q̂, x̂).

    push: B in the rows of bodies, where those are scaled; as it is if left out.
    """

    family: Family
    push: tuple[tuple[Several, Several], ...] | None = None

    @cached_property
    def receptance(self) -> FreeReceptance:
        return FreeReceptance(self.family)

    @property
    def variables(self) -> int:
        return self.receptance.track.variables

    @cached_property
    def border(self) -> Bordering:
        return Bordering.of(self.family, push=self.push)

    @cached_property
    def _forms(self) -> Forms:
        """The polynomials in σ and the parameters of which the matrix is made."""
        return forms_of(self.border.polynomials, 1 + len(self.family.paths))

    def __call__(self, boxes: Boxes) -> tuple[Quadratic, Receptances]:
        """(A of shape (boxes, n, n), the receptances it is made of)."""
        found = self.receptance(boxes)
        y, rho = boxes.variables
        with np.errstate(all="ignore"):
            return self.assembled(found.G, y, rho), found

    def polynomials(self, y: Any, rho: Complexes) -> Quadratic:
        """Over boxes, shape (boxes, polynomials)."""
        return self._forms(y, rho)

    def assembled(self, G: Quadratic, y: Any, rho: Complexes) -> Quadratic:
        """A from G between the places."""
        contact = np.array(self.family.index)
        first, second = self.border.one_each
        model: Quadratic = self.border.matrix(self.polynomials(y, rho), G[:, contact[first], contact[second]], joined)
        return model


def forms_of(polynomials: Sequence[Sequence[Several]], variables: int) -> Forms:
    """Of polynomials in σ whose coefficients are some in the parameters."""
    return Forms.of([{(k, *e): x for k, c in enumerate(f) for e, x in c} for f in polynomials], variables)
