"""What is said of a row of vehicles without end, and of the finite train beside it."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from mpsolve.endless.amplification import Amplification, Peak
from mpsolve.endless.axis import Gain
from mpsolve.endless.infinite_train import InfiniteTrain
from mpsolve.numbers.decimals import outward
from mpsolve.numbers.spoken import rounded, spoken


def train_text(title: str, found: InfiniteTrain, ratios: Amplification | None, count: int, si: bool) -> str:
    """Some plain lines; si: whether the problem is in SI, or in the paper's ratios."""
    lines = [title] if title else []
    v, spacing = Fraction(found.problem.v), Fraction(found.spacing)
    row = f"v = {spoken(v, 'm/s')}, spacing {rounded(spacing)} m" if si else f"v = {v}, spacing {spacing}"
    lines.append(f"endless train, {row}: {found.status.value}")
    lines.append(f"  {found.words}")
    if found.motion is not None:
        q = complex(found.motion.q)
        stated = f"q = {q.real:.10g} {q.imag:+.10g} i{' rad/s' * si}, kappa d = {found.motion.theta!r}"
        lines.append(f"  a motion that grows: {stated}")
    for name, gain in (("ahead", found.ahead), ("back", found.back)):
        stated = f"at most a factor {gain.factor:.6g} at {_frequency(gain.q, si)} (computed)"
        lines.append(f"  from each vehicle to the next, {name}: {stated}")
    if ratios is not None:
        state = {True: "stable", False: "unstable", None: "not decided"}[ratios.stable]
        lines.append(f"train of {count}: {state}; forces compared {_band(ratios, si)}")
        for name, peak in (("ahead", ratios.ahead), ("back", ratios.back)):
            if peak is not None:
                lines.append(f"  last force over first, {name}: {_bounds(peak, si)}")
        if ratios.reason is not None:
            lines.append(f"  {ratios.reason}")
    return "\n".join(lines) + "\n"


def _frequency(omega: float, si: bool) -> str:
    return f"{omega / math.tau:.6g} Hz" if si else f"{omega:.6g}"


def _band(ratios: Amplification, si: bool) -> str:
    """Over which frequencies, rounded inward."""
    unit = math.tau if si else 1.0
    low, high = (outward(float(x) / unit, 6, up=up) for x, up in zip(ratios.band, (True, False), strict=True))
    return f"from {low} to {high}{' Hz' * si}"


def _bounds(peak: Peak, si: bool) -> str:
    """What is proved of the largest ratio."""
    near = f"near {_frequency(peak.omega, si)}"
    low = outward(peak.low, 6, up=False)
    if not math.isfinite(peak.high):
        return f"{low} or more, {near}; no upper bound is known yet"
    return f"at most between {low} and {outward(peak.high, 6, up=True)}, {near}"


def train_data(title: str, found: InfiniteTrain, ratios: Amplification | None, count: int) -> dict[str, Any]:
    """The same for machines."""
    motion = None
    if found.motion is not None:
        q = found.motion.q
        motion = {"q": q.str(15), "kappa_d": found.motion.theta}
    content: dict[str, Any] = {
        "format": "mpsolve train",
        "version": 1,
        "title": title,
        "velocity": str(found.problem.v),
        "spacing": found.spacing,
        "status": found.status.value,
        "stable": found.stable,
        "words": found.words,
        "motion": motion,
        "computed": {
            "ahead": _gain(found.ahead),
            "back": _gain(found.back),
            "separation": found.separation,
            "long_trains_grow": found.long_trains,
        },
        "reason": None if found.reason is None else found.reason.data(),
    }
    if ratios is not None:
        content["train"] = {
            "count": count,
            "status": ratios.status.value,
            "stable": ratios.stable,
            "band": [str(x) for x in ratios.band],
            "ahead": _peak(ratios.ahead),
            "back": _peak(ratios.back),
            "reason": None if ratios.reason is None else ratios.reason.data(),
        }
    return content


def _gain(gain: Gain) -> dict[str, float]:
    return {"factor": gain.factor, "frequency": gain.q}


def _peak(peak: Peak | None) -> dict[str, float | None] | None:
    if peak is None:
        return None
    return {"low": peak.low, "high": peak.high if math.isfinite(peak.high) else None, "frequency": peak.omega}
