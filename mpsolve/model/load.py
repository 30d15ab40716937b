"""Where the folders that are still to be replaced look for it."""

from mpsolve.problem.load import gives_forces, loads_of
from mpsolve.vehicles.load import GRAVITY, Load

__all__ = ["GRAVITY", "Load", "gives_forces", "loads_of"]
