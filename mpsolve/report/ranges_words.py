"""What answers about ranges say to people: a verdict, the numbers, the ranges, and how far all of it is proved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.decimals import proved_digits, working_bits
from mpsolve.numbers.spoken import rounded, spoken
from mpsolve.outcome import Status
from mpsolve.problem.over import Over
from mpsolve.ranges.answer import Answer
from mpsolve.ranges.crossed import Crossings
from mpsolve.ranges.onset import Kind, Onset
from mpsolve.ranges.seen import BEYOND
from mpsolve.ranges.unstable import UnstableRanges
from mpsolve.report.over_words import margin, onset_at, stable_throughout, unstable_beyond, unstable_from_start
from mpsolve.report.ranges_asked import Asked
from mpsolve.report.spectrum_words import NOT_PROVED
from mpsolve.waves.speeds import wave_speeds

CERTIFIED = (
    "Proved: a certificate with the equations, all boxes of frequency and parameters, and the roots at one point, "
    "passed the standalone verifier; --certificate FILE writes it."
)
WITHOUT = (
    "Proved, without certificate: boxes of frequency and parameters are excluded in rigorous arithmetic, but there "
    "is no file of that which the verifier has passed"
)
THEOREM = "Proved, without certificate: by a theorem that needs no boxes."
_BASE = "The roots at one point, from which all are counted, are certified and passed the standalone verifier."
_UNVERIFIED = "The roots at one point, from which all are counted, are certified; the verifier has not passed them."


@dataclass(frozen=True)
class Said:
    """An answer with its name, its verdict in one sentence, and all that is said of it.

    grows: whether something is shown to grow. asked: the question, over the ranges of which the answer speaks.
    """

    name: str
    answer: Answer
    asked: Asked
    verdict: str
    text: str
    grows: bool = False


def said_of_onset(found: Onset, asked: Asked) -> Said:
    """The report of an onset."""
    asked = asked.answered(found.over)
    grows = found.kind in (Kind.CROSSES, Kind.UNSTABLE_FROM_START)
    return Said("onset", found, asked, onset_verdict(found, asked), _onset(found, asked), grows)


def said_of_ranges(found: UnstableRanges, asked: Asked) -> Said:
    """The report of all unstable ranges of one parameter."""
    asked = asked.answered(found.over)
    text = framed(_ranges(found, asked), found, asked)
    return Said("unstable_ranges", found, asked, ranges_verdict(found, asked), text, bool(found.intervals))


def _end_text(ball: Any, over: Over, digits: int) -> str:
    """An end of the range itself as it was written: no crossing touches it. None: it is open."""
    if ball is None:
        return "∞"
    with precision(working_bits(digits)):
        for end in (over.low, over.high):
            if end is not None and ball.overlaps(rational_ball(end)):
                return over.told(end)
    return value_text(ball, over, digits)


def said_of_crossings(found: Crossings, asked: Asked) -> Said:
    """The report of all crossings of the real axis."""
    asked = asked.answered(found.over)
    text = framed(_crossings(found, asked), found, asked)
    return Said("crossings", found, asked, crossings_verdict(found, asked), text, bool(found.crossings))


def _onset(found: Onset, asked: Asked) -> str:
    (over,) = asked.overs
    lines = [onset_verdict(found, asked)]
    if found.value is not None:
        lines += [f"  {over.path}: {value_text(found.value, over, found.digits)}"]
        lines += [] if found.q is None else [f"  frequency: {frequency_text(found.q, asked, found.digits)}"]
        if over.path in asked.problem.parameters and not over.path.startswith("scale."):
            lines.append(margin(over, found.value, asked.problem.parameters[over.path]))
    for low, high in found.known.get("stable", ()) if not found.proved else ():
        lines.append(f"  Proved: {stable_throughout(replace(over, low=low, high=high))}")
    return framed(lines, found, asked)


def onset_verdict(found: Onset, asked: Asked) -> str:
    """One sentence that begins with STABLE, UNSTABLE or UNDECIDED."""
    (over,) = asked.overs
    if found.kind is Kind.STABLE:
        return _but(found, stable_throughout(over))
    if found.kind is Kind.UNSTABLE_FROM_START:
        return unstable_from_start(over)
    if found.kind is Kind.CROSSES and found.q is None:
        return _but(found, unstable_beyond(over, found.value))
    if found.kind is Kind.CROSSES:
        return _but(found, onset_at(over, found.value, found.q, "Hz" if asked.si else "1/τ"))
    return undecided(found)


def _speeds(found: Answer) -> bool:
    """Whether speeds are left out of the answer."""
    return bool(getattr(found, "left_out", ()))


def _but(found: Answer, verdict: str) -> str:
    """The verdict with a word about what is left out of the range."""
    return f"{verdict.removesuffix('.')}; but see what is left out." if _speeds(found) else verdict


def ranges_verdict(found: UnstableRanges, asked: Asked) -> str:
    """One sentence."""
    (over,) = asked.overs
    if not found.proved:
        return undecided(found)
    if not found.intervals:
        return _but(found, stable_throughout(over))
    many = len(found.intervals)
    return _but(found, f"UNSTABLE in {'one part' if many == 1 else f'{many} parts'} of the range of {over.path}.")


def _ranges(found: UnstableRanges, asked: Asked) -> list[str]:
    (over,) = asked.overs
    lines = [ranges_verdict(found, asked)]
    for one in found.intervals:
        start, end = (_end_text(ball, over, found.digits) for ball in (one.start, one.end))
        first = (
            "the range begins" if one.q is None else f"it starts with {frequency_text(one.q, asked, found.digits)}"
        )
        lines.append(f"  {over.path} from {start} to {end}: {growing(one.roots)}; {first}")
    return lines


def crossings_verdict(found: Crossings, asked: Asked) -> str:
    """One sentence."""
    (over,) = asked.overs
    if not found.proved:
        return undecided(found)
    number = len(found.crossings)
    said = {0: "no value", 1: "one value"}.get(number, f"{number} values")
    return _but(found, f"Stability changes at {said} of {over.path} in the range.")


def _crossings(found: Crossings, asked: Asked) -> list[str]:
    (over,) = asked.overs
    lines = [crossings_verdict(found, asked)]
    for part in found.parts if found.counts is not None else ():
        lines += _crossed(part, replace(over, low=part.over[over.path][0]), asked)
    return lines if len(lines) > 1 else lines + _crossed(found, over, asked)


def _crossed(found: Crossings, over: Over, asked: Asked) -> list[str]:
    lines = []
    counts = found.counts or (None,) * (len(found.crossings) + 1)
    if found.counts is not None:
        lines.append(f"  from {over.told(over.low)} on: {growing(found.counts[0])}")
    for one, count in zip(found.crossings, counts[1:], strict=True):
        after = "" if count is None else f"; beyond it {growing(count)}"
        where = value_text(one.value, over, found.digits)
        lines.append(f"  {over.path} = {where}: {frequency_text(one.q, asked, found.digits)}{after}")
    return lines


def growing(count: int) -> str:
    """How many roots grow, q and −q̄ both counted."""
    return {0: "stable", 1: "1 root grows"}.get(count, f"{count} roots grow")


def undecided(found: Answer) -> str:
    """The verdict of an answer that is not proved."""
    return f"UNDECIDED: {found.reason}."


def value_text(ball: Any, over: Over, digits: int) -> str:
    """All digits in the model's unit, and few in the one that was written, or that people use."""
    with precision(working_bits(digits)):
        own = f"{proved_digits(ball, digits)} {over.si}".strip()
        other = over.told(ball) if over.unit != over.si else spoken(ball, over.si)
    return own if not over.si or other.endswith(f" {over.si}") else f"{own} ({other})"


