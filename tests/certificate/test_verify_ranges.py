"""The verifier of ranges: files that hold, and files in which one thing was changed."""

import copy
import itertools
import json
import re
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from flint import acb, acb_mat, arb, arb_mat, fmpq
from forging import as_file, sealed

from mpsolve import Problem, certify, tracks, vehicles
from mpsolve.certificate import verify_ranges as checker
from mpsolve.certificate.check import verify
from mpsolve.certificate.verify_ranges import (
    NONE,
    Form,
    Place,
    Refused,
    place_over,
    receptances,
    split_over,
    verify_bytes,
)
from mpsolve.numbers.balls import precision

FOLDER = Path(__file__).resolve().parents[2] / "certs" / "ranges"
CROSSING, STABLE, SLOPED = (
    FOLDER / f"{name}.json" for name in ("crossing_over_velocity", "stable_over_damping", "nearly_undamped_d1.5")
)
RAIL = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
Change = Callable[[dict[str, Any]], None]


@pytest.fixture(scope="module")
def content() -> dict[str, Any]:
    return dict(json.loads(CROSSING.read_text("ascii")))


@pytest.mark.parametrize("path", [CROSSING, STABLE, SLOPED])
def test_committed_certificates_hold(path: Path) -> None:
    verdict = verify(path)
    assert verdict.valid, verdict.reason
    assert "roots with Im q < 0" in verdict.claim


