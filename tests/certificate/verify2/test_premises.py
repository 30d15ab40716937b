"""What the verifier asks of tracks and vehicles: at rest a false file would be believed without any one of these."""

from __future__ import annotations

import copy
import json
from functools import cache

import planner as p
import pytest
from flint import fmpq, fmpq_mat
from forging import as_file

from mpsolve.certificate import verify2 as v2

BEAM = p.beam("1/4", 1, 1, "1/10")
PAIR = p.masses([40, 40], [0, "3/2"])


@cache
def made():
    """A claim that needs no path: on a passive track at rest nothing grows."""
    return json.dumps(p.plan(p.equations(BEAM, 0, PAIR), {"kind": "unstable"}))


def reason(track=BEAM, car=PAIR, basis=None):
    value = json.loads(made()) | {"equations": p.equations(track, 0, car), "basis": basis}
    return v2.verify_bytes(as_file(value)).reason


def test_the_file_itself_is_valid():
    assert reason() == ""


def rows(*entries):
    size = round(len(entries) ** 0.5)
    return {"matrix": [[p.poly(*x) for x in entries[k : k + size]] for k in range(0, size**2, size)], "loaded": 0}


RAIL = ((4, 0, 1), (0, 2, 1), (0, 1, 1), (0, 0, 3))
BELOW = ((0, 2, 1), (0, 1, 1), (0, 0, 2))
TRACKS = {
    "it pulls more than it is pulled": (rows(RAIL, [(0, 0, -1)], [(0, 0, "-1/2")], BELOW), "not symmetric"),
    "a push ahead only": (rows([*RAIL, (1, 0, 1)]), "not even in P"),
    "a receptance that does not decay in P": (
        rows(BELOW, [(0, 0, -1)], [(0, 0, -1)], [*BELOW, (2, 0, -1)]),
        "not decay as 1/p²",
    ),
    # N/D tends to −1/(P⁴ + 1): a heavy mass runs away from its place
    "no inertia under the load, and a negative spring": (
        rows([(4, 0, -1), (0, 0, -1)], [(0, 0, 1)], [(0, 0, 1)], [(0, 2, 1), (0, 1, 1), (0, 0, 1)]),
        "does not decay in frequency",
    ),
    "no equation": ({"matrix": [], "loaded": 0}, "no equations"),
    "no force moves it": (rows(RAIL, [(0, 0, -1)], [(0, 0, -1)], []), "determinant or cofactor vanishes"),
    "two rows alike": (rows(RAIL, [(0, 0, -1)], RAIL, [(0, 0, -1)]), "determinant or cofactor vanishes"),
    "high powers": (rows([*RAIL, (12, 6, 1)], [], [], [*BELOW, (12, 6, 1)]), "too high a degree"),
}


@pytest.mark.parametrize("name", TRACKS)
def test_a_track_is_refused(name):
    track, why = TRACKS[name]
    assert why in reason(track)


def test_a_term_that_stands_twice_is_refused():
    track = copy.deepcopy(BEAM)
    track["matrix"][0][0].append(track["matrix"][0][0][0])
    assert "stands twice" in reason(track)


def bodies(M, B, K=None, places=(0, "3/2"), h=(0, 0)):
    none = [[0] * len(M)] * len(M)
    return p.vehicle(M, none, K or none, B, places, h)


UNIT, DIAGONAL = [[1, 0], [0, 1]], [[40, 0], [0, 40]]
NOTHING = [[0, 0], [0, 0]]
VEHICLES = {
    "a body that nothing moves": (bodies([[40, 0], [0, 0]], [[1, 1], [0, 0]], h=(1, 1)), "no mass, spring or damper"),
    "two rigid contacts at one place": (bodies([[40]], [[1, 1]], places=(0, 0)), "share a force"),
    "a spring below 0": (bodies(DIAGONAL, UNIT, [[1, 0], [0, -1]]), "not symmetric and positive semidefinite"),
    "a spring that pulls one end only": (bodies(DIAGONAL, UNIT, [[2, -1], [0, 2]]), "not symmetric and positive"),
    "a compliance below 0": (bodies(DIAGONAL, UNIT, h=("-1/2", 0)), "compliance may be negative"),
    "no body": (bodies([], [], places=(0,), h=(0,)), "no body or no contact"),
    "no contact": (bodies([[40]], [[]], places=(), h=()), "no body or no contact"),
}


@pytest.mark.parametrize("name", VEHICLES)
def test_a_vehicle_is_refused(name):
    car, why = VEHICLES[name]
    assert why in reason(car=car)


def basis(matrix, neutral=0, unfelt=0):
    return {"matrix": [[str(x) for x in row] for row in matrix], "neutral": neutral, "unfelt": unfelt}


SPRING = bodies(DIAGONAL, [[1, 1], [0, 0]], [[2, -2], [-2, 2]], h=(1, 1))
ALONE = bodies(DIAGONAL, [[1, 1], [0, 0]], [[2, 0], [0, 2]], h=(1, 1))
BASES = {
    "a body left out": (PAIR, basis([[1, 0], [0, 0]], unfelt=1), "basis is singular"),
    "more coordinates than there are": (bodies(DIAGONAL, NOTHING), basis(UNIT, 2, 2), "too many coordinates"),
    "an unfelt mass on the track": (PAIR, basis(UNIT, unfelt=1), "carries a contact"),
    "a neutral mass on the track": (PAIR, basis(UNIT, neutral=1), "carries a contact"),
    "an unfelt mass on a spring to the other": (SPRING, basis(UNIT, unfelt=1), "are coupled"),
    "a neutral mass on a spring": (ALONE, basis(UNIT, neutral=1), "has a spring"),
}


