"""How far down instability comes: one mass, rows of masses, one bogie and two.

Dots: the proved onset of rows of equal masses on the paper's beam (η_M = 40, η_b = 0.05, spacing 1.5), as a part of
the critical velocity. Dashed: the velocity from which on disturbances grow along the endless row of the same masses
(examples/endless_train.py).
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from pathlib import Path
from typing import Any

from mpsolve import Problem, critical_velocities, infinite_train, onset, tracks, vehicles
from mpsolve.ranges.onset import Kind
from mpsolve.report.figures import COLOUR, save_figure

PICTURE = Path(__file__).parent / "rows_of_masses.svg"

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")  # v is α
SPACING = Fraction("1.5")
ROWS = {1: "1.10247286154", 2: "0.737876937093", 4: "0.610025982443", 8: "0.551223830014"}
ENDLESS = ("0.190", "0.1903")  # calm at the first, growing along the row at the second

RAIL = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
BOGIE = vehicles.Bogie(
    wheel=1500, frame=3000, inertia=155, wheelbase="2.5", k="4.8e6", c=250, body=12500, k2="2.708e6", c2="64e3"
)
BOGIES = {1: "334.590807373", 2: "299.359007483"}  # 15 m apart: m/s
ASKED = (150, 400)
CRITICAL = "290.391811646"  # m/s, of the rail without damping


@lru_cache(maxsize=8)
def row(count: int) -> Any:
    """The onset of a row of masses."""
    masses = [vehicles.Mass(40).at(k * SPACING) for k in range(count)]
    return onset(Problem(BEAM, masses, v="0.3"), over={"v": ("0.3", "1.2")}, check=False)


@lru_cache(maxsize=2)
def bogies(count: int) -> Any:
    """The onset of bogies 15 m apart on the rail."""
    return onset(Problem(RAIL, [BOGIE.at(15 * k) for k in range(count)], v=100), over={"v": ASKED}, check=False)


def check() -> None:
    """Every onset is proved, and is the printed one; the endless row is calm and not calm, by proof."""
    for find, printed in ((row, ROWS), (bogies, BOGIES)):
        for count, value in printed.items():
            answer = find(count)
            assert answer.kind is Kind.CROSSES, f"{count}: {answer.kind}, {answer.reason}"
            assert answer.value.str(12, radius=False) == value, f"{count}: {answer.value}"
    calm, grows = (infinite_train(Problem(BEAM, vehicles.Mass(40), v=v), SPACING) for v in ENDLESS)
    assert (calm.stable, grows.stable) == (True, False)
    [critical] = critical_velocities(RAIL).velocities
    assert critical.value.str(12, radius=False) == CRITICAL, str(critical.value)


def numbers() -> dict[str, Any]:
    """What the text beside this file leaves open."""
    [critical] = critical_velocities(RAIL).velocities
    return {
        "row": {n: f"{float(row(n).value):.4f}" for n in ROWS},
        "bogies": {n: f"{float(bogies(n).value):.1f}" for n in BOGIES},
        "endless": ENDLESS,
        "critical": f"{float(critical.value):.1f}",
        "low": ASKED[0],
        "high": ASKED[1],
    }


def draw(ax: Any) -> Any:
    """The onsets over the number of masses; returns the axes."""
    ax.semilogx(list(ROWS), [float(row(n).value) for n in ROWS], "o-", color=COLOUR.stable, linewidth=0.8)
    ax.axhline(float(ENDLESS[1]), color="black", linestyle="--", linewidth=0.9)
    ax.set(xlabel="masses in the row", ylabel="unstable from α on", ylim=(0, 1.2))
    ax.set_xticks(list(ROWS), [str(n) for n in ROWS])
    ax.minorticks_off()
    return ax


def visualize(path: Path | str = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""
    return save_figure(draw, path, (4.5, 3.0))


if __name__ == "__main__":
    check()
    print(visualize())
