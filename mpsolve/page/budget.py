"""A budget of time for a page: parts are made in order of importance, and what does not fit in is named.

Each part hears how long it may take. One that takes much longer is ended all the same. The first Ctrl-C ends the part
that is being made, and no further one is begun.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.linalg import LinAlgError

from mpsolve.errors import MpsolveError
from mpsolve.proof.deadline import TimeUpError, deadline
from mpsolve.proof.stopping import asked_to_end, ended_at_once

T = TypeVar("T")
_NO_TIME = "there was no time left for it: allow more with --effort"
_STOPPED = "the work was interrupted: start it again for the rest"
_GRACE = 0.2  # of its time, for a part that is about to end by itself


@dataclass(frozen=True)
class Part(Generic[T]):
    """What a part of the page shows, or why it is missing: `late` where time was up."""

    name: str
    value: T | None = None
    reason: str = ""
    late: bool = False
    seconds: float = 0.0

    @property
    def there(self) -> bool:
        return self.value is not None


@dataclass
class Budget:
    """Seconds of processor time that are left of `seconds`."""

    seconds: float
    tell: Callable[[str, float], None]
    clock: Callable[[], float] = time.process_time
    _start: float = field(init=False)

    def __post_init__(self) -> None:
        self._start = self.clock()

    @property
    def left(self) -> float:
        return self.seconds - (self.clock() - self._start)

    def part(self, name: str, make: Callable[[float], Any], *, share: float = 1.0, least: float = 0.0) -> Part[Any]:
        """make(seconds that it may take), unless less than `least` is left; no error of it ends the page.

        Where it has not come back a little after that, it is left, and is late.
        """
        if asked_to_end():
            return Part(name, reason=_STOPPED, late=True)
        left = self.left
        if left <= least:
            return Part(name, reason=_NO_TIME, late=True)
        self.tell(name, 1 - max(left, 0.0) / self.seconds)
        start = self.clock()
        seconds = max(share * left, least)
        try:
            with np.errstate(all="ignore"), ended_at_once(), deadline(min((1 + _GRACE) * seconds, left)):
                value = make(seconds)  # odd values overflow
        except KeyboardInterrupt:
            if not asked_to_end():
                raise
            return Part(name, reason=_STOPPED, late=True, seconds=self.clock() - start)
        except TimeUpError:
            return Part(name, reason=_NO_TIME, late=True, seconds=self.clock() - start)
        except (MpsolveError, ArithmeticError, LinAlgError) as error:
            return Part(name, reason=str(error), seconds=self.clock() - start)
        return Part(name, value, seconds=self.clock() - start)
