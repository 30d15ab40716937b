"""The answer about the distance of masses: the critical distance."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from flint import arb

from mpsolve.errors import known
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.decimals import proved_digits, working_bits
from mpsolve.numbers.exact import Exact
from mpsolve.report.answer import Answer, Source, between, number, short

if TYPE_CHECKING:
    from mpsolve.stability.distance import CriticalDistance


def distance_answer(found: CriticalDistance, source: Source, low: Exact, high: Exact, digits: int) -> Answer:
    """The answer to the critical distance in low ≤ d ≤ high, with `digits` certified digits."""
    headings: tuple[str, ...] = ("", "d", "Re q", "Im q")
    if source.physical is not None:
        headings = ("", "d", "distance [m]", "frequency [Hz]", "growth rate [1/s]")
    row: tuple[str, ...] = ()
    named: tuple[tuple[str, str], ...] = ()
    with ball_arithmetic(working_bits(digits)):
        if found.d is not None and found.q is not None:
            row = ("critical", short(found.d), *_at_distance(found, source))
            parts = (("d", found.d), ("Re q", abs(found.q.real)), ("Im q", found.q.imag))
            named = tuple((name, ("±" if name == "Re q" else "") + proved_digits(x, digits)) for name, x in parts)
        data = {
            "format": "mpsolve critical distance",
            "range": {"start": str(low), "end": str(high)},
            "critical": None if found.d is None else _distance_data(found, source, digits),
            "reason": found.reason,
        }
        said = _distance_sentence(found, low, high, digits)
    gaps = () if found.proved else ("A shorter range (--from, --to) about the minimum, or more --digits, may help.",)
    unused = ("positions of the input: the distance is what is looked for",)
    rows = (row,) if row else ()
    return Answer(source, said, unused, headings, rows, named, gaps, data, found.certificate, "Critical distance")


def _at_distance(found: CriticalDistance, source: Source) -> tuple[str, ...]:
    d, q = known(found.d, "the distance"), known(found.q, "its root")
    if source.physical is None:
        return f"±{short(abs(q.real))}", short(q.imag)
    metres = d / source.physical.chi.ball()
    return short(metres), short(_hertz(abs(q.real), source)), short(-q.imag * source.omega)


def _hertz(q: Any, source: Source) -> Any:
    return q * source.omega / (2 * arb.pi())


def _distance_data(found: CriticalDistance, source: Source, digits: int) -> dict[str, Any]:
    """d, q = ±re + i im, unstable (Im q < 0), and the distance in m, frequency in Hz, growth rate in 1/s, or null."""
    d, q, physical = known(found.d, "the distance"), known(found.q, "its root"), source.physical
    return {
        "d": number(d, digits),
        "re": number(abs(q.real), digits),
        "im": number(q.imag, digits),
        "unstable": bool(q.imag < 0),
        "distance_m": None if physical is None else number(d / physical.chi.ball(), digits),
        "frequency_Hz": None if physical is None else number(_hertz(abs(q.real), source), digits),
        "growth_rate_per_s": None if physical is None else number(-q.imag * source.omega, digits),
    }


def _distance_sentence(found: CriticalDistance, low: Exact, high: Exact, digits: int) -> str:
    whole = between(low, "d", high)
    if not found.proved:
        return f"UNDECIDED: the critical distance in {whole} is open: {found.reason}."
    grows = known(found.q, "its root").imag < 0
    meaning = "where the vibration grows fastest" if grows else "so the case is stable at every one of them"
    place = proved_digits(found.d, digits)
    return f"PROVED: of all distances {whole}, Im q over all roots is smallest at d = {place}, {meaning}."
