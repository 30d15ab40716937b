"""One fraction: an expression as numerator over denominator, neither of them divided by what depends on z.

Only sums, products, quotients and whole powers are opened; what stands in a function stays as it is. Sums share the
factors that are equal steps: 1/(z − 1) + 1/(z − 1)² has the denominator (z − 1)².
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from mpsolve.zeros.program import CUT, LEAVES, OPERATIONS, Expression, Program, Step, dependent, reduced

Factors = dict[int, int]


@dataclass(frozen=True)
class _Part:
    """top / Π factor^power, as steps."""

    top: int
    below: Factors


def as_fraction(program: Program, output: int) -> Expression:
    """The expression of a step as one fraction; without a denominator where nothing is divided by z."""
    depends = dependent(program.steps)
    parts: list[_Part] = []
    for k in range(output + 1):
        parts.append(_part(program, k, parts, depends))
    return _expression(program, parts[output])


def _part(program: Program, k: int, parts: list[_Part], depends: list[bool]) -> _Part:
    step = program.steps[k]
    if step[0] in LEAVES or not depends[k]:
        return _Part(k, {})
    if step[0] == "pow":
        one = parts[step[1]]
        return _Part(program.whole(one.top, step[2]), {f: n * step[2] for f, n in one.below.items()})
    if step[0] not in OPERATIONS:
        return _Part(k, {})
    a, b = parts[step[1]], parts[step[2]]
    if step[0] == "mul":
        return _Part(program.mul(a.top, b.top), _joined(a.below, b.below))
    if step[0] == "div":
        top = program.mul(a.top, _product(program, b.below))
        if not depends[step[2]]:
            return _Part(program.div(top, b.top), a.below)
        return _Part(top, _joined(a.below, _factored(program, b.top)))
    common = {f: max(a.below.get(f, 0), b.below.get(f, 0)) for f in [*a.below, *b.below]}
    tops = [program.mul(one.top, _product(program, _without(common, one.below))) for one in (a, b)]
    return _Part(program.add(*tops) if step[0] == "add" else program.sub(*tops), common)


def _factored(program: Program, k: int) -> Factors:
    step = program.steps[k]
    return {step[1]: step[2]} if step[0] == "pow" else {k: 1}


def _joined(a: Factors, b: Factors) -> Factors:
    return {f: a.get(f, 0) + b.get(f, 0) for f in [*a, *b]}


def _without(a: Factors, b: Factors) -> Factors:
    return {f: n - b.get(f, 0) for f, n in a.items() if n > b.get(f, 0)}


def _product(program: Program, factors: Factors) -> int:
    out = program.number(1)
    for f, n in factors.items():
        out = program.mul(out, program.whole(f, n))
    return out


def _expression(program: Program, part: _Part) -> Expression:
    if not part.below:
        steps, (top,) = reduced(program.steps, [part.top])
        return Expression(steps, top)
    steps, (top, bottom) = reduced(program.steps, [part.top, _product(program, part.below)])
    return Expression(steps, top, bottom)


def factors(steps: Sequence[Step], output: int) -> dict[int, int]:
    """The steps, to whole powers, whose product an output is by its outer steps; constants are left out."""
    return product_of(steps, output)[0]


def product_of(steps: Sequence[Step], output: int) -> tuple[dict[int, int], list[int]]:
    """The factors of an output that depend on z, with their powers, and the constant ones, divisors too."""
    program = Program(list(steps))
    depends, found = dependent(steps), Factors()
    constants: list[int] = []
    stack = [(output, 1)]
    while stack:
        k, power = stack.pop()
        step = steps[k]
        if not depends[k]:
            constants.append(k)
        elif step[0] == "mul":
            stack += [(step[2], power), (step[1], power)]
        elif step[0] == "pow":
            stack.append((step[1], power * step[2]))
        elif step[0] == "sub" and program.rational(step[1]) == 0:
            stack.append((step[2], power))
        elif step[0] == "div" and not depends[step[2]]:
            stack += [(step[2], -power), (step[1], power)]
        else:
            found[k] = found.get(k, 0) + power
    return found, constants


def guards(steps: Sequence[Step]) -> list[int]:
    """The steps that are not analytic everywhere, so that they need a proof of it."""
    depends = dependent(steps)
    return [
        k
        for k, step in enumerate(steps)
        if depends[k] and (step[0] in (*CUT, "atan") or (step[0] == "div" and depends[step[2]]))
    ]