@pytest.mark.parametrize("name", BASES)
def test_coordinates_that_are_not_what_they_are_called_are_refused(name):
    car, named, why = BASES[name]
    assert why in reason(car=car, basis=named)


def test_coordinates_that_are_what_they_are_called():
    assert reason(car=ALONE, basis=basis(UNIT, unfelt=1)) == ""
    assert reason(car=bodies(DIAGONAL, [[1, 1], [0, 0]], h=(1, 1)), basis=basis(UNIT, neutral=1)) == ""


def test_a_theorem_that_is_not_needed_is_refused():
    value = json.loads(made()) | {"theorem": {"half": "lower"}}
    assert "no theorem is needed" in v2.verify_bytes(as_file(value)).reason


def test_a_kind_that_is_not_known_is_refused():
    value = json.loads(made()) | {"kind": "sums"}
    assert "kind is not known" in v2.verify_bytes(as_file(value)).reason


@pytest.mark.parametrize("c", [-3, -1, 0, 1, 3])
def test_where_the_highest_coefficient_vanishes_in_the_region_a_p_root_is_real(c):
    """y(s² + cs + 1) + (s + 1)⁴ at y = p²: short waves come near the roots of s² + cs + 1; with c = 0 to the rim."""
    s = v2.S_
    assert v2.damped((s + 1) ** 4 - v2.P_**2 * (s**2 + c * s + 1), True) is (c >= 0)


# --- bounds of work ------------------------------------------------------------------------------------------


def test_numbers_are_not_longer_than_that_can_be_worked_with():
    one = {"re": "0x1", "exponent": 1100, "radius": [1, -65_000]}
    assert v2.read_ball(one, "re", "a ball")[2] == 66_101
    with pytest.raises(v2.Refused, match="too many digits"):
        v2.read_ball(one | {"radius": [1, -69_999]}, "re", "a ball")
    rows = [["1"] * 30] * 30
    assert v2.matrix(rows, 30, 30, "M") == fmpq_mat(30, 30, [1] * 900)
    with pytest.raises(v2.Refused, match="too many digits"):
        v2.matrix([["9" * 120] * 30, *rows[1:]], 30, 30, "M")


def test_polynomials_in_many_parameters_are_not_expanded_for_ever():
    unit = ((fmpq(0), fmpq(1)),)
    assert len(v2.bernstein({(4,) * 6: fmpq(1)}, unit * 6, fmpq_mat)) == 5**6
    with pytest.raises(v2.Refused, match="too high degrees"):
        v2.bernstein({(4,) * 7: fmpq(1)}, unit * 7, fmpq_mat)


def test_equations_that_are_too_long_are_refused(monkeypatch):
    monkeypatch.setattr(v2, "MAX_SIZE", 2)
    assert reason(BEAM) == ""
    assert "too long" in reason(p.two_layer(1, 1, 1, 1, 1, 1, 1))


def test_the_work_of_all_pieces_is_bounded():
    walker = v2.Walker(None, None)
    walker.spend(v2.MAX_WORK / 2)
    with pytest.raises(v2.Refused, match="more work"):
        walker.spend(v2.MAX_WORK / 2 + 1)


TERMS = [[i, j, [[1, "1"], [0, "1"]]] for i in range(5) for j in range(6)]


@pytest.mark.parametrize(
    ("matrix", "why"),
    [
        ([[TERMS[:1]]], None),
        ([[TERMS]], None),
        ([[TERMS, TERMS], [TERMS[:1], TERMS[:1]]], "too many terms"),
        ([[[[0, 0, [[1, "1"], [1, "2"]]]]]], "a power stands twice"),
        ([[[[0, 0, [[1, "0"]]]]]], "a coefficient is 0"),
    ],
)
def test_tracks_with_a_parameter(matrix, why):
    if why is None:
        assert v2.read_rows({"matrix": matrix, "loaded": 0}, 1)[2] == 0
    else:
        with pytest.raises(v2.Refused, match=why):
            v2.read_rows({"matrix": matrix, "loaded": 0}, 1)


def test_determinants_with_parameters_are_not_too_long():
    ring, rows, loaded = v2.read_rows({"matrix": [[[[4, 0, "1"], [0, 6, "1"]]]], "loaded": 0}, 1)
    assert v2.dispersion(ring, rows, loaded)[0]
    s = ring.gens()[1]
    with pytest.raises(v2.Refused, match="determinant is too long"):
        v2.dispersion(ring, [[rows[0][0] * s**3]], loaded)


def test_matrices_are_linear_in_each_parameter():
    both, square = [[[1, 1, "2"]]], [[[2, 0, "2"]]]
    assert v2.read_matrix([both], 1, 2, "K") == {(1, 1): fmpq_mat(1, 1, [2])}
    with pytest.raises(v2.Refused, match="not linear"):
        v2.read_matrix([square], 1, 2, "K")


@pytest.mark.parametrize(
    ("h", "low", "fine"),
    [
        ([[1, "1"]], 1, True),
        ([[1, "1"]], -1, False),
        ([[-1, "1"]], 0, False),
        ([[0, "1"]], -1, True),
        ("0", -1, True),
    ],
)
def test_compliances_with_a_parameter_are_not_below_0(h, low, fine):
    """θ, 1/θ, 1 and 0 for low ≤ θ ≤ 2."""
    car = bodies([[40]], [[1]], places=(0,), h=(0,)) | {"compliances": [h]}
    box = ((fmpq(low), fmpq(2)),)
    if fine:
        assert v2.read_bodies(car, None, box, 9, 9).h
    else:
        with pytest.raises(v2.Refused, match="compliance may be negative, or infinite"):
            v2.read_bodies(car, None, box, 9, 9)
