"""The whole sheet as certify answers it: which vehicles, which certificate, and forgeries that are refused."""

from __future__ import annotations

import copy
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from forging import as_file

from mpsolve import Effort, InputError, Problem, Status, certify, tracks, vehicles
from mpsolve.certificate import verify2
from mpsolve.certificate.solve import certify_problem
from mpsolve.numbers.rootball import Symmetry
from mpsolve.spectrum.regions import HalfPlane, Rectangle, Sheet
from mpsolve.spectrum.spectrum import Spectrum

PAPER = {"EI": "1/4", "m": 1, "k": 1}


@cache
def answer(v: str = "0.67", c: str = "0.1", masses: int = 2, M: object = 70) -> Spectrum:
    row = [vehicles.Mass(M).at(1.5 * j) for j in range(masses)]
    return certify_problem(Problem(tracks.EulerBernoulli(**PAPER, c=c), row, v=v), region="sheet", digits=20)


def judged(content: dict[str, Any]) -> verify2.Verdict:
    return verify2.verify_bytes(as_file(content))


@pytest.mark.parametrize(("v", "masses", "count", "unstable"), [("0.67", 2, 4, 2), ("1.2", 1, 4, 2), ("0", 2, 4, 0)])
def test_a_damped_beam(v: str, masses: int, count: int, unstable: int) -> None:
    found = answer(v, "0.1", masses)
    assert (found.status, found.count, found.unstable, found.region) == (Status.PROVED, count, unstable, Sheet())
    assert found.certificate.content["version"] == 2
    assert "on the whole physical sheet" in found.verified
    assert "no root lies on the cuts from |Re q| =" in found.closing


def test_a_loop_much_smaller_than_its_place_is_verified() -> None:
    """Strong tension: the two p-roots that meet at the tip of the cut are 10⁹ times smaller than the others."""
    beam = tracks.EulerBernoulli(**PAPER, c="0.4", kp="1e5")
    pair = [vehicles.Mass(40).at(0), vehicles.Mass(40).at("0.02")]
    found = certify_problem(Problem(beam, pair, v="0.7"), region="sheet", digits=15)
    assert (found.status, found.count) == (Status.PROVED, 2)


def test_without_damping_roots_in_the_gap_are_real_and_others_come_in_fours() -> None:
    slow, fast = answer("0.67", "0"), answer("1.2", "0")
    assert (slow.proved, slow.count, slow.unstable) == (True, 4, 0)
    assert {root.symmetry for root in slow.roots} == {Symmetry.REAL}
    assert (fast.proved, fast.count, fast.unstable) == (True, 4, 2)
    q = [complex(root.q.mid()) for root in fast.roots]
    assert sorted(q, key=str) == pytest.approx(sorted((x.conjugate() for x in q), key=str), abs=1e-15)


def test_the_unstable_part_of_an_undamped_beam() -> None:
    row = [vehicles.Mass(70), vehicles.Mass(70).at("1.5")]
    found = certify(Problem(tracks.EulerBernoulli(**PAPER), row, v="1.2"), region="unstable", digits=15)
    assert (found.proved, found.count, found.region) == (True, 2, HalfPlane())
    assert all(root.q.imag < 0 for root in found.roots)


def test_other_vehicles() -> None:
    """Without damping any vehicle of springs and masses; with it a theorem is known for masses only."""
    sprung = vehicles.Oscillator(wheel=1, body=20, k=2, c=0)
    found = certify(Problem(tracks.EulerBernoulli(**PAPER), [sprung], v="0.5"), region="sheet", digits=15)
    assert (found.proved, found.unstable) == (True, 0)
    with pytest.raises(InputError, match=r"region: .*more than masses on the beam.*give"):
        certify(Problem(tracks.EulerBernoulli(**PAPER, c="0.1"), [sprung], v="0.5"), region="sheet")
    damped = vehicles.Oscillator(wheel=1, body=20, k=2, c=1)
    with pytest.raises(InputError, match="the vehicle has dampers"):
        certify(Problem(tracks.EulerBernoulli(**PAPER), [damped], v="0.5"), region="sheet")
    with pytest.raises(InputError, match="a closed curve"):
        certify(Problem(tracks.EulerBernoulli(**PAPER, c=3), [vehicles.Mass(1)], v="0.5"), region="sheet")


@pytest.mark.parametrize("region", ["unstable", "sheet", None])
def test_dampers_on_an_undamped_beam_are_refused_with_what_is_decided(region: object) -> None:
    damped = vehicles.Oscillator(wheel=30, body=20, k=1, c="0.3")
    problem = Problem(tracks.EulerBernoulli(**PAPER), damped, v="1.2")
    with pytest.raises(InputError, match=r"the vehicle has dampers, .* Rectangle with im_max < 0"):
        certify_problem(problem, region=region)
    found = certify_problem(problem, region=Rectangle(-1, 1, -1, "-0.001"), digits=15)
    assert (found.status, found.unstable) == (Status.PROVED, 4)


