"""Terms that the equations of several tracks share, written over any ring."""

from __future__ import annotations

from typing import Any


def rail(x: Any) -> Any:
    """EI (1 + η s) P⁴ + (N − kp) P² + m s²: a beam with Kelvin–Voigt damping, axial force and shear modulus."""
    return x.EI * (1 + x.eta * x.s) * x.P**4 + (x.N - x.kp) * x.P**2 + x.m * x.s**2


def layer(x: Any, stiffness: Any, damping: Any) -> Any:
    """k + c s: springs and dampers side by side."""
    return stiffness + damping * x.s
