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
    """What the receptance is made of, as elements of one arithmetic (+, ×, −, `times`, `inverse`, `exp`, `quotient`).

    a, b: ip and the p-root that it meets; a2, b2: the other upper and the other lower one. lead, N: coefficients of
    D and of the numerator. sigma: iq. places: of the contacts; distances: the different ones between them, with
    their signs.
    """

    a: Any
    b: Any
    a2: Any
    b2: Any
    lead: Any
    N: Any
    sigma: Any
    places: Sequence[Any]
    distances: Sequence[Any]
    signs: Sequence[int]
    one: Any
    zero: Any

    def passing(self, wave: Any) -> list[Any]:
        """What it is at each contact."""
        return [(wave * x).exp() for x in self.places]

    def excited(self, wave: Any) -> list[Any]:
        """What a force at each contact does to its unknown, the sign as in the row that defines it."""
        return [-((wave * x).times(-1).exp()) for x in self.places]


def of_one(parts: Parts) -> list[Any]:
    """What `Bordering` with one wave, μ, takes in the place of receptances."""
    a, b, a2, b2, one = parts.a, parts.b, parts.a2, parts.b2, parts.one
    slope_a = parts.lead * (a + -b) * (a + -a2) * (a + -b2)
    slope_a2 = parts.lead * (a2 + -a) * (a2 + -b) * (a2 + -b2)
    slope_b2 = parts.lead * (b2 + -a) * (b2 + -a2) * (b2 + -b)
    share = (a + -b) * (a + -b2) * ((a2 + -b) * (a2 + -b2)).inverse()
    over_g = slope_a * (parts.N * (one + -share)).inverse()
    ahead, back = parts.N * slope_a2.inverse(), parts.N * slope_b2.inverse()
    meeting = parts.N * (parts.lead * (b + -a2) * (b + -b2)).inverse()

    def receptance(xi: Any, sign: int) -> Any:
        """e^{aξ} H(ξ)."""
        if not sign:
            return parts.zero
        if sign > 0:
            return ((a2 * xi).exp() + -(a * xi).exp()) * ahead
        first = (a * xi).exp() * xi * ((b + -a) * xi).quotient() * meeting
        return -(first + ((b2 * xi).exp() + -(a * xi).exp()) * back)

    G = [receptance(xi, sign) for xi, sign in zip(parts.distances, parts.signs, strict=True)]
    return [*G, *parts.passing(a), *parts.excited(a), over_g]


def of_two(parts: Parts) -> list[Any]:
    """The same with unknowns for a and a′: bounded where b meets a, where b′ meets a′, or both."""
    a, b, a2, b2, lead = parts.a, parts.b, parts.a2, parts.b2, parts.lead
    inverse = parts.N.inverse()
    pairs = []  # of (a, b) and (a′, b′): 1/g, r(a), (r(a) − r(b))/(a − b)
    for (x, y), (x2, y2) in (((a, b), (a2, b2)), ((a2, b2), (a, b))):
        first, second = (lead * (z + -x2) * (z + -y2) * inverse for z in (x, y))
        r = first.inverse()
        bend = ((x + y) * lead * inverse).times(-2) * r * second.inverse()
        pairs.append((x, y, (x + -y) * first, r, bend))

    def receptance(xi: Any, sign: int) -> Any:
        total = parts.zero
        for x, y, _, r, bend in pairs if sign < 0 else ():
            total = total + r * (x * xi).exp() * xi * ((y + -x) * xi).quotient() + bend * (y * xi).exp()
        return -total

    G = [receptance(xi, sign) for xi, sign in zip(parts.distances, parts.signs, strict=True)]
    corners = [pairs[0][2], parts.zero, parts.zero, pairs[1][2]]
    return [*G, *parts.passing(a), *parts.passing(a2), *parts.excited(a), *parts.excited(a2), *corners]
