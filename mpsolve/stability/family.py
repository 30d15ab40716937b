"""A case with one free real parameter t, or two, and what a box [x] × [t] with q = x + i·height needs of it.

The function whose zeros are sought is R det[unit·I − κ K M] with κ = 2q²/π and unit = 1 (then it is R·Δ); or, for a
free level of all masses, κ = u (1 + q²), unit = 1 − u, where (1 + q²) u/(1 − u) = 2ηq²/π runs through (0, ∞) as u
does through (0, 1).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, Literal

from mpsolve.model.branch import ALONG_ALPHA, ALONG_DAMPING, Motion, Track, track
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case

Parameter = Literal["alpha", "eta_b", "distance", "level", "mass"]


@dataclass(frozen=True)
class Family:
    """`case` with its parameter set free, on the line Im q = height.

    "distance": the masses stand at 0, d, 2d, …. "level": the masses are η·eta_m; "mass": they are t·eta_m. `second`
    is free as well if given.
    """

    case: Case
    parameter: Parameter
    height: Exact = Exact.parse(0, "height")  # noqa: RUF009
    second: Parameter | None = None
    _fixed: dict[Any, Track] = field(default_factory=dict, compare=False, repr=False)

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        return (self.parameter,) if self.second is None else (self.parameter, self.second)

    def at(self, arithmetic: Any, *values: Any) -> Track:
        """The numbers of the case at these values of its parameters (levels and masses apart: they go into κ)."""
        model = self.fixed(arithmetic)
        for name, value in zip(self.parameters, values, strict=True):
            model = moved(model, name, value)
        return model

    @property
    def kind(self) -> tuple[object, ...]:
        """Families of one kind can be swept together."""
        return self.parameters, self.case.merged.count, bool(self.height)

    def fixed(self, arithmetic: Any) -> Track:
        """The numbers that stay the same; they are kept for each arithmetic and precision."""
        key = type(arithmetic), getattr(arithmetic, "bits", 0)
        if key not in self._fixed:
            self._fixed[key] = track(self.case, arithmetic)
        return self._fixed[key]

    def case_at(self, t: Exact) -> Case:
        """The case at an exact t (not for a free mass level)."""
        if self.parameter == "alpha":
            return replace(self.case, alpha=t)
        if self.parameter == "eta_b":
            return replace(self.case, eta_b=t)
        if self.parameter == "distance":
            return replace(self.case, positions=tuple(t * k for k in range(self.case.count)))
        raise ValueError("a free mass level has no case of its own")

    def motion(self, count: int) -> Motion:
        """The direction of t, for derivatives of the kernel."""
        return self.motions(count)[0]

    def motions(self, count: int) -> list[Motion]:
        """The directions of all parameters."""
        directions = {"alpha": ALONG_ALPHA, "eta_b": ALONG_DAMPING, "distance": Motion(positions=tuple(range(count)))}
        return [directions.get(name, Motion()) for name in self.parameters]


def moved(model: Track, name: Parameter, value: Any) -> Track:
    """The model with one of its parameters set."""
    if name == "alpha":
        return replace(model, alpha=value)
    if name == "eta_b":
        return replace(model, eta_b=value)
    if name == "distance":
        return replace(model, positions=tuple(k * value for k in range(len(model.eta_m))))
    return model
