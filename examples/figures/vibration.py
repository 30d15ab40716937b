"""The unsteady harmonic part at the rear contact point between its envelopes, as in Figures 3 to 8 and 11."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from style import LIMIT, agree, greys, page

from mpsolve import Case, Load, Spectrum, certify, envelope, response
from mpsolve.problem.cases import as_problem
from mpsolve.vibration.studies import Envelope

TAU: Any = np.linspace(0.0, 400.0, 2001)
DIGITS = 15  # of the certified induced frequencies
W_ST = 0.5  # χ/(2k) of a unit force, in the units of the beam with EI = 1/4, m = k = 1


@dataclass(frozen=True)
class Vibration:
    """w: the unsteady harmonic part (36) at ξ = 0, shape (len(tau),), in w_st, for one unit constant force on each
    mass. q: the certified induced frequency of each pair, in float64, Re q > 0."""

    case: Case
    tau: Any
    w: Any
    envelope: Envelope
    q: tuple[complex, ...]


def pair_of_masses(alpha: str, eta_m: int, d: str, eta_b: str = "0") -> Case:
    """Two equal masses at the distance d (rear one at ξ = 0), η_N = η_S = 0."""
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, d))


def vibration(case: Case, tau: Any = TAU, spectrum: Spectrum | None = None) -> Vibration:
    """From one certificate of all induced frequencies, new unless given; errors as for `response`."""
    spectrum = certify(case, digits=DIGITS) if spectrum is None else spectrum
    loads = [Load(1 / W_ST)] * case.count  # so that deflections come in w_st
    found = response(as_problem(case), loads, times=tau, places=[0], spectrum=spectrum)
    return Vibration(case, tau, found.harmonic[0], envelope(found), tuple(part.q for part in found.induced))


def beat(q: Sequence[complex]) -> float:
    """The time in which two pairs of frequencies come back into phase."""
    return 2 * np.pi / abs(q[1].real - q[0].real)


def checked_vibration(case: Case) -> Vibration:
    """The vibration over TAU, or one whole beat if that is longer, after asserting what holds in every panel.

    The curve is the sum of the residues of `image` at the certified frequencies. The envelope is touched and never
    crossed; without damping its extremes over the whole time are |A₁| ± |A₂|, half a beat apart.
    """
    spectrum = certify(case, digits=DIGITS)
    q = [complex(root.q) for root in spectrum.roots if root.q.real > 0]
    end = max(TAU[-1], beat(q) if len(q) > 1 else 0)
    found = vibration(case, np.linspace(0.0, end, 4001), spectrum)
    agree(found.w, sum((residue(case, z) * np.exp(1j * z * found.tau)).real for z in q), 1e-8)
    touched = np.abs(found.w) / found.envelope.modulus
    assert 0.999 < touched.max() < 1 + 1e-12
    if found.envelope.greatest is not None:
        most, least = np.argmax(found.envelope.modulus), np.argmin(found.envelope.modulus)
        agree(found.envelope.modulus[[most, least]], (found.envelope.greatest, found.envelope.least), 1e-4)
        if len(q) > 1:
            agree(abs(found.tau[most] - found.tau[least]) / beat(q) % 1, 0.5, 0.01)
    return found


def alone(case: Case) -> float:
    """The certified frequency Re q of one of the masses alone, without damping and below the critical velocity."""
    spectrum = certify(replace(case, eta_m=case.eta_m[:1], positions=case.positions[:1]), digits=DIGITS)
    (q,) = (root.q for root in spectrum.roots if root.q.real > 0)
    return float(q.real.mid())


def residue(case: Case, q: complex) -> complex:
    """A of the wave Re(A e^{iqτ}) at ξ = 0 that (36) gives: the mean of `image` round q, taken with its mirror −q̄."""
    turn = 1e-4 * np.exp(2j * np.pi * np.arange(16) / 16)
    return complex(2j * np.mean([image(case, q + step) * step for step in turn]))


def image(case: Case, q: complex) -> complex:
    """The Laplace image of ŵ at the rear mass under unit constant forces, by (18), (37) and (25) as they stand.

    η_N = η_S. No formula of the package is used: the p-roots are those of a polynomial, K a sum over them.
    """
    alpha, eta_b, d = float(case.alpha), float(case.eta_b), float(case.positions[-1])
    D = [1, 0, -4 * alpha**2, 8 * alpha * (q - 1j * eta_b), 4 - 4 * q**2 + 8j * eta_b * q]
    p = np.array(sorted(np.roots(D), key=lambda root: -root.imag))  # two above the real axis, two below
    upper, lower = np.split(2j * np.pi / np.polyval(np.polyder(D), p), 2)
    own, ahead, behind = upper.sum(), upper @ np.exp(1j * p[:2] * d), -lower @ np.exp(-1j * p[2:] * d)
    kernels = np.array([[own, behind], [ahead, own]])
    inertia = 2 * q * q * np.array([float(eta) for eta in case.eta_m])
    return complex(np.linalg.solve(np.pi * np.eye(2) - kernels * inertia, 4 / (1j * q) * kernels.sum(axis=1))[0])


def harmonic_figure(path: Path | str, panels: Sequence[Sequence[Case]], tau: Any = TAU) -> Path:
    """One panel a case, in the rows given; the darker the line, the greater the distance. Returns the path."""
    rows, columns = len(panels), len(panels[0])
    distances = sorted({float(case.positions[-1]) for row in panels for case in row})
    shade = dict(zip(distances, greys(len(distances)), strict=True))
    with page(path, rows, columns, sharex=True, sharey=True) as axes:
        for cases, row in zip(panels, axes, strict=True):
            for case, ax in zip(cases, row, strict=True):
                draw_vibration(vibration(case, tau), ax, shade[float(case.positions[-1])])
        for ax in axes[-1]:
            ax.set_xlabel("$τ$")
        for ax in axes[:, 0]:
            ax.set_ylabel("$\\hat w$ at the rear mass")
        axes[0, 0].invert_yaxis()  # displacements are positive downward
    return Path(path)


def draw_vibration(found: Vibration, ax: Any, shade: str) -> Any:
    """One line and, dotted, ± the modulus of the envelope; returns `ax`."""
    ax.plot(found.tau, found.w, color=shade)
    for sign in (1, -1):
        ax.plot(found.tau, sign * found.envelope.modulus, **LIMIT)
    ax.set_title(f"$\\hat d = {float(found.case.positions[-1]):g}$, $α = {float(found.case.alpha):g}$")
    ax.set_xlim(found.tau[0], found.tau[-1])
    return ax
