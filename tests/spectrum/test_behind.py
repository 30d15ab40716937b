"""Faster than all waves of the track a vehicle with one place feels nothing of it, as if the rail did not move."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest
from forging import as_file

from mpsolve import Problem, Status, certify, receptance, tracks, vehicles
from mpsolve.certificate.verify2 import verify_bytes
from mpsolve.characteristic.start import start
from mpsolve.problem.reduced import reduce_problem
from mpsolve.report.spectrum_words import verdict
from mpsolve.spectrum.behind import BEHIND, all_behind
from mpsolve.spectrum.regions import Below, HalfPlane

WIRE = tracks.String(T=1, m=1, k=1, c="0.1")  # waves at 1
RAIL = tracks.Timoshenko(EI=1, m=1, S=4, J="0.1", k=1, c="0.1")  # 2 and √10
MASS, BOGIE = vehicles.Mass(10), vehicles.Bogie(wheel=1, frame=1, inertia=1, wheelbase=1, k=1)
CAR = vehicles.Oscillator(wheel=1, body=2, k=3, c="0.1")
SOFT = vehicles.Oscillator(wheel=1, body=1, k=1, k_contact=5)


def told(track: Any, placed: Any, v: object) -> bool:
    reduced = reduce_problem(Problem(track, placed, v=v))
    return all_behind(reduced, start(reduced.guide))


def test_the_theorem_asks_for_waves_behind_and_one_place() -> None:
    assert told(WIRE, [MASS, CAR, SOFT], "1.5")
    assert told(RAIL, CAR, 4)
    assert not told(WIRE, MASS, "0.9")
    assert not told(RAIL, MASS, 3)  # the bending waves run ahead
    assert not told(WIRE, BOGIE, "1.5")
    assert not told(WIRE, [MASS, MASS.at(5)], "1.5")


def test_a_force_that_a_rail_at_rest_does_not_tell() -> None:
    """Two tight contacts at one place that press a body from both sides: on this track nothing tells their forces."""
    pressed = vehicles.Vehicle(M=[[1]], C=[[0]], K=[[0]], B=[[1, -1]], places=[0, 0])
    assert not told(WIRE, pressed, "1.5")


@pytest.mark.parametrize(("track", "v"), [(WIRE, "1.5"), (RAIL, 4)], ids=["wire", "rail"])
def test_nothing_is_felt_ahead(track: Any, v: object) -> None:
    G = receptance(track, xi=[-0.5, 0, 0.5], omega=[0.3, 2], v=v)
    assert np.abs(G[1:]).max() < 1e-14
    assert np.abs(G[0]).min() > 1e-3


@pytest.mark.parametrize("placed", [MASS, SOFT, [SOFT, CAR], [MASS, MASS]])
@pytest.mark.parametrize(("track", "v"), [(WIRE, "1.5"), (RAIL, 4)], ids=["wire", "rail"])
def test_the_whole_half_plane_is_proved(track: Any, v: object, placed: Any) -> None:
    found = certify(Problem(track, placed, v=v), region="unstable", digits=15)
    assert (found.status, found.count, found.region, found.note) == (Status.PROVED, 0, HalfPlane(), "")
    assert (found.stable, found.closing) == (True, BEHIND)
    assert "need not decay" in verdict(found)  # a soft contact swings for ever


def test_below_a_height_the_roots_are_those_of_the_cars_on_a_rigid_rail() -> None:
    other = vehicles.Oscillator(wheel=3, body=5, k=1, c="0.2")
    found = certify(Problem(WIRE, [CAR, other], v="1.5"), digits=15)
    assert found.stable
    assert isinstance(found.region, Below)
    assert found.region.radius is None
    alone = [*np.roots([-2, 0.1j, 3]), *np.roots([-5, 0.2j, 1])]  # k + iqc − q² body: the wheels are held
    near = [complex(root.q.mid()) for root in found.roots]
    assert np.abs(np.sort_complex(near) - np.sort_complex(alone)).max() < 1e-12
    for root in found.roots:
        still = [abs(y) for name, y in root.shape.bodies.items() if "wheel" in name]
        assert len(still) == 2
        assert max(map(float, still)) < 1e-9


def test_a_bogie_hands_on_what_its_rear_wheel_feels() -> None:
    found = certify(Problem(WIRE, BOGIE, v="1.5"), region="unstable", digits=15)
    assert (found.status, found.unstable) == (Status.PROVED, 2)
    assert found.region.radius is not None


@pytest.mark.parametrize("region", ["unstable", ("below", "0.03")])
def test_the_verifier_takes_it_for_no_other_problem(region: Any) -> None:
    content = certify(Problem(WIRE, [MASS, CAR], v="1.5"), region=region, digits=15).certificate.content
    assert verify_bytes(as_file(content)).valid

    def refused(*path: Any, value: Any) -> str:
        forged = copy.deepcopy(content)
        at = forged
        for key in path[:-1]:
            at = at[key]
        at[path[-1]] = value
        return str(verify_bytes(as_file(forged)).reason)

    vehicle = ("equations", "vehicle")
    assert "waves run ahead" in refused("equations", "velocity", value="1/2")
    assert "several places" in refused(*vehicle, "places", value=["0", "1"])
    assert "cut" in refused("equations", "track", "matrix", 0, 0, 1, value=[0, 1, "0"])
    claim = content["claim"]["region"]
    disc = {"kind": "disc", "radius": "3"} if region == "unstable" else {**claim, "kind": "below disc"}
    assert refused("claim", "region", value={k: x for k, x in disc.items() if k != "reach"} | {"radius": "3"})


def test_the_verifier_wants_forces_that_a_rail_at_rest_tells() -> None:
    content = certify(Problem(WIRE, [MASS, MASS], v="1.5"), region="unstable", digits=15).certificate.content
    content = copy.deepcopy(content)
    content["equations"]["vehicle"] |= {"B": [["1", "-1"], ["0", "0"]]}
    assert "does not determine" in str(verify_bytes(as_file(content)).reason)
