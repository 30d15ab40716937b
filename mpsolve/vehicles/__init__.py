"""The vehicles: each file holds one, as exact equations of motion; Vehicle is for anybody's own."""

from mpsolve.vehicles.bogie import Bogie
from mpsolve.vehicles.coach import Coach
from mpsolve.vehicles.mass import Mass
from mpsolve.vehicles.oscillator import Oscillator
from mpsolve.vehicles.own import Vehicle
from mpsolve.vehicles.vehicle import AnyVehicle, Pencil, Placed, train

CATALOGUE: tuple[type[AnyVehicle], ...] = (Mass, Oscillator, Bogie, Coach, Vehicle)
"""Every vehicle, from the plainest to the richest."""

__all__ = ["Mass", "Oscillator", "Bogie", "Coach", "Vehicle", "train", "AnyVehicle", "Pencil", "Placed", "CATALOGUE"]
