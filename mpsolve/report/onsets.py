"""Answers about the velocity: the first onset of instability, and all unstable ranges."""

from __future__ import annotations

from typing import Any

from flint import arb

from mpsolve.fields import ball_arithmetic
from mpsolve.model.specs import label
from mpsolve.numbers.decimals import outward, proved_digits, working_bits
from mpsolve.numbers.exact import Exact
from mpsolve.report.answer import PLACES, Answer, Source, between, number, short
from mpsolve.stability import strips
from mpsolve.stability.velocities import Interval, Onset, UnstableRanges

_REMEDY = "A shorter range (--from, --to) that leaves the strip out, or more --digits, may help."
_UNUSED = "it is what is looked for"


def onset_answer(onset: Onset, source: Source, low: Exact, high: Exact, digits: int) -> Answer:
    """The answer to the first onset in low ≤ α ≤ high, with `digits` certified digits."""
    with ball_arithmetic(working_bits(digits)):
        found = onset.alpha is not None
        rows = (("onset", *_quantities(onset.alpha, onset.q, source)),) if found else ()
        named = _named("", onset.alpha, onset.q, digits) if found else ()
        crossing = _crossing(onset.alpha, onset.q, source, digits) if found else None
    data = {
        "format": "mpsolve onset",
        "range": {"start": str(low), "end": str(high)},
        "onset": crossing,
        "stable": onset.proved and not found,
        "stable_below": onset.stable_below,
        "reason": onset.reason,
        "strips": [] if onset.proved else strips.data(onset.ranges.strips),
    }
    said = _onset_sentence(onset, low, high, digits)
    gaps = () if onset.proved else strips.lines("α", onset.ranges.strips, (low, high), _REMEDY)
    return Answer(source, said, _unused(source), _headings(source), rows, named, gaps, data, onset.certificate)


def ranges_answer(found: UnstableRanges, source: Source, digits: int) -> Answer:
    """The answer to all unstable velocities of the range that was asked for."""
    rows: list[tuple[str, ...]] = []
    named: list[tuple[str, str]] = []
    with ball_arithmetic(working_bits(digits)):
        for k, interval in enumerate(found, 1):
            for what, name, alpha, q in (
                ("unstable from", "_start", interval.start, interval.q_start),
                ("unstable to", "_end", interval.end, interval.q_end),
            ):
                if q is not None:
                    rows.append((what, *_quantities(alpha, q, source)))
                    named += _named(f"{name}{k}", alpha, q, digits)
        intervals = [_interval_data(interval, source, digits) for interval in found]
        said = _ranges_sentence(found, digits)
    data = {
        "format": "mpsolve unstable velocities",
        "range": {"start": str(found.start), "end": str(found.end)},
        "unstable": intervals,
        "unknown": [{"start": start, "end": end} for start, end in found.unknown],
        "reason": found.reason,
        "strips": strips.data(found.strips),
    }
    gaps = () if found.proved else strips.lines("α", found.strips, (found.start, found.end), _REMEDY)
    return Answer(
        source, said, _unused(source), _headings(source), tuple(rows), tuple(named), gaps, data, found.certificate
    )


def _onset_sentence(onset: Onset, low: Exact, high: Exact, digits: int) -> str:
    whole = between(low, "α", high)
    if not onset.proved:
        limit = outward(onset.stable_below, PLACES, up=False)
        below = f" Stable for {label(low)} ≤ α < {limit}." if onset.stable_below > float(low) else ""
        return f"UNDECIDED: the first onset in {whole} is open: {onset.reason}.{below}"
    if onset.alpha is None:
        return f"PROVED: stable for every velocity ratio in {whole}, so there is no onset there."
    if onset.q is None:
        return f"PROVED: unstable from the start of the range on, α = {label(low)}; the onset lies below it."
    alpha = proved_digits(onset.alpha, digits)
    return f"PROVED: stable from α = {label(low)} up to the onset at α = {alpha}, where two roots ±q enter Im q < 0."


def _ranges_sentence(found: UnstableRanges, digits: int) -> str:
    whole = between(found.start, "α", found.end)
    texts = " and ".join(_interval_text(interval, found, digits) for interval in found)
    if not found.proved:
        known = f" Unstable for {texts}." if texts else ""
        return f"UNDECIDED: a part of {whole} is open: {found.reason}.{known}"
    if not texts:
        return f"PROVED: stable for every velocity ratio in {whole}."
    return f"PROVED: of all velocity ratios {whole}, the case is unstable for {texts}, and for no others."


def _interval_text(interval: Interval, found: UnstableRanges, digits: int) -> str:
    """Such as 0.69 < α < 0.88; an end that is that of the range belongs to the interval."""
    crossed, left = interval.q_start is not None, interval.q_end is not None
    start = proved_digits(interval.start, digits) if crossed else _limit(interval.start, found, found.start)
    end = proved_digits(interval.end, digits) if left else _limit(interval.end, found, found.end)
    return f"{start} {'<' if crossed else '≤'} α {'<' if left else '≤'} {end}"


def _limit(ball: Any, found: UnstableRanges, limit: Exact) -> str:
    """The end of the range, or of a strip inside it, where nothing crosses."""
    if found.proved or ball.overlaps(limit.ball()):
        return label(limit)
    return proved_digits(ball, PLACES)


def _interval_data(interval: Interval, source: Source, digits: int) -> dict[str, Any]:
    ends = {}
    for key, ball, q in (("start", interval.start, interval.q_start), ("end", interval.end, interval.q_end)):
        ends[key] = _crossing(ball, q, source, digits)
    return {**ends, "roots": interval.roots}


def _headings(source: Source) -> tuple[str, ...]:
    if source.physical is None:
        return ("", "α", "q")
    return ("", "α", "v [m/s]", "v [km/h]", "frequency [Hz]")


def _quantities(alpha: Any, q: Any | None, source: Source) -> tuple[str, ...]:
    if source.physical is None:
        return short(alpha), "" if q is None else f"±{short(q)}"
    v = alpha * source.physical.v_cr.ball()
    return short(alpha), short(v), short(v * 18 / 5), "" if q is None else short(_hertz(q, source))


def _hertz(q: Any, source: Source) -> Any:
    return q * source.omega / (2 * arb.pi())


def _named(suffix: str, alpha: Any, q: Any | None, digits: int) -> tuple[tuple[str, str], ...]:
    if q is None:
        return ()
    return (f"α{suffix}", proved_digits(alpha, digits)), (f"q{suffix}", "±" + proved_digits(q, digits))


def _crossing(alpha: Any, q: Any | None, source: Source, digits: int) -> dict[str, Any]:
    """alpha, q (null: an end of the range or of a strip, no crossing), and v in m/s, km/h, q in Hz, or null."""
    physical = source.physical
    v = None if physical is None else alpha * physical.v_cr.ball()
    return {
        "alpha": number(alpha, digits),
        "q": None if q is None else number(q, digits),
        "v_m_per_s": None if v is None else number(v, digits),
        "v_km_per_h": None if v is None else number(v * 18 / 5, digits),
        "frequency_Hz": None if physical is None or q is None else number(_hertz(q, source), digits),
    }


def _unused(source: Source) -> tuple[str, ...]:
    own = "α" if source.physical is None else "v"
    return (f"{own} of the input: {_UNUSED}",)
