"""Where the folders that are still to be replaced look for it."""

from mpsolve.problem.specs import (
    MAX_DIGITS,
    MAX_VALUES,
    ONE_MASS,
    PARAMETERS,
    Grid,
    Value,
    case_of,
    choice,
    count_of_masses,
    digits,
    errors_at,
    fixed,
    grid,
    kind_of,
    label,
    load,
    rationals,
    section,
    steps,
    title,
    velocity_range,
)

__all__ = [
    "PARAMETERS", "ONE_MASS", "MAX_VALUES", "MAX_DIGITS", "Value", "Grid", "label", "load",
    "title", "digits", "choice", "grid", "fixed", "count_of_masses", "velocity_range", "case_of",
    "errors_at", "steps", "rationals", "section", "kind_of",
]  # fmt: skip
