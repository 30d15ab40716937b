"""A train without end, and what it says of others: masses of η_M = 40 on the paper's beam, spacing 1.5, η_b = 0.05.

Left: at α = 0.4 the frequencies q(κ) of the endless row (line) come below the real axis, so disturbances grow along
it; those of 16 masses (dots, certified) do not: they gather on the set where two roots z have one modulus (dashed).
Middle: the velocity from which on N masses grow by themselves falls to a limit far above the one from which on
disturbances grow along the row. Right: how much stronger the force under the last wheel is than under the first.

`python examples/endless_train.py` checks the numbers and writes endless_train.svg beside itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from mpsolve import (
    Amplification,
    Problem,
    Spectrum,
    amplification,
    certify,
    infinite_train,
    tracks,
    train_velocities,
    vehicles,
)
from mpsolve.endless.axis import gains
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.doubling import growing_in_floats
from mpsolve.endless.growing import find_growing
from mpsolve.endless.row import Row, row_of
from mpsolve.report.figures import COLOUR, save_figure

PICTURE = Path(__file__).parent / "endless_train.svg"

TRACK = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")  # the paper's beam: v is α
MASS = vehicles.Mass(40)
SPACING = "1.5"
CALM, DRIFTS = "0.1", "0.4"  # velocities below and above the first threshold
CONVECTIVE = ("0.1901469", "0.190146902")  # proved: nothing grows up to the first, something at the second
LIMIT = 0.44507  # computed: long trains grow by themselves
ONSETS = {2: 0.738, 4: 0.610, 8: 0.551, 16: 0.479, 32: 0.461, 64: 0.4535}
COUNTS = (2, 4, 8, 16, 32)
ENDS = (-0.0007 + 0.305j, -0.0043 + 0.176j)  # near where the set of the long trains ends at α = 0.4
_STEPS, _NEWTON, _TINY = 40, 6, 1e-13


def around(bloch: Bloch, theta: float, sigma: complex, points: int = 400) -> tuple[Any, Any]:
    """(θ, σ) for `points` values of θ from theta over a whole turn, each root from the one before by Newton's method.

    The curve closes where the root comes back to itself; below the cuts of the track it may end, as nan.
    """
    angles = theta + 2 * np.pi * np.arange(points + 1) / points
    out = np.full(points + 1, np.nan, complex)
    here = before = complex(sigma)
    for k, angle in enumerate(angles):
        guess = 2 * here - before if k > 1 else here
        for _ in range(_NEWTON):
            value, slope = bloch.delta(np.array([guess]), np.exp(1j * np.array([angle])))
            guess -= complex(value[0] / slope[0])
        if not np.isfinite(guess):
            break
        before, here = here, guess
        out[k] = guess
    return angles, out


@dataclass(frozen=True)
class Meeting:
    """The two middle roots are both z at σ (scaled): the frequency of the slowest decay, or fastest growth, of long
    trains. Computed."""

    sigma: complex
    z: complex


def meeting(row: Row, near: complex) -> Meeting | None:
    """The place next to σ = near where the middle roots meet; None where Newton's method does not end.

    A train of N vehicles has a root where T^N carries what decays behind of it into what decays ahead of it, T the
    map of one cell with the eigenvalues z_1, …, z_n by modulus. As N → ∞ the n − n₊ largest win, unless
    |z_{n₊}| = |z_{n₊+1}|: so the roots of long trains gather on that set (Schmidt and Spitzer, Widom, Day; the
    absolute spectrum of Sandstede and Scheel), apart from single ones that belong to an end of the train. The set
    ends where the two roots meet: there (z_{n₊} − z_{n₊+1})² is analytic in σ with a simple zero.
    """
    bloch = Bloch(row)

    def square(sigma: complex) -> tuple[complex, complex]:
        a, b = bloch.middle(np.array([sigma]))
        return complex(((a - b) ** 2)[0]), complex(((a + b) / 2)[0])

    before, here = near, near * (1 + 1e-5)
    f0, f1 = square(before)[0], square(here)[0]
    for _ in range(_STEPS):
        if f1 == f0:
            break
        step = f1 * (here - before) / (f1 - f0)
        limit = 0.1 * abs(here)
        step *= min(1.0, limit / abs(step)) if step else 1.0
        before, f0, here = here, f1, here - step
        if here.real < -0.2 * abs(here):
            return None
        f1 = square(here)[0]
        if abs(step) < _TINY * abs(here):
            break
    value, z = square(here)
    return Meeting(here, z) if abs(value) < 1e-8 * abs(z) ** 2 else None


def gathering(row: Row, end: Meeting, angles: Any) -> Any:
    """σ on the set on which roots of long trains gather, from its end on: where z_{n₊+1}/z_{n₊} = e^{iφ}.

    angles: φ ascending from near 0, in steps small enough to follow the curve. Roots of a train of N vehicles lie
    near those of φ = 2πj/N.
    """
    bloch, out = Bloch(row), []

    def miss(sigma: complex, wanted: float) -> complex:
        a, b = bloch.middle(np.array([sigma]))
        return complex((a / b + b / a)[0]) - wanted  # analytic at the end too

    before, here = end.sigma, end.sigma * (1 + 1e-6)
    for angle in np.asarray(angles, float):
        wanted = 2 * float(np.cos(angle))
        x, y = 2 * here - before, here  # along the curve, from the last point
        before = here
        f, g = miss(x, wanted), miss(y, wanted)
        for _ in range(_STEPS):
            if f == g or abs(x - y) < _TINY * abs(x):
                break
            step = f * (x - y) / (f - g)
            step *= min(1.0, 0.02 * abs(x) / abs(step)) if step else 1.0
            y, g, x = x, f, x - step
            f = miss(x, wanted)
        here = x
        out.append(here)
    return np.array(out)


def row(v: str) -> Row:
    """The endless row at this velocity."""
    return row_of(Problem(TRACK, MASS, v=v), SPACING)


def spectrum(count: int, v: str) -> Spectrum:
    """The certified frequencies of a finite train."""
    return certify(row(v).train(count), region=("below", "0.01"), digits=15, check=False)


def ratios(v: str) -> list[Amplification]:
    """The enclosed amplification of each of the trains."""
    return [amplification(row(v).train(count), band=(0, 1)) for count in COUNTS]


def check() -> None:
    """The thresholds by proof, the onsets by certified counts, the growth per wheel by enclosed ratios."""
    both = train_velocities(Problem(TRACK, MASS, v=CALM), SPACING, (0, "0.6"))
    assert both.proved
    assert both.stable_to is not None
    assert both.stable_to >= Fraction(CONVECTIVE[0])
    assert both.grows is not None
    assert both.grows.problem.v <= Fraction(CONVECTIVE[1])
    assert not both.grows.long_trains
    assert both.limit is not None
    assert abs(both.limit - LIMIT) < 1e-5
    for count, onset in ONSETS.items():
        around_it = [f"{onset + step:.4f}" for step in (-0.001, 0.001)]
        if count > 16:
            found = [growing_in_floats(Bloch(row(v)), count, 1.0, 0.5) for v in around_it]
        else:
            found = [certify(row(v).train(count), region="unstable", check=False).unstable for v in around_it]
        assert found[0] == 0, (count, found)
        assert found[1], (count, found)
    excess = [onset - LIMIT for onset in ONSETS.values()]
    assert all(1.2 < a / b < 5 for a, b in pairwise(excess))  # the onsets fall to the limit
    ends = [infinite_train(Problem(TRACK, MASS, v=f"{LIMIT + step:.4f}"), SPACING) for step in (-0.0002, 0.0002)]
    assert [one.long_trains for one in ends] == [False, True]
    drifting, calm_ones = ratios(DRIFTS), ratios(CALM)
    assert all(one.proved for one in (*drifting, *calm_ones))
    back = [one.back.low for one in drifting if one.back is not None]
    assert [round(x, 2) for x in back] == [10.01, 12.07, 8.66, 7.07, 10.88]
    assert [round(one.back.low, 2) for one in calm_ones if one.back is not None] == [14.13, 11.14, 6.3, 3.67, 2.07]
    per_wheel = (back[-1] / back[-2]) ** (1 / (COUNTS[-1] - COUNTS[-2]))
    assert 1 < per_wheel < gains(Bloch(row(DRIFTS)), 1.0)[1].factor < 1.053


def _plane(ax: Any) -> None:
    """The q-plane at α = 0.4."""
    here = row(DRIFTS)
    seed = find_growing(here, 1.0)
    assert seed is not None
    _, sigma = around(Bloch(here), seed.theta, 1j * complex(seed.q))
    q = -1j * sigma
    ax.plot(q.real, q.imag, color=COLOUR.unstable, linewidth=1.2, label="endless row, all κ")
    angles = np.linspace(0.02, 0.995 * np.pi, 160)
    for k, near in enumerate(ENDS):
        end = meeting(here, near)
        assert end is not None
        set_ = -1j * gathering(here, end, angles)
        ax.plot(set_.real, set_.imag, "--", color=COLOUR.ink, linewidth=0.8, label=None if k else "|z₂| = |z₃|")
    dots = np.array([complex(root.q) for root in spectrum(16, DRIFTS).roots])
    dots = dots[dots.real > 0]
    ax.plot(dots.real, dots.imag, "o", color=COLOUR.ink, markersize=3, label="16 masses, certified")
    ax.axhline(0, color="gray", linewidth=0.6)
    ax.set(xlabel="Re q", ylabel="Im q (below 0: grows)", title="α = 0.4")
    ax.legend(frameon=False, fontsize=7, loc="upper right")


def _onsets(ax: Any) -> None:
    ax.semilogx(list(ONSETS), list(ONSETS.values()), "o", color=COLOUR.ink, markersize=4, base=2)
    ax.axhline(LIMIT, color=COLOUR.ink, linestyle="--", linewidth=0.8)
    ax.axhline(float(CONVECTIVE[1]), color=COLOUR.unstable, linewidth=1.2)
    ax.text(64, LIMIT - 0.015, "limit of long trains", ha="right", va="top", fontsize=7)
    ax.text(64, float(CONVECTIVE[1]) - 0.015, "disturbances grow along the row", ha="right", va="top", fontsize=7)
    ax.set(xlabel="number of masses", ylabel="velocity ratio α of the onset", ylim=(0, 0.8))
    ax.set_xticks(list(ONSETS), [str(n) for n in ONSETS])


def _amplification(ax: Any) -> None:
    for v, colour in ((CALM, "gray"), (DRIFTS, COLOUR.unstable)):
        peaks = ratios(v)
        back = [one.back.low for one in peaks if one.back is not None]
        ahead = [one.ahead.low for one in peaks if one.ahead is not None]
        ax.semilogy(COUNTS, back, "o-", color=colour, markersize=4, linewidth=0.8, label=f"α = {v}: to the rear")
        ax.semilogy(COUNTS, ahead, "s:", color=colour, markersize=3, linewidth=0.8, label=f"α = {v}: to the front")
        factor = gains(Bloch(row(v)), 1.0)[1].factor
        n = np.array([16, 40])
        ax.semilogy(n, back[-1] * factor ** (n - COUNTS[-1]), color=colour, linewidth=0.6)
    ax.set(xlabel="number of masses", ylabel="largest |λ_last / λ_first|, enclosed")
    ax.legend(frameon=False, fontsize=7)


def draw(axes: Any) -> Any:
    """The three panels on three axes; returns them."""
    for ax, panel in zip(axes, (_plane, _onsets, _amplification), strict=True):
        panel(ax)
    return axes


def visualize(path: Path | str = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""

    def whole(ax: Any) -> Any:
        figure = ax.figure
        ax.remove()
        return draw(figure.subplots(1, 3))

    return save_figure(whole, path, (11.5, 3.6))


if __name__ == "__main__":
    check()
    print(visualize())
