"""A soft contact opens a window: a sprung wheel of 1 t under a body of 1 t, by the stiffness of wheel on rail.

Bars: the number of growing roots over the velocity; every boundary and every count between them is proved. Above:
a contact of 1e9 N/m, as of steel on steel; it can hardly be told from a rigid one. Below: 1e7 N/m, a hundredth of it.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

from mpsolve import Problem, certify, crossings, tracks, vehicles
from mpsolve.report.figures import COLOUR, save_figure

PICTURE = Path(__file__).parent / "soft_contact.svg"

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
RANGE = (150, 900)  # m/s
COUNTS: dict[str | None, tuple[int, ...]] = {None: (0, 2), "1e9": (0, 2), "1e7": (0, 2, 0, 2, 0)}
BOUNDARIES: dict[str | None, tuple[str, ...]] = {  # k_contact in N/m, None: rigid; m/s
    None: ("382.743967329",),
    "1e9": ("382.657767901",),
    "1e7": ("331.658157282", "342.210232309", "378.397692348", "592.538234365"),
}


def problem(k_contact: str | None, v: int = 300) -> Problem:
    """The sprung wheel with this contact."""
    wheel = vehicles.Oscillator(wheel=1000, body=1000, k="1e6", c="1e4", k_contact=k_contact)
    return Problem(TRACK, wheel, v=v)


@lru_cache(maxsize=4)
def found(k_contact: str | None) -> Any:
    """All velocities at which a vibration is about to grow or to decay."""
    return crossings(problem(k_contact), over={"v": RANGE})


def check() -> None:
    """The boundaries and the counts between them; a certified spectrum inside each part says the same."""
    for k_contact, counts in COUNTS.items():
        answer = found(k_contact)
        assert answer.proved, str(answer.reason)
        assert answer.counts == counts, str(answer.counts)
        printed = BOUNDARIES[k_contact]
        assert tuple(one.value.str(12, radius=False) for one in answer.crossings) == printed, str(answer)
    for v, count in zip((300, 337, 360, 500, 800), COUNTS["1e7"], strict=True):
        certified = certify(problem("1e7", v), region="unstable", digits=15)
        assert certified.proved, f"v = {v}: {certified.reason}"
        assert certified.unstable == count, f"v = {v}: {certified.unstable}"


def numbers() -> dict[str, Any]:
    """What the text beside this file leaves open."""
    [rigid], [steel], soft = ([float(one.value) for one in found(k).crossings] for k in COUNTS)
    lower = {"little": f"{100 * (1 - steel / rigid):.2f}", "much": f"{100 * (1 - soft[0] / rigid):.0f}"}
    rest = {"rigid": f"{rigid:.2f}", "steel": f"{steel:.2f}", "high": RANGE[1]}
    return {"soft": [f"{v:.1f}" for v in soft]} | lower | rest


def draw(ax: Any) -> Any:
    """The number of growing roots over the velocity for the two contacts; returns the axes."""
    for level, k_contact in ((0, "1e7"), (1, "1e9")):
        answer = found(k_contact)
        ends = [RANGE[0], *(float(one.value) for one in answer.crossings), RANGE[1]]
        for (low, high), count in zip(pairwise(ends), answer.counts, strict=True):
            if count:
                ax.fill_between([low, high], level + 0.1, level + 0.9, color=COLOUR.unstable, linewidth=0)
    ax.set(xlabel="velocity in m/s", xlim=RANGE, ylim=(0, 2), title="unstable velocities by the contact's stiffness")
    ax.set_yticks((0.5, 1.5), ("1e7 N/m", "1e9 N/m"))
    return ax


def visualize(path: Path | str = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""
    return save_figure(draw, path, (4.5, 2.2))


if __name__ == "__main__":
    check()
    print(visualize())
