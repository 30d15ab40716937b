"""M, C, K, B, places and compliances of every vehicle, typed by hand from the equations of motion."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Matrix = list[list[Fraction]]


@dataclass
class Assembly:
    """Bodies with M ÿ + C ẏ + K y = B λ; contacts at `x` (rear to front) with compliances h."""

    M: Matrix
    C: Matrix
    K: Matrix
    B: Matrix
    x: list[Fraction]
    h: list[Fraction]


def zeros(rows: int, columns: int) -> Matrix:
    return [[Fraction(0)] * columns for _ in range(rows)]


def spring(matrix: Matrix, pattern: list[tuple[int, Fraction]], k: Fraction) -> None:
    """Adds k (Σ a y)²/2 to the energy whose second derivative the matrix is."""
    for i, a in pattern:
        for j, b in pattern:
            matrix[i][j] += k * a * b


def mass(a: dict[str, Any]) -> Assembly:
    z = zeros(1, 1)
    return Assembly([[number(a, "M")]], z, zeros(1, 1), [[Fraction(1)]], [Fraction(0)], [contact(a)])


def oscillator(a: dict[str, Any]) -> Assembly:
    M, C, K = zeros(2, 2), zeros(2, 2), zeros(2, 2)
    M[0][0], M[1][1] = number(a, "wheel"), number(a, "body")
    link = [(0, Fraction(1)), (1, Fraction(-1))]
    spring(K, link, number(a, "k"))
    spring(C, link, number(a, "c"))
    return Assembly(M, C, K, [[Fraction(1)], [Fraction(0)]], [Fraction(0)], [contact(a)])


def bogie(a: dict[str, Any]) -> Assembly:
    """y = rear wheel, front wheel, frame's bounce, frame's pitch (nose up), body."""
    n = 5 if "body" in a else 4
    M, C, K, B = zeros(n, n), zeros(n, n), zeros(n, n), zeros(n, 2)
    half = number(a, "wheelbase") / 2
    masses = [number(a, "wheel"), number(a, "wheel"), number(a, "frame"), number(a, "inertia"), number(a, "body")]
    for i in range(n):
        M[i][i] = masses[i]
    for wheel, arm in ((0, -half), (1, half)):
        link = [(wheel, Fraction(-1)), (2, Fraction(1)), (3, arm)]
        spring(K, link, number(a, "k"))
        spring(C, link, number(a, "c"))
        B[wheel][wheel] = Fraction(1)
    if n == 5:
        link = [(2, Fraction(1)), (4, Fraction(-1))]
        spring(K, link, number(a, "k2"))
        spring(C, link, number(a, "c2"))
    return Assembly(M, C, K, B, [-half, half], [contact(a)] * 2)


def coach(a: dict[str, Any]) -> Assembly:
    """Body's bounce and pitch on two bogies whose middles are `pivots` apart."""
    inner = {key: value for key, value in a["bogie"].items() if key not in ("body", "k2", "c2")}
    part, half = bogie(inner), number(a, "pivots") / 2
    M, C, K, B = zeros(10, 10), zeros(10, 10), zeros(10, 10), zeros(10, 4)
    x: list[Fraction] = []
    for side, place in enumerate((-half, half)):
        at = 4 * side
        for i in range(4):
            for target, source in ((M, part.M), (C, part.C), (K, part.K)):
                target[at + i][at : at + 4] = source[i]
            B[at + i][2 * side : 2 * side + 2] = part.B[i]
        link = [(at + 2, Fraction(1)), (8, Fraction(-1)), (9, -place)]
        spring(K, link, number(a, "k2"))
        spring(C, link, number(a, "c2"))
        x += [place + inside for inside in part.x]
    M[8][8], M[9][9] = number(a, "body"), number(a, "inertia")
    order = sorted(range(4), key=lambda j: x[j])
    return Assembly(
        M, C, K, [[row[j] for j in order] for row in B], [x[j] for j in order], [part.h[j // 2] for j in order]
    )


def own(a: dict[str, Any]) -> Assembly:
    M, C, K, B = ([[Fraction(x) for x in row] for row in a[key]] for key in ("M", "C", "K", "B"))
    places = [Fraction(x) for x in a["places"]]
    return Assembly(M, C, K, B, places, [contact(a)] * len(places))


VEHICLES = {"mass": mass, "oscillator": oscillator, "bogie": bogie, "coach": coach, "matrices": own}


def number(a: dict[str, Any], key: str) -> Fraction:
    return Fraction(a.get(key, 0))


def contact(a: dict[str, Any]) -> Fraction:
    return 1 / Fraction(a["k_contact"]) if a.get("k_contact") is not None else Fraction(0)


def together(vehicles: list[dict[str, Any]]) -> Assembly:
    """All vehicles as one; contacts from rear to front."""
    parts = [(VEHICLES[a["model"]](a), Fraction(a.get("at", 0))) for a in vehicles]
    n, c = sum(len(part.M) for part, _ in parts), sum(len(part.x) for part, _ in parts)
    M, C, K, B = zeros(n, n), zeros(n, n), zeros(n, n), zeros(n, c)
    x: list[Fraction] = []
    h: list[Fraction] = []
    row = 0
    for part, position in parts:
        for i in range(len(part.M)):
            for target, source in ((M, part.M), (C, part.C), (K, part.K)):
                target[row + i][row : row + len(part.M)] = source[i]
            B[row + i][len(x) : len(x) + len(part.x)] = part.B[i]
        x += [position + place for place in part.x]
        h += part.h
        row += len(part.M)
    order = sorted(range(c), key=lambda j: x[j])
    return Assembly(M, C, K, [[r[j] for j in order] for r in B], [x[j] for j in order], [h[j] for j in order])
