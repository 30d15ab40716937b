"""The equations of motion of every track from the forces in it, and what is left of them for a single wave.

Each track is written down as a mechanic does: internal forces, balance of momentum, balance of rotation. The wave
e^{i(px + Ωt)} is put in, which gives the matrix A(p, Ω) with A u = e λ.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from types import SimpleNamespace
from typing import Any

import sympy as sp

from mpsolve import tracks
from mpsolve.errors import InputError
from mpsolve.numbers.model import Model, quantities
from mpsolve.tracks.waveguide import Track

Expr = Any
x, t = sp.symbols("x t", real=True)
p, Omega = sp.symbols("p Omega", real=True)
load = sp.Function("f")(x, t)
w, z, y, phi, psi = (sp.Function(name)(x, t) for name in ("w", "z", "y", "phi", "psi"))


@dataclass(frozen=True)
class Derived:
    """Equations of motion (each an expression that equals the load, or 0), the fields, and the matrix A(p, Ω)."""

    fields: tuple[Expr, ...]
    equations: tuple[Expr, ...]
    matrix: Expr

    @property
    def dispersion(self) -> Expr:
        """D = det A."""
        return sp.expand(self.matrix.det(method="berkowitz"))

    @property
    def numerator(self) -> Expr:
        """N, the cofactor of the loaded field, which is the first."""
        return sp.expand(self.matrix.minor(0, 0, method="berkowitz")) if len(self.fields) > 1 else sp.Integer(1)


def symbols_of(model: type[Model]) -> SimpleNamespace:
    """A symbol for each parameter of a model."""
    return SimpleNamespace(**{name: sp.Symbol(name, positive=True) for name in quantities(model)})


@lru_cache
def derived(model: type[Track]) -> Derived:
    """The derivation for a track of the catalogue, with its parameters as symbols."""
    if model not in _MOTIONS:
        stated = f"is {model.name}, whose equations of motion are not written down"
        raise InputError("track", f"{stated}: write them in mpsolve/derivation/tracks.py")
    fields, equations = _MOTIONS[model](symbols_of(model))
    wave = sp.exp(sp.I * (p * x + Omega * t))
    size = range(len(fields))
    amplitudes = sp.symbols(f"U:{len(fields)}")
    waves = {field: amplitude * wave for field, amplitude in zip(fields, amplitudes, strict=True)}
    left = [sp.expand(sp.expand(equation.subs(waves).doit()) / wave) for equation in equations]
    matrix = sp.Matrix(len(fields), len(fields), lambda i, j: sp.expand(left[i].coeff(amplitudes[j])))
    rest = [sp.expand(left[i] - sum(matrix[i, j] * amplitudes[j] for j in size)) for i in size]
    if any(rest):
        raise ArithmeticError(f"{model.__name__}: not all is linear in the fields: {rest}")
    return Derived(fields, equations, matrix)


def _layer(stiffness: Expr, damping: Expr, lengthening: Expr) -> Expr:
    """The force of springs and dampers along the track."""
    return stiffness * lengthening + damping * lengthening.diff(t)


def _bending(EI: Expr, eta: Expr, field: Expr) -> Expr:
    """The bending moment of a Kelvin–Voigt beam, M = −EI (w″ + η ẇ″)."""
    return -EI * (field.diff(x, 2) + eta * field.diff(x, 2, t))


def _beam(a: Any, eta: Expr, axial: Expr, rotary: Expr = 0) -> Expr:
    """What a beam needs beside its support: m ẅ − Q′ + N w″, with the shear force Q from the balance of rotation."""
    Q = _bending(a.EI, eta, w).diff(x) + rotary * w.diff(x, t, t)
    return a.m * w.diff(t, 2) - Q.diff(x) + axial * w.diff(x, 2)


def _string(a: Any) -> Any:
    return (w,), (a.m * w.diff(t, 2) - (a.T * w.diff(x)).diff(x) + _layer(a.k, a.c, w),)


def _euler_bernoulli(a: Any) -> Any:
    return (w,), (_beam(a, a.eta, a.N - a.kp) + _layer(a.k, a.c, w),)


def _rayleigh(a: Any) -> Any:
    return (w,), (_beam(a, a.eta, a.N - a.kp, a.J) + _layer(a.k, a.c, w),)


def _timoshenko(a: Any) -> Any:
    Q = a.S * (w.diff(x) - phi)
    momentum = a.m * w.diff(t, 2) - Q.diff(x) + (a.N - a.kp) * w.diff(x, 2) + _layer(a.k, a.c, w)
    rotation = a.J * phi.diff(t, 2) - (a.EI * phi.diff(x)).diff(x) - Q
    return (w, phi), (momentum, rotation)


def _two_layer(a: Any) -> Any:
    pad, ballast = _layer(a.k_pad, a.c_pad, w - z), _layer(a.k_ballast, a.c_ballast, z)
    return (w, z), (_beam(a, a.eta, a.N - a.kp) + pad, a.m_sleeper * z.diff(t, 2) - pad + ballast)


def _three_layer(a: Any) -> Any:
    pad, ballast = _layer(a.k_pad, a.c_pad, w - z), _layer(a.k_ballast, a.c_ballast, z - y)
    ground = _layer(a.k_ground, a.c_ground, y) - (a.shear * y.diff(x)).diff(x)
    sleeper = a.m_sleeper * z.diff(t, 2) - pad + ballast
    return (w, z, y), (_beam(a, a.eta, a.N) + pad, sleeper, a.m_ballast * y.diff(t, 2) - ballast + ground)


def _slab(a: Any) -> Any:
    pad = _layer(a.k_pad, a.c_pad, w - z)
    slab = a.m_slab * z.diff(t, 2) - _bending(a.EI_slab, 0, z).diff(x, 2) - pad + _layer(a.k, a.c, z)
    return (w, z), (_beam(a, 0, 0) + pad, slab)


def _floating_ice(a: Any) -> Any:
    """Bernoulli under the plate, p = −ρ (g w + ψ̇), and the water that leaves a column, ẇ = −(depth ψ′)′."""
    pressure = -a.rho_water * (a.g * w + psi.diff(t))
    plate = a.rho_ice * a.h * w.diff(t, 2) - _bending(a.B, a.eta, w).diff(x, 2) + a.c * w.diff(t) - pressure
    return (w, psi), (plate, -a.rho_water * (w.diff(t) + (a.depth * psi.diff(x)).diff(x)))


_MOTIONS: dict[type[Track], Callable[[Any], Any]] = {
    tracks.String: _string,
    tracks.EulerBernoulli: _euler_bernoulli,
    tracks.Rayleigh: _rayleigh,
    tracks.Timoshenko: _timoshenko,
    tracks.TwoLayer: _two_layer,
    tracks.ThreeLayer: _three_layer,
    tracks.Slab: _slab,
    tracks.FloatingIce: _floating_ice,
}
