"""What one tab of the explorer holds: the problem and its history, the view, the chosen root, the proof under way."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.batch.view import View, Window, look
from mpsolve.errors import InputError, MpsolveError
from mpsolve.explorer.charting import Chart, ProvedPoint, chart_of
from mpsolve.explorer.history import History, Waiting
from mpsolve.explorer.player import motion_pictures, root_picture
from mpsolve.explorer.proving import Proving, report
from mpsolve.numbers.units import in_unit
from mpsolve.pictures.plane import plane_picture
from mpsolve.problem.left_out import left_out
from mpsolve.problem.outputfile import problem_toml
from mpsolve.problem.problem import Problem

_QUICK = 1.0  # s


@dataclass
class Session:
    """All that a page shows is asked from here; nothing here knows the page."""

    history: History[Problem]
    title: str = ""
    window: Window | None = None
    view: View | None = None
    chosen: int | None = None
    proving: Proving | None = None
    reporting: Proving | None = None
    chart: Chart | None = None
    proved: tuple[ProvedPoint, ...] = ()
    motion: str = ""
    moving: str = ""
    quick: bool = False
    waiting: Waiting = field(default_factory=Waiting)
    _moved_of: Problem | None = field(default=None, repr=False)
    _near: Any = field(default=(), repr=False)
    _moved: tuple[str, float] = ("", 0.0)

    @classmethod
    def of(cls, problem: Problem, title: str = "") -> Session:
        session = cls(History(problem), title)
        session.refresh()
        return session

    @property
    def problem(self) -> Problem:
        return self.history.now

    def parameters(self) -> dict[str, Fraction]:
        """The paths that stand on the page: all but factors and what several vehicles share."""
        own = self.problem.parameters
        return {path: x for path, x in own.items() if not path.startswith(("scale.", "vehicles."))}

    def fields(self) -> dict[str, Fraction | None]:
        """As `parameters`, and with None what is left out, behind the others of the same track or vehicle."""
        own: dict[str, Fraction | None] = {**self.parameters(), **dict.fromkeys(left_out(self.problem))}
        order = list(dict.fromkeys(path.split(".")[0] for path in own))
        return dict(sorted(own.items(), key=lambda item: order.index(item[0].split(".")[0])))

    def axes(self) -> dict[str, str]:
        """The paths that a chart can be over, and what they are called: what is above 0 now."""
        quantity = self.problem.quantity
        return {path: f"{quantity(path).meaning} ({path})" for path, value in self.parameters().items() if value > 0}

    def change(self, path: str, value: object, step: bool = True, quick: bool = False) -> None:
        """Set a parameter, an empty text leaves it out; InputError says why it cannot be.

        step: whether undo comes back to what was before.
        """
        problem = self.waiting.taken(self.problem, path, value)
        if step:
            self.history.change(problem)
        else:
            self.history.replace(problem)
        self.refresh(quick)

    def nudge(self, path: str, value: object) -> None:
        """As `change`, looked at quickly; moves of one parameter that follow each other are one step for undo."""
        now = time.monotonic()
        same = path == self._moved[0] and now < self._moved[1]
        self.change(path, value, step=not same, quick=True)
        done = time.monotonic()
        self._moved = (path, done + max(_QUICK, 3 * (done - now)))  # a slow machine is no reason for more steps

    def open(self, problem: Problem, title: str) -> None:
        """Another problem altogether; undo leads back."""
        self.title, self.window, self.waiting = title, None, Waiting()
        self.history.change(problem)
        self.refresh()

    def undo(self) -> None:
        self.history.undo()
        self.waiting = Waiting()
        self.refresh()

    def redo(self) -> None:
        self.history.redo()
        self.waiting = Waiting()
        self.refresh()

    def zoom(self, factor: float | None) -> None:
        """Show more or less of the plane; None: what fits."""
        self.window = None if factor is None or self.view is None else self.view.window.zoomed(factor)
        self.refresh()

    def settle(self) -> bool:
        """Look thoroughly at what was looked at quickly; whether that was so."""
        if not self.quick:
            return False
        self.refresh()
        return True

    def refresh(self, quick: bool = False) -> View:
        """Compute what is to be seen now."""
        q = self._chosen_root()
        if self.problem != self._moved_of:
            self.motion = self.moving = ""
        self.view, self.quick = look(self.problem, self.window, self._near, quick), quick
        self.window = self.view.window
        self._near = self.view.roots
        self.chosen = self._choice(q)
        return self.view

    def _chosen_root(self) -> complex | None:
        roots = self._near
        return complex(roots[self.chosen]) if self.chosen is not None and self.chosen < len(roots) else None

    def _choice(self, before: complex | None) -> int | None:
        """The root nearest to the one that was chosen, else the one that grows most or decays least."""
        roots = self.view.roots if self.view is not None else np.zeros(0)
        if not len(roots):
            return None
        if before is not None:
            return int(np.argmin(np.abs(roots - before)))
        right = np.where(roots.real >= 0, roots.imag, np.inf)
        return int(np.argmin(right))

    def choose(self, k: int) -> None:
        if self.view is not None and 0 <= k < len(self.view.roots):
            self.chosen = k

    def plane(self) -> str:
        """The picture of the plane."""
        view = self.view
        if view is None:
            return ""
        window = view.window
        return plane_picture(view.roots, view.cuts, window.width, window.depth, window.height, self.chosen)

    def shape(self) -> str:
        """The picture of the chosen vibration, or a sentence why there is none."""
        if self.view is None or self.chosen is None:
            return ""
        q = complex(self.view.roots[self.chosen])
        try:
            return root_picture(self.problem, q)
        except (MpsolveError, ZeroDivisionError):
            return "<p>The shape of this vibration cannot be told in floats.</p>"

    def verdict(self) -> str:
        """What the floats say, in words that promise nothing."""
        if self.view is None:
            return ""
        if self.view.refused:
            return self.view.refused
        grow = self.view.growing
        if not grow:
            return "No growing vibration found in the window (computed, not proved)"
        worst = self.view.roots[int(np.argmin(self.view.roots.imag))]
        return (
            f"{grow} of the roots found grow; the fastest at {abs(worst.real) / (2 * np.pi):.3g} Hz doubles every "
            f"{np.log(2) / -worst.imag:.3g} s (computed, not proved)"
        )

    def draw_motion(self, duration: str) -> None:
        """Draw the motion so long after the vehicle is put on the track; InputError for what is no time above 0."""
        seconds = float(in_unit(duration.strip(), "s", "duration", "time"))
        if not seconds > 0:
            raise InputError("duration", f"is {duration}: give a time above 0")
        self.motion, self.moving = motion_pictures(self.problem, seconds)
        self._moved_of = self.problem

    def draw_chart(self, x: str, y: str) -> None:
        """Count over two parameters round the present problem; InputError says why that cannot be."""
        self.chart = chart_of(self.problem, x, y)

    def chart_axes(self) -> tuple[str, str] | None:
        """The two parameters of the chart, None where there is none of this kind of problem."""
        chart = self.chart
        return (chart.x, chart.y) if chart is not None and {chart.x, chart.y} <= set(self.axes()) else None

    def chart_picture(self) -> str:
        return (
            "" if self.chart is None or self.chart_axes() is None else self.chart.picture(self.problem, self.proved)
        )

    def note_proof(self) -> bool:
        """Keep what a proof has shown so far, once; whether there was something new."""
        proving = self.proving
        if proving is None or proving.answer is None or proving.answer.stable is None:
            return False
        point = ProvedPoint(proving.problem, bool(proving.answer.stable), proving.region)
        if point in self.proved:
            return False
        self.proved = (*(one for one in self.proved if one.problem != point.problem or one.region), point)
        return True

    def toml(self) -> str:
        """The state as an input file."""
        return problem_toml(self.problem, self.title)

    def start_proof(self, axes: tuple[str, ...] = (), seconds: float = 60.0) -> Proving:
        """Prove what is shown, and a region of the parameters `axes` round it; a proof under way is stopped."""
        if self.proving is not None:
            self.proving.stop()
        self.proving = Proving(self.problem, seconds, more=axes if len(set(axes)) == 2 else ())
        self.proving.start()
        return self.proving

    def start_report(self, seconds: float = 30.0) -> Proving:
        """Write the page of what is shown; one under way is stopped."""
        if self.reporting is not None:
            self.reporting.stop()
        self.reporting = Proving(self.problem, seconds, work=report, more=(self.title or "Explored",))
        self.reporting.start()
        return self.reporting

    def stop_proof(self) -> None:
        """End all work that is under way."""
        for one in (self.proving, self.reporting):
            if one is not None:
                one.stop()
