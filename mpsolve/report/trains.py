"""What is said of a row of vehicles without end, and of the finite train beside it."""

from __future__ import annotations

import json
import math
from typing import Any

from mpsolve.endless.amplification import Amplification, Peak
from mpsolve.endless.axis import Gain
from mpsolve.endless.infinite_train import InfiniteTrain
from mpsolve.numbers.decimals import outward


def train_text(title: str, found: InfiniteTrain, ratios: Amplification | None, count: int) -> str:
    """Some plain lines."""
    lines = [title] if title else []
    lines.append(f"endless train, v = {found.problem.v}, spacing {found.spacing}: {found.status.value}")
    lines.append(f"  {found.words}")
    if found.motion is not None:
        q = complex(found.motion.q)
        lines.append(f"  a motion that grows: q = {q.real:.10g} {q.imag:+.10g} i, kappa d = {found.motion.theta!r}")
    for name, gain in (("ahead", found.ahead), ("back", found.back)):
        lines.append(
            f"  from each vehicle to the next, {name}: at most a factor {gain.factor:.6g} at {gain.q:.6g} (computed)"
        )
    if ratios is not None:
        state = {True: "stable", False: "unstable", None: "not decided"}[ratios.stable]
        lines.append(f"train of {count}: {state}")
        for name, peak in (("ahead", ratios.ahead), ("back", ratios.back)):
            if peak is not None:
                lines.append(f"  last force over first, {name}: {_bounds(peak)}")
        if ratios.reason is not None:
            lines.append(f"  {ratios.reason}")
    return "\n".join(lines) + "\n"


def _bounds(peak: Peak) -> str:
    """What is proved of the largest ratio."""
    low = outward(peak.low, 6, up=False)
    if not math.isfinite(peak.high):
        return f"{low} or more, near {peak.omega:.6g}; no upper bound is known yet"
    return f"at most between {low} and {outward(peak.high, 6, up=True)}, near {peak.omega:.6g}"


def train_json(title: str, found: InfiniteTrain, ratios: Amplification | None, count: int) -> str:
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
    return json.dumps(content, indent=2) + "\n"


def _gain(gain: Gain) -> dict[str, float]:
    return {"factor": gain.factor, "frequency": gain.q}


def _peak(peak: Peak | None) -> dict[str, float | None] | None:
    if peak is None:
        return None
    return {"low": peak.low, "high": peak.high if math.isfinite(peak.high) else None, "frequency": peak.omega}
