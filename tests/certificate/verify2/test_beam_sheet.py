"""The whole sheet of a beam: forged files and made-up numbers that one check alone stands against."""

from __future__ import annotations

import planner as p
import pytest
from flint import acb, fmpq
from forging import as_file, stored

from mpsolve.certificate import verify2 as v2


def reason(value):
    return v2.verify_bytes(as_file(value)).reason


def sheet(track=None, velocity="9/10", car=None):
    eq = p.equations(track or p.beam("1/4", 1, 1, "1/10"), velocity, car or p.masses([70], [0]))
    return v2.Sheet.of(v2.read_track(eq["track"], eq["velocity"]), v2.read_vehicle(eq["vehicle"], None))


# --- the track ------------------------------------------------------------------------------------------------

PULLED = [[0, 0, "-1"], [0, 2, "-1"], [4, 0, "-1/4"]]
ENTRIES = [(2, 0, "1/4")], [(0, 2, -1), (0, 0, -1)], [(0, 0, 1)], [(2, 0, 1), (0, 0, 1)]  # D is a beam's, N = P² + 1
SHIFTED = {"matrix": [[p.poly(*x) for x in ENTRIES[k : k + 2]] for k in (0, 2)], "loaded": 0}
TRACKS = {
    "damped in itself": (p.beam("1/4", 1, 1, "1/10", eta="1/10"), "one layer only"),
    "loaded through something else": (SHIFTED, "one layer only"),
    "on two layers": (p.two_layer("1/4", 1, 1, "1/10", 1, 1, "1/10"), "one layer only"),
    "pushed where it is loaded": ({"matrix": [[PULLED, []], [[], [[0, 0, "-1"]]]], "loaded": 0}, "one layer only"),
    "overdamped": (p.beam("1/4", 1, 1, 3), "do not lie on one line"),
    "damped below 0": (p.beam("1/4", 1, 1, "-1/10"), "do not lie on one line"),
    "buckled": (p.beam("1/4", 1, 1, "1/10", N=2), "do not lie on one line"),
}


@pytest.mark.parametrize("name", TRACKS)
def test_another_track_is_refused(name):
    track, why = TRACKS[name]
    with pytest.raises(v2.Refused, match=why):
        sheet(track)


def test_neutral_coordinates_are_refused():
    eq = p.equations(
        p.beam("1/4", 1, 1, 0), 1, p.vehicle([[9, 0], [0, 9]], [[0, 0]] * 2, [[0, 0]] * 2, [[1], [0]], [0], [0])
    )
    car = v2.read_vehicle(eq["vehicle"], {"matrix": [["1", "0"], ["0", "1"]], "neutral": 1, "unfelt": 0})
    with pytest.raises(v2.Refused, match="neutral"):
        v2.Sheet.of(v2.read_track(eq["track"], eq["velocity"]), car)


@pytest.mark.parametrize(
    ("track", "velocity", "why"),
    [
        (p.beam("1/4", 1, 1, 0), "9/10", ""),
        (p.beam("1/4", 1, 1, 0), "11/10", "not undamped and passive"),
        (p.beam("1/4", 1, 1, "1/10"), "9/10", "not undamped and passive"),
        (TRACKS["pushed where it is loaded"][0], "9/10", "one layer only"),
    ],
)
def test_nothing_grows_on_a_slow_undamped_beam_alone(track, velocity, why):
    value = stored("undamped_subcritical") | {
        "equations": p.equations(track, velocity, p.masses([40], [0])),
        "theorem": {"half": "passive"},
        "paths": [],
        "roots": [],
        "claim": {"region": {"kind": "unstable"}, "count": 0, "unstable": 0},
    }
    said = reason(value)
    assert why in said
    assert bool(why) is bool(said)


# --- paths ----------------------------------------------------------------------------------------------------


def _link_elsewhere(c):
    c["paths"][0]["points"].pop()


def _link_from_elsewhere(c):
    del c["paths"][0]["points"][0]


def _link_above(c):
    begin = c["paths"][0]["points"][-1]
    c["paths"][0]["points"] += [[begin[0], 2**12, begin[2]], begin]


def _beyond_the_loop(c):
    c["paths"][1]["points"].append(c["paths"][1]["points"][-2])


def _before_the_end(c):
    """So slow waves are not passive yet."""
    m, _, e = c["paths"][2]["points"][-2]
    c["theorem"]["end"] = [m, e]


def _before_the_begin(c):
    c["theorem"]["begin"] = [-1, -9]


def _on_the_cut(c):
    """From where a p-root is real."""
    m, _, e = c["paths"][2]["points"][1]
    c["theorem"]["begin"] = [m, e]


def _in_the_gap(c):
    c["theorem"]["end"] = c["theorem"]["begin"]


def _beyond_the_end(c):
    c["paths"][2]["points"].append(c["paths"][2]["points"][-2])


def _begins_elsewhere(c):
    del c["paths"][2]["points"][0]


def _a_damper(c):
    c["equations"]["vehicle"]["C"][0][0] = "1"


def _loops_above(c):
    c["theorem"]["upper"] = c["theorem"]["lower"]


def _as_wide_as_far(c):
    c["theorem"]["lower"][0]["radius"] = c["theorem"]["lower"][0]["centre"]


