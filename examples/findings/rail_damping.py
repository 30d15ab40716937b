"""Rail damping lifts the onset: two 10 t masses on a 60E1 rail, by the damping time η of the rail's bending.

The rail and masses of examples/rail_60e1.toml. Dots: from this velocity on a vibration grows (proved, each to 15
digits, with everything from 150 m/s to there proved stable). The line only joins them.
"""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any

from mpsolve import Problem, onset, tracks, vehicles
from mpsolve.ranges.onset import Kind
from mpsolve.report.figures import COLOUR, save_figure

PICTURE = Path(__file__).parent / "rail_damping.svg"

ONSETS = {"0": "191.183147740034", "1e-4": "197.878095351170", "1e-3": "227.589808114007"}  # η in s: v in m/s
RANGE = (150, 260)
MASS, GAP = 10000, "3.4"


def problem(eta: str) -> Problem:
    """Two masses on a rail with Kelvin–Voigt damping η, in s."""
    track = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770, eta=eta)
    return Problem(track, [vehicles.Mass(MASS).at(0), vehicles.Mass(MASS).at(GAP)], v=100)


@lru_cache(maxsize=8)
def found(eta: str) -> Any:
    """The onset over the velocity."""
    return onset(problem(eta), over={"v": RANGE})


def check() -> None:
    """Each onset is proved, and is the printed one to all its digits."""
    for eta, printed in ONSETS.items():
        answer = found(eta)
        assert answer.kind is Kind.CROSSES, f"η = {eta}: {answer.kind}, {answer.reason}"
        assert answer.proved, f"η = {eta}: {answer.reason}"
        assert answer.value.str(15, radius=False) == printed, f"η = {eta}: {answer.value}, not {printed}"


def numbers() -> dict[str, Any]:
    """What the text beside this file leaves open."""
    onsets = [float(found(eta).value) for eta in ONSETS]
    return {"onset": [f"{v:.3f}" for v in onsets], "gain": f"{onsets[2] - onsets[0]:.0f}", "low": RANGE[0]}


def draw(ax: Any) -> Any:
    """The onsets over η; returns the axes."""
    eta = [1000 * float(x) for x in ONSETS]
    ax.plot(eta, [float(found(x).value) for x in ONSETS], "o-", color=COLOUR.stable, linewidth=0.8)
    ax.set(xlabel="damping time η of the rail in ms", ylabel="unstable from v in m/s", title="Two 10 t masses")
    return ax


def visualize(path: Path | str = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""
    return save_figure(draw, path, (4.5, 3.0))


if __name__ == "__main__":
    check()
    print(visualize())
