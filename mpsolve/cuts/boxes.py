"""The characteristic matrix along the edge of the cut over boxes of (p, x̂), as Taylor models."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import forms_of
from mpsolve.characteristic.free_receptance import Receptances
from mpsolve.characteristic.free_roots import Roots, roots_over
from mpsolve.cuts.edge import Edge, beam, edge, sides
from mpsolve.cuts.entries import Parts, of_one, of_two
from mpsolve.cuts.model import ROUNDING, Model, model_of
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths
from mpsolve.numbers.forms import Forms
from mpsolve.numbers.jets import TINY, UP, U
from mpsolve.numbers.quadratic import Quadratic, constant, joined, lifted, pairs
from mpsolve.problem.family import Family

_NEWTON = 4
_CLOSE = 0.25  # of |p|: two p-roots that may be about to meet


def _scale(A: Any) -> Any:
    """Powers of two that bring the rows and columns of matrices near 1: such a factor loses nothing."""
    size = np.nan_to_num(np.abs(A), nan=1.0, posinf=1.0)
    rows = np.exp2(-np.round(np.log2(np.maximum(size.max(2, keepdims=True), 1e-100))))
    columns = np.exp2(-np.round(np.log2(np.maximum((size * rows).max(1, keepdims=True), 1e-100))))
    return rows * columns


@dataclass(frozen=True)
class EdgeMatrix:
    """A over boxes of one side of the cut; variable 0 is p.

    meeting: whether boxes are told in which a′ and b′ may meet. A bounds all values there, but is not analytic where
    they do, so that nothing about slopes follows.
    """

    family: Family
    side: int
    variables: int = 2
    meeting: bool = True

    @cached_property
    def _borders(self) -> tuple[Bordering, Bordering]:
        """With an unknown for a, and with one for a′ too: of the same polynomials in σ."""
        return Bordering.of(self.family, waves=1), Bordering.of(self.family, waves=2)

    @cached_property
    def _forms(self) -> tuple[Forms, Forms]:
        """Of the beam; of the matrix's polynomials (by powers of σ), the places and the distances."""
        family, border = self.family, self._borders[0]
        zero = family.ring.constant(0)
        own = [f[k] if k < len(f) else zero for k in range(3) for f in border.polynomials]
        own += [*(family.places[k] for k in family.index), *border.distances]
        return forms_of([[c] for c in beam(family)], 2), forms_of([[c] for c in own], 2)

    def edge(self, boxes: Boxes) -> tuple[Edge, list[Model]]:
        """(z and what goes with it, the beam's coefficients)."""
        y, rho = boxes.variables
        all_ = self._forms[0](y, rho)
        coefficients = [model_of(all_[:, n]) for n in range(all_.e.shape[1])]
        p = Model(np.zeros(all_.k.shape[:2], complex), 4 * U * np.abs(y[0]), 2)
        p.k[0], p.k[1] = y[0], rho[0]
        return edge(p, coefficients[:-1], _root), [p, *coefficients]

    def __call__(self, boxes: Boxes) -> tuple[Quadratic, Receptances]:
        """(A of shape (boxes, n, n), where it is good)."""
        with np.errstate(all="ignore"):
            at, (p, EI, *_, v, N) = self.edge(boxes)
            cubic, sane, z, real, found = self._others(at, p, EI, v)
            one = constant(np.ones(1), boxes.count, 2)
            r = [model_of(found.P[:, n]) for n in range(3)]
            good = sane & found.good.all(1) & _told(at, r, v, real)
            y, rho = boxes.variables
            own = self._forms[1](y, rho)
            k, e = self._filled(self._parts((p, *r), EI, N, at.sigma, own), own, of_one)
            # where the cuts overlap G(0) vanishes at Re q = 0, and b′ meets a′ at the end of the overlap
            both = np.flatnonzero(good & (real | (np.abs(r[1].a - r[2].a) < _CLOSE * np.abs(p.a))))
            rest = np.flatnonzero(sane & ~good) if self.meeting else both[:0]
            if len(both) or len(rest):
                k, e = _with_one_more(k, e)
                waves, beams = ([model_of(x[both]) for x in some] for some in ((p, *r), (EI, N, at.sigma)))
                parts = self._parts(tuple(waves), beams[0], beams[1], beams[2], own[both])
                k[:, both], e[both] = self._filled(parts, own[both], of_two)
                k[:, rest], e[rest], good[rest] = self._meeting(cubic, z, (p, EI, v, N), at, own, rest)
            good = good & np.isfinite(e).all((1, 2)) & np.isfinite(k).all((0, 2, 3))
            span = float(max(map(abs, map(float, self._span))))
            strain = np.nan_to_num(found.strain) + np.abs(p.b) * (span + 1)
            scale = _scale(k[0])
            return Quadratic(k * scale, e * scale, 2), Receptances(one, good, strain)

    def _others(self, at: Edge, p: Model, EI: Model, v: Model) -> tuple[Quadratic, Any, Any, Any, Roots]:
        """(the cubic, where it is finite, floats near its roots b, a′, b′, whether they are real, the roots)."""
        cubic = _stacked(list(at.cubic))
        sane = np.isfinite(cubic.a).all(1) & np.isfinite(cubic.e).all(1)
        floats = np.where(sane[:, None], cubic.a.real, [0.0, 1.0, 0.0, 1.0])
        z, real = sides(floats, p.a.real, np.where(sane, at.z.a.real, 0.0), v.a.real, self.side)
        for _ in range(_NEWTON if p.a.imag.any() else 0):  # from the roots next to the real axis
            rise = sum(j * cubic.a[:, j : j + 1] * z ** (j - 1) for j in (1, 2, 3))
            z = z - sum(cubic.a[:, j : j + 1] * z**j for j in range(4)) / rise
        return cubic, sane, z, real, roots_over(cubic, constant(np.ones(1), len(sane), 2), z, _least(EI), None)

    def apart(self, boxes: Boxes) -> Any:
        """Where a′ is proved to lie above the real axis and b′ below it, for all complex p of a box too."""
        with np.errstate(all="ignore"):
            at, (p, EI, *_, v, _) = self.edge(boxes)
            _, sane, _, _, found = self._others(at, p, EI, v)
            return sane & found.good.all(1) & _off_axis([model_of(found.P[:, n]) for n in (1, 2)])

    @cached_property
    def _span(self) -> list[Fraction]:
        """The places at the ring's point."""
        return [place.at(self.family.ring.point) for place in self.family.places]

    def _meeting(
        self,
        cubic: Quadratic,
        z: Complexes,
        wave: tuple[Model, Model, Model, Model],
        at: Edge,
        own: Quadratic,
        rows: Integers,
    ) -> tuple[Complexes, Reals, Truths]:
        """(A's coefficients, its remainders, where it is good) where a′ and b′ may meet: c ± √w, a third variable."""
        p, EI, v, N = (model_of(x[rows]) for x in wave)
        z_, lean, sigma, *terms = (model_of(x[rows]) for x in (at.z, at.lean, at.sigma, *at.cubic))
        at = Edge(z_, lean, sigma, terms)
        found = roots_over(cubic[rows], constant(np.ones(1), len(rows), 2), z[rows, :1], _least(EI), None)
        r = model_of(found.P[:, 0])
        c = -(p + r).times(0.5)
        w = c * c + -(at.cubic[1] * EI.inverse() + r * (p + r))
        radius = np.sqrt(w.size) * UP
        good = found.good[:, 0] & _behind(at, Model(c.k, c.e + radius, 2), v)
        p, r, c, EI, N, sigma = (model_of(lifted(x, 3)) for x in (p, r, c, EI, N, at.sigma))
        apart = np.zeros(c.k.shape, complex)
        apart[3] = radius
        half = Model(apart, 4 * U * radius, 3)
        own = lifted(own[rows], 3)
        k, e = self._filled(self._parts((p, r, c + half, c + -half), EI, N, sigma, own), own, of_two)
        kept = [0, 1, 2, *(1 + 3 + pairs(3).index(pair) for pair in pairs(2))]
        lost = np.abs(k).sum(0) - np.abs(k[kept]).sum(0)
        return k[kept], (e + lost) * UP + 64 * U * np.abs(k).sum(0), good

    def _parts(self, r: tuple[Model, ...], EI: Model, N: Model, sigma: Any, own: Quadratic) -> Parts:
        """r: the p-roots a, b, a′, b′, divided by i."""
        border, boxes = self._borders[0], len(EI.e)
        behind = [model_of(own[:, j]) for j in range(3 * len(border.polynomials), own.e.shape[1])]
        contacts = len(border.which)
        one, zero = (model_of(constant(x, boxes, EI.m)) for x in (1.0, 0.0))
        a, b, a2, b2 = (x.times(1j) for x in r)
        return Parts(a, b, a2, b2, EI, N, sigma, behind[:contacts], behind[contacts:], border.signs, one, zero)

    def _filled(self, parts: Parts, own: Quadratic, given: Callable[[Parts], list[Any]]) -> tuple[Complexes, Reals]:
        """(A's coefficients, its remainders)."""
        border = self._borders[0 if given is of_one else 1]
        n, sigma = len(border.polynomials), parts.sigma[:, None]
        f = (own[:, 2 * n : 3 * n] * sigma + own[:, n : 2 * n]) * sigma + own[:, :n]
        A = border.matrix(f, joined([x[:, None] for x in given(parts)]), joined)
        return A.k, A.e

    def off_the_cut(self, boxes: Boxes, waves: list[Quadratic]) -> tuple[Complexes, Reals]:
        """(A's coefficients, its remainders) over boxes of (q̂, x̂), from models of a, b, a′ and b′ there."""
        y, rho = boxes.variables
        all_ = self._forms[0](y, rho)
        EI, *_, N = (model_of(all_[:, n]) for n in range(all_.e.shape[1]))
        sigma = Model(np.zeros(all_.k.shape[:2], complex), 4 * U * np.abs(y[0]), 2)
        sigma.k[0], sigma.k[1] = y[0], rho[0]
        r = tuple(model_of(wave).times(-1j) for wave in waves)
        own = self._forms[1](y, rho)
        k, e = self._filled(self._parts(r, EI, N, sigma, own), own, of_two)
        scale = _scale(k[0])
        return k * scale, e * scale

    def elsewhere(self, boxes: Boxes) -> Any:
        """Boxes all of whose points belong to the other side of the cut, or to mirror images."""
        with np.errstate(all="ignore"):
            at, _ = self.edge(boxes)
            wrong = -self.side * at.lean.a.real > at.lean.spread
            return wrong | (-at.z.a.real > at.z.spread)