def _a_light_mass(c):
    """Its root is next to the branch point, inside the loop."""
    c["equations"]["vehicle"]["M"][0][0] = "1/2"


FORGERIES = {
    "a link to elsewhere": ("single_mass", _link_elsewhere, "does not lead to where the count begins"),
    "a link from elsewhere": ("single_mass", _link_from_elsewhere, "does not lead to where the count begins"),
    "a link over the line of the cuts": ("single_mass", _link_above, "above the line"),
    "a turn that goes on beyond its loop": ("undamped_supercritical", _beyond_the_loop, "not end where its loop"),
    "a turn that goes on beyond the end": ("undamped_supercritical", _beyond_the_end, "where the count closes"),
    "an end too soon": ("undamped_supercritical", _before_the_end, "not passive beyond the end"),
    "a begin below 0": ("undamped_supercritical", _before_the_begin, "begins or ends elsewhere"),
    "an end before the begin": ("undamped_subcritical", lambda c: c["theorem"].update(end=[0, 0]), "ends elsewhere"),
    "a begin on the cut": ("undamped_supercritical", _on_the_cut, "not begin in the gap"),
    "an end in the gap": ("undamped_subcritical", _in_the_gap, "without damping the path ends on the cut"),
    "a turn that begins elsewhere": ("undamped_supercritical", _begins_elsewhere, "where the one before ends"),
    "a damper without damping of the track": ("undamped_subcritical", _a_damper, "vehicle is not passive"),
    "loops above, and no path there": ("single_mass", _loops_above, "loops without a path"),
    "a loop's disc that reaches 0": ("single_mass", _as_wide_as_far, "no branch point alone"),
    "a root in the loop": ("single_mass", _a_light_mass, "next to a branch point"),
}


@pytest.mark.parametrize("name", FORGERIES)
def test_a_forgery_is_refused(name):
    file, change, why = FORGERIES[name]
    value = stored(file)
    change(value)
    assert why in reason(value)


# --- loops ----------------------------------------------------------------------------------------------------


def point_of(sheet):
    """A number in the ball of the branch point z_b > 0."""
    ((square, _),) = [(z, k) for z, k in v2.meeting(sheet.track) if z.real > 0 and z.imag.contains(0)]
    return v2.no_less(square.sqrt().real.mid())


@pytest.mark.parametrize(
    ("centre", "radius", "why"),
    [(1, fmpq(1, 64), "on the rim"), (2, fmpq(1, 64), "one branch point alone"), (0, 1, "one branch point alone")],
)
def test_a_loop_round_one_branch_point_alone(centre, radius, why):
    """The centre so far from it: in radii."""
    with v2.precision(64):
        beam = sheet()
        loop = v2.Loop(point_of(beam) * bool(centre) + centre * radius, radius, [])
        with pytest.raises(v2.Refused, match=why):
            v2.check_loop(loop, beam.track, 1, None)


def test_three_p_roots_that_meet_are_known_at_rest_only(monkeypatch):
    with v2.precision(64):
        monkeypatch.setattr(v2, "meeting", lambda _: [(acb(1), 3)])
        loop = v2.Loop(fmpq(1), fmpq(1, 2), [(fmpq(1, 2), fmpq(0))] * 2)
        with pytest.raises(v2.Refused, match="more p-roots meet"):
            v2.check_loop(loop, sheet().track, 1, None)
        with pytest.raises(v2.Refused, match="counterclockwise"):
            v2.check_loop(loop, sheet(velocity=0).track, 1, None)


ROUND = [(fmpq(x, 8), fmpq(y, 8)) for x, y in ((4, 0), (8, -4), (12, 0), (8, 4))]  # round 1
WIDER = [(fmpq(4, 8), fmpq(0)), (fmpq(1), fmpq(-5, 8)), *ROUND[2:]]
LOOPS = {
    "once": (ROUND, "as it must"),
    "two rounds that differ": ([*ROUND, *WIDER], "as it must"),
    "four rounds": (ROUND * 4, "as it must"),
    "the other way": ([*ROUND, *ROUND][::-1], "counterclockwise"),
}


@pytest.mark.parametrize("name", LOOPS)
def test_a_loop_goes_twice_round_its_branch_point(monkeypatch, name):
    points, why = LOOPS[name]
    monkeypatch.setattr(v2, "meeting", lambda _: [(acb(1), 2)])
    with v2.precision(64), pytest.raises(v2.Refused, match=why):
        v2.check_loop(v2.Loop(fmpq(1), fmpq(3, 4), [*points, points[0]]), sheet().track, 1, None)


@pytest.mark.parametrize(("points", "back"), [([-1, -1j, 1, 1j, -1], 2), ([-1, 1 - 1j, 1 + 1j, -1], None)])
def test_a_loop_is_below_the_axis_until_it_comes_back_to_it(points, back):
    loop = v2.Loop(fmpq(0), fmpq(2), [(fmpq(int(z.real)), fmpq(int(z.imag))) for z in map(complex, points)])
    if back is not None:
        assert loop.back == back
    else:
        with pytest.raises(v2.Refused, match="below the real axis"):
            _ = loop.back
