"""First-order models over a disc: a + b·t + e for |t| ≤ r, |e| ≤ rest. Lines of one disc have one r."""

from __future__ import annotations

from balls import ONE, ZERO, Ball, UnclearError, exp, up


class Line:
    """a + b·t + e with |e| ≤ rest on the disc |t| ≤ r."""

    __slots__ = ("a", "b", "r", "rest")

    def __init__(self, a: Ball, b: Ball, rest: float, r: float) -> None:
        self.a, self.b, self.rest, self.r = a, b, rest, r

    def spread(self) -> float:
        """A bound for |value − a|."""
        return up(self.b.upper() * self.r + self.rest)

    def upper(self) -> float:
        """A bound for |value|."""
        return up(self.a.upper() + self.spread())

    def lower(self) -> float:
        """A number that |value| is never below."""
        return max(0.0, self.a.lower() * (1 - 2.0**-45) - self.spread())

    def at(self, t: Ball) -> Ball:
        """A ball for the value at t."""
        return (self.a + self.b * t).wide(self.rest)

    def __add__(self, other: Line) -> Line:
        return Line(self.a + other.a, self.b + other.b, up(self.rest + other.rest), self.r)

    def __sub__(self, other: Line) -> Line:
        return self + -other

    def __neg__(self) -> Line:
        return Line(-self.a, -self.b, self.rest, self.r)

    def times(self, c: Ball) -> Line:
        """c·self for a constant."""
        return Line(self.a * c, self.b * c, up(self.rest * c.upper()), self.r)

    def __mul__(self, other: Line) -> Line:
        r, bent = self.r, self.b.upper() * other.b.upper() * self.r * self.r
        mine, its = self.rest, other.rest
        bent += up(self.a.upper() + self.b.upper() * r) * its + up(other.upper()) * mine
        return Line(self.a * other.a, self.a * other.b + self.b * other.a, up(bent), r)

    def inverse(self) -> Line:
        """1/self: with u = (bt + e)/a, 1/(1 + u) = 1 − u + u²/(1 + u)."""
        one = self.a.inverse()
        low = self.a.lower()
        y = up(self.spread() / low * (1 + 2.0**-40))
        if not y < 0.99:
            raise UnclearError("a divisor varies too much")
        rest = up((self.rest / low + y * y / (1 - y)) / low * (1 + 2.0**-40))
        return Line(one, -(self.b * one * one), rest, self.r)

    def exp(self) -> Line:
        """e^self: |e^u − 1 − u| ≤ y²/2 / (1 − y/3) for |u| ≤ y < 3."""
        y = self.spread()
        if not y < 2:
            raise UnclearError("an exponential varies too much")
        head = exp(self.a)
        return Line(
            head, head * self.b, up(head.upper() * (self.rest + y * y / 2 / (1 - y / 3) * (1 + 2.0**-40))), self.r
        )


def constant(c: Ball, r: float) -> Line:
    """The constant c."""
    return Line(c, ZERO, 0.0, r)


def near_one(matrix: list[list[Line]], r: float) -> float:
    """A bound for |det − 1| over the disc, by elimination in lines, for a matrix near 1."""
    A = [list(row) for row in matrix]
    n, det = len(A), constant(ONE, r)
    for k in range(n):
        det = det * A[k][k]
        over = A[k][k].inverse()
        for i in range(k + 1, n):
            factor = A[i][k] * over
            for j in range(k + 1, n):
                A[i][j] = A[i][j] - factor * A[k][j]
    return (det - constant(ONE, r)).upper()


def determinant(matrix: list[list[Ball]]) -> Ball:
    """The determinant of balls, by elimination with the largest pivot."""
    A = [list(row) for row in matrix]
    n, det = len(A), ONE
    for k in range(n):
        best = max(range(k, n), key=lambda i: A[i][k].lower())
        if best != k:
            A[k], A[best], det = A[best], A[k], -det
        det = det * A[k][k]
        over = A[k][k].inverse()
        for i in range(k + 1, n):
            if not (A[i][k].a or A[i][k].b or A[i][k].r):
                continue
            factor = A[i][k] * over
            for j in range(k + 1, n):
                A[i][j] = A[i][j] - factor * A[k][j]
    return det


def solve(matrix: list[list[Ball]], right: list[list[Ball]]) -> list[list[Ball]]:
    """X with matrix·X = right."""
    n = len(matrix)
    A = [list(row) + list(more) for row, more in zip(matrix, right, strict=True)]
    for k in range(n):
        best = max(range(k, n), key=lambda i: A[i][k].lower())
        A[k], A[best] = A[best], A[k]
        over = A[k][k].inverse()
        A[k] = [x * over for x in A[k]]
        for i in range(n):
            if i != k:
                factor = A[i][k]
                A[i] = [x - factor * y for x, y in zip(A[i], A[k], strict=True)]
    return [row[n:] for row in A]
