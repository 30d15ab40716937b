"""What is said of proofs over boxes of parameters, and of charts."""

from __future__ import annotations

from mpsolve.numbers.spoken import beside, rounded
from mpsolve.outcome import Status
from mpsolve.ranges.chart import Chart
from mpsolve.ranges.meeting import Meeting
from mpsolve.ranges.robust_answer import Robust
from mpsolve.report.ranges_asked import Asked
from mpsolve.report.ranges_words import Said, framed, growing, undecided

_SHOWN = 8


def said_of_robust(found: Robust, asked: Asked) -> Said:
    """The report of a proof over a box."""
    asked = asked.answered(found.over)
    return Said("robust", found, asked, _robust_verdict(found), _robust(found, asked), found.stable is False)


def _robust_verdict(found: Robust) -> str:
    if not found.proved or found.stable is None:
        return undecided(found)
    return "STABLE for all these values." if found.stable else "UNSTABLE for some of these values."


def _robust(found: Robust, asked: Asked) -> str:
    lines = [_robust_verdict(found)]
    if found.counterexample is not None:
        lines.append("  A vibration grows at the point")
        lines += [f"    {path} = {_value(x, path, asked)}" for path, x in found.counterexample.items()]
    if found.open:
        lines.append(
            f"  Open: {len(found.open)} parts of the ranges" + (", such as" if len(found.open) > _SHOWN else "")
        )
        for box in found.open[:_SHOWN]:
            shown = (
                f"{one.path} from {one.told(box[one.path][0])} to {one.told(box[one.path][1])}" for one in asked.overs
            )
            lines.append(f"    {', '.join(shown)}")
    if found.stable is False and found.proved:
        return _refuted(lines, found, asked)
    return framed(lines, found, asked)


def _refuted(lines: list[str], found: Robust, asked: Asked) -> str:
    """One certified point is enough: what is said of boxes has no part in it."""
    sure = " and passed the standalone verifier" if found.status is Status.PROVED else ", but not verified"
    proof = f"The roots at this point are certified{sure}. Other points were not asked for."
    return "\n".join([*lines, f"The ranges: {asked.ranges}.", proof]) + "\n"


def _value(x: object, path: str, asked: Asked) -> str:
    return beside(x, asked.problem.quantity(path).unit) if asked.si else rounded(x)


_MEETINGS = {
    "two pairs": "two boundaries cross, with two pairs of roots real,",
    "pair and divergence": "a boundary of a pair crosses one of divergence",
    "pair from q = 0": "a boundary of a pair ends on one of divergence, as q comes to 0,",
}


def said_of_chart(found: Chart, asked: Asked) -> Said:
    """The report of a chart."""
    asked = asked.answered(found.over)
    lines = [*_chart(found, asked), *_what_is_certified(found)]
    return Said("chart", found, asked, _chart_verdict(found), framed(lines, found, asked))


def _what_is_certified(found: Chart) -> list[str]:
    told = "  The certificate states the number of each cell; curves are proved without certificate."
    return [] if found.certificate is None else [told]


def _chart_verdict(found: Chart) -> str:
    if not found.proved:
        return undecided(found)
    regions = f"{len(found.parts)} region{'s' if len(found.parts) > 1 else ''}"
    between = "proved curves run between them" if found.traced else "in strips the number may change"
    return f"{100 * found.share:.3g} % of the chart is decided, in {regions}; {between}."


def _chart(found: Chart, asked: Asked) -> list[str]:
    lines = [_chart_verdict(found)]
    total = found.counts.size if found.detail is None else found.detail.size
    for part in found.parts:
        where = ", ".join(f"{one.path} = {one.told(part.point[one.path])}" for one in asked.overs)
        share = f"{100 * part.cells / total:.3g} % of the chart"
        known = "by a theorem" if part.spectrum is None else f"certified at {where}"
        lines.append(f"  open: {share}" if part.roots is None else f"  {growing(part.roots)}: {share}, {known}")
    for curve in found.boundaries:
        kind = "a root passes q = 0 (divergence)" if curve.divergence else "a pair of roots crosses the real axis"
        end = "" if curve.whole else "; it could not be followed further"
        lines.append(f"  a boundary, proved through {len(curve.x)} points: {kind}{end}")
    lines += [f"  {_meeting(one, asked)}" for one in found.meetings]
    rest = 1 - found.share - sum(part.cells for part in found.parts if part.roots is None) / total
    return [
        *lines,
        f"  strips round the boundaries{', or not looked at' * (not found.proved)}: {100 * rest:.3g} % of the chart",
    ]


def _meeting(one: Meeting, asked: Asked) -> str:
    each = zip(asked.overs, (one.x, one.y), strict=True)
    where = " and ".join(f"{over.path} = {over.told(float(ball.mid()))}" for over, ball in each)
    return f"{_MEETINGS[one.kind]} at {where}"