def _with_one_more(k: Any, e: Reals) -> tuple[Complexes, Reals]:
    """Matrices with one more row and column, those of the identity."""
    n = e.shape[1]
    k = np.pad(k, ((0, 0), (0, 0), (0, 1), (0, 1)))
    k[0, :, n, n] = 1
    return k, np.pad(e, ((0, 0), (0, 1), (0, 1)))


def _root(f: Model, m: Model) -> Model:
    ratio = f.a / m.a
    s = np.sqrt(np.where(ratio.real > 0, ratio, TINY))
    D = _stacked([-f, f.times(0.0), m])
    z = np.stack([-s, s], 1)
    found = roots_over(D, constant(np.ones(1), len(s), 2), z, _least(m), 1)
    P = model_of(found.P[:, 1])
    return Model(P.k, np.where(found.good.all(1), P.e, np.inf), 2)


def _least(lead: Model) -> Any:
    return (np.abs(lead.a) - lead.spread) * (1 - 64 * U)


def _stacked(parts: list[Model]) -> Quadratic:
    return Quadratic(np.stack([x.k for x in parts], -1), np.stack([x.e for x in parts], -1), 2)


def _told(at: Edge, r: list[Model], v: Model, real: Any) -> Any:
    """Where a′ and b′ are not real, or real, on the other branch, and told by their order (they are apart)."""
    return np.where(real, _behind(at, r[1], v) & _behind(at, r[2], v), _off_axis(r[1:]))


def _off_axis(pair: list[Model]) -> Any:
    first, second = pair
    return (first.a.imag > first.spread * UP) & (-second.a.imag > second.spread * UP)


def _behind(at: Edge, r: Model, v: Model) -> Any:
    """Where r, if it is real, belongs to the branch z = vr − S."""
    x = at.z + -(v * r)
    return x.a.real + x.spread < -ROUNDING * np.abs(x.a)
