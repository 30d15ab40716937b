"""The roots of many neighbouring cases: certified anchors first, then level by level the cases between solved ones.

Cases come in an order in which neighbours are alike (order.py). A case is solved when the roots that Newton's
method reaches from the roots of its neighbours are as many as the winding number along the edge of its cut. What
is missing is sought from the edge itself and from a grid; what is still open is certified by itself.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any

import numpy as np

from mpsolve.certificate.sheet import certify_sheet
from mpsolve.errors import MpsolveError
from mpsolve.fast.cases import Cases
from mpsolve.fast.count import NODES, Edge, count_roots
from mpsolve.fast.guesses import edge_guesses, grid_guesses
from mpsolve.fast.newton import distinct, packed, polish, snapped, weight

STRIDE = 8192  # cases between anchors
MOST = 64  # roots of a case: one that has more is not followed
_DIGITS = 17
_PIECES = 2_000  # of the contour of a proof: a second, and twice what ordinary cases need
_FAILURES = 16  # of proofs after which no more of them are tried
_FEW = 256
_WORK = 1 << 20  # guesses, times the roots that are divided out of each, at a time: it bounds the memory


class Outcome(IntEnum):
    """How the roots of a case are known."""

    UNRESOLVED = 0  # not at all: no count could be confirmed, or the roots found do not add up to it
    TRACKED = 1  # float64: Newton's method converged to as many distinct roots as the float64 winding number says
    CERTIFIED = 2  # proved by `certify` for this very case, then rounded


@dataclass
class Following:
    """The state: q holds the distinct roots with Re q ≥ 0 found so far, shape (cases, columns), nan beyond them."""

    cases: Cases
    edge: Edge
    q: Any = field(init=False)
    outcome: Any = field(init=False)
    hopeless: Any = field(init=False)  # cases with too many roots, or whose proof has failed

    def __post_init__(self) -> None:
        self.hopeless = self.edge.count > MOST
        self.edge.count[self.hopeless] = -1
        width = max(2, int(self.edge.count.max(initial=0)))
        self.q = np.full((len(self.cases), width), np.nan, complex)
        none = self.edge.count == 0
        self.outcome = np.where(none, Outcome.TRACKED, Outcome.UNRESOLVED).astype(np.int8)

    def certify(self, places: Any) -> None:
        """Proves the roots of these cases, as long as no more than a few proofs fail: they are what takes long."""
        failures = 0
        for place in places[~self.hopeless[places]].tolist():
            roots = certified(self.cases, place)
            if roots is None:
                self.hopeless[place] = True
                failures += 1
                if failures == _FAILURES:
                    return
                continue
            self.q = packed(self.q, max(len(roots), self.q.shape[1]))
            self.q[place] = packed(np.array([roots], complex), self.q.shape[1])
            self.outcome[place] = Outcome.CERTIFIED

    def between(self, places: Any, stride: int) -> None:
        """Solves cases whose neighbours at a distance of `stride` are done."""
        for there in (places - stride, places + stride):
            roots = self._roots_at(there)
            still = self._open(places)
            self._extend(places[still], roots[still])
        self.search(places)

    def search(self, places: Any) -> None:
        """Roots that no neighbour has: from the edge, from a grid, at last from many more nodes of the edge."""
        places = places[self._open(places)]
        self._extend(places, edge_guesses(self.cases[places], self.edge[places], 12))
        places = places[self._open(places)]
        self._extend(places, grid_guesses(self.cases[places]), apart=True)
        places = places[self._open(places)]
        for some in (places[k : k + _FEW] for k in range(0, len(places), _FEW)):
            fine = count_roots(self.cases[some], 8 * NODES)
            self.edge.count[some] = np.where(fine.count == self.edge.count[some], fine.count, -1)
            self._extend(some, edge_guesses(self.cases[some], fine, 96), apart=True)

    def _open(self, places: Any) -> Any:
        return weight(self.q[places]) < self.edge.count[places]

    def _roots_at(self, there: Any) -> Any:
        inside = (there < len(self.q))[:, None]
        return np.where(inside, self.q[np.minimum(there, len(self.q) - 1)], np.nan)

    def _extend(self, places: Any, guesses: Any, apart: bool = False) -> None:
        """Adds what the guesses lead to, if `apart` with the known roots divided out."""
        size = max(1, _WORK // (guesses.shape[1] * (1 + self.q.shape[1] * apart)))
        for k in range(0, len(places), size):
            self._add(places[k : k + size], guesses[k : k + size], apart)

    def _add(self, places: Any, guesses: Any, apart: bool) -> None:
        known = self.q[places]
        each = np.repeat(np.arange(len(places)), guesses.shape[1])
        some = self.cases[places][each]
        new = polish(some, guesses.ravel(), known[each] if apart else None)
        if apart:
            new = polish(some, new)
        new = snapped(some, new).reshape(guesses.shape)
        found = distinct(self.cases[places], np.concatenate([known, new], axis=1), self.q.shape[1])
        have, want = weight(found), self.edge.count[places]
        self.q[places] = found
        self.outcome[places[have == want]] = Outcome.TRACKED


def follow(cases: Cases) -> tuple[Any, Any]:
    """(q, outcome) of the cases, one-dimensional and in order: roots with Re q ≥ 0, shape (cases, columns).

    At most one case in 512 (and 64 more) is certified for its own sake.
    """
    with np.errstate(all="ignore"):  # beyond the range of float64 there is no count, and so no root
        return _followed(cases)


def _followed(cases: Cases) -> tuple[Any, Any]:
    n = len(cases)
    state = Following(cases, count_roots(cases))
    stride = min(STRIDE, 1 << max(n - 1, 0).bit_length())
    anchors = np.arange(0, n, stride)
    state.certify(anchors[state.edge.count[anchors] >= 0])
    while stride > 1:
        stride //= 2
        state.between(np.arange(stride, n, 2 * stride), stride)
    state.search(np.flatnonzero(state.outcome == Outcome.UNRESOLVED))  # anchors without a proof
    state.certify(np.flatnonzero(state.outcome == Outcome.UNRESOLVED)[: 64 + n // 512])
    return np.where((state.outcome == Outcome.UNRESOLVED)[:, None], np.nan, state.q), state.outcome


def certified(cases: Cases, place: int) -> list[complex] | None:
    """Every root of one case with Re q ≥ 0, proved and rounded to float64; None if the proof fails."""
    try:
        spectrum = certify_sheet(cases.exact(place), _DIGITS, max_pieces=_PIECES, check=False)
    except MpsolveError:
        return None
    if not spectrum.proved or any(root.multiplicity > 1 for root in spectrum.roots):
        return None
    return [q for q in (complex(root.q.mid()) for root in spectrum.roots) if q.real >= 0]
