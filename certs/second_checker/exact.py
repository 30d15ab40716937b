"""Exact algebra: polynomials in one and two variables over the rationals, and what decides their signs."""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations, pairwise
from math import comb, lcm

Poly = list[Fraction]
Terms = dict[tuple[int, int], Fraction]


def trimmed(p: Poly) -> Poly:
    while p and not p[-1]:
        p = p[:-1]
    return p


def divide(p: Poly, q: Poly) -> tuple[Poly, Poly]:
    """Quotient and remainder."""
    rest, out = list(p), [Fraction(0)] * max(0, len(p) - len(q) + 1)
    for k in range(len(p) - len(q), -1, -1):
        out[k] = c = rest[k + len(q) - 1] / q[-1]
        for i, x in enumerate(q):
            rest[k + i] -= c * x
    return trimmed(out), trimmed(rest[: len(q) - 1])


def derivative(p: Poly) -> Poly:
    return [k * c for k, c in enumerate(p)][1:]


def gcd(p: Poly, q: Poly) -> Poly:
    while q:
        p, q = q, divide(p, q)[1]
    return [c / p[-1] for c in p]


def value(p: Poly, x: Fraction) -> Fraction:
    out = Fraction(0)
    for c in reversed(p):
        out = out * x + c
    return out


def odd_parts(p: Poly) -> list[Poly]:
    """The squarefree factors of odd multiplicity (Yun)."""
    p = trimmed(p)
    if len(p) < 2:
        return []
    common = gcd(p, derivative(p))
    b, c = divide(p, common)[0], divide(derivative(p), common)[0]
    out, k = [], 1
    while len(b) > 1:
        d = trimmed(
            [
                x - y
                for x, y in zip(
                    c + [Fraction(0)] * len(b), derivative(b) + [Fraction(0)] * (len(c) + 2), strict=False
                )
            ]
        )
        a = gcd(b, d) if d else [x / b[-1] for x in b]
        if k % 2 and len(a) > 1:
            out.append(a)
        b, c, k = divide(b, a)[0], divide(d, a)[0] if d else [], k + 1
    return out


def positive_roots(p: Poly) -> int:
    """How many roots y > 0 a squarefree polynomial has (Sturm)."""
    while p and not p[0]:
        p = p[1:]
    chain = [p, derivative(p)]
    while len(chain[-1]) > 1:
        chain.append([-c for c in divide(chain[-2], chain[-1])[1]])
        if not chain[-1]:
            chain.pop()
            break

    def changes(signs: list[Fraction]) -> int:
        kept = [s for s in signs if s]
        return sum((x > 0) != (y > 0) for x, y in pairwise(kept))

    return changes([q[0] for q in chain if q]) - changes([q[-1] for q in chain if q])


def nonnegative(p: Poly) -> bool:
    """Whether p(y) ≥ 0 for all y ≥ 0 and p is not 0."""
    p = trimmed(p)
    return bool(p) and p[-1] > 0 and not any(positive_roots(a) for a in odd_parts(p))


def positive(p: Poly) -> bool:
    """Whether p(y) > 0 for all y ≥ 0."""
    p = trimmed(p)
    if not p or p[0] <= 0 or p[-1] <= 0:
        return False
    if len(p) == 1:
        return True
    return not positive_roots(divide(p, gcd(p, derivative(p)))[0])


def add(p: Terms, q: Terms, factor: Fraction | int = 1) -> Terms:
    out = dict(p)
    for k, c in q.items():
        out[k] = out.get(k, Fraction(0)) + factor * c
    return {k: c for k, c in out.items() if c}


def multiply(p: Terms, q: Terms) -> Terms:
    out: Terms = {}
    for (i, j), c in p.items():
        for (k, m), d in q.items():
            out[i + k, j + m] = out.get((i + k, j + m), Fraction(0)) + c * d
    return {k: c for k, c in out.items() if c}


def determinant(A: list[list[Terms]]) -> Terms:
    """By the first row."""
    if not A:
        return {(0, 0): Fraction(1)}
    out: Terms = {}
    for j, entry in enumerate(A[0]):
        if entry:
            out = add(out, multiply(entry, determinant([row[:j] + row[j + 1 :] for row in A[1:]])), (-1) ** j)
    return out


def replaced(p: Terms, first: Terms, second: Terms) -> Terms:
    """p with its two variables replaced by polynomials."""
    out: Terms = {}
    powers: dict[tuple[int, int], Terms] = {}

    def power(which: int, n: int) -> Terms:
        if n == 0:
            return {(0, 0): Fraction(1)}
        if (which, n) not in powers:
            powers[which, n] = multiply(power(which, n - 1), (first, second)[which])
        return powers[which, n]

    for (i, j), c in p.items():
        out = add(out, multiply(power(0, i), power(1, j)), c)
    return out


