"""The velocity up to which no vehicle with one contact can be unstable, over the damping of the track.

The paper's beam. Dots: α_p, below which the beam only takes up energy at a contact, whatever stands on it (proved).
Every passive vehicle with one contact is stable there. The slightest damping gives no room above the critical
velocity, α = 1; critical damping gives a third.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from pathlib import Path
from typing import Any

from mpsolve import passivity_velocity, tracks
from mpsolve.report.figures import COLOUR, save_figure

PICTURE = Path(__file__).parent / "passivity_over_damping.svg"

VELOCITIES = {  # η_b: α_p
    "0.05": "1.0201285771",
    "0.1": "1.0397888599",
    "0.2": "1.0781567374",
    "0.3": "1.1157520657",
    "0.5": "1.1899209703",
}
RANGE = (0, 3)


@lru_cache(maxsize=8)
def found(eta_b: str) -> Any:
    """The passivity velocity of the beam with this damping."""
    track = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=2 * Fraction(eta_b))
    return passivity_velocity(track, over={"v": RANGE})


def check() -> None:
    """Each is proved, and is the printed one to all its digits."""
    for eta_b, printed in VELOCITIES.items():
        answer = found(eta_b)
        assert answer.proved, f"η_b = {eta_b}: {answer.reason}"
        assert answer.value.str(11, radius=False) == printed, f"η_b = {eta_b}: {answer.value}"


def numbers() -> dict[str, Any]:
    """What the text beside this file leaves open."""
    at = [float(found(eta_b).value) for eta_b in VELOCITIES]
    slope = (at[1] - 1) / float(list(VELOCITIES)[1])
    return {"at": [f"{a:.4f}" for a in at], "slope": f"{slope:.1f}"}


def draw(ax: Any) -> Any:
    """α_p over η_b; returns the axes."""
    eta = [float(x) for x in VELOCITIES]
    ax.plot(eta, [float(found(x).value) for x in VELOCITIES], "o-", color=COLOUR.stable, linewidth=0.8)
    ax.axhline(1, color="black", linestyle=":", linewidth=0.9)
    ax.set(xlabel="damping ratio η_b", ylabel="passive up to α_p", xlim=(0, 0.55))
    return ax


def visualize(path: Path | str = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""
    return save_figure(draw, path, (4.5, 3.0))


if __name__ == "__main__":
    check()
    print(visualize())
