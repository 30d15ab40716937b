"""Work beside the page, in a process of its own, with progress, which can be stopped at any time: proofs, reports."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from mpsolve.errors import MpsolveError
from mpsolve.problem.problem import Problem

Tell = Callable[[str, float], None]
Give = Callable[[str, Any], None]
_REGION = 20.0  # s for the region round the point
_HALF = Fraction(1, 2)


def prove(problem: Problem, seconds: float, axes: tuple[str, ...], give: Give, tell: Tell) -> None:
    """Certify, then prove a region of the two parameters `axes` round the problem if it is stable."""
    from mpsolve.certificate.certify import certify
    from mpsolve.proof.effort import Effort
    from mpsolve.ranges.margin import stable_region

    answer = certify(problem, digits=15, effort=Effort(seconds=seconds), progress=tell)
    give("answer", answer)
    if answer.stable and axes:
        tell("region round it", 0.9)
        give("region", stable_region(problem, dict.fromkeys(axes, _HALF), _REGION))


def report(problem: Problem, seconds: float, title: tuple[str, ...], give: Give, tell: Tell) -> None:
    """The page that `mpsolve report` writes, as a text."""
    from mpsolve.page.page import page_html
    from mpsolve.page.parts import gather

    give("answer", page_html(gather(problem, " ".join(title), digits=15, seconds=seconds, tell=tell), "explored"))


def _run(connection: Any, work: Callable[..., None], problem: Problem, seconds: float, more: tuple[str, ...]) -> None:
    def tell(stage: str, fraction: float) -> None:
        connection.send(("progress", (stage, fraction)))

    try:
        work(problem, seconds, more, lambda kind, value: connection.send((kind, value)), tell)
        connection.send(("end", None))
    except MpsolveError as error:
        connection.send(("failed", str(error)))


@dataclass
class Proving:
    """Work under way. `poll` takes what has arrived; `stop` ends it.

    work: `prove` or `report`; more: the paths of the region's two parameters, or the title of the report.
    answer: what is proved, or the page; region: {path: (low, high)} all over which the problem is proved stable.
    """

    problem: Problem
    seconds: float = 60.0
    work: Callable[..., None] = prove
    more: tuple[str, ...] = ()
    stage: str = "starting"
    fraction: float = 0.0
    answer: Any = None
    region: Any = None
    failure: str = ""
    ended: bool = False
    _process: Any = field(default=None, repr=False)
    _pipe: Any = field(default=None, repr=False)

    def start(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._pipe, far = context.Pipe(duplex=False)
        arguments = (far, self.work, self.problem, self.seconds, self.more)
        self._process = context.Process(target=_run, args=arguments, daemon=True)
        self._process.start()
        far.close()

    @property
    def running(self) -> bool:
        return self._process is not None and not self.ended and not self.failure

    def poll(self) -> None:
        """Take what the process has sent so far."""
        while self.running:
            try:
                if not self._pipe.poll():
                    if self._process.is_alive() or self._pipe.poll():
                        return
                    raise EOFError
                self._take(*self._pipe.recv())
            except (EOFError, OSError):
                self.failure = "it ended without an answer: its process was stopped"
                return
        self._close()

    def _take(self, kind: str, value: Any) -> None:
        if kind == "progress":
            self.stage, self.fraction = value
        elif kind == "answer":
            self.answer = value
        elif kind == "region":
            self.region = value
        elif kind == "end":
            self.ended = True
        else:
            self.failure = value

    def stop(self) -> None:
        """End the work, whatever it is at; what has arrived stays."""
        if self.running:
            self.failure = "stopped"
        self._close()

    def _close(self) -> None:
        if self._process is not None:
            if self._process.is_alive():
                self._process.terminate()
            self._process.join(5)
            self._process = None
            self._pipe.close()
