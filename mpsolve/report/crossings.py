"""Answers about the masses and their distance: all crossing mass levels, and the critical distance."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from flint import arb

from mpsolve.errors import known
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.decimals import proved_digits, working_bits
from mpsolve.numbers.exact import Exact
from mpsolve.report.answer import Answer, Source, between, number, short
from mpsolve.stability import strips
from mpsolve.stability.masses import Crossing, CrossingMasses

if TYPE_CHECKING:
    from mpsolve.stability.distance import CriticalDistance

_REMEDY = "More --digits, or a slightly changed case, may help; a single mass can be decided by mpsolve certify."
_MOST = 3  # masses that are listed one by one in a row


def largest(source: Source) -> Exact:
    """The largest mass ratio of the case: the crossing level η is that of this mass."""
    return max(source.case.eta_m)


def crossings_answer(found: CrossingMasses, source: Source, digits: int) -> Answer:
    """The answer to all crossing masses; `found` is for the proportions η_M,j/max η_M of the case."""
    with ball_arithmetic(working_bits(digits)):
        rows = tuple(_row(k, found, source) for k in range(len(found)))
        named: list[tuple[str, str]] = []
        for k, crossing in enumerate(found, 1):
            named += [
                (f"η{k}", proved_digits(crossing.eta, digits)),
                (f"q{k}", "±" + proved_digits(crossing.q, digits)),
            ]
        data = {
            "format": "mpsolve crossings",
            "level": "eta is the mass ratio of the largest mass; factor multiplies the masses of the case",
            "crossings": [_data(crossing, source, digits) for crossing in found],
            "counts": list(found.counts),
            "reason": found.reason,
            "strips": strips.data(found.strips),
        }
        said = _sentence(found, digits)
    gaps = () if found.proved else strips.lines("u", found.strips, strips.UNIT, _REMEDY)
    unused = ("size of the masses: only their proportions are",)
    return Answer(source, said, unused, _headings(source), rows, tuple(named), gaps, data, found.certificate)


def _sentence(found: CrossingMasses, digits: int) -> str:
    if not found.proved:
        return f"UNDECIDED: not all crossing masses are known: {found.reason}."
    if not len(found):
        return "PROVED: stable for every size of the masses, in the proportions of the case."
    first = found[0]
    below = f"PROVED: stable as long as the largest mass ratio is below η = {proved_digits(first.eta, digits)}"
    if len(found) == 1:
        return f"{below}, and unstable for every larger one, in the proportions of the case."
    counts = ", ".join(map(str, found.counts))
    return (
        f"{below}; as the masses grow on, in the proportions of the case, roots cross the real axis at exactly "
        f"{len(found)} levels, and the number of unstable roots below, between and above them is {counts}."
    )


def _headings(source: Source) -> tuple[str, ...]:
    count = source.case.count
    named = range(1, count + 1) if count <= _MOST else ()
    ratios = tuple(f"η_M{j}" for j in named) if named else ("largest η_M",)
    if source.physical is None:
        return ("", "× case", *ratios, "q", "unstable above")
    masses = tuple(f"M{j} [kg]" for j in named) if named else ("largest M [kg]",)
    return ("", "× case", *masses, "[Hz]", "unstable above")


def _row(k: int, found: CrossingMasses, source: Source) -> tuple[str, ...]:
    crossing = found[k]
    factor = crossing.eta / largest(source).ball()
    sizes = [mass.M for mass in source.physical.masses] if source.physical else list(source.case.eta_m)
    listed = sizes if len(sizes) <= _MOST else [max(sizes)]
    place = f"±{short(crossing.q)}" if source.physical is None else short(_hertz(crossing.q, source))
    after = found.counts[k + 1]
    shown = "open" if after is None else f"{after} roots" if after else "none"
    return f"η{k + 1}", short(factor), *(short(factor * size.ball()) for size in listed), place, shown


def _hertz(q: Any, source: Source) -> Any:
    return q * source.omega / (2 * arb.pi())


def _data(crossing: Crossing, source: Source, digits: int) -> dict[str, Any]:
    """eta, factor, masses of all, q, direction +1 (two roots become unstable as the masses grow) or −1."""
    factor = crossing.eta / largest(source).ball()
    physical = source.physical
    return {
        "eta": number(crossing.eta, digits),
        "factor": number(factor, digits),
        "eta_m": [number(factor * ratio.ball(), digits) for ratio in source.case.eta_m],
        "M_kg": None if physical is None else [number(factor * mass.M.ball(), digits) for mass in physical.masses],
        "q": number(crossing.q, digits),
        "frequency_Hz": None if physical is None else number(_hertz(crossing.q, source), digits),
        "direction": crossing.direction,
    }


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
