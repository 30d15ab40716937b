"""Errors that carry what was given, why it cannot be, and what to do."""

from __future__ import annotations

from typing import TypeVar

from mpsolve.outcome import Reason

T = TypeVar("T")


class MpsolveError(Exception):
    """Base of every error that mpsolve raises on purpose. Its argument is a sentence, or a `Reason`."""

    @property
    def reason(self) -> Reason:
        """Why, in parts; a plain sentence has no more than its words."""
        given = self.args[0] if self.args else ""
        return given if isinstance(given, Reason) else Reason("unspecified", str(self))


class InputError(MpsolveError, ValueError):
    """A value that the user gave cannot be used; `key` names it (a TOML key or an argument)."""

    def __init__(self, key: str, message: str) -> None:
        super().__init__(f"{key}: {message}")
        self.key, self.said = key, message

    def __reduce__(self) -> tuple[type[InputError], tuple[str, str]]:
        return type(self), (self.key, self.said)

    def under(self, key: str) -> InputError:
        """The same about another key."""
        return InputError(key, self.said)


class PrecisionError(MpsolveError, ArithmeticError):
    """Balls too wide to decide at the present precision or piece length: split or raise the precision."""


class EffortError(PrecisionError):
    """The effort that was allowed is spent: only more of it would help."""


class ContradictionError(MpsolveError):
    """Two things that cannot both be were computed: a fault of mpsolve, not of what was given. Nothing is proved."""


class CertificateError(MpsolveError):
    """A certificate cannot be written or read; the message names the file and the cause."""


class StudyError(MpsolveError):
    """A study cannot be stored or read; the message names the file, the cause and what helps."""


def known(value: T | None, name: str) -> T:
    """The value, where it has to be there: unlike an `assert`, this holds under `python -O` too."""
    if value is None:
        raise ContradictionError(f"{name} is missing where it was proved to be: please report this as a fault")
    return value
