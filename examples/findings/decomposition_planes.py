"""The planes of the literature, proved: where a mass and a sprung wheel on a Timoshenko beam are unstable.

Dark: two roots grow, one vibration; white: none. The curves are proved through all their points, and so is the number
on each side of them. The cross is the case that each plane goes through. Left: velocity and mass, as in Metrikine and
Dieterman, J. Sound Vib. 201 (1997); middle and right: wheel and stiffness, stiffness and damping of the suspension,
as in Metrikine and Verichev, Arch. Appl. Mech. 71 (2001), who found such curves by D-decomposition.
"""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.colors import ListedColormap

from mpsolve import Problem, certify, crossings, stability_chart, tracks, vehicles
from mpsolve.pictures.proved_chart import drawn, ends
from mpsolve.report.figures import COLOUR, save_figure

PICTURE = Path(__file__).parent / "decomposition_planes.svg"

TRACK = tracks.Timoshenko(EI="6.4e6", m=60, S="2.5e8", J="0.24", k="1e6", c=770)  # a 60E1 rail on a soft foundation
MASS = Problem(TRACK, vehicles.Mass(1000), v=320)
SPRUNG = Problem(TRACK, vehicles.Oscillator(wheel=1000, body=10000, k="1e6", c="5e4"), v=320)
M, K, C = "vehicles[0].wheel", "vehicles[0].k", "vehicles[0].c"
PLANES: dict[str, tuple[Problem, dict[str, Any]]] = {
    "(v, M)": (MASS, {"v": (250, 400), "vehicles[0].M": (100, 5000)}),
    "(M, k)": (SPRUNG, {M: (100, 20000), K: ("1e5", "4e6")}),
    "(k, c)": (SPRUNG, {K: ("1e5", "4e6"), C: ("2e3", "3e5")}),
}
AXES = {
    "v": ("velocity, m/s", 1), "vehicles[0].M": ("mass, t", 1e-3), M: ("wheel, t", 1e-3),
    K: ("stiffness, MN/m", 1e-6), C: ("damping, kN s/m", 1e-3),
}  # fmt: skip
ONSET, STIFF = "367.129179176", "2104630.75056"  # through the case: in m/s, and in N/m
GROWING = ListedColormap(COLOUR.counts[:3])


@lru_cache(maxsize=4)
def found(plane: str) -> Any:
    """The chart."""
    problem, over = PLANES[plane]
    return stability_chart(problem, over=over, depth=4, check=False)


@lru_cache(maxsize=8)
def through(plane: str, path: str) -> Any:
    """All boundaries along one parameter, through the case."""
    problem, over = PLANES[plane]
    return crossings(problem, over={path: over[path]}, check=False)


def check() -> None:
    """Each curve is whole and parts no vibration from one; along each axis it lies where `crossings` says."""
    for plane, (problem, over) in PLANES.items():
        chart = found(plane)
        assert chart.proved, str(chart.reason)
        assert chart.traced, plane
        assert {part.roots for part in chart.parts} == {0, 2}, plane
        own = problem.parameters
        counted = certify(problem, region="unstable", digits=15).unstable
        assert chart.at(*(own[path] for path in over)) == counted, plane
        for path in over:
            answer = through(plane, path)
            assert answer.proved, str(answer.reason)
            places = [float(one.value) for one in answer.crossings]
            assert len(places) == len(seen := along(chart, path, own)), (plane, path)
            assert np.allclose(sorted(seen), places, rtol=2e-3), (plane, path)
    for plane, path, number in (("(v, M)", "v", ONSET), ("(k, c)", K, STIFF)):
        assert [one.value.str(12, radius=False) for one in through(plane, path).crossings] == [number], plane


def along(chart: Any, path: str, own: Any) -> list[float]:
    """Where the curves of a chart meet the line through the case along one of its parameters."""
    first = path == next(iter(chart.over))
    (fixed,) = [other for other in chart.over if other != path]
    out: list[float] = []
    for curve in chart.boundaries:
        line, aside = (curve.x, curve.y) if first else (curve.y, curve.x)
        away = aside - float(own[fixed])
        k = np.flatnonzero(away[:-1] * away[1:] < 0)
        out += (line[k] - away[k] * (line[k + 1] - line[k]) / (away[k + 1] - away[k])).tolist()
    return out


def numbers() -> dict[str, Any]:
    """What the text beside this file leaves open."""

    def told(plane: str, path: str, factor: float, digits: int) -> str:
        places = (factor * float(one.value) for one in through(plane, path).crossings)
        return " and ".join(f"{place:.{digits}f}" for place in places)

    share = {name: f"{100 * found(plane).share:.0f}" for name, plane in zip(("vM", "Mk", "kc"), PLANES, strict=True)}
    return {
        "onset": told("(v, M)", "v", 1, 1), "wheel": told("(M, k)", M, 1e-3, 1), "stiff": told("(k, c)", K, 1e-6, 2),
        "damped": told("(k, c)", C, 1e-3, 1), "share": share,
    }  # fmt: skip


def draw(ax: Any) -> Any:
    """The three planes, each with its case, in place of one pair of axes, which are returned."""
    grid = ax.get_subplotspec().subgridspec(1, len(PLANES))
    figure = ax.figure
    figure.delaxes(ax)
    for place, (plane, (problem, over)) in zip(grid, PLANES.items(), strict=True):
        chart, own, panel = found(plane), problem.parameters, figure.add_subplot(place)
        (x_title, x), (y_title, y) = (AXES[path] for path in over)
        counts = drawn(chart)
        edges = ends(chart.x, counts.shape[0]) * x, ends(chart.y, counts.shape[1]) * y
        panel.pcolormesh(*edges, np.ma.masked_less(counts.T, 0), cmap=GROWING, vmin=0, vmax=2, rasterized=True)
        for curve in chart.boundaries:
            panel.plot(x * curve.x, y * curve.y, color="black", linewidth=1.2)
        place_x, place_y = (float(own[path]) for path in over)
        panel.plot(x * place_x, y * place_y, "k+", markersize=10)
        panel.set(xlabel=x_title, ylabel=y_title, xlim=edges[0][[0, -1]], ylim=edges[1][[0, -1]])
    return ax


def visualize(path: Path | str = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""
    return save_figure(draw, path, (7.5, 2.6))


if __name__ == "__main__":
    check()
    print(visualize())