def in_y(p: Terms) -> list[Poly]:
    """Σ a_j(y) s^j of a polynomial that is even in P, at P = ip, y = p²; else ValueError."""
    out: list[Poly] = [[] for _ in range(1 + max((j for _, j in p), default=0))]
    for (i, j), c in p.items():
        if i % 2:
            raise ValueError("not even in P")
        row = out[j]
        row.extend([Fraction(0)] * (i // 2 + 1 - len(row)))
        row[i // 2] += (-1) ** (i // 2) * c
    return [trimmed(row) for row in out]


def product(p: Poly, q: Poly) -> Poly:
    out = [Fraction(0)] * max(0, len(p) + len(q) - 1)
    for i, c in enumerate(p):
        for j, d in enumerate(q):
            out[i + j] += c * d
    return trimmed(out)


def poly_det(A: list[list[Poly]]) -> Poly:
    if not A:
        return [Fraction(1)]
    out: Poly = []
    for j, entry in enumerate(A[0]):
        if entry:
            part = product(entry, poly_det([row[:j] + row[j + 1 :] for row in A[1:]]))
            n = max(len(out), len(part))
            sign = (-1) ** j
            out = trimmed(
                [
                    (out[i] if i < len(out) else Fraction(0)) + (sign * part[i] if i < len(part) else 0)
                    for i in range(n)
                ]
            )
    return out


def hurwitz(a: list[Poly]) -> list[Poly]:
    """The Hurwitz determinants H_1 … H_m of Σ a_j s^j, coefficients polynomials in y."""
    m = len(a) - 1

    def entry(i: int, j: int) -> Poly:  # row i, column j from 1: the coefficient of s^(m − (2j − i))
        k = m - (2 * j - i)
        return a[k] if 0 <= k <= m else []

    return [poly_det([[entry(i, j) for j in range(1, n + 1)] for i in range(1, n + 1)]) for n in range(1, m + 1)]


def semidefinite(A: list[list[Fraction]]) -> bool:
    """Whether a symmetric matrix is positive semidefinite: symmetric elimination."""
    A = [list(row) for row in A]
    n = len(A)
    if any(A[i][j] != A[j][i] for i in range(n) for j in range(n)):
        return False
    for k in range(n):
        if A[k][k] < 0 or (A[k][k] == 0 and any(A[k][k:])):
            return False
        for i in range(k + 1, n):
            if A[k][k]:
                f = A[i][k] / A[k][k]
                A[i] = [x - f * y for x, y in zip(A[i], A[k], strict=True)]
    return True


def rank(A: list[list[Fraction]]) -> int:
    A, r = [list(row) for row in A], 0
    for j in range(len(A[0]) if A else 0):
        pivot = next((i for i in range(r, len(A)) if A[i][j]), None)
        if pivot is None:
            continue
        A[r], A[pivot] = A[pivot], A[r]
        for i in range(r + 1, len(A)):
            f = A[i][j] / A[r][j]
            A[i] = [x - f * y for x, y in zip(A[i], A[r], strict=True)]
        r += 1
    return r


def minors(A: list[list[Poly]]) -> list[Poly]:
    """All principal minors."""
    n = len(A)
    return [poly_det([[A[i][j] for j in c] for i in c]) for k in range(1, n + 1) for c in combinations(range(n), k)]


def positive_on_box(
    p: Terms, box: tuple[Fraction, Fraction, Fraction, Fraction], beyond: Fraction | None = None
) -> bool:
    """Whether p > 0 on [x0, x1] × [y0, y1]: Bernstein coefficients, halving; where xy > beyond nothing is asked."""
    x0, x1, y0, y1 = box
    shifted = replaced(p, {(0, 0): x0, (1, 0): x1 - x0}, {(0, 0): y0, (0, 1): y1 - y0})
    m, n = max((i for i, _ in shifted), default=0), max((j for _, j in shifted), default=0)
    top = lcm(*(c.denominator for c in shifted.values())) if shifted else 1
    grid = [[Fraction(0)] * (n + 1) for _ in range(m + 1)]
    for (i, j), c in shifted.items():
        for k in range(i, m + 1):
            for h in range(j, n + 1):
                grid[k][h] += c * top * Fraction(comb(k, i) * comb(h, j), comb(m, i) * comb(n, j))
    scale = lcm(*(c.denominator for row in grid for c in row))
    todo = [([[int(c * scale) for c in row] for row in grid], Fraction(0), Fraction(0), 0)]
    for _ in range(4000):
        if not todo:
            return True
        B, u, w, depth = todo.pop()
        wide_x, wide_y = Fraction(1, 2 ** ((depth + 1) // 2)), Fraction(1, 2 ** (depth // 2))
        if min(min(row) for row in B) > 0:
            continue
        if beyond is not None and (x0 + u * (x1 - x0)) * (y0 + w * (y1 - y0)) > beyond:
            continue
        if min(B[0][0], B[0][-1], B[-1][0], B[-1][-1]) <= 0 and beyond is None:
            return False
        if depth % 2 == 0:
            left, right = halves([list(c) for c in zip(*B, strict=True)])
            todo.append(([list(c) for c in zip(*left, strict=True)], u, w, depth + 1))
            todo.append(([list(c) for c in zip(*right, strict=True)], u + wide_x / 2, w, depth + 1))
        else:
            left, right = halves(B)
            todo.append((left, u, w, depth + 1))
            todo.append((right, u, w + wide_y / 2, depth + 1))
    return False


def halves(rows: list[list[int]]) -> tuple[list[list[int]], list[list[int]]]:
    """De Casteljau on each row, all times 2^degree."""
    low, high = [], []
    for row in rows:
        n = len(row) - 1
        left, right, now = [], [], list(row)
        for k in range(n + 1):
            left.append(now[0] << n - k)
            right.append(now[-1] << n - k)
            now = [x + y for x, y in pairwise(now)]
        low.append(left)
        high.append(right[::-1])
    return low, high
