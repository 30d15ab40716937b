"""The functions on which `roots` is measured: as an expression, and in numpy with their slopes for others.

Sources: Kravanja and Van Barel, Computing the Zeros of Analytic Functions (Springer 2000), examples 1.4.1 to 1.5.3;
Dellnitz, Schütze and Zheng 2002 (annular combustion); cxroots #299 (ducted flame); IntervalRootFinding #122;
Kowalczyk, GRPF (lossy waveguide, graphene line, with its constants).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve import Cut, Disc, Rectangle

exp, sin, cos, sqrt, tan = np.exp, np.sin, np.cos, np.emath.sqrt, np.tan


@dataclass(frozen=True)
class Trial:
    """f as a text, its region, numpy's f and f′, and the number of zeros by another way (None: see `note`)."""

    name: str
    text: str
    region: Any
    f: Callable[[Any], Any]
    df: Callable[[Any], Any]
    count: int
    cuts: tuple[Cut, ...] = ()
    note: str = ""


def _product(roots: Any) -> tuple[str, Callable[[Any], Any], Callable[[Any], Any]]:
    """Π (z − root) as a text of exact floats, and in numpy."""
    roots = np.asarray(roots, complex)
    text = "*".join(f"(z - ({z.real!r}) - ({z.imag!r})*i)" for z in roots.tolist())

    def f(z: Any) -> Any:
        return np.prod(np.asarray(z)[..., None] - roots, axis=-1)

    def df(z: Any) -> Any:
        gaps = np.asarray(z)[..., None] - roots
        return sum(np.prod(np.delete(gaps, k, axis=-1), axis=-1) for k in range(len(roots)))

    return text, f, df


def sobol_points() -> Any:
    """The first 100 points of Sobol's sequence in two dimensions after the origin, in [−10, 10]²: exact in floats.

    By Gray code: dimension one from 1/2, 1/4, …; dimension two from the primitive polynomial x + 1.
    """
    bits = 20
    one = [1 << (bits - 1 - k) for k in range(bits)]
    two = [1 << (bits - 1)]
    for _ in range(1, bits):
        two.append(two[-1] ^ (two[-1] >> 1))
    x = y = 0
    points = []
    for k in range(1, 101):
        zeros = (k & -k).bit_length() - 1
        x, y = x ^ one[zeros], y ^ two[zeros]
        points.append(complex(x / 2**bits * 20 - 10, y / 2**bits * 20 - 10))
    return np.array(points)


def _flame() -> tuple[str, Callable[[Any], Any], Callable[[Any], Any]]:
    """Crocco's n-τ model in a duct with a jump of temperature (cxroots #299)."""
    a, b, n, tau = 0.25, 0.75, 10.0, 0.005
    c1, c2 = (float(np.sqrt(1.4 * 287.0 * t)) for t in (300, 1200))
    zeta = (101325 / (287.0 * 300)) * c1 / (101325 / (287.0 * 1200) * c2)
    p, q = a / c1, b / c2
    text = f"{zeta!r}*cos({p!r}*z)*cos({q!r}*z) - (1 + 10*exp(0.005*i*z))*sin({p!r}*z)*sin({q!r}*z)"

    def f(z: Any) -> Any:
        return zeta * cos(p * z) * cos(q * z) - (1 + n * exp(1j * tau * z)) * sin(p * z) * sin(q * z)

    def df(z: Any) -> Any:
        e = exp(1j * tau * z)
        return (
            -zeta * (p * sin(p * z) * cos(q * z) + q * cos(p * z) * sin(q * z))
            - (1 + n * e) * (p * cos(p * z) * sin(q * z) + q * sin(p * z) * cos(q * z))
            - 1j * tau * n * e * sin(p * z) * sin(q * z)
        )

    return text, f, df


