"""The characteristic matrix at a point of the cut's edge, over any arithmetic: no pole where the cut begins.

z = q − iη is real there, and p is a real p-root. U holds a = ip and a′, L holds b and b′; b meets a where the cut
begins. With P₀ = a the receptance is G(ξ) = e^{aξ}(g + H(ξ)), where g = G(0) alone is large there (SPEC2, 8.4): one
more unknown μ = g Σ e^{−a x_j} λ_j, whose row is divided by g, leaves a matrix of determinant Δ̂/g: bounded.

Where cuts overlap b′ meets a′, too, where the other one begins. With r(P) = N/lead/((P − a′)(P − b′)) the residues at
a and b are g_a = r(a)/(a − b) and −r(b)/(a − b), so that for ξ < 0 their share of G, less e^{aξ} g_a, is
−(r(a) (e^{aξ} − e^{bξ}) + (r(a) − r(b)) e^{bξ})/(a − b), r(a) − r(b) = −2 (a − b)(a + b) r(a) r(b) lead/N, as
a + b + a′ + b′ = 0; those at a′ and b′ likewise, and for ξ ≥ 0 nothing is left. An unknown for a and one for a′, with
rows divided by g_a and g_a′, leave a matrix of determinant Δ̂/(g_a g_a′), bounded where either pair meets.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Parts:
    """What the matrix is made of, as elements of one arithmetic (+, ×, −, `times`, `inverse`, `exp`, `quotient`).

    a, b: ip and the p-root that it meets; a2, b2: the other upper and the other lower one. lead, N: coefficients of
    D and of the numerator. sigma: iq. S, B, h: those of the vehicle, S[k][i][j] that of σᵏ. places: of the contacts.
    """

    a: Any
    b: Any
    a2: Any
    b2: Any
    lead: Any
    N: Any
    sigma: Any
    S: Any
    B: Any
    h: Any
    places: Sequence[Any]
    one: Any
    zero: Any


def entries(parts: Parts, order: Sequence[Sequence[int]]) -> list[list[Any]]:
    """The matrix: rows of bodies, contacts, and μ. order[i][j]: the sign of x_i − x_j."""
    a, b, a2, b2, one = parts.a, parts.b, parts.a2, parts.b2, parts.one
    slope_a = parts.lead * (a + -b) * (a + -a2) * (a + -b2)
    slope_a2 = parts.lead * (a2 + -a) * (a2 + -b) * (a2 + -b2)
    slope_b2 = parts.lead * (b2 + -a) * (b2 + -a2) * (b2 + -b)
    share = (a + -b) * (a + -b2) * ((a2 + -b) * (a2 + -b2)).inverse()
    over_g = slope_a * (parts.N * (one + -share)).inverse()
    ahead, back = parts.N * slope_a2.inverse(), parts.N * slope_b2.inverse()
    meeting = parts.N * (parts.lead * (b + -a2) * (b + -b2)).inverse()

    def receptance(i: int, j: int) -> Any:
        """e^{aξ} H(ξ)."""
        if not order[i][j]:
            return parts.zero
        xi = parts.places[i] + -parts.places[j]
        if order[i][j] > 0:
            return ((a2 * xi).exp() + -(a * xi).exp()) * ahead
        first = (a * xi).exp() * xi * ((b + -a) * xi).quotient() * meeting
        return -(first + ((b2 * xi).exp() + -(a * xi).exp()) * back)

    bodies, contacts = range(len(parts.B)), range(len(parts.places))
    rows = []
    for i in bodies:
        rows.append([*_pencil(parts, i), *(-parts.B[i][j] for j in contacts), parts.zero])
    for i in contacts:
        own = [receptance(i, j) + parts.h[i] if i == j else receptance(i, j) for j in contacts]
        rows.append([*(parts.B[j][i] for j in bodies), *own, (a * parts.places[i]).exp()])
    waves = [-((a * x).times(-1).exp()) for x in parts.places]
    return [*rows, [*(parts.zero for _ in bodies), *waves, over_g]]


def entries_of_two(parts: Parts, order: Sequence[Sequence[int]]) -> list[list[Any]]:
    """The matrix with an unknown for a and one for a′: bounded where b meets a, where b′ meets a′, or both."""
    a, b, a2, b2, lead, places = parts.a, parts.b, parts.a2, parts.b2, parts.lead, parts.places
    inverse = parts.N.inverse()
    pairs = []  # of (a, b) and (a′, b′): 1/g, r(a), (r(a) − r(b))/(a − b)
    for (x, y), (x2, y2) in (((a, b), (a2, b2)), ((a2, b2), (a, b))):
        first, second = (lead * (z + -x2) * (z + -y2) * inverse for z in (x, y))
        r = first.inverse()
        bend = ((x + y) * lead * inverse).times(-2) * r * second.inverse()
        pairs.append((x, y, (x + -y) * first, r, bend))

    def receptance(i: int, j: int) -> Any:
        if order[i][j] >= 0:
            return parts.zero
        xi = places[i] + -places[j]
        total = parts.zero
        for x, y, _, r, bend in pairs:
            total = total + r * (x * xi).exp() * xi * ((y + -x) * xi).quotient() + bend * (y * xi).exp()
        return -total

    bodies, contacts = range(len(parts.B)), range(len(places))
    rows = []
    for i in bodies:
        rows.append([*_pencil(parts, i), *(-parts.B[i][j] for j in contacts), parts.zero, parts.zero])
    for i in contacts:
        own = [receptance(i, j) + parts.h[i] if i == j else receptance(i, j) for j in contacts]
        rows.append([*(parts.B[j][i] for j in bodies), *own, *((x * places[i]).exp() for x, *_ in pairs)])
    for k, (x, _, over_g, *_) in enumerate(pairs):
        waves = [-((x * place).times(-1).exp()) for place in places]
        ends = (over_g, parts.zero) if k == 0 else (parts.zero, over_g)
        rows.append([*(parts.zero for _ in bodies), *waves, *ends])
    return rows


def _pencil(parts: Parts, i: int) -> list[Any]:
    S, sigma = parts.S, parts.sigma
    return [S[0][i][j] + sigma * (S[1][i][j] + sigma * S[2][i][j]) for j in range(len(parts.B))]
