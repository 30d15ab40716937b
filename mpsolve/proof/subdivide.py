"""Subdivision: boxes of several variables are judged in batches, those that stay open halved. The tree is kept.

Nothing here knows what is proved of a box. Boxes are given by float corners; a box is halved at a float between its
corners, so that the two halves have all its points.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import EffortError
from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.outcome import Reason
from mpsolve.proof.effort import Effort
from mpsolve.proof.sheared import SLOPED, sheared

BATCH = 2048
FEW = 48  # boxes: so many take as long as one, so that fewer are halved without being judged
OPEN = 0
"""Of a box that is not decided."""
Judge = Callable[[Any, Any], tuple[Any, ...]]
"""(low, high), shape (variables, boxes) → (for each box a kind > 0, or OPEN; along which variable to halve it).

And thirdly, where the last row is that of slopes (`sheared`), a new slope for each box, nan where it is kept.
"""


@dataclass(frozen=True)
class Tree:
    """Nodes in the order of their making, the root first.

    kind[n] > 0: a leaf, decided so; axis[n] ≥ 0: halved along that variable, its halves are child[n], child[n] + 1.
    A node with neither stayed open. Where the axis is SLOPED it was halved along variable 1, and the halves
    laid along a new slope.
    """

    low: Reals
    high: Reals
    kind: Any
    axis: Any
    child: Integers

    @property
    def open(self) -> Integers:
        """The numbers of the leaves that stayed open."""
        return np.flatnonzero((self.kind == OPEN) & (self.axis < 0))

    @property
    def nodes(self) -> int:
        return len(self.kind)

    def boxes(self, numbers: Integers) -> tuple[Reals, Reals]:
        """Low and high corners, shape (variables, boxes)."""
        return self.low[:, numbers], self.high[:, numbers]


@dataclass(frozen=True)
class Covered:
    """A tree; `reason` says why boxes stayed open, where some did."""

    tree: Tree
    reason: Reason | None = None


def subdivide(
    low: Any,
    high: Any,
    judge: Judge,
    effort: Effort,
    smallest: Any = 2.0**-24,
    tell: Callable[[float], None] | None = None,
    few: int = FEW,
) -> Covered:
    """Boxes smaller than `smallest` of the whole along every variable stay open. Never raises for spent effort.

    smallest: one share of the whole, or one for each variable. few: boxes that are judged at once at least, if they
    are not too small: with fewer the tree has fewer leaves, but takes longer to find.
    """
    smallest = np.broadcast_to(np.asarray(smallest, float), np.shape(low))[:, None]
    lows, highs = [np.asarray(low, float)[:, None]], [np.asarray(high, float)[:, None]]
    grown = _Grown()
    waiting = [(grown.add(1), lows[0], highs[0])]
    whole = highs[0] - lows[0]
    stuck, reason, closed = 0, None, 0.0

    def halve(numbers: Integers, a: Any, b: Any, axis: Any, slope: Any = None) -> tuple[Integers, Reals, Reals]:
        new = grown.halve(numbers, a, b, axis, slope, whole, smallest)
        lows.append(new[1])
        highs.append(new[2])
        return new

    while waiting:
        numbers, a, b = _taken(waiting)
        while len(numbers) <= few // 2 and _wide(a, b, whole, smallest).all():
            numbers, a, b = halve(numbers, a, b, _longest(a, b, whole, smallest))
        try:
            effort.spend(len(numbers))
        except EffortError as error:
            reason = error.reason
            break
        kind, axis, *more = judge(a, b)
        closed += float(_share(a[:, kind > 0], b[:, kind > 0], whole).sum())
        grown.kind[numbers] = kind
        rest = kind == OPEN
        wide = rest & _wide(a, b, whole, smallest)
        stuck += int((rest & ~wide).sum())
        if wide.any():
            waiting.append(halve(numbers[wide], a[:, wide], b[:, wide], axis[wide], *(part[wide] for part in more)))
        if tell is not None:
            tell(min(closed, 1.0))
    tree = Tree(np.concatenate(lows, 1), np.concatenate(highs, 1), *grown.arrays)
    if reason is None and stuck:
        message = f"{stuck} boxes stay open at the smallest size"
        reason = Reason("boxes", message, {"boxes": str(stuck)}, "leave out what lies there, or give narrower ranges")
    return Covered(tree, reason)


def _taken(waiting: list[tuple[Integers, Reals, Reals]]) -> tuple[Integers, Reals, Reals]:
    """A batch from the end."""
    numbers, a, b = waiting.pop()
    while waiting and len(numbers) + len(waiting[-1][0]) <= BATCH:
        more, c, d = waiting.pop()
        numbers, a, b = np.concatenate([more, numbers]), np.concatenate([c, a], 1), np.concatenate([d, b], 1)
    if len(numbers) > BATCH:
        waiting.append((numbers[:-BATCH], a[:, :-BATCH], b[:, :-BATCH]))
        numbers, a, b = numbers[-BATCH:], a[:, -BATCH:], b[:, -BATCH:]
    return numbers, a, b


def _wide(a: Any, b: Reals, whole: Reals, smallest: Reals) -> Any:
    return (b - a > smallest * whole * (1 + 2.0**-20)).any(0)


def _longest(a: Any, b: Reals, whole: Reals, smallest: Reals) -> Any:
    """Of each box, relative to the smallest that there may be."""
    return ((b - a) / np.where(whole > 0, whole, np.inf) / smallest).argmax(0)


def _share(a: Any, b: Any, whole: Any) -> Any:
    return ((b - a) / np.where(whole > 0, whole, 1)).prod(0, where=whole > 0)


class _Grown:
    """Arrays of nodes that grow."""

    def __init__(self) -> None:
        self.kind, self.axis, self.child = np.zeros(0, np.int8), np.zeros(0, np.int8), np.zeros(0, np.int64)

    @property
    def arrays(self) -> tuple[Any, Any, Integers]:
        return self.kind, self.axis, self.child

    def add(self, count: int) -> Integers:
        first = len(self.kind)
        self.kind = np.concatenate([self.kind, np.zeros(count, np.int8)])
        self.axis = np.concatenate([self.axis, np.full(count, -1, np.int8)])
        self.child = np.concatenate([self.child, np.full(count, -1, np.int64)])
        return np.arange(first, first + count)

    def halve(
        self, numbers: Integers, a: Any, b: Reals, axis: Any, slope: Any, whole: Reals, smallest: Reals
    ) -> tuple[Integers, Reals, Reals]:
        """The halves, next to each other, along `axis` or along the longest side where that one is too short."""
        columns = np.arange(len(numbers))
        size = (b - a) / np.where(whole > 0, whole, np.inf) / smallest
        axis = np.where(size[axis, columns] > 1 + 2.0**-20, axis, size.argmax(0))
        turned = np.zeros(len(numbers), bool) if slope is None else np.isfinite(slope)
        axis = np.where(turned, 1, axis)
        middle = a[axis, columns] / 2 + b[axis, columns] / 2
        first, second = b.copy(), a.copy()
        first[axis, columns], second[axis, columns] = middle, middle
        new = self.add(2 * len(numbers))
        self.axis[numbers], self.child[numbers] = np.where(turned, SLOPED, axis), new[::2]
        low, high = _interleaved(a, second), _interleaved(first, b)
        if turned.any():
            rows = np.repeat(turned, 2)
            low[:, rows], high[:, rows] = sheared(low[:, rows], high[:, rows], np.repeat(slope, 2)[rows])
        return new, low, high


def _interleaved(one: Any, other: Reals) -> Reals:
    return np.stack([one, other], 2).reshape(len(one), -1)


def halved(low: Reals, high: Reals, times: int) -> Tree:
    """2^times open boxes, 32 at least, each halved along its longest sides, relative to the whole."""
    whole = np.asarray(high, float) - np.asarray(low, float)

    def judge(a: Any, b: Reals) -> tuple[Integers, Integers]:
        share = (b - a) / np.where(whole > 0, whole, np.inf)[:, None]
        done = np.log2(share, where=share > 0, out=np.zeros_like(share)).sum(0) <= 0.5 - times
        return np.where(done, 1, OPEN), share.argmax(0)

    tree = subdivide(low, high, judge, Effort()).tree
    return Tree(tree.low, tree.high, np.zeros_like(tree.kind), tree.axis, tree.child)


def grafted(tree: Tree, leaves: Sequence[int], trees: Sequence[Tree]) -> Tree:
    """`tree` with other trees in the places of some of its open leaves, whose boxes are theirs."""
    parts = [tree]
    kind, axis, child = (part.copy() for part in (tree.kind, tree.axis, tree.child))
    size = tree.nodes
    for leaf, one in zip(leaves, trees, strict=True):
        shift = size - 1  # the root of the new one is the leaf; its other nodes follow
        kind[leaf], axis[leaf] = one.kind[0], one.axis[0]
        child[leaf] = one.child[0] + shift if one.axis[0] >= 0 else -1
        moved = np.where(one.axis >= 0, one.child + shift, -1)
        parts.append(Tree(one.low[:, 1:], one.high[:, 1:], one.kind[1:], one.axis[1:], moved[1:]))
        size += one.nodes - 1
    new = parts[1:]
    return Tree(
        np.concatenate([part.low for part in parts], 1),
        np.concatenate([part.high for part in parts], 1),
        np.concatenate([kind, *(part.kind for part in new)]),
        np.concatenate([axis, *(part.axis for part in new)]),
        np.concatenate([child, *(part.child for part in new)]),
    )
