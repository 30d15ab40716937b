"""The vehicles: each file holds one, as exact equations of motion."""

from mpsolve.vehicles.bogie import Bogie
from mpsolve.vehicles.mass import Mass
from mpsolve.vehicles.vehicle import Pencil, Placed, Vehicle

__all__ = ["Bogie", "Mass", "Pencil", "Placed", "Vehicle"]
