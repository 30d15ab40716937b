"""A spectrum and a motion that figures are drawn of, and where marks stand."""

from __future__ import annotations

from typing import Any

from mpsolve import Case, certify
from mpsolve.report.vibration import vibrations

CASE = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
SPECTRUM = certify(CASE)
MOTIONS = vibrations(SPECTRUM)


def placed(ax: Any, gid: str) -> tuple[float, float]:
    """Where the mark of this id stands, in the units of the axes."""
    (line,) = [line for line in ax.lines if line.get_gid() == gid]
    (x,), (y,) = line.get_data()
    return float(x), float(y)
