"""Where the folders that are still to be replaced look for it."""

from mpsolve.problem.case import Case
from mpsolve.problem.checked import errors_under
from mpsolve.problem.physical import Mass, PhysicalCase

__all__ = ["Case", "Mass", "PhysicalCase", "errors_under"]
