"""Certificates under certs/ for whole ranges: crossing masses, onsets, windows.

`python examples/crossings.py` proves each anew. Sections are the paper's.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from mpsolve import crossing_masses
from mpsolve.report.figures import COLOUR, save_figure
from mpsolve.stability.velocities import onset_velocity, unstable_velocities

FOLDER = Path(__file__).resolve().parent.parent / "certs"

RESULTS: dict[str, Callable[[], object]] = {
    # Section 4.3 prints 21.9 for α = 0.99, η_b = 0.1 at the critical distance; it belongs to d = 1.1
    "crossing_masses_d1.1_alpha0.99": lambda: crossing_masses("0.99", "0.1", (0, "1.1")),
    # Section 4.3: first unstable grid velocities 0.97 and 0.67
    "onset_d1.0_eta70": lambda: onset_velocity("0.05", (70, 70), (0, "1")),
    "onset_d1.5_eta70": lambda: onset_velocity("0.05", (70, 70), (0, "1.5"), digits=100),
    "onset_single_mass_eta70": lambda: onset_velocity("0.05", 70),
    # a stable window between two unstable ranges
    "windows_d1.5_eta50": lambda: unstable_velocities("0.05", (50, 50), (0, "1.5"), alpha=(0, 1)),
}


VELOCITIES = ("onset_d1.0_eta70", "onset_d1.5_eta70", "onset_single_mass_eta70", "windows_d1.5_eta50")


def draw(ax: Any, names: Sequence[str] = VELOCITIES) -> Any:
    """A bar for the velocity ratios that each of these results searched, filled where it proves growth; the axes."""
    for k, name in enumerate(names):
        result: Any = RESULTS[name]()
        ranges = getattr(result, "ranges", result)  # an onset is the first end of ranges
        low, high = float(ranges.start), float(ranges.end)
        ax.barh(k, high - low, left=low, height=0.5, facecolor=COLOUR.counts[0], edgecolor=COLOUR.ink)
        for one in ranges:
            start, end = float(one.start), float(one.end)
            ax.barh(k, end - start, left=start, height=0.5, color=COLOUR.unstable, gid=name)
    ax.set(xlabel="velocity ratio α that is searched; filled: unstable", ylim=(len(names) - 0.5, -0.5))
    ax.set_yticks(range(len(names)), names)
    return ax


def visualize(path: Path | str = "velocities.svg", names: Sequence[str] = VELOCITIES) -> Path:
    """Proves these results anew, writes their picture and returns its path."""
    return save_figure(lambda ax: draw(ax, names), path, (7.0, 0.6 + 0.6 * len(names)))


def main() -> None:
    """Writes every certificate."""
    for name, prove in RESULTS.items():
        result = prove()
        certificate = result.certificate  # type: ignore[attr-defined]
        if certificate is None:
            raise SystemExit(f"{name}: {result.reason}")  # type: ignore[attr-defined]
        certificate.save(FOLDER / f"{name}.json")
        print(name)


if __name__ == "__main__":
    main()
