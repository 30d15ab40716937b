"""Every track against the table of dispersion functions, typed in again in p and Ω."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given
from track_models import DAMPED, random_tracks

from mpsolve import tracks
from mpsolve.errors import InputError
from mpsolve.numbers.model import quantities
from mpsolve.tracks.waveguide import Polynomial


class Gaussian:
    """Complex numbers with rational parts, so that the table is compared without rounding."""

    def __init__(self, re: Any, im: Any = 0) -> None:
        self.re, self.im = Fraction(re), Fraction(im)

    def __add__(self, other: Any) -> Gaussian:
        other = other if isinstance(other, Gaussian) else Gaussian(other)
        return Gaussian(self.re + other.re, self.im + other.im)

    def __mul__(self, other: Any) -> Gaussian:
        other = other if isinstance(other, Gaussian) else Gaussian(other)
        return Gaussian(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)

    def __sub__(self, other: Any) -> Gaussian:
        return self + Gaussian(-1) * other

    def __pow__(self, n: int) -> Gaussian:
        return self * self ** (n - 1) if n else Gaussian(1)

    __radd__, __rmul__ = __add__, __mul__

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Gaussian) and (self.re, self.im) == (other.re, other.im)

    def __bool__(self) -> bool:
        return bool(self.re or self.im)


I = Gaussian(0, 1)  # noqa: E741 — the imaginary unit
POINTS = [(Fraction(7, 3), Fraction(11, 5)), (Fraction(-2, 7), Fraction(3)), (Fraction(5), Fraction(-1, 9))]


def value(polynomial: Polynomial, p: Fraction, omega: Fraction) -> Gaussian:
    """At P = ip, s = iΩ."""
    return sum((Gaussian(c) * (I * p) ** i * (I * omega) ** j for (i, j), c in polynomial.items()), Gaussian(0))


def table(name: str, a: Any, p: Fraction, o: Fraction) -> tuple[Any, Any]:
    """(D, N) as the field writes them; the kinds that carry an axial force and a shear modulus have both."""

    def kappa(k: Fraction, c: Fraction) -> Gaussian:
        return k + I * c * o

    def beam() -> Gaussian:
        eta = a.get("eta", Fraction(0))
        rail = a["EI"] * (1 + I * eta * o) * p**4 - a["m"] * o**2
        return rail + (a.get("kp", Fraction(0)) - a.get("N", Fraction(0))) * p**2

    one = Gaussian(1)
    if name == "string":
        return a["T"] * p**2 - a["m"] * o**2 + kappa(a["k"], a["c"]), one
    if name == "euler-bernoulli":
        return beam() + kappa(a["k"], a["c"]), one
    if name == "rayleigh":
        return beam() + kappa(a["k"], a["c"]) - a["J"] * o**2 * p**2, one
    if name == "timoshenko":
        b = a["EI"] * p**2 - a["J"] * o**2 + a["S"]
        axial = (a["kp"] - a["N"]) * p**2
        return (kappa(a["k"], a["c"]) + a["S"] * p**2 - a["m"] * o**2 + axial) * b - a["S"] ** 2 * p**2, one * b
    if name == "two-layer":
        pad = kappa(a["k_pad"], a["c_pad"])
        b = pad + kappa(a["k_ballast"], a["c_ballast"]) - a["m_sleeper"] * o**2
        return (beam() + pad) * b - pad**2, b
    if name == "three-layer":
        pad, ballast = kappa(a["k_pad"], a["c_pad"]), kappa(a["k_ballast"], a["c_ballast"])
        b = pad + ballast - a["m_sleeper"] * o**2
        d = ballast + kappa(a["k_ground"], a["c_ground"]) - a["m_ballast"] * o**2 + a["shear"] * p**2
        return (beam() + pad) * (b * d - ballast**2) - pad**2 * d, b * d - ballast**2
    if name == "slab":
        pad = kappa(a["k_pad"], a["c_pad"])
        b = pad + kappa(a["k"], a["c"]) - a["m_slab"] * o**2 + a["EI_slab"] * p**4
        return (beam() + pad) * b - pad**2, b
    assert name == "floating-ice", f"{name}: write its D and N here"
    plate = a["B"] * (1 + I * a["eta"] * o) * p**4 - a["rho_ice"] * a["h"] * o**2 + a["rho_water"] * a["g"]
    depth = a["rho_water"] * a["depth"] * p**2
    return (plate + I * a["c"] * o) * depth - a["rho_water"] ** 2 * o**2, one * depth


@pytest.mark.parametrize("name", DAMPED)
def test_a_track_is_the_one_of_the_table(name: str) -> None:
    track = DAMPED[name]
    waveguide = track.waveguide
    assert track.name == name
    for p, omega in POINTS:
        D, N = table(name, track.parameters, p, omega)
        assert value(waveguide.dispersion, p, omega) == D
        assert value(waveguide.numerator, p, omega) == N


@given(random_tracks())
def test_any_parameters_give_the_table(track: tracks.Track) -> None:
    p, omega = POINTS[0]
    D, N = table(track.name, track.parameters, p, omega)
    assert value(track.waveguide.dispersion, p, omega) == D
    assert value(track.waveguide.numerator, p, omega) == N


@given(random_tracks())
def test_a_track_looks_the_same_from_both_ends_and_is_real(track: tracks.Track) -> None:
    """D and N are even in P; with real coefficients, D(−p, −Ω) is the conjugate of D(p, Ω)."""
    waveguide = track.waveguide
    for polynomial in (waveguide.dispersion, waveguide.numerator):
        assert polynomial
        assert all(i % 2 == 0 for i, _ in polynomial)
        p, omega = POINTS[1]
        here, there = value(polynomial, p, omega), value(polynomial, -p, -omega)
        assert (here.re, here.im) == (there.re, -there.im)


def test_the_signatures() -> None:
    """Names and order of the arguments are public."""
    expected = {
        tracks.String: "T m k c",
        tracks.EulerBernoulli: "EI m k c kp N eta",
        tracks.Rayleigh: "EI m J k c kp N eta",
        tracks.Timoshenko: "EI m S J k c kp N",
        tracks.TwoLayer: "EI m k_pad c_pad m_sleeper k_ballast c_ballast kp N eta",
        tracks.ThreeLayer: "EI m k_pad c_pad m_sleeper k_ballast c_ballast m_ballast shear k_ground c_ground N eta",
        tracks.Slab: "EI m k_pad c_pad EI_slab m_slab k c",
        tracks.FloatingIce: "B h rho_ice rho_water depth g c eta",
    }
    assert {model: " ".join(quantities(model)) for model in tracks.CATALOGUE} == expected


@pytest.mark.parametrize(
    ("model", "values", "key"),
    [
        (tracks.String, {"T": 0, "m": 1}, "T"),
        (tracks.EulerBernoulli, {"EI": 1, "m": 1, "c": "-1e-30"}, "c"),
        (tracks.Timoshenko, {"EI": 1, "m": 1, "S": 0, "J": 1}, "S"),
        (tracks.Timoshenko, {"EI": 1, "m": 1, "S": 1, "J": "nan"}, "J"),
        (tracks.ThreeLayer, {"EI": 1, "m": 1, "k_pad": 1}, "k_ballast"),
        (tracks.FloatingIce, {"B": 1, "h": 1, "rho_ice": 1, "rho_water": 1, "depth": -1}, "depth"),
        (tracks.Slab, {"EI": 1, "m": "root4(2)", "k_pad": 1}, "m"),
    ],
)
def test_what_no_track_has_is_refused(model: type[tracks.Track], values: dict[str, Any], key: str) -> None:
    with pytest.raises(InputError) as caught:
        model(**values)
    assert caught.value.key == key