def frequency_text(q: Any, asked: Asked, digits: int) -> str:
    """q with all its digits, and in Hz; 0 where a deflection begins to grow without oscillation."""
    if q == 0:
        return "q = 0, a deflection that begins without oscillation"
    with precision(working_bits(digits)):
        number = proved_digits(q, digits)
        if not asked.si:
            return f"q = {number} √(k/m)"
        from flint import arb

        return f"q = {number} rad/s ({rounded(q / (2 * arb.pi()))} Hz)"


_SLOWER = (
    "Nothing is claimed of slower velocities, as the equations lose waves at v = 0; certify decides v = 0 itself."
)


def _skipped(asked: Asked) -> list[str]:
    """Velocities that the default ranges leave out."""
    if asked.skipped is None:
        return []
    (over,), (low, high) = asked.overs, asked.skipped
    speeds = wave_speeds(asked.problem.track).items()
    names = ", ".join(name for name, square in speeds if low**2 <= square <= high**2)
    part = f"{over.path} from {over.told(low)} to {over.told(high)}"
    return [f"Nothing is said of {part}, round a wave speed ({names}): certify decides single ones."]


def framed(lines: list[str], found: Answer, asked: Asked) -> str:
    """What is said of an answer: verdict, numbers; then the ranges, warnings, and how sure it is."""
    default = " (give others with --over)" if asked.by_default else ""
    lines = [*lines, f"The range: {asked.ranges}{default}."]
    limited = found.note if _speeds(found) else BEYOND if BEYOND in found.note else ""
    lines += [f"Note: {limited}."] if found.proved and limited else []
    lines += [*([_SLOWER] if asked.slower else []), *_skipped(asked)]
    lines += [f"Warning: {reason}." for reason in asked.warnings]
    return "\n".join([*lines, trust(found)]) + "\n"


def report_of(parts: Sequence[Said]) -> str:
    """The report of one answer, or of several ranges: the title and what is assumed stand there once."""
    title = parts[0].asked.title
    return f"{title}\n" * bool(title) + "\n".join(one.text for one in parts) + f"{NOT_PROVED}\n"


def trust(found: Answer) -> str:
    """How far the answer is proved, said plainly."""
    if not found.proved:
        known = "" if not found.known else " What is listed is proved all the same, but may not be all."
        return f"Not decided, so nothing is claimed of the whole range.{known}"
    if found.certificate is not None and found.status is Status.PROVED:
        return CERTIFIED
    if not found.proofs and found.note:  # by a theorem, without boxes
        return THEOREM if _speeds(found) else f"Proved, without certificate: {found.note}."
    verified = all(proof.base is not None and proof.base.status is Status.PROVED for proof in found.proofs)
    why = "" if _speeds(found) else found.note.removesuffix(BEYOND).removesuffix("; ")
    return f"{WITHOUT}{why and f': {why}'}. {_BASE if found.proofs and verified else _UNVERIFIED}"
