"""A proof beside the page: in a process of its own, with progress, which can be stopped at any time."""

from __future__ import annotations

import multiprocessing
from dataclasses import dataclass, field
from typing import Any

from mpsolve.errors import MpsolveError
from mpsolve.problem.problem import Problem


def prove(connection: Any, problem: Problem, seconds: float) -> None:
    """What the process does: certify, telling its progress; ends with ("done", answer) or ("failed", sentence)."""
    from mpsolve.certificate.certify import certify
    from mpsolve.proof.effort import Effort

    def tell(stage: str, fraction: float) -> None:
        connection.send(("progress", (stage, fraction)))

    try:
        connection.send(("done", certify(problem, digits=15, effort=Effort(seconds=seconds), progress=tell)))
    except MpsolveError as error:
        connection.send(("failed", str(error)))


@dataclass
class Proving:
    """One proof under way. `poll` takes what has arrived; `stop` ends it."""

    problem: Problem
    seconds: float = 60.0
    stage: str = "starting"
    fraction: float = 0.0
    answer: Any = None
    failure: str = ""
    _process: Any = field(default=None, repr=False)
    _pipe: Any = field(default=None, repr=False)

    def start(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._pipe, far = context.Pipe(duplex=False)
        self._process = context.Process(target=prove, args=(far, self.problem, self.seconds), daemon=True)
        self._process.start()
        far.close()

    @property
    def running(self) -> bool:
        return self._process is not None and self.answer is None and not self.failure

    def poll(self) -> None:
        """Take what the process has sent so far."""
        while self.running:
            try:
                if not self._pipe.poll():
                    if self._process.is_alive() or self._pipe.poll():
                        return
                    raise EOFError
                kind, value = self._pipe.recv()
            except (EOFError, OSError):
                self.failure = "the proof ended without an answer: its process was stopped"
                return
            if kind == "progress":
                self.stage, self.fraction = value
            elif kind == "done":
                self.answer = value
            else:
                self.failure = value
        self._close()

    def stop(self) -> None:
        """End the proof, whatever it is at."""
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
