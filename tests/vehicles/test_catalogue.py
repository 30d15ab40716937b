"""What every vehicle has, what each one is at rest and as a rigid body, and what is refused."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from vehicle_models import BOGIE, TYPICAL, random_vehicles

from mpsolve import vehicles
from mpsolve.errors import InputError
from mpsolve.numbers.model import quantities
from mpsolve.vehicles.vehicle import Pencil, checked_pencil


def arrays(pencil: Pencil) -> tuple[np.ndarray, ...]:
    return tuple(np.array(getattr(pencil, key), dtype=float) for key in "MCKB")


@given(random_vehicles())
def test_matrices_are_symmetric_and_give_no_energy(vehicle: vehicles.AnyVehicle) -> None:
    pencil = checked_pencil(vehicle.pencil)
    for matrix in arrays(pencil)[:3]:
        assert (matrix == matrix.T).all()
        assert np.linalg.eigvalsh(matrix).min() > -1e-9 * (1 + abs(matrix).max())
    assert len(pencil.names) == len(set(pencil.names)) == pencil.size
    assert list(pencil.places) == sorted(pencil.places)


@given(random_vehicles())
def test_rigid_motion_costs_no_spring_and_has_the_whole_mass(vehicle: vehicles.AnyVehicle) -> None:
    """Heave and pitch about the middle: no spring or damper is stretched, the contacts move as rigid points."""
    pencil = vehicle.pencil
    M, C, K, B = arrays(pencil)
    heave, pitch = (np.array([_rigid(vehicle, name, kind) for name in pencil.names]) for kind in ("heave", "pitch"))
    places = np.array([float(x) for x in pencil.places])
    for motion, contact in ((heave, 1 + 0 * places), (pitch, places)):
        assert abs(K @ motion).max() < 1e-9
        assert abs(C @ motion).max() < 1e-9
        assert np.allclose(B.T @ motion, contact)
    assert heave @ M @ heave == pytest.approx(float(_mass(vehicle)))


def _mass(vehicle: Any) -> Fraction:
    if isinstance(vehicle, vehicles.Coach):
        return vehicle.body + 2 * _mass(vehicle.bogie)
    if isinstance(vehicle, vehicles.Bogie):
        return 2 * vehicle.wheel + vehicle.frame + (vehicle.body or 0)
    return vehicle.M if isinstance(vehicle, vehicles.Mass) else vehicle.wheel + vehicle.body


def _rigid(vehicle: Any, name: str, kind: str) -> float:
    """How a named coordinate moves in a heave or a pitch of the whole vehicle as one rigid body."""
    if "pitch" in name:
        return float(kind == "pitch")
    if kind == "heave":
        return 1.0
    bogie = vehicle.bogie if isinstance(vehicle, vehicles.Coach) else vehicle
    place = 0.0
    if isinstance(vehicle, vehicles.Coach) and "bogie" in name:
        place += float(vehicle.pivots) / 2 * (-1 if "rear bogie" in name else 1)
    if isinstance(bogie, vehicles.Bogie) and "wheel" in name:
        place += float(bogie.wheelbase) / 2 * (-1 if name.startswith("rear") else 1)
    return place


def test_the_signatures() -> None:
    """Names and order of the arguments are public."""
    assert {model: " ".join(quantities(model)) for model in vehicles.CATALOGUE} == {
        vehicles.Mass: "M",
        vehicles.Oscillator: "wheel body k c k_contact",
        vehicles.Bogie: "wheel frame inertia wheelbase k c k_contact body k2 c2",
        vehicles.Coach: "body inertia bogie pivots k2 c2",
        vehicles.Vehicle: "M C K B places k_contact names",
    }
    assert {vehicle.name for vehicle in TYPICAL.values()} == TYPICAL.keys()


def test_names_and_contacts_of_a_coach() -> None:
    pencil = TYPICAL["coach"].pencil
    assert pencil.names == (
        "rear wheel of the rear bogie", "front wheel of the rear bogie", "frame bounce of the rear bogie",
        "frame pitch of the rear bogie", "rear wheel of the front bogie", "front wheel of the front bogie",
        "frame bounce of the front bogie", "frame pitch of the front bogie", "body bounce", "body pitch",
    )  # fmt: skip
    assert [float(x) for x in pencil.places] == [-10.78, -8.22, 8.22, 10.78]


def test_a_contact_spring_is_a_compliance() -> None:
    assert TYPICAL["bogie"].pencil.h == (Fraction(1, 1_400_000_000),) * 2
    assert TYPICAL["coach"].pencil.h == (0,) * 4


ONE = {"M": [[1]], "C": [[0]], "K": [[0]], "B": [[1]], "places": [0]}
TWO = {"M": [[1, 0], [0, 1]], "C": [[0, 0], [0, 0]], "K": [[1, -1], [-1, 1]], "B": [[1], [0]], "places": [0]}


@pytest.mark.parametrize(
    ("model", "values", "key", "said"),
    [
        (vehicles.Mass, {"M": 0}, "M", "above 0"),
        (vehicles.Oscillator, {"wheel": 1, "body": 1}, "k", "carries the body"),
        (vehicles.Oscillator, {"wheel": 1, "body": 1, "k": 1, "k_contact": 0}, "k_contact", "above 0"),
        (vehicles.Bogie, BOGIE | {"k": 0, "c": 0}, "k", "carries the frame"),
        (vehicles.Bogie, BOGIE | {"body": 1}, "k2", "carries the body: .*, or add its mass to the frame's"),
        (vehicles.Bogie, BOGIE | {"k2": 1}, "body", "missing"),
        (vehicles.Coach, {"body": 1, "inertia": 1, "bogie": 5, "pivots": 1, "k2": 1}, "bogie", "of type int"),
        (vehicles.Coach, {"body": 1, "inertia": 1, "bogie": TYPICAL["bogie"], "pivots": 1, "k2": 1}, "bogie", "own"),
        (vehicles.Coach, {"body": 1, "inertia": 1, "bogie": vehicles.Bogie(**BOGIE), "pivots": 1}, "k2", "carries"),
        (vehicles.Vehicle, ONE | {"M": [[-1]]}, "M", "semidefinite"),
        (vehicles.Vehicle, ONE | {"M": [[1, 2]]}, "M", "1 × 1"),
        (vehicles.Vehicle, ONE | {"M": "1"}, "M", "list of rows"),
        (vehicles.Vehicle, ONE | {"M": [["x"]]}, "M[1][1]", "not a number"),
        (vehicles.Vehicle, ONE | {"places": []}, "places", "empty"),
        (vehicles.Vehicle, ONE | {"B": [[0]]}, "K", "free to move"),
        (vehicles.Vehicle, ONE | {"B": [[1, 0]], "places": [0, 1]}, "B", "contact 2"),
        (vehicles.Vehicle, ONE | {"names": ["a", "b"]}, "names", "2 names for 1"),
        (vehicles.Vehicle, ONE | {"names": "a"}, "names", "list of texts"),
        (vehicles.Vehicle, TWO | {"K": [[1, -1], [-2, 1]]}, "K", "symmetric"),
        (vehicles.Vehicle, TWO | {"K": [[1, -2], [-2, 1]]}, "K", "semidefinite"),
        (vehicles.Vehicle, TWO | {"K": [[1, 0], [0, 0]]}, "K", "coordinate 2 free"),
        (vehicles.Vehicle, TWO | {"M": [[1, 0], [0, 0]], "K": [[1, 0], [0, 0]]}, "M", "coordinate 2 without mass"),
    ],
)
def test_what_no_vehicle_has_is_refused(model: type, values: dict[str, Any], key: str, said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        model(**values)
    assert caught.value.key == key


def test_a_body_on_a_damper_alone_is_a_vehicle() -> None:
    damped = vehicles.Vehicle(**(TWO | {"K": [[0, 0], [0, 0]], "C": [[1, -1], [-1, 1]]}))
    assert damped.pencil == vehicles.Oscillator(1, 1, 0, 1).pencil.__class__(
        **(vars(vehicles.Oscillator(1, 1, 0, 1).pencil) | {"names": damped.pencil.names})
    )
