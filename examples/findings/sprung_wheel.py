"""A stable window above instability: one sprung wheel on a damped Timoshenko rail.

A wheel of 1 t under a body of 10 t, on a 60E1 rail on a soft foundation. Bars: the number of growing roots over the
velocity (two make one vibration); every boundary and every count between them is proved. Dotted: from here on a wave
can run with the wheel. Without the suspension, as bare masses of 1 t or of 11 t, there is no such window.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

from mpsolve import Problem, certify, critical_velocities, crossings, tracks, vehicles
from mpsolve.report.figures import COLOUR, save_figure

PICTURE = Path(__file__).parent / "sprung_wheel.svg"

TRACK = tracks.Timoshenko(EI="6.4e6", m=60, S="2.5e8", J="0.24", k="1e6", c=770)
WHEEL = vehicles.Oscillator(wheel=1000, body=10000, k="1e6", c="1e4")
RANGE = (100, 500)  # m/s
COUNTS = (0, 2, 0, 2)
BOUNDARIES = ("305.310066477536", "319.598826884659", "379.590125946053")  # m/s
BARE = {1000: "367.129179175780", 11000: "309.188444495832"}  # kg: m/s, the one boundary of a bare mass
WAVE = "289.429650328"  # m/s: below it no wave runs with the wheel


@lru_cache(maxsize=4)
def found(vehicle: Any = WHEEL) -> Any:
    """All velocities at which a vibration is about to grow or to decay."""
    return crossings(Problem(TRACK, vehicle, v=300), over={"v": RANGE})


def check() -> None:
    """The boundaries and the counts between them; a certified spectrum inside each part says the same."""
    answer = found()
    assert answer.proved, str(answer.reason)
    assert answer.counts == COUNTS, str(answer.counts)
    assert tuple(one.value.str(15, radius=False) for one in answer.crossings) == BOUNDARIES
    for v, count in zip((300, 312, 350, 400), COUNTS, strict=True):
        certified = certify(Problem(TRACK, WHEEL, v=v), region="unstable", digits=15)
        assert certified.proved, f"v = {v}: {certified.reason}"
        assert certified.unstable == count, f"v = {v}: {certified.unstable}"
    for mass, boundary in BARE.items():
        bare = found(vehicles.Mass(mass))
        assert bare.proved, f"{mass} kg: {bare.reason}"
        assert bare.counts == (0, 2), f"{mass} kg: {bare.counts}"
        assert bare.crossings[0].value.str(15, radius=False) == boundary, f"{mass} kg"
    least = critical_velocities(TRACK).velocities[0].value
    assert least.str(12, radius=False) == WAVE, str(least)


def numbers() -> dict[str, Any]:
    """What the text beside this file leaves open."""
    at = [float(one.value) for one in found().crossings]
    light, heavy = (float(found(vehicles.Mass(mass)).crossings[0].value) for mass in BARE)
    wave = float(critical_velocities(TRACK).velocities[0].value)
    low, high = RANGE
    told = {"light": light, "heavy": heavy, "wave": wave}
    rest = {"at": [f"{v:.2f}" for v in at], "width": f"{at[2] - at[1]:.0f}", "low": low, "high": high}
    return {name: f"{v:.2f}" for name, v in told.items()} | rest


def draw(ax: Any) -> Any:
    """The number of growing roots over the velocity; returns the axes."""
    answer = found()
    ends = [RANGE[0], *(float(one.value) for one in answer.crossings), RANGE[1]]
    for (low, high), count in zip(pairwise(ends), answer.counts, strict=True):
        ax.fill_between([low, high], [count, count], color=COLOUR.unstable, linewidth=0)
    ax.axvline(float(WAVE), color="black", linestyle=":", linewidth=0.9)
    ax.set(xlabel="velocity in m/s", ylabel="growing roots", yticks=(0, 2), xlim=(250, 430), ylim=(0, 2.5))
    return ax


def visualize(path: Path | str = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""
    return save_figure(draw, path, (4.5, 2.2))


if __name__ == "__main__":
    check()
    print(visualize())
