"""Why a count of roots is undecided, in parts: what stands in the way, where, and what helps.

Remedies name things as the library and the command line both do: region "unstable", max_pieces, digits.
"""

from __future__ import annotations

from mpsolve.fields import Float64
from mpsolve.model.limits import branch_points, critical_velocity_ratio
from mpsolve.numbers.exact import Exact
from mpsolve.outcome import Reason
from mpsolve.problem.case import Case
from mpsolve.sheet.region import Region
from mpsolve.spectrum.regions import Rectangle

_UNSTABLE = 'ask for the region "unstable"'
_BESIDE = 0.02  # of its distance from 0: so near to a branch point it is the branch point that stops a contour
_CRITICAL = 0.01  # so near to α_C the whole neighbourhood of q = 0 is a branch point


def pieces(limit: int) -> Reason:
    """The effort is spent."""
    return Reason(
        "pieces", f"the contour needs more than {limit} pieces", {"max_pieces": str(limit)}, "raise max_pieces"
    )


def root_on_contour(here: float) -> Reason:
    """A piece became too short: a zero lies on the path, or next to it."""
    return Reason(
        "contour-root",
        f"a root lies on the contour (a cut, the real axis, a side), or too close to it, near {here:.6g}",
        {"near": repr(here)},
        "change a parameter a little, or move the side of the rectangle",
    )


def on_sheet(case: Case, found: Reason) -> Reason:
    """The reason why the whole sheet could not be counted, told from what lies where the contour stopped."""
    if found.code == "pieces" and case.eta_b > 0:
        return Reason(found.code, found.message, found.numbers, f"{_UNSTABLE}, or {found.remedy}")
    if found.code != "contour-root":
        return found
    here = float(found.numbers["near"])
    critical = float(critical_velocity_ratio(case, Float64()))
    if not case.eta_b and abs(float(case.alpha) - critical) < _CRITICAL * critical:
        return Reason(
            "near-critical",
            f"alpha = {case.alpha.short()} is so close to alpha_C = {critical:.8g}, where the cuts join at q = 0, "
            "that the contour cannot pass between them",
            {"alpha": str(case.alpha), "alpha_C": repr(critical), "near": repr(here)},
            "take alpha further from alpha_C",
        )
    beside = [point for point in branch_points(case) if abs(here - point) < _BESIDE * point]
    if not beside:
        return found
    point = min(beside, key=lambda p: abs(here - p))
    helps = _UNSTABLE if case.eta_b else "change alpha a little, or give some damping"
    return Reason(
        "branch-point",
        f"the contour cannot pass the branch point of the cuts at Re q = {point:.8g}, where p-roots meet",
        {"branch_point": repr(point), "near": repr(here)},
        helps,
    )


def beside_cut(case: Case, box: Rectangle) -> Reason:
    """A side of a rectangle nearly touches the line of the cuts."""
    sides = {"im_max": box.im_max, "im_min": box.im_min}
    name, side = min(sides.items(), key=lambda item: abs(float(item[1]) - float(case.eta_b)))
    shown = Exact.parse(side).short(20)
    return Reason(
        "beside-cut",
        f"{name} = {shown} is so close to the cut line Im q = eta_b = {case.eta_b.short()} that the sides "
        "of p-roots cannot be told apart there",
        {name: str(side), "eta_b": str(case.eta_b)},
        f"take {name} further from eta_b",
    )


def rectangle_too_large(reach: float, radius: float) -> Reason:
    """The rectangle goes on where no root can be, and a proof of that by its sides takes too many pieces."""
    return Reason(
        "rectangle-too-large",
        f"the rectangle reaches to |q| = {reach:.6g}, and no root has |q − i eta_b| ≥ {radius:.6g}",
        {"reach": repr(reach), "radius": repr(radius)},
        f"end it at ±{radius:.6g}, which loses no root",
    )


def too_many(case: Case, region: Region, counted: int, most: int) -> Reason:
    """More roots than a certificate may list."""
    return Reason(
        "too-many-roots",
        f"{counted} roots were counted, more than the {most} that a certificate lists",
        {"counted": str(counted), "most": str(most)},
        _UNSTABLE + ", or for a rectangle about the roots that matter"
        if region == "sheet" and case.eta_b > 0
        else "ask for a rectangle about the roots that matter",
    )


def missing_helps(case: Case, region: Region) -> str:
    """What helps where fewer roots were enclosed than counted."""
    if region == "sheet" and case.eta_b > 0:
        return f"{_UNSTABLE}, or for more digits, so that clusters come apart"
    return "ask for more digits, so that clusters come apart, or for a rectangle"
