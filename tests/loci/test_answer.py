"""Answers about lines: a row for each point of each line, and events have floats on both sides."""

from fractions import Fraction

from flint import acb, arb

from mpsolve.loci.answer import Event, FrequencyLine, FrequencyLines, LineEnd
from mpsolve.outcome import Status


def test_rows_and_events() -> None:
    end = LineEnd("range")
    values = (Fraction(1), Fraction(3, 2))
    line = FrequencyLine(values, (acb(0.5, -0.1), acb(0.6, 0.2)), (end, end), 2)
    found = FrequencyLines(None, {"v": (Fraction(1), Fraction(2))}, Status.UNVERIFIED, lines=(line, line))  # type: ignore[arg-type]
    assert [(row["line"], row["value"], row["im_q"]) for row in found.rows()] == [
        (1, 1.0, -0.1), (1, 1.5, 0.2), (2, 1.0, -0.1), (2, 1.5, 0.2)
    ]  # fmt: skip
    event = Event(arb("0.1", "1e-20"), acb(1), 2)
    assert event.lower <= 0.1 <= event.upper
