"""D and N of every track, typed by hand as polynomials in p² and X = iΩ with real coefficients.

−mΩ² is mX², icΩ is cX. A polynomial is {(power of p, power of X): Fraction}.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

Poly = dict[tuple[int, int], Fraction]


def plus(*terms: Poly) -> Poly:
    out: Poly = {}
    for term in terms:
        for key, value in term.items():
            out[key] = out.get(key, Fraction(0)) + value
    return {key: value for key, value in out.items() if value}


def times(a: Poly, b: Poly) -> Poly:
    out: Poly = {}
    for (i, j), x in a.items():
        for (k, m), y in b.items():
            out[i + k, j + m] = out.get((i + k, j + m), Fraction(0)) + x * y
    return {key: value for key, value in out.items() if value}


def minus(a: Poly) -> Poly:
    return {key: -value for key, value in a.items()}


ZERO = Fraction(0)


def poly(
    p4: Fraction = ZERO,
    p2: Fraction = ZERO,
    XX: Fraction = ZERO,
    X: Fraction = ZERO,
    one: Fraction = ZERO,
    p4X: Fraction = ZERO,
    p2XX: Fraction = ZERO,
) -> Poly:
    keys = {(4, 0): p4, (2, 0): p2, (0, 2): XX, (0, 1): X, (0, 0): one, (4, 1): p4X, (2, 2): p2XX}
    return {key: value for key, value in keys.items() if value}


class Values(dict[str, Fraction]):
    """Parameters by name; what is left out is 0."""

    def __missing__(self, _key: str) -> Fraction:
        return Fraction(0)


def string(a: Values) -> tuple[Poly, Poly]:
    return poly(p2=a["T"], XX=a["m"], X=a["c"], one=a["k"]), poly(one=Fraction(1))


def euler_bernoulli(a: Values) -> tuple[Poly, Poly]:
    D = poly(p4=a["EI"], p4X=a["EI"] * a["eta"], p2=a["kp"] - a["N"], XX=a["m"], X=a["c"], one=a["k"])
    return D, poly(one=Fraction(1))


def rayleigh(a: Values) -> tuple[Poly, Poly]:
    D, N = euler_bernoulli(a)
    return plus(D, poly(p2XX=a["J"])), N


def timoshenko(a: Values) -> tuple[Poly, Poly]:
    b = poly(p2=a["EI"], XX=a["J"], one=a["S"])
    rail = poly(p2=a["S"] + a["kp"] - a["N"], XX=a["m"], X=a["c"], one=a["k"])
    return plus(times(rail, b), minus(poly(p2=a["S"] ** 2))), b


def two_layer(a: Values) -> tuple[Poly, Poly]:
    pad, ballast = poly(X=a["c_pad"], one=a["k_pad"]), poly(X=a["c_ballast"], one=a["k_ballast"])
    b = plus(poly(XX=a["m_sleeper"]), pad, ballast)
    rail = plus(poly(p4=a["EI"], p4X=a["EI"] * a["eta"], p2=a["kp"] - a["N"], XX=a["m"]), pad)
    return plus(times(rail, b), minus(times(pad, pad))), b


def three_layer(a: Values) -> tuple[Poly, Poly]:
    pad, ballast = poly(X=a["c_pad"], one=a["k_pad"]), poly(X=a["c_ballast"], one=a["k_ballast"])
    ground = poly(X=a["c_ground"], one=a["k_ground"])
    b = plus(poly(XX=a["m_sleeper"]), pad, ballast)
    d = plus(poly(XX=a["m_ballast"], p2=a["shear"]), ballast, ground)
    rail = plus(poly(p4=a["EI"], p4X=a["EI"] * a["eta"], p2=-a["N"], XX=a["m"]), pad)
    N = plus(times(b, d), minus(times(ballast, ballast)))
    return plus(times(rail, N), minus(times(times(pad, pad), d))), N


def slab(a: Values) -> tuple[Poly, Poly]:
    pad = poly(X=a["c_pad"], one=a["k_pad"])
    b = plus(poly(p4=a["EI_slab"], XX=a["m_slab"], X=a["c"], one=a["k"]), pad)
    rail = plus(poly(p4=a["EI"], XX=a["m"]), pad)
    return plus(times(rail, b), minus(times(pad, pad))), b


def floating_ice(a: Values) -> tuple[Poly, Poly]:
    plate = poly(p4=a["B"], p4X=a["B"] * a["eta"], XX=a["rho_ice"] * a["h"], X=a["c"], one=a["rho_water"] * a["g"])
    Hp2 = poly(p2=a["depth"])
    return plus(times(plate, Hp2), poly(XX=a["rho_water"])), Hp2


TRACKS: dict[str, Callable[[Values], tuple[Poly, Poly]]] = {
    "string": string, "euler-bernoulli": euler_bernoulli, "rayleigh": rayleigh, "timoshenko": timoshenko,
    "two-layer": two_layer, "three-layer": three_layer, "slab": slab, "floating-ice": floating_ice,
}  # fmt: skip


def track(data: dict[str, str]) -> tuple[Poly, Poly]:
    """D and N at rest."""
    values = Values({key: Fraction(value) for key, value in data.items() if key != "model"})
    return TRACKS[data["model"]](values)


def binomial(n: int, k: int) -> int:
    out = 1
    for i in range(k):
        out = out * (n - i) // (i + 1)
    return out


def moving(a: Poly, v: Fraction) -> dict[tuple[int, int], Fraction]:
    """Real r with Σ r i^(k+j) p^k q^j the polynomial at Ω = q − vp: powers of p in `a` are even."""
    out: Poly = {}
    for (i, b), value in a.items():
        for r in range(b + 1):
            key = (i + r, b - r)
            sign = -1 if (i // 2) % 2 else 1
            out[key] = out.get(key, Fraction(0)) + sign * value * binomial(b, r) * (-v) ** r
    return {key: value for key, value in out.items() if value}
