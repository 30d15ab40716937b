"""The simply supported beam in its modes, (40), made dimensionless, and what the modes that are left out still give.

With the fixed coordinate x = ξ + ατ + const of (10) and contact forces f_j, (13) reads

    w_xxxx + 4N w_xx + 4 w_ττ + 8η_b w_τ + 4w = 4 Σ_j f_j(τ) δ(x − x_j − ατ),   f_j = P_j − η_M,j w0_j,ττ,

with P_j = 2η_C + 2η_A sin(ω̂τ + φ); and w = Σ a_n(τ) sin k_n x, k_n = nπ/L, gives (46)–(53) mode by mode:

    a_n,ττ + 2η_b a_n,τ + ω_n² a_n = (2/L) Σ_j f_j sin k_n(x_j + ατ),   ω_n² = k_n⁴/4 − N k_n² + 1.

Each mode is kept as Re(weight · z) with z_τ = rate · z + its right-hand side.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

_NEAR_CRITICAL = 1e-10
_TAIL_REACH = 40


@dataclass(frozen=True)
class Beam:
    """A simply supported beam of dimensionless `length`, cut after `count` modes, under loads of velocity `alpha`.

    `tail`: whether the contact points keep the flexibility of the modes beyond. All float64.
    """

    length: float
    count: int
    alpha: float
    axial: float
    eta_b: float
    tail: bool = True

    @cached_property
    def exponentials(self) -> tuple[Any, Any, Any]:
        """Wavenumber, rate and weight of every exponential, each (E,): one a mode, two for an overdamped mode.

        An underdamped mode has a = Im z/ν with rate −η_b + iν, ν² = ω² − η_b². A mode within 1e-10 of critical
        damping is moved there, which changes w by some 1e-10 of itself.
        """
        k = np.arange(1, self.count + 1) * (np.pi / self.length)
        nu2 = self.stiffness(k) - self.eta_b**2
        nu2 = np.where(np.abs(nu2) < _NEAR_CRITICAL, _NEAR_CRITICAL, nu2)
        nu, over = np.sqrt(nu2 + 0j), nu2 < 0
        weight = np.where(over, 0.5, 1) / (1j * nu)
        rate = -self.eta_b + 1j * nu
        return (
            np.concatenate([k, k[over]]),
            np.concatenate([rate, (-self.eta_b - 1j * nu)[over]]),
            np.concatenate([weight, -weight[over]]),
        )

    def stiffness(self, k: Any) -> Any:
        """ω² of the wavenumber k; positive for N < 1."""
        return k**4 / 4 - self.axial * k**2 + 1

    @cached_property
    def tail_rate(self) -> complex:
        """The rate of the oscillator that stands for the modes beyond, at every contact.

        Seen from a contact, the modes beyond are stiff: a force e^{iqτ} there meets the flexibility
        (1/L) Σ_{n>count} ½[1/(ω_n² − (q + αk_n)²) + 1/(ω_n² − (q − αk_n)²)] = c₀ + c₁q² + …, damping and the images
        in the supports left out. One oscillator c₀/(1 − q²/ν²) with ν² = c₀/c₁ has the same two terms.
        """
        nu2 = self._tail_sums[2]
        return complex(-self.eta_b, np.sqrt(max(nu2 - self.eta_b**2, 0.01 * nu2)))

    def tail_flexibility(self, distance: Any) -> Any:
        """c₀ between points at these distances, in the shape of `distance`; 0 without the tail."""
        if not self.tail:
            return np.zeros(np.shape(distance))
        k, compliance, _ = self._tail_sums
        sums = [np.cos(gap * k) @ compliance for gap in np.ravel(distance)]
        return np.reshape(sums, np.shape(distance)) / self.length

    @cached_property
    def _tail_sums(self) -> tuple[Any, Any, float]:
        """k and 1/(ω² − α²k²) of the modes beyond, as far as they count, and ν²."""
        k = np.arange(self.count + 1, _TAIL_REACH * self.count + 1) * (np.pi / self.length)
        compliance = 1 / (self.stiffness(k) - (self.alpha * k) ** 2)
        c0, c1 = np.sum(compliance), np.sum(compliance**2 + 4 * (self.alpha * k) ** 2 * compliance**3)
        return k, compliance, float(c0 / c1)
