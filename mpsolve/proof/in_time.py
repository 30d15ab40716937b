"""Steps that look at no effort, such as a verifier, within one."""

from __future__ import annotations

from collections.abc import Callable
from time import process_time
from typing import TypeVar

from mpsolve.proof.deadline import TimeUpError, deadline
from mpsolve.proof.effort import MORE_EFFORT, Effort
from mpsolve.proof.stopping import asked_to_end, ended_at_once

T = TypeVar("T")


def in_time(
    step: Callable[[], T], budget: Effort, done: str = "the verifier was through"
) -> tuple[T | None, str, float]:
    """(what the step gives, or why it gives nothing, processor seconds).

    It has what is left of the effort, and the first Ctrl-C ends it too. done: what did not come about, in words.
    """
    started, left = process_time(), budget.rest()
    found, why = None, ""
    try:
        with ended_at_once(), deadline(None if left is None else left.seconds):
            found = step()
    except TimeUpError:
        asked = (budget.whole or budget).seconds
        limit = "all the time" if asked is None else f"the effort of {asked:g} s of processor time"
        why = f"{limit} was spent before {done}: {MORE_EFFORT}"
    except KeyboardInterrupt:
        if not asked_to_end():
            raise
        why = f"the work was interrupted before {done}"
    return found, why, process_time() - started
