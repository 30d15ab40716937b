"""One mass far below the critical velocity: a wheel of 5 t on rail, pads, sleepers and ballast.

Bars: the number of growing roots over the velocity (two make one vibration); every boundary and every count between
them is proved. Dotted: the one critical velocity of a constant force on the undamped track. A wheel of 0.5 t becomes
unstable beyond it, as on a track of one layer; one of 5 t does so at 0.37 of it, and is stable again in between.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

from mpsolve import Problem, certify, critical_velocities, crossings, tracks, vehicles
from mpsolve.report.figures import COLOUR, save_figure

PICTURE = Path(__file__).parent / "two_layer_window.svg"

LAYERS = {"EI": "6.4e6", "m": 60, "k_pad": "3e8", "m_sleeper": 250, "k_ballast": "1e8"}
TRACK = tracks.TwoLayer(**LAYERS, c_pad="1e4", c_ballast="1e4")
RANGE = (300, 1700)  # m/s
HEAVY, LIGHT = 5000, 500  # kg
COUNTS = {HEAVY: (0, 2, 0, 2), LIGHT: (0, 2)}
BOUNDARIES = {HEAVY: ("464.679547778", "809.523848107", "1301.20482268"), LIGHT: ("1456.93167379",)}  # m/s
CRITICAL = ("1243.49036286",)  # m/s, without damping: there is one, and the list is complete


@lru_cache(maxsize=4)
def found(mass: int) -> Any:
    """All velocities at which a vibration is about to grow or to decay."""
    return crossings(Problem(TRACK, vehicles.Mass(mass), v=300), over={"v": RANGE}, check=False)


def check() -> None:
    """The boundaries and the counts between them; a certified spectrum inside each part says the same."""
    for mass, counts in COUNTS.items():
        answer = found(mass)
        assert answer.proved, str(answer.reason)
        assert answer.counts == counts, str(answer.counts)
        assert tuple(one.value.str(12, radius=False) for one in answer.crossings) == BOUNDARIES[mass], str(answer)
    for v, count in zip((400, 600, 1000, 1400), COUNTS[HEAVY], strict=True):
        certified = certify(Problem(TRACK, vehicles.Mass(HEAVY), v=v), region="unstable", digits=15)
        assert certified.proved, f"v = {v}: {certified.reason}"
        assert certified.unstable == count, f"v = {v}: {certified.unstable}"
    critical = critical_velocities(tracks.TwoLayer(**LAYERS)).velocities
    assert tuple(one.value.str(12, radius=False) for one in critical) == CRITICAL, str(critical)


def numbers() -> dict[str, Any]:
    """What the text beside this file leaves open."""
    heavy, light = ([float(one.value) for one in found(mass).crossings] for mass in (HEAVY, LIGHT))
    [critical] = critical_velocities(tracks.TwoLayer(**LAYERS)).velocities
    share = heavy[0] / float(critical.value)
    rest = {"critical": f"{float(critical.value):.0f}", "share": f"{share:.2f}", "high": RANGE[1]}
    return {"heavy": [f"{v:.1f}" for v in heavy], "light": [f"{v:.1f}" for v in light]} | rest


def draw(ax: Any) -> Any:
    """The number of growing roots over the velocity; returns the axes."""
    answer = found(HEAVY)
    ends = [RANGE[0], *(float(one.value) for one in answer.crossings), RANGE[1]]
    for (low, high), count in zip(pairwise(ends), answer.counts, strict=True):
        ax.fill_between([low, high], [count, count], color=COLOUR.unstable, linewidth=0)
    ax.axvline(float(CRITICAL[0]), color="black", linestyle=":", linewidth=0.9)
    ax.set(xlabel="velocity in m/s", ylabel="growing roots", yticks=(0, 2), xlim=RANGE, ylim=(0, 2.5))
    return ax


def visualize(path: Path | str = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""
    return save_figure(draw, path, (4.5, 2.2))


if __name__ == "__main__":
    check()
    print(visualize())
