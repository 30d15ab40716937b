"""Why a count stays open: the place on its line where it fails, and what lies there."""

from __future__ import annotations

import numpy as np

from mpsolve.characteristic.start import NoStartError
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.outcome import Reason
from mpsolve.problem.line import Line
from mpsolve.problem.reduced import Reduced
from mpsolve.proof.cover import OpenPieceError
from mpsolve.proof.effort import MORE_EFFORT
from mpsolve.spectrum.candidates import nearest_root

_NEAR = 1e-6  # relative: a root this close to the line is named as the reason


class WavesMeetError(PrecisionError):
    """Two p-roots come to p = 0 as q → 0, so that no count passes q = 0."""

    def __init__(self) -> None:
        super().__init__("two waves of the track come to p = 0 as q goes to 0, where this count passes")


def reason_of(reduced: Reduced, error: EffortError | PrecisionError) -> Reason:
    """The error as a reason, with a remedy that fits it."""
    if isinstance(error, EffortError) and error.reason.code == "interrupted":
        return error.reason
    if isinstance(error, EffortError):
        return Reason("effort", error.reason.message, {}, f"{MORE_EFFORT}, or ask for a Rectangle round what matters")
    if isinstance(error, WavesMeetError):
        return Reason("waves-meet", str(error), {}, "ask for a Rectangle that keeps away from q = 0, with re_min > 0")
    if isinstance(error, NoStartError):
        return Reason("start", error.words[0], {}, error.words[1])
    if isinstance(error, OpenPieceError):
        return _at_place(reduced, error.place)
    return Reason("count", str(error), {}, "ask for a Rectangle that keeps away from the real axis")


def sheet_reason(line: Line, reduced: Reduced, error: EffortError | PrecisionError) -> Reason:
    """Why the whole sheet stays open; places are those of q."""
    passive = bool(line.height) or not line.passive_from
    other = 'ask for "unstable"' if passive else 'give some damping, and ask for "unstable"'
    if isinstance(error, EffortError) and error.reason.code == "interrupted":
        return error.reason
    if isinstance(error, EffortError):
        return Reason("effort", error.reason.message, {}, f"{MORE_EFFORT}, or {other}")
    if not isinstance(error, OpenPieceError):
        return Reason("sheet", str(error), {}, other)
    unit, place = float(reduced.frequency_unit), error.place + 1j * float(line.height)
    root = nearest_root(reduced, place)
    numbers = {"re": f"{place.real * unit:.10g}", "im": f"{place.imag * unit:.10g}"}
    if root is not None and abs(root - place) <= _NEAR * abs(place):
        at = f"{root.real * unit:.10g}{root.imag * unit:+.10g}i"
        message = f"a root at q = {at}, or one closer to the cut than can be told, lies on the edge of the cut"
        return Reason("root-on-line", message, {**numbers, "root": at}, other)
    message = f"nothing is proved near q = {place.real * unit:.6g}{place.imag * unit:+.6g}i on the edge of the cut"
    return Reason("line", message, numbers, other)


def _at_place(reduced: Reduced, place: complex) -> Reason:
    unit = float(reduced.frequency_unit)
    numbers = {"re": f"{place.real * unit:.10g}", "im": f"{place.imag * unit:.10g}"}
    root = nearest_root(reduced, place)
    if root is not None and abs(root - place) <= _NEAR * abs(place):
        at = f"{root.real * unit:.10g}"
        message = (
            f"a root at q = {at}, or one closer to the real axis than can be told, lies on the line of the count"
        )
        remedy = 'ask for a Rectangle with im_max < 0 below it, or where cuts allow it for ("below", h)'
        return Reason("root-on-line", message, {**numbers, "root": at}, remedy)
    message = f"nothing is proved near q = {place.real * unit:.6g}{place.imag * unit:+.6g}i on the line of the count"
    if np.abs(place) < 1e-6:
        message += ", at q = 0"
    remedy = "ask for a Rectangle that keeps away from this place, or change a parameter a little"
    return Reason("line", message, numbers, remedy)
