"""What all answers share: how far they are to be trusted, why not further, what they rest on and what they took."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from mpsolve.numbers.packed import Portable

if TYPE_CHECKING:
    from mpsolve.outcome import Reason, Status


class Result(Portable):
    """Base of frozen dataclasses with a `status`; they pickle, and refuse a truth value, which would mislead.

    reason: why the answer is undecided, and what helps, or None. known: what is proved all the same.
    certificate: what others can check, or None where no file of such a proof is written. cost: what it took, or None.
    """

    if TYPE_CHECKING:

        @property
        def status(self) -> Status: ...
        @property
        def reason(self) -> Reason | None: ...

    known: Mapping[str, Any] = MappingProxyType({})
    certificate: Any = None
    cost: Any = None

    @property
    def proved(self) -> bool:
        """Whether the whole answer is proved."""
        return self.status.holds

    def __bool__(self) -> bool:
        raise TypeError(f"{type(self).__name__} has no truth value: ask for .proved, or for what it says")