def test_masses_at_one_place_are_one() -> None:
    row = [vehicles.Mass(30), vehicles.Mass(40), vehicles.Mass(70).at("1.5")]
    found = certify(Problem(tracks.EulerBernoulli(**PAPER, c="0.1"), row, v="0.67"), region="sheet", digits=20)
    assert found.proved
    for one, other in zip(found.roots, answer().roots, strict=True):
        assert one.q.overlaps(other.q)


@pytest.mark.parametrize(
    ("c", "v", "box", "count"),
    [
        ("0.1", "0.67", ("-0.3", "0.3", "-0.1", "0.3"), 4),  # across the line, in the gap
        ("0.1", "0.67", ("-0.4", "0.4", "0.05", "1"), 0),  # from the line on
        ("0.1", "1.2", ("-1", "1", "0.06", "2"), 2),  # above the joined cuts
        ("0.1", "1.2", ("0.001", "1", "-2", "0.049"), 1),
        ("0", "1.2", ("0.01", "1", "0.01", "2"), 1),
        ("0", "0.67", ("0.14", "0.3", "-0.1", "0.3"), 1),
    ],
)
def test_rectangles_beside_the_cuts(c: str, v: str, box: tuple[str, ...], count: int) -> None:
    row = [vehicles.Mass(70), vehicles.Mass(70).at("1.5")]
    problem = Problem(tracks.EulerBernoulli(**PAPER, c=c), row, v=v)
    found = certify(problem, region=Rectangle(*box), digits=15)
    assert (found.status, found.count) == (Status.PROVED, count)
    inside = [
        root.q
        for root in answer(v, c).roots
        if float(box[0]) < float(root.q.real) < float(box[1]) and float(box[2]) < float(root.q.imag) < float(box[3])
    ]
    assert len(inside) == count
    forged = copy.deepcopy(found.certificate.content)
    if float(box[3]) < 0.05 and float(c) > 0:  # below the cuts no half needs to be named
        assert forged["theorem"] is None
        return
    forged["theorem"]["half"] = "upper" if forged["theorem"]["half"] == "lower" else "lower"
    assert not judged(forged).valid


@pytest.mark.parametrize(
    ("c", "N", "words", "height"),
    [
        ("2.4", "0", "closed curve down to Im q = 0.536675", "0.53667"),
        ("1.8", "0.8", "closed curve down to Im q = 0.229179", "0.22917"),
        ("2", "0", "damped exactly critically", "0.99999"),
    ],
)
def test_waves_that_do_not_vibrate_leave_no_two_sides(c: str, N: str, words: str, height: str) -> None:
    """The refusal names the curve that they are cut along, and what is proved instead."""
    problem = Problem(tracks.EulerBernoulli(**PAPER, c=c, N=N), [vehicles.Mass(5)], v="0.5")
    with pytest.raises(InputError, match=words) as refused:
        certify(problem, region="sheet")
    assert f'ask for "unstable", or for ("below", h) give h up to {height}' in str(refused.value)
    assert certify(problem, region=("below", float(height) * 0.9), digits=15).proved
    assert certify(problem, region="unstable", digits=15).stable


@pytest.mark.parametrize(("eta", "N", "z"), [(1.2, 0.0, 0.1), (0.9, 0.8, 0.55)])
def test_inside_that_curve_other_numbers_of_waves_run_ahead(eta: float, N: float, z: complex) -> None:
    def ahead(z: complex, v: float = 0.5) -> int:
        q = np.array([-v, z + 1j * eta])  # Ω over p
        D = np.polyadd(np.polyadd([0.25, 0, -N, 0, 1], -np.polymul(q, q)), 2j * eta * q)
        return int((np.roots(D).imag > 0).sum())

    assert [ahead(z + 0.2j), ahead(z - 0.2j), ahead(z + 3j), ahead(z - 3j)] == [1, 3, 2, 2]


def test_a_rectangle_across_a_cut_is_refused() -> None:
    row = [vehicles.Mass(70), vehicles.Mass(70).at("1.5")]
    with pytest.raises(InputError, match="beyond the gap of the cuts"):
        certify(Problem(tracks.EulerBernoulli(**PAPER, c="0.1"), row, v="0.67"), region=Rectangle(-1, 1, -1, 1))


@pytest.mark.parametrize(
    ("c", "v", "evaluations", "code", "words"),
    [("0.1", "0.67", 40, "effort", 'or ask for "unstable"'), ("0", "1", None, "sheet", 'ask for "unstable"')],
)
def test_what_stays_open_says_why(c: str, v: str, evaluations: int | None, code: str, words: str) -> None:
    problem = Problem(tracks.EulerBernoulli(**PAPER, c=c), [vehicles.Mass(70)], v=v)
    effort = None if evaluations is None else Effort(evaluations=evaluations)
    found = certify(problem, region="sheet", digits=15, effort=effort)
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == code
    assert words in found.reason.remedy
    assert certify(problem, region="unstable", digits=15, check=False).proved  # the remedy


