"""What the least stable value of a range says to people."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from flint import arb

from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import proved_digits, working_bits
from mpsolve.numbers.spoken import rounded
from mpsolve.problem.cases import as_problem
from mpsolve.problem.over import Over
from mpsolve.problem.reduced import reduce_problem
from mpsolve.ranges.onset import Kind, Onset
from mpsolve.ranges.worst import Worst
from mpsolve.report.ranges_asked import Asked
from mpsolve.report.ranges_words import Said, framed, frequency_text, onset_verdict, undecided, value_text

_ENDS = {"inside": "inside the range", "start": "where the range begins", "end": "where the range ends"}


def said_of_worst(found: Worst, asked: Asked) -> Said:
    """The report of the least stable value."""
    asked = asked.answered(found.over)
    grows = found.growth is not None and bool(found.growth > 0)
    return Said("worst", found, asked, worst_verdict(found, asked), framed(_lines(found, asked), found, asked), grows)


def said_of_onset_at_worst(found: Onset, asked: Asked, second: Asked) -> Said:
    """The report of an onset at the worst value of a second parameter."""
    asked, second = asked.answered(found.over), second.answered(found.over)
    (over,) = second.overs
    verdict = onset_verdict(found, asked)
    if found.kind is Kind.UNSTABLE_FROM_START:
        verdict = f"At {over.path} = {over.told(found.worst)}: {verdict}"
    elif found.proved:
        verdict = f"For every {over.path} from {over.told(over.low)} to {over.told(_end(over))}: {verdict}"
    lines = [verdict]
    if found.value is not None and found.worst is not None:
        lines.append(f"  {asked.overs[0].path}: {value_text(found.value, asked.overs[0], found.digits)}")
        lines.append(f"  worst {over.path}: {value_text(found.worst, over, found.digits)}, {_ENDS[found.where]}")
        lines.append(f"  frequency: {frequency_text(found.q, asked, found.digits)}")
    both = replace(asked, overs=(*asked.overs, over))
    text = framed(lines, found, both)
    return Said("onset", found, both, lines[0], text, found.kind in (Kind.CROSSES, Kind.UNSTABLE_FROM_START))


def _end(over: Over) -> Fraction:
    return over.low if over.high is None else over.high


def worst_verdict(found: Worst, asked: Asked) -> str:
    """One sentence."""
    if found.value is None or found.growth is None:
        return f"STABLE: {found.note}." if found.proved else undecided(found)
    (over,) = asked.overs
    with precision(working_bits(found.digits)):
        grows = bool(found.growth > 0)
    motion = (
        "the fastest growing vibration grows fastest" if grows else "the least damped vibration decays most slowly"
    )
    where = f"{over.path} = {over.told(found.value)}, {_ENDS[found.where]}"
    return f"{'UNSTABLE' if grows else 'STABLE'}: {motion} at {where}."


def _lines(found: Worst, asked: Asked) -> list[str]:
    (over,) = asked.overs
    lines = [worst_verdict(found, asked)]
    if found.value is None or found.growth is None or found.q is None:
        return lines
    lines.append(f"  {over.path}: {value_text(found.value, over, found.digits)}")
    lines.append(f"  frequency: {frequency_text(found.q.real, asked, found.digits)}")
    lines.append(f"  {_rate(found.growth, asked, found.digits)}")
    if found.reach is not None:
        unit = "rad/s" if asked.si else "√(k/m)"
        far = f"{rounded(found.reach)} {unit}"
        lines.append(
            f"  No root grows anywhere in the range; those below the lowest cut are compared up to Re q = {far}."
        )
    if reduce_problem(as_problem(found.problem)).parts.unfelt is not None:
        lines.append("  Motions that no contact feels are left out; none of them grows.")
    return lines


def _rate(growth: arb, asked: Asked, digits: int) -> str:
    from flint import arb

    with precision(working_bits(digits)):
        up = bool(growth > 0)
        number = proved_digits(abs(growth), digits)
        if not asked.si:
            return f"{'growth' if up else 'decay'}: {'−' if up else ''}Im q = {number} √(k/m)"
        time = rounded(arb(2).log() / abs(growth))
        return f"growth: {number} 1/s (doubles in {time} s)" if up else f"decay: {number} 1/s (halves in {time} s)"
