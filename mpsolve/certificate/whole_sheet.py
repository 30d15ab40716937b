"""The whole sheet as a region: for which problems it is known, what closes it, and what of it has Im q < 0."""

from __future__ import annotations

from dataclasses import replace

from mpsolve.errors import InputError
from mpsolve.numbers.decimals import outward
from mpsolve.numbers.model import shown
from mpsolve.numbers.rootball import Symmetry
from mpsolve.problem.line import Line
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.premises import open_on_sheet
from mpsolve.spectrum.regions import HalfPlane
from mpsolve.spectrum.sheet import SheetCount
from mpsolve.spectrum.spectrum import Spectrum

_OTHERS = 'give "unstable", ("below", h) or a Rectangle'


def sheet_halves(line: Line | None) -> Line:
    """The two halves of the whole sheet, or InputError where its theorems do not hold."""
    if line is None:
        known = "a beam on one layer, without damping of the rail, whose cuts lie on one line"
        raise InputError("region", f'is "sheet", which is known for {known}: {_OTHERS}')
    reason = open_on_sheet(line)
    if reason and not line.height:  # all that is asked of it but a rectangle is asked of its sheet
        stated = f"has no damping, and {reason}, so that only rectangles are decided"
        raise InputError("track", f"{stated}: give a Rectangle with im_max < 0, or the track some damping")
    if reason:
        raise InputError("region", f'is "sheet", but {reason}, so that its theorems do not hold: {_OTHERS}')
    return line


def unstable_part(found: Spectrum) -> Spectrum:
    """The answer about Im q < 0 from that of the whole sheet."""
    roots = tuple(root for root in found.roots if root.symmetry is not Symmetry.REAL and root.q.imag < 0)
    return replace(found, region=HalfPlane(), roots=roots, count=found.unstable)


def closing_words(reduced: Reduced, count: SheetCount) -> str:
    """What proves that no root of the whole sheet is missed."""
    if count.far is None:
        return "vehicle and track are lossless, so that pivots tell the argument where the contour ends"
    far = outward(float(reduced.frequency_unit) * count.far.reach, 6, up=True)
    height = shown(count.line.height * reduced.frequency_unit)
    return f"a bound of the waves that masses reflect: no root has |q − {height}i| ≥ {far}"
