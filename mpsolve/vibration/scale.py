"""The units in which a motion is shown: dimensionless, or those of a physical case."""

from __future__ import annotations

from dataclasses import dataclass

from mpsolve.problem.physical import PhysicalCase


@dataclass(frozen=True)
class Scale:
    """What one unit of τ, of w and of force is in the units that are shown, and their names."""

    time: float = 1.0
    length: float = 1.0
    force: float = 1.0
    time_name: str = "τ"
    length_name: str = "w/w_st"
    force_name: str = "1"

    @classmethod
    def of(cls, physical: PhysicalCase | None) -> Scale:
        """In s, mm and kN for loads in units of 1 N: τ = √(k/m) t of (10), w_st = χ/(2k) · 1 N of (13)."""
        if physical is None:
            return cls()
        static = float(physical.chi) / (2 * float(physical.k))
        return cls(1 / float(physical.time_scale), 1e3 * static, 1e-3, "s", "mm", "kN")

    @property
    def physical(self) -> bool:
        """Whether the units are those of a physical case."""
        return self.time_name == "s"

    @property
    def said(self) -> str:
        """The units in words."""
        if self.physical:
            return "times in s, displacements in mm, forces in kN"
        return "τ = √(k/m) t, ξ = χ x, displacements in units of w_st = χ/(2k) · unit force, forces in unit forces"
