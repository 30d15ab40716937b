"""A table of receptances as CSV for text import and as JSON, with what its numbers mean in SI units."""

from __future__ import annotations

import csv
import io
import json
import math
from dataclasses import dataclass
from typing import Any

from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.model.receptance import receptance

FORMAT, VERSION = "mpsolve receptance", 1
MEANING = (
    "A force of 1 that moves along at xi = 0 as exp(i omega tau) deflects the beam by (4/pi) K(xi, omega) "
    "exp(i omega tau) in units of w_st; computed in float64."
)


@dataclass(frozen=True)
class Receptances:
    """K[i, j] = K(xi[i], omega[j]), complex128; xi in units of 1/χ, omega real in units of χ v_cr = √(k/m)."""

    case: Case
    physical: PhysicalCase | None
    title: str
    xi: tuple[float, ...]
    omega: tuple[float, ...]
    K: Any

    def to_csv(self) -> str:
        """A row for each ω: omega, then re_K(ξ) and im_K(ξ) for each ξ."""
        stream = io.StringIO()
        rows = csv.writer(stream, lineterminator="\n")
        rows.writerow(["omega", *(f"{part}_K({xi:.10g})" for xi in self.xi for part in ("re", "im"))])
        for omega, column in zip(self.omega, self.K.T.tolist(), strict=True):
            rows.writerow([repr(omega), *(repr(part) for value in column for part in (value.real, value.imag))])
        return stream.getvalue()

    def to_json(self) -> str:
        """K_re[i][j], K_im[i][j] for xi[i], omega[j]; units: what 1 in each is in SI, or null without units."""
        content = {
            "format": FORMAT,
            "version": VERSION,
            "title": self.title,
            "meaning": MEANING,
            "case": self.case.as_dict(),
            "units": None if self.physical is None else _units(self.physical),
            "xi": self.xi,
            "omega": self.omega,
            "K_re": self.K.real.tolist(),
            "K_im": self.K.imag.tolist(),
        }
        return json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def receptances(
    case: Case, physical: PhysicalCase | None, title: str, xi: tuple[float, ...], omega: tuple[float, ...]
) -> Receptances:
    """The table of the case, whose masses play no part. Raises InputError as `receptance` does."""
    return Receptances(case, physical, title, xi, omega, receptance(case, xi, omega))


def _units(physical: PhysicalCase) -> dict[str, float]:
    """1 in xi, omega and K in SI: w_st = χ/(2k) · 1 N of (13), so that K stands for 4/π of it."""
    chi = float(physical.chi)
    return {
        "xi_m": 1 / chi,
        "omega_rad_per_s": float(physical.time_scale),
        "K_m_per_N": 2 * chi / (math.pi * float(physical.k)),
    }
