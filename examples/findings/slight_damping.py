"""What the slightest damping does to two masses: neutral without any, unstable with a thousandth of the critical.

The paper's beam, η_M = 70, distance 1.5. Without damping every frequency is real at each of the velocities that are
looked at (proved: nothing grows, nothing decays). Bars: with the damping η_b a vibration grows at these α (proved,
with every boundary between 0.3 and 0.99). As η_b falls the bar does not close.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

from flint import arb

from mpsolve import Problem, certify, crossings, tracks, vehicles
from mpsolve.report.figures import COLOUR, save_figure

PICTURE = Path(__file__).parent / "slight_damping.svg"

RANGE = ("0.3", "0.99")  # α
COUNTS = {"0.1": (0, 2), "0.01": (0, 2, 0), "0.001": (0, 2, 0)}  # η_b: growing roots between the boundaries
BOUNDARIES = {
    "0.1": ("0.657625038453",),
    "0.01": ("0.670199031644", "0.898712572478"),
    "0.001": ("0.670338073432", "0.897220227453"),
}
NEUTRAL = ("0.3", "0.6", "0.7", "0.8", "0.9", "0.95", "0.99")  # α, without damping


def problem(eta_b: str, alpha: str) -> Problem:
    """Two masses on the paper's beam."""
    track = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=2 * Fraction(eta_b))
    return Problem(track, [vehicles.Mass(70).at(0), vehicles.Mass(70).at("1.5")], v=alpha)


@lru_cache(maxsize=4)
def found(eta_b: str) -> Any:
    """All velocities at which a vibration is about to grow or to decay."""
    return crossings(problem(eta_b, "0.5"), over={"v": RANGE})


def check() -> None:
    """The boundaries by proof; without damping certified spectra of the whole sheet that are real."""
    for eta_b, counts in COUNTS.items():
        answer = found(eta_b)
        assert answer.proved, f"η_b = {eta_b}: {answer.reason}"
        assert answer.counts == counts, f"η_b = {eta_b}: {answer.counts}"
        assert tuple(one.value.str(12, radius=False) for one in answer.crossings) == BOUNDARIES[eta_b], str(answer)
    for alpha in NEUTRAL:
        spectrum = certify(problem("0", alpha), region="sheet", digits=15)
        assert spectrum.proved, f"α = {alpha}: {spectrum.reason}"
        assert spectrum.unstable == 0, f"α = {alpha}: {spectrum.unstable}"
        assert all(root.q.imag == arb(0) for root in spectrum.roots), f"α = {alpha}: a frequency is not real"
    smallest = certify(problem("0.001", "0.8"), region="unstable", digits=15)
    assert smallest.proved, str(smallest.reason)
    assert smallest.unstable == 2, f"{smallest.unstable}"


def numbers() -> dict[str, Any]:
    """What the text beside this file leaves open."""
    names = ("large", "middle", "small")
    at = {
        name: [f"{float(one.value):.4f}" for one in found(eta_b).crossings]
        for name, eta_b in zip(names, COUNTS, strict=True)
    }
    return at | {"low": RANGE[0], "highest": RANGE[1]}


def draw(ax: Any) -> Any:
    """The unstable velocities for each damping; returns the axes."""
    for level, eta_b in enumerate(COUNTS):
        answer = found(eta_b)
        ends = [float(RANGE[0]), *(float(one.value) for one in answer.crossings), float(RANGE[1])]
        for (low, high), count in zip(pairwise(ends), answer.counts, strict=True):
            if count:
                ax.fill_between([low, high], level + 0.1, level + 0.9, color=COLOUR.unstable, linewidth=0)
    ax.set(xlabel="α", ylabel="η_b", xlim=tuple(map(float, RANGE)), ylim=(0, len(COUNTS)))
    ax.set_yticks([k + 0.5 for k in range(len(COUNTS))], list(COUNTS))
    ax.set_title("Two masses, distance 1.5: unstable velocities")
    return ax


def visualize(path: Path | str = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""
    return save_figure(draw, path, (4.5, 2.4))


if __name__ == "__main__":
    check()
    print(visualize())
