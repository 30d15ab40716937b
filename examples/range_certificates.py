"""The certificates under certs/ranges/: answers over ranges of parameters, made anew by this script.

Two masses of 10 t on a rail: where a vibration begins to grow as they run faster, and that none does while the
damping is uncertain. One mass on an elastic foundation: a chart of velocities and damping. And in
the paper's ratios what its Section 4.3 prints: a limiting mass, onsets, and a window of stable velocities between two
unstable ranges.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from mpsolve import Case, Problem, crossings, onset, prove_stable, stability_chart, tracks, unstable_ranges, vehicles
from mpsolve.report.figures import COLOUR, save_figure

FOLDER = Path(__file__).resolve().parent.parent / "certs" / "ranges"
RAIL = tracks.EulerBernoulli(EI="6.4e6", m="60", k="1e6", c="770")
PAIR = Problem(RAIL, [vehicles.Mass("10e3").at(0), vehicles.Mass("10e3").at("3.4")], v="150")

SINGLE = Problem(tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.4"), vehicles.Mass(10), v="1.3")


def equal(eta_m: object, d: str | None, alpha: str = "0.5", eta_b: str = "0.05") -> Case:
    """Two equal masses at the distance d, or one (d None)."""
    masses, places = ((eta_m, eta_m), ("0", d)) if d else ((eta_m,), ("0",))
    return Case(alpha=alpha, eta_b=eta_b, eta_m=masses, positions=places)  # type: ignore[arg-type]


RESULTS: dict[str, Callable[[bool], Any]] = {
    "crossing_over_velocity": lambda check: crossings(PAIR, over={"v": (170, 210)}, check=check),
    "stable_over_damping": lambda check: prove_stable(PAIR, over={"track.c": (600, 900), "v": (0, 100)}, check=check),
    "chart_over_damping": lambda check: stability_chart(
        SINGLE, over={"v": ("1.25", "1.35"), "track.c": ("0.3", "0.5")}, depth=2, check=check
    ),
    # Section 4.3 prints 21.9 for α = 0.99, η_b = 0.1 at the critical distance; it belongs to d = 1.1
    "crossing_masses_d1.1_alpha0.99": lambda check: crossings(
        equal(1, "1.1", "0.99", "0.1"), over={"scale.mass": (1, 1000)}, check=check
    ),
    # Section 4.3: first unstable grid velocities 0.97 and 0.67
    "onset_d1.0_eta70": lambda check: onset(equal(70, "1"), over={"v": (0, 2)}, check=check),
    "onset_d1.5_eta70": lambda check: onset(equal(70, "1.5"), over={"v": (0, 2)}, digits=100, check=check),
    "onset_single_mass_eta70": lambda check: onset(equal(70, None), over={"v": (0, 2)}, check=check),
    # the only crossing next to where the cuts join, with hardly any damping: its boxes lie along a curve
    "nearly_undamped_d1.5": lambda check: crossings(
        equal(70, "1.5", eta_b="0.0001"), over={"alpha": ("1.02", "1.03")}, check=check
    ),
    # a stable window between two unstable ranges
    "windows_d1.5_eta50": lambda check: unstable_ranges(equal(50, "1.5"), over={"v": (0, 1)}, check=check),
}
_LINE = 0.005
VELOCITIES = ("onset_d1.0_eta70", "onset_d1.5_eta70", "onset_single_mass_eta70", "windows_d1.5_eta50")


def prove(name: str, check: bool = True) -> Any:
    """The answer that a file certifies; without `check` no certificate of it is made."""
    return RESULTS[name](check)


def draw(ax: Any, names: Sequence[str] = VELOCITIES) -> Any:
    """A bar for the velocity ratios that each of these results searched, filled where it proves growth; the axes."""
    for k, name in enumerate(names):
        result = prove(name, check=False)
        low, high = map(float, result.over["v"])
        ax.barh(k, high - low, left=low, height=0.5, facecolor=COLOUR.counts[0], edgecolor=COLOUR.ink)
        for start, end in _grows(result, high):
            ax.barh(k, end - start, left=start, height=0.5, color=COLOUR.unstable, gid=name)
    ax.set(xlabel="velocity ratio α that is searched; filled: unstable", ylim=(len(names) - 0.5, -0.5))
    ax.set_yticks(range(len(names)), names)
    return ax


def _grows(result: Any, high: float) -> list[tuple[float, float]]:
    """Where roots grow; of an onset no more than where that begins is told: a line."""
    if hasattr(result, "intervals"):
        return [(float(one.start.mid()), float(one.end.mid())) for one in result.intervals]
    return [(float(result.value.mid()), float(result.value.mid()) + _LINE * high)]


def visualize(path: Path | str = "velocities.svg", names: Sequence[str] = VELOCITIES) -> Path:
    """Proves these results anew, writes their picture and returns its path."""
    return save_figure(lambda ax: draw(ax, names), path, (7.0, 0.6 + 0.6 * len(names)))


if __name__ == "__main__":
    for one in RESULTS:
        print(prove(one).certificate.save(FOLDER / f"{one}.json"))