def test_it_runs_as_a_plain_script() -> None:
    script = Path(checker.__file__)
    ran = subprocess.run(
        [sys.executable, "-I", str(script), str(STABLE)], capture_output=True, text=True, check=False
    )
    assert ran.returncode != 0  # isolated: verify2.py is not found
    ran = subprocess.run([sys.executable, str(script), str(STABLE)], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert "valid: 0 roots" in ran.stdout


def _drop_crossing(c: dict[str, Any]) -> None:
    c["zeros"], c["claim"] = [], {"counts": [0], "directions": []}
    c["tree"] = c["tree"].replace("z", "n")


def _drop_from_claim(c: dict[str, Any]) -> None:
    c["claim"] = {"counts": [0], "directions": []}


def _turn(c: dict[str, Any]) -> None:
    c["claim"] = {"counts": [0, 2], "directions": [-2]}


def _raise_counts(c: dict[str, Any]) -> None:
    c["claim"]["counts"] = [2, 4]


def _cut_tree(c: dict[str, Any]) -> None:
    c["tree"] = c["tree"][:-1]


def _merge_leaves(c: dict[str, Any]) -> None:
    """The whole box as one leaf: not within a bounded work, as a root is real in it."""
    c["tree"] = "n"


def _known_elsewhere(c: dict[str, Any]) -> None:
    c["tree"] = c["tree"].replace("n", "z", 1)


def _absorbing_at_rest(c: dict[str, Any]) -> None:
    """The first leaf begins at q = 0, where nothing is absorbed."""
    c["tree"] = c["tree"].replace("n", "g", 1)


def _absorbing_beside_crossing(c: dict[str, Any]) -> None:
    """Where a mass has a real root the rail does not absorb whatever the vehicle is."""
    c["tree"] = c["tree"].replace("z", "g")


def _longer_range(c: dict[str, Any]) -> None:
    c["range"] = [["170", "2000"]]


def _end_at_crossing(c: dict[str, Any]) -> None:
    c["range"] = [["170", "191.183147740034"]]


def _shorter_range(c: dict[str, Any]) -> None:
    """Then the crossing lies outside, and the claim names one too many."""
    c["range"] = [["170", "185"]]


def _other_mass(c: dict[str, Any]) -> None:
    c["equations"]["vehicle"]["M"][0][0] = "10001"


def _other_track(c: dict[str, Any]) -> None:
    for term in c["equations"]["track"]["matrix"][0][0]:
        if term[:2] == [0, 1]:
            term[2] = "771"


def _negative_damping(c: dict[str, Any]) -> None:
    for where in (c, c["base"]["spectrum"]):
        for term in where["equations"]["track"]["matrix"][0][0]:
            if term[:2] == [0, 1]:
                term[2] = "-770"
    c["base"]["spectrum"] = sealed(c["base"]["spectrum"])


def _other_base(c: dict[str, Any]) -> None:
    c["base"]["at"] = ["171"]


def _moved_ball(c: dict[str, Any]) -> None:
    x = c["zeros"][0]["x"]
    away = 10 * x["radius"][0] * Fraction(2) ** (x["radius"][1] - x["exponent"])
    x["middle"] = hex(int(x["middle"], 16) + int(away) + 1)


def _smaller_room(c: dict[str, Any]) -> None:
    """Then leaves reach out of it."""
    q, room = c["zeros"][0]["q"], c["zeros"][0]["room"]
    middle = Fraction(int(q["middle"], 16)) * Fraction(2) ** q["exponent"]
    room[0] = [[int(middle * 2**30) - 99, -30], [int(middle * 2**30) + 99, -30]]


def _lower_X(c: dict[str, Any]) -> None:
    """Passivity is asked of a frequency at which there is none."""
    c["X"] = [1, 0]


def _lower_Q(c: dict[str, Any]) -> None:
    c["tail"]["Q"], c["beyond"] = c["X"], []


def _more_taken(c: dict[str, Any]) -> None:
    for block in c["tail"]["blocks"]:
        block[2][1] += 6


def _less_given(c: dict[str, Any]) -> None:
    for one in c["tail"]["bounds"]:
        one[1][1] -= 8


@pytest.mark.parametrize(
    "change",
    [
        _drop_crossing, _drop_from_claim, _turn, _raise_counts, _cut_tree, _merge_leaves, _known_elsewhere,
        _absorbing_at_rest, _absorbing_beside_crossing,
        _longer_range, _end_at_crossing, _shorter_range, _other_mass, _other_track, _negative_damping,
        _other_base, _moved_ball, _smaller_room, _lower_X, _lower_Q, _more_taken, _less_given,
    ],
)  # fmt: skip
def test_a_changed_file_is_refused(content: dict[str, Any], change: Change) -> None:
    changed = copy.deepcopy(content)
    change(changed)
    assert changed != content
    verdict = verify_bytes(as_file(changed), 1500)
    assert not verdict.valid
    assert not verdict.reason.startswith("malformed"), verdict.reason


def _outside(tree: str) -> str:
    return re.sub(r"(;[0-9]*)n", r"\1o", tree, count=1)


def _passive_along(tree: str) -> str:
    return re.sub(r"(;[0-9]*)n", r"\1p", tree, count=1)


def _absorbing_along(tree: str) -> str:
    return re.sub(r"(;[0-9]*)n", r"\1g", tree, count=1)


def _far_slope(tree: str) -> str:
    """A leaf along a slope that has nothing to do with what is there: it holds too much for any work."""
    return re.sub(r"s[-0-9]*e", "s9999999e", tree)


@pytest.mark.parametrize(
    "change",
    [
        lambda tree: tree.replace("z", "n"), _outside, _passive_along, _absorbing_along, _far_slope,
        lambda tree: re.sub(r"s[^;]*;", "1", tree),
    ],
)  # fmt: skip
def test_a_tree_with_slopes_that_was_changed_is_refused(change: Callable[[str], str]) -> None:
    """Upright boxes in place of those along a slope would need more work than is allowed."""
    value = json.loads(SLOPED.read_text("ascii"))
    tree = change(value["tree"])
    assert tree != value["tree"]
    verdict = verify_bytes(as_file(value | {"tree": tree}), 700)
    assert not verdict.valid
    assert not verdict.reason.startswith("malformed"), verdict.reason


def test_boxes_along_a_slope_hold_what_they_replace() -> None:
    box, one, other = ((fmpq(1), fmpq(2)), (fmpq(-1), fmpq(3))), fmpq(1, 2), fmpq(-3)
    (low, high), x = checker.laid(box, one, other)
    assert x == box[1]
    for t, y in itertools.product((1, fmpq(3, 2), 2), (-1, 0, 3)):
        assert low <= t + (one - other) * y <= high
    assert (low, high) == (1 - fmpq(7, 2), 2 + fmpq(21, 2))


def test_an_unsealed_change_is_refused(content: dict[str, Any]) -> None:
    assert "digest" in verify_bytes(json.dumps(content | {"tree": "n"}).encode()).reason


@pytest.mark.parametrize(
    "raw",
    [b"", b"[]", b"{}", b'{"format": "mpsolve certificate", "version": 2, "kind": "stable"}', b"\xff", b"1" * 99],
)
def test_what_is_no_certificate_is_refused(raw: bytes) -> None:
    assert not verify_bytes(raw).valid


def test_a_distance_whose_bound_is_negative_proves_nothing(content: dict[str, Any]) -> None:
    """The gap 17/5 + (v − 195)²/100 is ≥ 3.4 m, but its lower bound over the range is below 0, and roots do cross."""
    content = copy.deepcopy(content)
    gap = lambda v: Fraction(17, 5) + Fraction((v - 195) ** 2, 100)  # noqa: E731
    pair = lambda v: Problem(RAIL, [vehicles.Mass("10e3").at(0), vehicles.Mass("10e3").at(gap(v))], v=v)  # noqa: E731
    base = certify(pair(181), region="unstable")
    assert (base.unstable, certify(pair(195), region="unstable").unstable) == (0, 2)
    content["equations"]["vehicle"]["places"] = ["0", [[0, str(gap(0))], [1, "-39/10"], [2, "1/100"]]]
    content["base"] = {"at": ["181"], "spectrum": json.loads(base.certificate.text)}
    content |= {"X": [4, 0], "beyond": [], "tree": "n", "zeros": [], "claim": {"counts": [0], "directions": []}}
    content["tail"] = {
        "Q": [4, 0], "gamma": [1, 2], "blocks": [[[-9, -10], [9, -10], [1, -40]]], "alpha": 4, "omega": [1, 10],
        "bounds": [[[1, -6], [1, 10]]],
    }  # fmt: skip
    verdict = checker.verify_bytes(as_file(content))
    assert not verdict.valid
    assert "least distance" in verdict.reason


def test_a_direction_is_a_number(content: dict[str, Any]) -> None:
    content = copy.deepcopy(content)
    content["claim"]["directions"] = ["2"]
    assert not checker.verify_bytes(as_file(content)).valid


def test_a_stable_box_with_another_number_is_refused() -> None:
    value = json.loads(STABLE.read_text("ascii"))
    value["claim"]["unstable"] = 2
    assert "number at the base" in verify_bytes(as_file(value)).reason


@pytest.mark.parametrize("names", [["v", "v"], ["v from 0 to 1, c", "v"], ["", "v"], ["c", 1], ["c"]])
def test_what_varies_is_named_once(names: list[Any]) -> None:
    """The claim says "for c from …, v from …": with one name twice, or a sentence as a name, it says another one."""
    value = json.loads(STABLE.read_text("ascii"))
    value["equations"]["free"] = names
    verdict = verify_bytes(as_file(value))
    assert not verdict.valid
    assert any(word in verdict.reason for word in ("name", "range"))


@pytest.mark.parametrize("order", [1, 2])
def test_forms_hold_their_functions(order: int) -> None:
    """Products, inverses and exponentials over a box of two variables, at its corners and inside, complex too."""
    with precision(64):
        place = Place([arb(2), arb(1)], [arb("0.1"), arb("0.2")], order)
        x, y = place.power(0, 1), place.power(1, 1)
        made = ((x * y + x.scaled([3])).inverse() * (x * y).exp(), lambda a, b: (a * b).exp() / (a * b + 3 * a))
        polynomial = {(0, 0): fmpq(1), (1, 2): fmpq(-2), (3, 1): fmpq(1, 3), (0, 4): fmpq(5)}
        exact = place.value(checker.Sums.of([{}, polynomial])).take([1])
        for form, function in (
            made, (x.inverse(), lambda a, _: 1 / a), (y.exp(), lambda _, b: b.exp()),
            (exact, lambda a, b: 1 - 2 * a * b**2 + a**3 * b / 3 + 5 * b**4),
        ):  # fmt: skip
            assert form.e[0] < (0.5 if order == 2 else 3)
            for u, v in ((1, 1), (-1, 1), (0.5, -0.25), (1j, 0.6 - 0.8j), (0, 0)):
                a, b = acb(2) + acb("0.1") * acb(u), acb(1) + acb("0.2") * acb(v)
                assert abs(_model(form, (u, v)) - function(a, b)) <= form.e[0] + arb(2) ** -50


def _model(form: Form, u: tuple[complex, ...], at: int = 0) -> Any:
    total = form.k[0][at]
    for i, x in enumerate(u):
        total = total + form.k[1 + i][at] * acb(x)
    for n, i, j in form.second:
        total = total + form.k[n][at] * acb(u[i - 1]) * acb(u[j - 1])
    return total


def family_of(content: dict[str, Any], low: int, high: int) -> checker.Family:
    box = ((fmpq(low), fmpq(high)),)
    track = checker.spectra.read_track(content["equations"]["track"], content["equations"]["velocity"], box)
    vehicle = checker.spectra.read_bodies(content["equations"]["vehicle"], None, box, 24, 12)
    waves = checker.Waves(track, vehicle, box)
    envelope = checker.Envelope(7, [(arb(1), arb("1e-5"))], arb(high))
    return checker.Family(track, vehicle, box, envelope, waves, checker.spectra.Bordered(vehicle, waves), left=1000)


@pytest.fixture(scope="module")
def family(content: dict[str, Any]) -> checker.Family:
    return family_of(content, 170, 210)


@pytest.mark.parametrize("half", [("0.5", 2), ("0.001", "0.01")])
def test_receptances_over_boxes_hold_those_at_points(family: checker.Family, half: tuple[object, object]) -> None:
    """Against thin boxes at points of them."""
    with precision(64):
        r = [arb(str(x)) for x in half]
        wide = receptances(family.waves, split_over(family.waves, place_over([arb(12), arb(180)], r), False))
        for u in ((1, 1), (-1, 1), (0.3, -0.7)):
            at = [m + x * s for m, x, s in zip((arb(12), arb(180)), u, r, strict=True)]
            thin = receptances(family.waves, split_over(family.waves, place_over(at, [arb("1e-12")] * 2), False))
            for n, (rest, other) in enumerate(zip(wide.e, thin.k[0], strict=True)):
                assert abs(_model(wide, u, n) - other) <= rest + abs(other) * 1e-9
                assert rest < abs(wide.k[0][n])


MEETING = (132.66819917, 35.62467215)  # q, v: two p-roots with Re P > 0 meet there


def floats_of(q: float, v: float, xi: float) -> complex:
    """G(ξ) of RAIL: residues of N e^{Pξ}/D at numpy's roots."""
    s = 1j * q
    d = np.array([6.4e6, 0, 60 * v * v, -(120 * s + 770) * v, 60 * s * s + 770 * s + 1e6])
    roots = np.roots(d)
    own = roots[(roots.real < 0) == (xi >= 0)]
    return complex((1 if xi >= 0 else -1) * sum(np.exp(own * xi) / np.polyval(np.polyder(d), own)))


def test_the_determinant_along_a_slope_is_that_of_numpy(family: checker.Family) -> None:
    """|Δ̂| at points of a parallelogram against residues at numpy's roots, up to one constant; the form holds it."""
    slope = fmpq(-3, 8)
    with precision(64):
        place = checker.place_of(((fmpq(78), fmpq(79)), (fmpq(178), fmpq(180))), slope)
        A, E = family.matrix(place, checker.kernels_over(family.waves, place, False))
        assert max(float(x) for x in E.entries()) < 1e-3 * max(float(abs(x)) for x in A[0].entries())
        ratios = []
        for u in ((1, 1), (-1, 1), (0.3, -0.7), (0, 0)):
            t, v = 78.5 + 0.5 * u[0], 179 + u[1]
            q = t + float(slope) * v
            weights = [1, *u, u[0] * u[0], u[0] * u[1], u[1] * u[1]]
            got = acb_mat(2, 2, [NONE] * 4)
            for a, w in zip(A, weights, strict=True):
                got = got + a * acb(w)
            gap = 3.4
            G = np.array([[floats_of(q, v, x) for x in row] for row in ((0, -gap), (gap, 0))])
            ratios.append(complex(got.det().mid()) / np.linalg.det(np.eye(2) - 1e4 * q * q * G))
        assert np.allclose(ratios, ratios[0], rtol=1e-4)


def test_roots_alone_are_those_of_numpy(family: checker.Family, monkeypatch: pytest.MonkeyPatch) -> None:
    """Followed over a box: P, N/D_P and G at real points, the roots at complex ones; a radius that is less fails."""
    m, r = (12.0, 180.0), (1.5, 4.0)
    with precision(64):
        place = place_over([arb(x) for x in m], [arb(x) for x in r])
        nodes = checker.nodes_over(family.waves, place)
        found = checker.alone(nodes, range(4), False)
        assert found is not None
        G = checker.kernels_over(family.waves, place, False)
        for u in ((1, 1), (-1, 1), (0.3, -0.7), (1j, -1), (0.6 + 0.8j, 1j)):
            q, v = (a + b * x for a, b, x in zip(m, r, u, strict=True))
            s = 1j * q
            d = np.array([6.4e6, 0, 60 * v * v, -(120 * s + 770) * v, 60 * s * s + 770 * s + 1e6])
            for k in range(4):
                P = min(np.roots(d), key=lambda x, k=k: abs(x - complex(_model(found[0], u, k).mid())))
                assert float(abs(_model(found[0], u, k) - acb(P)).lower()) <= float(found[0].e[k].upper()) + 1e-9
                away = abs(_model(found[1], u, k) - acb(1 / np.polyval(np.polyder(d), P)))
                assert not away > found[1].e[k] + 1e-9 * abs(found[1].k[0][k])
            if all(np.isreal(u)):
                for n, gap in enumerate(family.waves.gaps):
                    away = abs(_model(G, u, n) - acb(floats_of(q, v, float(gap.get((0,), 0)))))
                    assert not away > G.e[n] + abs(G.k[0][n]) * 1e-9
        few = checker.spectra.Nodes(nodes.z, nodes.up - 1, nodes.local)
        assert checker.alone(few, range(4), False) is None  # a root on the other side than is told
        monkeypatch.setattr(checker, "nodes_apart", lambda *_: False)
        assert checker.alone(nodes, range(4), False) is None


def test_one_side_alone_gives_the_receptance_at_a_place(family: checker.Family) -> None:
    """G(0) from the roots of one side, against numpy; with another number than is known the splitting tells."""
    one, used = cast(Any, SimpleNamespace(places=family.vehicle.places[:1])), []
    waves, alone = checker.Waves(family.track, one, family.box), checker.alone
    with precision(64):
        place = place_over([arb(12), arb(180)], [arb("1.5"), arb(4)])
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(
                checker, "alone", lambda nodes, which, *more: used.append(which) or alone(nodes, which, *more)
            )
            for up in (None, 1):
                waves.up = up
                G = checker.kernels_over(waves, place, False)
                for u in ((1, 1), (-1, 1), (0.3, -0.7)):
                    true = acb(floats_of(12 + 1.5 * u[0], 180 + 4 * u[1], 0.0))
                    assert not abs(_model(G, u) - true) > G.e[0] + 1e-9 * abs(true)
        assert used == [[0, 1]]


def test_roots_alone_are_those_of_all_that_a_ball_holds() -> None:
    b, one = 0.1, {(0,): fmpq(1)}
    d = checker.Sums.of([{(0,): fmpq(-1)}, {}, one])
    d.matrix[1, 0] = acb(arb(0, b))  # P² + (0 ± b)P − 1
    with precision(64):
        local = checker.spectra.Local(Place([acb(0)], [arb(2.0**-60)], 2), d, checker.Sums.of([one]))
        found = checker.alone(checker.spectra.Nodes([acb(-1), acb(1)], 1, local), range(2), True)
        assert found is not None
        for c in (-b, b):
            roots = sorted(np.roots([1, c, -1]))
            for form, true in zip(found, (roots, [1 / (2 * x + c) for x in roots]), strict=True):
                assert not any(abs(k - x) > e for x, k, e in zip(true, form.k[0], form.e, strict=True))


def test_no_root_is_alone_where_two_meet(content: dict[str, Any]) -> None:
    family = family_of(content, 30, 40)
    with precision(64):
        for half in ((0.002, 0.001), (1e-6, 1e-7)):
            place = place_over(
                [arb(x) + arb(r) / 3 for x, r in zip(MEETING, half, strict=True)], [arb(r) for r in half]
            )
            assert checker.alone(checker.nodes_over(family.waves, place), range(4), False) is None


def test_a_radius_holds_what_it_must() -> None:
    """base + ε² ≤ ε has solutions up to base = 1/4."""
    with precision(64):
        alone = checker.spectra.alone
        for base in ("0.01", "0.1", "0.2"):
            found = alone([2 * arb(base), arb(0), arb(2)], arb(2))
            assert (1 - (1 - 4 * arb(base)).sqrt()) / 2 <= found
            assert found < 2 * arb(base)
        with pytest.raises(checker.Refused, match="told apart"):
            alone([arb("0.3"), arb(0), arb(1)], arb(1))
        with pytest.raises(checker.Refused, match="meet"):
            alone([arb("0.1"), arb(0), arb(1)], arb(0, 1))


@pytest.mark.parametrize("slope", [fmpq(0), fmpq(5, 2), fmpq(6)])
def test_where_p_roots_of_one_side_meet(
    content: dict[str, Any], monkeypatch: pytest.MonkeyPatch, slope: fmpq
) -> None:
    """Their sum is bounded over a box round the point, and holds what numpy finds beside it; the box is proved."""
    family, used = family_of(content, 30, 40), []
    points = checker.on_points
    monkeypatch.setattr(checker, "on_points", lambda *some: used.append(1) or points(*some))
    half = (0.002, 0.001)
    with precision(64):
        at_ = (MEETING[0] - float(arb(slope)) * MEETING[1], MEETING[1])
        box = [(fmpq(int((m - 2 * r / 3) * 10**9), 10**9), fmpq(int((m + 4 * r / 3) * 10**9), 10**9))
               for m, r in zip(at_, half, strict=True)]  # fmt: skip
        split = split_over(family.waves, checker.place_of((box[0], box[1]), slope), False)
        forms = receptances(family.waves, split)
        assert used
        for n, gap in enumerate(family.waves.gaps):
            xi = float(gap.get((0,), 0))
            for u in ((1, 1), (-1, 1), (0.3, -0.7)):
                t, v = (float(arb((a + b) / 2)) + x * r for (a, b), x, r in zip(box, u, half, strict=True))
                away = abs(_model(forms, u, n) - acb(floats_of(t + float(arb(slope)) * v, v, xi)))
                assert not away > forms.e[n] + abs(forms.k[0][n]) * 1e-9
                assert away + forms.e[n] < 1e-2 * abs(forms.k[0][n])
        ends = [(fmpq(int((m - 8 * r) * 10**6), 10**6), fmpq(int((m + 8 * r) * 10**6), 10**6))
                for m, r in zip(at_, half, strict=True)]  # fmt: skip
        family.prove("n", (ends[0], ends[1]), slope)


def test_a_circle_through_other_nodes_bounds_nothing(family: checker.Family, monkeypatch: pytest.MonkeyPatch) -> None:
    with precision(64):
        place = place_over([arb(12), arb(180)], [arb("0.5"), arb(2)])
        split = split_over(family.waves, place, False)
        N, gaps = place.value(family.waves.n), place.value(family.waves.xi)
        for side in (0, 1):
            middle, radii, inside = checker.circles(split, side, 3.4)[0]
            checker.on_circle(split, N, gaps, middle, radii[1], inside)
            for radius, nodes in ((radii[1], []), (radii[1] * 1e6, inside), (radii[1] * 0, inside)):
                with pytest.raises(Refused, match="too near"):
                    checker.on_circle(split, N, gaps, middle, radius, nodes)
            swapped = [(middle, radii[::-1], inside)]
            monkeypatch.setattr(checker, "circles", lambda *_, one=swapped: one)
            with pytest.raises(checker.Wide, match="not in order"):
                receptances(family.waves, split)
            monkeypatch.undo()


@pytest.mark.parametrize(("fixed", "samples"), [(True, 4), (True, 12), (False, 12)])
def test_what_samples_do_not_see_is_in_the_rest(
    family: checker.Family, monkeypatch: pytest.MonkeyPatch, fixed: bool, samples: int
) -> None:
    """With few points of a circle the mean is wrong by more than rounding, and the rest holds it."""
    monkeypatch.setattr(checker, "SAMPLES", samples)
    monkeypatch.setattr(family.waves, "fixed", fixed)
    with precision(64):
        split = split_over(family.waves, place_over([arb(12), arb(180)], [arb("1e-9"), arb("1e-9")]), False)
        forms = receptances(family.waves, split)
        for n, gap in enumerate(family.waves.gaps):
            away = float(abs(forms.k[0][n] - acb(floats_of(12, 180, float(gap.get((0,), 0))))))
            size = float(abs(forms.k[0][n]))
            assert 1e-9 * size < away < float(forms.e[n])
            assert samples < 12 or float(forms.e[n]) < 0.1 * size


def test_the_scalar_vanishes_where_the_determinant_does() -> None:
    """[[1, x], [y, xy]] is singular everywhere; with a corner of 1 more it is not."""
    with precision(64):
        place = Place([arb(1), arb(2)], [arb("0.01"), arb("0.01")], 2)
        x, y, one = place.power(0, 1), place.power(1, 1), place.number(1)

        def scalar(corner: Form) -> Form:
            f = checker.spectra.joined([one, x, y, corner])
            return checker.scalar(([acb_mat(2, 2, row) for row in f.k], arb_mat(2, 2, f.e)), 2, [[1.0, 1.0]] * 2)

        s = scalar(x * y)
        assert s.size[0] < s.e[0] + arb("1e-3")
        with pytest.raises(Refused):
            checker.check_nonzero(s)
        checker.check_nonzero(scalar(x * y + one))


@pytest.mark.parametrize("terms", [0, 1, 3])
def test_the_reduction_holds_what_it_leaves_out(monkeypatch: pytest.MonkeyPatch, terms: int) -> None:
    """Against the quotient of determinants at corners, for random matrices that change by a fifth."""
    monkeypatch.setattr(checker, "TERMS", terms)
    rng, units = np.random.default_rng(5), [[1.0, 2.0, 0.5, 4.0], [1.0, 1.0, 8.0, 1.0]]
    with precision(64):
        for _ in range(4):
            parts = [acb_mat((rng.normal(size=(4, 4)) * size).tolist()) for size in (1, 0.04, 0.04, 0.01, 0.01, 0.01)]
            s = checker.scalar((parts, arb_mat(4, 4)), 2, units)
            X, Y = checker.cleared(parts[0], units)
            for u in itertools.product((-1, 0.5, 1, 1j), repeat=2):
                factors = (1, *u, u[0] ** 2, u[0] * u[1], u[1] ** 2)
                A = sum((a * acb(f) for a, f in zip(parts, factors, strict=True)), acb_mat(4, 4))
                B = X * A * Y
                block = acb_mat([row[:3] for row in B.tolist()[:3]])
                assert abs(_model(s, u) - B.det() / block.det()) <= s.e[0] + arb(2) ** -40


def test_rests_are_no_smaller_than_what_is_left_out() -> None:
    """Of functions whose terms all have one sign at an end of the box: the rest is met to within a small factor."""
    with precision(64):
        u = Form([[acb(0)], [acb("0.8")], [acb(0)]], [arb(0)], 1)  # 0.8 u
        cube = Form([[acb(0)]] * 3, [arb("0.1")], 1)  # 0.1 u³
        for form, true in ((u.exp(), acb("0.8").exp()), ((u + cube).exp(), acb("0.9").exp())):
            left = abs(_model(form, (1,)) - true)
            assert left <= form.e[0] + arb(2) ** -50 < 3 * left
        for f, at_end in ((u, acb("0.8")), (u + cube, acb("0.9"))):
            form = (-f).plus([acb(1)]).inverse()
            assert abs(_model(form, (1,)) - 1 / (1 - at_end)) <= form.e[0] + arb(2) ** -50
        form = (u.scaled([5])).plus([acb(-10)]).exp()  # changes by e^±4: its largest value bounds it
        assert all(row[0] == 0 for row in form.k)
        assert acb(-6).exp().real <= form.e[0] + arb(2) ** -50
        assert form.e[0] < 0.003


def test_a_root_moves_as_its_form_says() -> None:
    """0.1 u + h + h³ = 0: what is left out is (0.1 u)³, and a little more at u = i. N = 1 + h²."""
    cubic = checker.Sums.of([{(1,): fmpq(1, 10)}, {(0,): fmpq(1)}, {}, {(0,): fmpq(1)}])
    above = checker.Sums.of([{(0,): fmpq(1)}, {}, {(0,): fmpq(1)}])
    with precision(64):
        local = checker.spectra.Local(Place([acb(0)], [acb(1)], 1), cubic, above)
        alone = checker.spectra.Apart(local, [acb(0)], 1, [arb("0.3")], *local.about([acb(0)], local.D))
        root, weight = checker.spectra.residues([alone], [0])
        for u in (1, -1, 1j):
            h = acb(0)
            for _ in range(60):
                h = -acb("0.1") * acb(u) - h**3
            assert abs(_model(root, (u,)) - h) <= root.e[0]
            assert abs(_model(weight, (u,)) - (1 + h * h) / (1 + 3 * h * h)) <= weight.e[0]
        assert root.e[0] < 0.03


def continued(q: tuple[float, float], v: tuple[float, float], u: tuple[complex, complex], xi: float) -> complex:
    """G(ξ) of RAIL at complex (q, v) = middle + half·u: p-roots followed from the middle, each side by itself."""
    sides, up = [np.empty(0, complex)] * 2, xi >= 0
    d = np.empty(0, complex)
    for t in np.linspace(0, 1, 60):
        s, w = 1j * (q[0] + q[1] * u[0] * t), v[0] + v[1] * u[1] * t
        d = np.array([6.4e6, 0, 60 * w * w, -(120 * s + 770) * w, 60 * s * s + 770 * s + 1e6])
        roots = np.roots(d)
        away = [
            np.abs(roots[:, None] - side).min(1) if t else sign * roots.real
            for side, sign in zip(sides, (1, -1), strict=True)
        ]
        sides = [roots[away[0] < away[1]], roots[away[0] >= away[1]]]
    own = sides[0 if up else 1]
    return complex((1 if up else -1) * sum(np.exp(own * xi) / np.polyval(np.polyder(d), own)))


@pytest.mark.parametrize(
    ("q", "v"),
    [
        ((0.5, 0.5), (180.0, 4.0)),
        ((12.0, 2.0), (180.0, 6.0)),
        ((MEETING[0] + 0.0007, 0.002), (MEETING[1] + 0.0003, 0.001)),
    ],
)
def test_receptances_hold_at_complex_points(
    content: dict[str, Any], q: tuple[float, float], v: tuple[float, float]
) -> None:
    """On all of |u_i| ≤ 1, as Taylor's rests: at q = 0, over a wide box, and where two p-roots of a side meet."""
    family = family_of(content, int(v[0]) - 5, int(v[0]) + 5)
    with precision(64):
        place = place_over([arb(q[0]), arb(v[0])], [arb(q[1]), arb(v[1])])
        forms = receptances(family.waves, split_over(family.waves, place, False))
        turns = np.exp(2j * np.pi * np.random.default_rng(1).random((12, 2)))
        for n, gap in enumerate(family.waves.gaps):
            xi = float(gap.get((0,), 0))
            for a, b in turns:
                u = (complex(a), complex(b))
                away = abs(_model(forms, u, n) - acb(continued(q, v, u, xi)))
                assert not away > forms.e[n] + abs(forms.k[0][n]) * 1e-9


def _bodies(theta: str | list[Any], soft: str | list[Any], box: Any) -> Any:
    """A wheel without mass of its own spring, a sprung mass on it, and a soft contact of a third body."""
    value = {
        "M": [["0", "0", "0"], ["0", "3", "0"], ["0", "0", "2"]],
        "C": [["1", "-1", "0"], ["-1", "1", "0"], ["0", "0", "0"]],
        "K": [[theta, "0", "0"], ["0", "4", "-4"], ["0", "-4", "4"]],
        "B": [["2", "0"], ["0", "0"], ["0", "1"]], "places": ["0", "1"], "compliances": ["0", soft],
    }  # fmt: skip
    return checker.spectra.read_bodies(value, None, box, 24, 12)


def test_the_matrix_over_parameters_holds_those_at_points() -> None:
    """Springs and a compliance 1/θ that vary, direct and soft contacts, at corners, inside and complex."""
    track = checker.spectra.read_track(
        {"matrix": [[[[4, 0, "1"], [0, 2, "1"], [0, 1, "1"], [0, 0, "1"]]]], "loaded": 0}, "1"
    )
    box, spectra = ((fmpq(2), fmpq(3)),), checker.spectra
    moving = spectra.Track(*(getattr(track, name) for name in ("ring", "rows", "loaded", "velocity", "D", "N")),
                           *({(*e, 0): c for e, c in part.items()} for part in (track.d, track.n)))  # fmt: skip
    with precision(64):
        wide = _bodies([[1, "1"]], [[-1, "1"]], box)
        waves = spectra.Waves(moving, wide.places, [fmpq(5, 2)])
        place = place_over([arb("0.7"), arb("2.5")], [arb("0.1"), arb("0.5")])
        G = [[acb(k + 1, 2 - k) for k in range(len(waves.gaps))]]
        row = Form(G + [[acb(0)] * len(waves.gaps)] * 5, [arb(0)] * len(waves.gaps), 2)
        A, rest = spectra.Bordered(wide, waves)(place, row)
        for u in ((1, 1), (-1, 1), (1j, -1), (0.3, 0.6 - 0.8j), (0, 0)):
            theta = 2.5 + 0.5 * u[1]
            q = 0.7 + 0.1 * u[0]
            S = 1j * q * np.array([[1, -1, 0], [-1, 1, 0], [0, 0, 0]]) + np.array(
                [[theta, 0, 0], [0, 4, -4], [0, -4, 4]]
            )
            S = S - q * q * np.diag([0, 3, 2])
            own, cross, back = (complex(G[0][waves.index[i][j]]) for i, j in ((0, 0), (0, 1), (1, 0)))
            low = complex(G[0][waves.index[1][1]])
            exact = np.zeros((4, 4), complex)
            exact[:3, :2] = S[:, 1:]
            exact[:3, 2:] = -np.array([[2, 0], [0, 0], [0, 1]]) - np.outer(S[:, 0] / 2, [own, cross])
            exact[3] = [0, 1, back, low + 1 / theta]
            for i, j in itertools.product(range(4), repeat=2):
                found = _model(Form([[a[i, j]] for a in A], [rest[i, j]], 2), u)
                assert abs(found - acb(complex(exact[i, j]))) <= rest[i, j] + arb("1e-12")
                assert rest[i, j] < 0.2


def test_trees_are_read_to_their_last_leaf() -> None:
    box = ((fmpq(0), fmpq(1)), (fmpq(0), fmpq(2)))
    leaves = list(checker.walk("0n1pz", box))
    assert [kind for kind, *_ in leaves] == ["n", "p", "z"]
    assert leaves[1][1] == ((fmpq(1, 2), fmpq(1)), (fmpq(0), fmpq(1)))
    _, (kind, part, slope) = checker.walk("s-3e-2;on", box)
    assert (kind, slope) == ("n", fmpq(-3, 4))
    assert part == ((fmpq(3, 4), fmpq(5, 2)), (fmpq(1), fmpq(2)))
    for bad in (
        "0n",
        "0nnn",
        "2nn",
        "x",
        "",
        "s1e0nn",
        "s1e9999;nn",
        "s1;nn",
        "s 1e0;nn",
        "s1e0;n",
        "ns1e0;",
        "s\u0661e0;nn",
    ):
        with pytest.raises(Refused):
            list(checker.walk(bad, box))


def test_lower_bounds_over_boxes() -> None:
    """x² − x on [0, 1] is at least −1/4; the least Bernstein coefficient is lower, and exact for a linear one."""
    square = {(2,): fmpq(1), (1,): fmpq(-1)}
    assert checker.spectra.least(square, ((fmpq(0), fmpq(1)),)) <= fmpq(-1, 4)
    assert checker.spectra.least({(1, 1): fmpq(-1)}, ((fmpq(1), fmpq(2)), (fmpq(3), fmpq(4)))) == -8


def _edge(rng: Any, m: int) -> list[complex]:
    return [complex(x) for x in 0.9999999 * np.exp(2j * np.pi * rng.random(m))]


@pytest.mark.parametrize("seed", range(12))
def test_forms_of_waves_hold_them_at_complex_points(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """P, N/D_P and G, against numpy's roots at the edge of wide boxes, with few points on circles too."""
    monkeypatch.setattr(checker, "SAMPLES", 6 if seed % 2 else 32)
    rng, held = np.random.default_rng(seed), []
    c = rng.normal(size=(5, 3)) * [1, 0.5, 0.3] + [[9, 0, 0], *[[0, 0, 0]] * 3, [3, 0, 0]]
    d, one = [{(i,): fmpq(int(64 * x), 64) for i, x in enumerate(row)} for row in c], {(0,): fmpq(1)}
    number = np.array([[float(arb(x)) for x in row.values()] for row in d])
    waves: Any = SimpleNamespace(fixed=True, ahead=[True, False], distances=[arb(1), arb(-1)])
    waves.xi = checker.Sums.of([{(0,): fmpq(1)}, {(0,): fmpq(-1)}])
    with precision(64):
        for size in (0.4, 0.3, 0.2, 0.15, 0.1, 0.05):
            local = checker.spectra.Local(
                Place([acb(0.3)], [arb(size)], 2), checker.Sums.of(d), checker.Sums.of([one])
            )
            nodes = checker.spectra.nodes_near(local)
            try:
                split = nodes.split()
                G, (P, weight) = receptances(waves, split), checker.alone(nodes, range(4), False) or (None, None)
            except Refused:
                continue
            for u in (_edge(rng, 1) for _ in range(12)):
                row = number @ (0.3 + size * u[0]) ** np.arange(3)
                p = np.roots(row[::-1])
                p = p[[checker.spectra.nearest(acb(z), [acb(x) for x in p]) for z in map(complex, nodes.z)]]
                for k, z in enumerate(map(complex, nodes.z)):
                    side = p[: nodes.up] if k < nodes.up else p[nodes.up :]
                    own = [complex(x) for j, x in enumerate(nodes.z) if (j < nodes.up) == (k < nodes.up) and j != k]
                    assert abs(np.prod(z - side) / np.prod(z - np.array(own))) <= float(split.tight[k]) + 1e-9
                w = 1 / np.polyval(np.polyder(row[::-1]), p)
                true = [(w * np.exp(p))[: nodes.up].sum(), -(w * np.exp(-p))[nodes.up :].sum()]
                held += [(G, u, k, x) for k, x in enumerate(true)]
                if P is not None:
                    held += [(form, u, k, x) for form, all_ in ((P, p), (weight, w)) for k, x in enumerate(all_)]
        assert held
        assert not any(abs(_model(form, tuple(u), k) - acb(x)) > form.e[k] + 1e-12 for form, u, k, x in held)


def test_the_reduced_determinant_is_held_at_complex_points() -> None:
    rng = np.random.default_rng(4)
    for size in np.linspace(0.01, 0.2, 60):
        parts = rng.normal(size=(6, 4, 4, 2)) @ [1, 1j] * np.array([1, size, size, 0, 0, 0])[:, None, None]
        lost, units = np.zeros((4, 4)) if size > 0.1 else 0.002 * rng.random((4, 4)), ([1.0] * 4, [1.0] * 4)
        with precision(64):
            A = [acb_mat(part.tolist()) for part in parts]
            try:
                s = checker.scalar((A, arb_mat(lost.tolist())), 2, units)
            except Refused:
                continue
            X, Y = (np.array([[complex(x) for x in r] for r in a.tolist()]) for a in checker.cleared(A[0], units))
            for _ in range(10):
                u, v = _edge(rng, 2)
                whole = np.tensordot([1, u, v, u * u, u * v, v * v], parts, 1)
                B = X @ (whole + lost * np.exp(2j * np.pi * rng.random((4, 4)))) @ Y
                true = np.linalg.det(B) / np.linalg.det(B[:3, :3])
                assert not abs(_model(s, (u, v)) - acb(true)) > s.e[0] + 1e-9


def test_polynomials_of_forms_hold_all_of_them() -> None:
    """Of modulus as large as may be, so that what is left out counts: Σ E_i h^i with E_i, h > 0."""
    place = Place([acb(0)], [arb("0.5")], 2)
    E = [Form([[acb(1)], [acb(0)], [acb(0)]], [arb("0.1")], 1) for _ in range(7)]
    h = Form([[acb("0.5")], [acb("0.25")], [acb(0)]], [arb("0.05")], 1)
    for slope in (False, True):
        got = checker.spectra.along(E[: place.order + 2], [f.size for f in E], h, h.size, slope)
        true = sum(1.1 * (i if slope else 1) * 0.8 ** (i - slope) for i in range(slope, 7))
        assert _model(got, (1,)).real + got.e[0] > true - 1e-9


def test_what_a_form_leaves_out_counts_against_passivity() -> None:
    for n in (1, 2):
        index = [[(i != j) for j in range(n)] for i in range(n)]
        for rest, fine in (("0.5", True), ("1.5", False)):
            F = Form([[acb(0, -1), acb(0)]], [arb(rest), arb(0)], 0)
            assert checker.spectra.definite(*checker.spectra.hermitian(F, index, [acb(0, 1)])) == fine
        F = Form([[acb(0, 1), acb(0)]], [arb(0), arb(0)], 0)
        assert not checker.spectra.definite(*checker.spectra.hermitian(F, index, [acb(0, 1)]))


def test_the_box_of_a_pair_is_mapped_into_itself() -> None:
    rng, wide = np.random.default_rng(2), []
    for size in np.linspace(0.01, 0.3, 60):
        near = rng.random((4, 4)) * [[0, 0, 1, 1], [0, 0, 1, 1], [1, 1, 0, 0], [1, 1, 0, 0]]
        w = size * rng.random(4)
        found = checker.spectra.contraction([arb(x) for x in w], arb_mat(near.tolist()), arb("1e-60"))
        if found is not None:
            beta = np.array([float(x) for x in found[0]])
            assert (near @ beta < 0.5).all()
            assert (w / (1 - near @ beta) < beta).all()
            wide.append((beta > 2 * w).all())
    assert 0 < sum(wide) < len(wide)


def test_a_pair_is_found_where_the_first_box_is_too_wide() -> None:
    """1.2 w takes 0.51 of one side; 1.15 τ, less than half of it."""
    near, w = [[0, 1], [1, 0]], (0.425, 0.01)
    found = checker.spectra.contraction([arb(x) for x in w], arb_mat(near), arb("1e-60"))
    assert found is not None
    (a, b), (s, t) = ([float(x) for x in row] for row in found)
    assert a < 0.5 < 1.2 * w[0]
    assert w[0] / (1 - b) <= s < a
    assert w[1] / (1 - a) <= t < b
    assert checker.spectra.contraction([arb("0.5"), arb("0.01")], arb_mat(near), arb("1e-60")) is None


def test_boxes_are_passive_by_the_receptance_where_the_contacts_take_up_power(family: checker.Family) -> None:
    """Against floats of −Im G, of both contacts: it has both signs over the range."""
    seen, xi = set(), abs(float(max(family.waves.distances, key=abs).real))
    for q, v in itertools.product((5, 20, 60, 120, 250, 500), (172, 190, 208)):
        G = np.array([[floats_of(q, v, x) for x in row] for row in ((0, xi), (-xi, 0))])
        least = np.linalg.eigvalsh(-(G - G.conj().T) / 2j)[0] / abs(G).max()
        with precision(64):
            try:
                checker.by_roots(family, place_over([arb(q), arb(v)], [arb("1e-6")] * 2))
                found = True
            except Refused:
                found = False
        assert found == (least > 0), (q, v, least)
        seen.add(found)
    assert seen == {True, False}
