"""The whole sheet as a region: for which problems it is known, what closes it, and what of it has Im q < 0."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import nextafter

from mpsolve.errors import InputError
from mpsolve.numbers.decimals import outward
from mpsolve.numbers.model import shown
from mpsolve.numbers.rootball import Symmetry
from mpsolve.problem.line import Line, beam_height
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.premises import open_on_sheet
from mpsolve.spectrum.regions import HalfPlane
from mpsolve.spectrum.sheet import SheetCount
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.tracks.at_rest import lowest_cut
from mpsolve.tracks.waveguide import Track, Waveguide

_OTHERS = 'give "unstable", ("below", h) or a Rectangle'


def sheet_halves(reduced: Reduced, line: Line | None) -> Line:
    """The two halves of the whole sheet, or InputError where its theorems do not hold."""
    if line is None:
        raise InputError("region", f'is "sheet", {_no_line(reduced.problem.track)}')
    reason = open_on_sheet(line)
    if reason and not line.height:  # all that is asked of it but a rectangle is asked of its sheet
        stated = f"has no damping, and {reason}, so that only rectangles are decided"
        raise InputError("track", f"{stated}: give a Rectangle with im_max < 0, or the track some damping")
    if reason:
        raise InputError("region", f'is "sheet", but {reason}, so that its theorems do not hold: {_OTHERS}')
    return line


def _no_line(track: Track | Waveguide) -> str:
    """Why a track's cuts have no two sides, and what to ask for.

    Where c² > 4m(EI p⁴ − T p² + k) for some real p, waves of these p decay without vibrating. In z = q − iη their
    cut is z = vp ± i√(c²/4m² − (EI p⁴ − T p² + k)/m), closed curves (slits at v = 0) that part more from the plane
    than its two halves: inside, one p-root has Im p > 0 above the real axis of z, and three below it, not two.
    """
    height = beam_height(track)
    if height is None:
        known = "a beam on one layer, without damping of the rail, whose cuts lie on one line"
        return f"which is known for {known}: {_OTHERS}"
    low, line = lowest_cut(track)[0], f"the line Im q = {shown(height)}"
    below = f', or for ("below", h) give h up to {outward(nextafter(float(low), 0), 5, up=False)}' if low > 0 else ""
    if low > height * (1 - Fraction(1, 2**19)):
        return f'but some waves are damped exactly critically: change c a little, or ask for "unstable"{below}'
    why = "this beam is damped so strongly that some of its waves decay without vibrating"
    curve = f"their cut leaves {line} in a closed curve down to Im q = {float(low):.6g}"
    return f'but {why}: {curve}, and what lies inside is on neither side of it: ask for "unstable"{below}'


def unstable_part(found: Spectrum) -> Spectrum:
    """The answer about Im q < 0 from that of the whole sheet."""
    roots = tuple(root for root in found.roots if root.symmetry is not Symmetry.REAL and root.q.imag < 0)
    return replace(found, region=HalfPlane(), roots=roots, count=found.unstable)


def closing_words(reduced: Reduced, count: SheetCount) -> str:
    """What proves that no root of the whole sheet is missed."""
    if count.far is None:
        return "vehicle and track are lossless, so that pivots tell the argument where the contour ends"
    far = outward(float(reduced.frequency_unit) * count.far.reach, 6, up=True)
    known = f"no root lies on the cuts from |Re q| = {far} on, and how the argument turns beyond is known"
    return f"a bound of the waves that masses reflect: {known}"