# --- forgeries ---------------------------------------------------------------------------------------------


def _theorem(**changed: Any) -> Callable[[dict[str, Any]], None]:
    return lambda content: content["theorem"].update(changed)


def _no_loop(content: dict[str, Any]) -> None:
    content["theorem"]["lower"] = []


def _one_round(content: dict[str, Any]) -> None:
    loop = content["theorem"]["lower"][0]
    loop["points"] = loop["points"][: len(loop["points"]) // 2 + 1]


def _other_way(content: dict[str, Any]) -> None:
    content["theorem"]["lower"][0]["points"].reverse()


def _wide_disc(content: dict[str, Any]) -> None:
    content["theorem"]["lower"][0]["radius"][1] -= 8


def _beside(content: dict[str, Any]) -> None:
    edge = content["paths"][2]["points"]
    edge.insert(1, [edge[0][0] * 2 + edge[1][0] * 0, -1, edge[0][2] - 1])


def _less(content: dict[str, Any]) -> None:
    content["claim"]["count"] -= 2
    content["roots"].pop()


def _more_mass(content: dict[str, Any]) -> None:
    content["equations"]["vehicle"]["M"][0][0] = "71"


def _damper(content: dict[str, Any]) -> None:
    content["equations"]["vehicle"]["C"][0][0] = "1"


def _shorter(content: dict[str, Any]) -> None:
    """The last turn ends next to where it begins."""
    x, _, e = content["paths"][-1]["points"][0]
    content["paths"][-1]["points"][1:] = [[x * 2**20 + 2**10, 0, e - 20]]


def _shorter_below(content: dict[str, Any]) -> None:
    lower = 1 + len(content["theorem"]["lower"])
    content["paths"][lower]["points"] = content["paths"][lower]["points"][:1]


def _wall(content: dict[str, Any]) -> None:
    x, _, e = content["paths"][-1]["points"][-1]
    content["paths"][-1]["points"].append([x, -x, e])


def _not_joined(content: dict[str, Any]) -> None:
    content["paths"][2]["points"].pop(0)


FORGERIES: dict[str, tuple[str, Callable[[dict[str, Any]], None]]] = {
    "the theorem begins too soon": ("0.67", _shorter),
    "the theorem begins between branch points": ("1.2", _shorter_below),
    "a wall below the line": ("0.67", _wall),
    "a begin beyond the gap": ("0.67", _theorem(begin=[1, -1])),
    "an end that is not passive": ("1.2", _theorem(end=[1, -1])),
    "an end before the begin": ("0.67", _theorem(end=[0, 0])),
    "no loop": ("0.67", _no_loop),
    "half a loop": ("0.67", _one_round),
    "a loop the other way": ("0.67", _other_way),
    "a disc that the loop leaves": ("0.67", _wide_disc),
    "a path beside the edge": ("0.67", _beside),
    "a path that leaves something out": ("0.67", _not_joined),
    "a root too few": ("0.67", _less),
    "another mass": ("0.67", _more_mass),
    "a damper": ("0.67", _damper),
    "an upper path too short": ("1.2", lambda content: content["paths"][-1]["points"].pop()),
    "no loop above": ("1.2", lambda content: content["theorem"].update(upper=[])),
    "no path above": ("1.2", lambda content: content.update(paths=content["paths"][:3])),
}


@pytest.mark.parametrize("name", FORGERIES)
def test_a_forgery_is_refused(name: str) -> None:
    v, change = FORGERIES[name]
    content = copy.deepcopy(answer(v).certificate.content)
    assert judged(content).valid
    change(content)
    found = judged(content)
    assert not found.valid
    assert not found.reason.startswith("malformed")


def test_without_damping_the_gap_is_left_nowhere() -> None:
    """A count that closes where it begins would miss roots between there and the branch point."""
    content = copy.deepcopy(answer("0.67", "0").certificate.content)
    content["theorem"] |= {"end": content["theorem"]["begin"], "lower": []}
    content["paths"] = content["paths"][:2]
    assert "the path ends on the cut" in judged(content).reason


def test_every_track_parameter_matters() -> None:
    """A changed coefficient of the beam leaves the roots where they are not."""
    for place, value in ((0, "1001/1000"), (1, "11/100"), (2, "99/100"), (3, "26/100")):
        content = copy.deepcopy(answer().certificate.content)
        content["equations"]["track"]["matrix"][0][0][place][2] = value
        assert not judged(content).valid


def test_masses_that_hardly_feel_each_other_are_verified() -> None:
    """At a root of one of them its row of the matrix is nearly 0, and what couples it to the others is small too."""
    row = [vehicles.Mass(M).at(x) for M, x in (("53.9", 0), ("0.125", "21.9"), ("0.888", "31.32"))]
    track = tracks.EulerBernoulli(**PAPER, c="0.002", kp="0.083")
    found = certify_problem(Problem(track, row, v="0.01"), region="sheet", digits=20)
    assert (found.status, found.count) == (Status.PROVED, 6)