def _slope(f: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """By a central difference, for what has no short derivative."""
    return lambda z: (f(z + 1e-5) - f(z - 1e-5)) / 2e-5


def _waveguide() -> tuple[str, Callable[[Any], Any]]:
    """Lossy multilayered waveguide (GRPF, example 2): det [[1, −m11 + iγ_c m12], [iγ_s, −m21 + iγ_c m22]].

    Even in κ = √(n² − z²): written with cos √ and sin √/√, entire functions of κ².
    """
    text = "(-(1)*(i*K*S) + i*sqrt(z**2 - 1)*C) - (i*sqrt(z**2 - (0.065 - 4*i)**2))*(-C + i*sqrt(z**2 - 1)*(i*D*S))"
    d = 2 * np.pi / 0.6328e-6 * 1.81e-6
    square = f"(1.5835**2 - z**2)*{d!r}**2"
    text = (
        text.replace("K*S", f"((1.5835**2 - z**2)*{d!r})*sinc_sqrt({square})")
        .replace("D*S", f"{d!r}*sinc_sqrt({square})")
        .replace("C", f"cos_sqrt({square})")
    )

    def f(z: Any) -> Any:
        z = np.asarray(z, complex)
        k, s, c = np.sqrt(1.5835**2 - z**2), np.sqrt(z**2 - (0.065 - 4j) ** 2), np.sqrt(z**2 - 1)
        m11, m12, m21 = cos(k * d), 1j / k * sin(k * d), 1j * k * sin(k * d)
        return (-m21 + 1j * c * m11) - 1j * s * (-m11 + 1j * c * m12)

    return text, f


def _graphene() -> tuple[str, Callable[[Any], Any]]:
    """Graphene transmission line (GRPF, example 3): the product over its four sheets, even in each admittance.

    Π (Y ± Y₁ ± Y₂) = (Y² − Y₁² − Y₂²)² − 4Y₁²Y₂²; Y₁², Y₂² are rational in z. Divided by the conductivity, times
    the denominators (1 + z²)²(11.9 + z²)².
    """
    frequency, c, muo = 1e12, 299792458, 4 * np.pi * 1e-7
    eps, e, kb, hk, fermi, tau, temperature = (
        1 / (muo * c * c), 1.602176565e-19, 1.3806488e-23, 1.05457168e-34, 1e6, 0.135e-12, 300
    )  # fmt: skip
    w = 2 * np.pi * frequency
    k0 = w / c
    slow = -1j * e * e * kb * temperature * np.log(2 + 2 * np.cosh(0.05 * e / kb / temperature))
    slow = complex(slow / (np.pi * hk * hk * (w - 1j / tau)))
    a = complex(-3 * fermi**2 * slow / (4 * (w - 1j / tau) ** 2)) * 4 / 3 * k0**2 / slow  # on −z²
    u, v = (complex((w * eps * er / k0 / slow) ** 2) for er in (1, 11.9))
    A, U, V = (f"(({x.real!r}) + ({x.imag!r})*i)" for x in (a, u, v))
    y2, one, two = f"(1 - {A}*z**2)**2", "(1 + z**2)", "(11.9 + z**2)"
    text = f"({y2}*{one}*{two} - {U}*{two} - {V}*{one})**2 - 4*{U}*{V}*{one}*{two}"

    def f(z: Any) -> Any:
        z = np.asarray(z, complex)
        p, q = 1 + z**2, 11.9 + z**2
        return ((1 - a * z**2) ** 2 * p * q - u * q - v * p) ** 2 - 4 * u * v * p * q

    return text, f


def trials() -> list[Trial]:
    """All of them."""
    ten, f10, df10 = _product(range(1, 11))
    hundred, f100, df100 = _product(sobol_points())
    flame, f299, df299 = _flame()
    guide, fguide = _waveguide()
    line, fline = _graphene()
    e = "0.01"
    kvb2 = (lambda z: exp(3 * z) + 2 * z * cos(z) - 1, lambda z: 3 * exp(3 * z) + 2 * cos(z) - 2 * z * sin(z))
    kvb3 = (
        lambda z: z**2 * (z - 1) * (z - 2) * (z - 3) * (z - 4) + z * sin(z),
        lambda z: 2 * z * (3 * z**4 - 25 * z**3 + 70 * z**2 - 75 * z + 24) + sin(z) + z * cos(z),
    )
    g4 = (
        lambda z: exp(2 * z) * cos(z) + z**3 - 1 - sin(z),
        lambda z: 2 * exp(2 * z) * cos(z) - exp(2 * z) * sin(z) + 3 * z**2 - cos(z),
    )
    kvb4 = (
        lambda z: (z * (z - 2)) ** 2 * g4[0](z),
        lambda z: 4 * z * (z - 2) * (z - 1) * g4[0](z) + (z * (z - 2)) ** 2 * g4[1](z),
    )
    text2 = "exp(3*z) + 2*z*cos(z) - 1"
    text3 = "z**2*(z - 1)*(z - 2)*(z - 3)*(z - 4) + z*sin(z)"
    text4 = "(z*(z - 2))**2*(exp(2*z)*cos(z) + z**3 - 1 - sin(z))"
    return [
        Trial(
            "KVB 1.4.1",
            f"(z - {e})*(1 + (z - sqrt(3))**2)",
            Disc(0, 3),
            lambda z: (z - 0.01) * (1 + (z - 3**0.5) ** 2),
            lambda z: 1 + (z - 3**0.5) ** 2 + (z - 0.01) * 2 * (z - 3**0.5),
            3,
        ),
        Trial("KVB 1.4.2", text2, Disc(0, 2), *kvb2, 4),
        Trial("KVB 1.4.3", text3, Disc(0, 5), *kvb3, 6),
        Trial("KVB 1.4.4", text4, Disc(0, 3), *kvb4, 8),
        Trial("KVB 1.4.5", ten, Disc(0, 11), f10, df10, 10),
        Trial("KVB 1.5.1", text2, Rectangle(-2, 2, -2, 3), *kvb2, 4),
        Trial("KVB 1.5.2", text3, Rectangle("-0.5", "5.5", "-0.5", "1.5"), *kvb3, 6),
        Trial("KVB 1.5.3", text4, Rectangle(-1, 3, -1, 1), *kvb4, 8),
        Trial("100 Sobol zeros", hundred, Rectangle("-10.01", "10.02", "-10.03", "10.04"), f100, df100, 100),
        Trial(
            "annular combustion",
            "z**2 - 0.19435*z + 1000.41*exp(-0.005*z) + 522463",
            Rectangle(-15000, 5000, -15000, 15000),
            lambda z: z**2 - 0.19435 * z + 1000.41 * exp(-0.005 * z) + 522463,
            lambda z: 2 * z - 0.19435 - 5.00205 * exp(-0.005 * z),
            24,
        ),
        Trial(
            "sin √(z² + 1) − z",
            "sin(sqrt(z - i)*sqrt(z + i)) - z",
            Rectangle(-5, 5, -5, 5),
            lambda z: sin(np.sqrt(z**2 + 1 + 0j)) - z,
            lambda z: cos(np.sqrt(z**2 + 1 + 0j)) * z / np.sqrt(z**2 + 1 + 0j) - 1,
            3,
            (Cut.ray(1j, -1), Cut.ray(-1j, -1)),
            "cuts turned to the left: with the principal ones two of the three zeros lie on their lips",
        ),
        Trial("cxroots #299", flame, Rectangle(0, 5000, -500, 500), f299, df299, 7),
        Trial("lossy waveguide", guide, Rectangle("1.000001", "2.5", -1, 1), fguide, _slope(fguide), 7),
        Trial("graphene line", line, Rectangle(-100, 400, -100, 400), fline, _slope(fline), 12),
    ]
