"""Certificates of crossings: what is true is accepted, and every change of it is refused by the mathematics."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from flint import acb, arb
from oracle import Truth

from mpsolve import Case
from mpsolve.certificate.format import digest
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.certificate.verify import (
    Beside,
    Box,
    Branches,
    Dual,
    Refused,
    Verdict,
    branches,
    confirms_crossing,
    delta_off_cut,
    det,
    entire,
    entire_slope,
    first_seeds,
    free_problem,
    natural,
    outward,
    precision,
    prove_free,
    seeds_at,
    value_and_slopes,
    value_off_cut,
    verify,
)
from mpsolve.numbers.exact import Exact
from mpsolve.stability.family import Family
from mpsolve.stability.zero import Zero, approach, isolate, sharpen

Content = dict[str, Any]
Change = Callable[[Content], object]
PAIR: Content = {"eta_b": "0.05", "eta_m": (70, 70), "positions": (0, "1.5")}
TILT = Case(alpha="0.67", **PAIR)
DENSE = Case(alpha="0.99", eta_b="0.99", eta_m=(70, 70), positions=(0, 1))
LEVEL = Case(alpha="0.99", eta_b="0.1", eta_m=(1, 1), positions=(0, "1.1"))

# family, start, end, radius, (x, t, direction, reach) of the crossings, t of the base, counts
ALPHA = (Family(TILT, "alpha"), "13/20", "7/10", 256, [(0.1562, 0.6669, 1, 2**-18)], "0.66", [0, 2])
DISTANCE = (
    Family(DENSE, "distance"), "9/5", "5/2", 512,
    [(0.2417, 1.8881, -1, 2**-13), (0.2998, 2.3914, 1, 2**-15)], "2", [2, 0, 2],
)  # fmt: skip
FREE_LEVEL = (Family(LEVEL, "level"), "0", "1", 256, [(0.2357, 0.423, 1, 2**-11)], None, [0, 2])
BELOW = (
    Family(TILT, "alpha", Exact("-1/500")), "19/20", "97/100", 512, [(0.119, 0.96013, 1, 2**-17)], "0.952", [0, 2],
)  # fmt: skip
DAMPING = (Family(TILT, "eta_b"), "1/20", "1/18", 256, [], "0.05", [2])
SINGLE = (
    Family(Case(alpha=1, eta_b="0.1", eta_m=70), "alpha"),
    "1",
    "6/5",
    512,
    [(0.1629, 1.09, 1, 2**-12)],
    "1",
    [0, 2],
)
MADE = {
    "alpha": ALPHA,
    "at rest": (ALPHA[0], "0", "7/10", *ALPHA[3:5], None, [0, 2]),
    "distance": DISTANCE,
    "level": FREE_LEVEL,
    "below": BELOW,
    "damping": DAMPING,
    "single": SINGLE,
}
TRIPLE = Case(alpha="0.67", eta_b="0.5", eta_m=(20, 30, 10), positions=(0, 1, 2))
FULL = {
    "three masses": (Family(TRIPLE, "eta_b"), "1/2", "11/20", 2**15, [], "1/2", [0]),
    "alpha": (ALPHA[0], "0", "7/10", *ALPHA[3:]),
    "distance": (
        DISTANCE[0], "3/10", "3", 512,
        [(0.22877, 0.55684, 1, 2**-13), *DISTANCE[4], (0.28898, 2.7362, -1, 2**-16)], "1", [0, 2, 0, 2, 0],
    ),
}  # fmt: skip


def crossing(family: Family, x: float, t: float, direction: int, reach: float) -> Content:
    point = approach(family, x, t)
    assert point is not None
    zero = sharpen(family, isolate(family, *point), 20)
    assert zero.direction == direction
    places = on_grid(zero, 60) | {"direction": direction}
    return places | {"reach": [hex(1), int(math.log2(reach))]}


def on_grid(zero: Zero, bits: int) -> Content:
    """x and t rounded to multiples of 2^−bits."""
    with precision(2 * bits):
        x, t = (hex(int((ball * arb(2) ** bits + 0.5).floor().unique_fmpz())) for ball in (zero.x, zero.t))
    return {"x": x, "x_exponent": -bits, "t": t, "t_exponent": -bits}


def made(made_of: Any) -> str:
    family, start, end, radius, points, base, counts = made_of
    content = {
        "format": "mpsolve certificate",
        "version": 1,
        "kind": "crossings",
        "case": family.case.as_dict(),
        "family": {"parameter": family.parameter, "start": start, "end": end},
        "height": str(family.height),
        "radius": [hex(radius), 0],
        "crossings": [crossing(family, *point) for point in points],
        "base": None
        if base is None
        else {"t": str(Exact(base)), "certificate": spectrum(family.case_at(Exact(base)))},
        "claim": {"counts": counts},
    }
    return json.dumps(content | {"sha256": digest(content)})


@cache
def original(name: str) -> str:
    return made(MADE[name])


def spectrum(case: Case) -> Content:
    certificate = certify(case, digits=15, region="unstable").certificate
    assert certificate is not None
    return certificate.content


def changed(name: str, change: Change) -> str:
    """The certificate with a change, and with digests that fit."""
    content = json.loads(original(name))
    change(content)
    for part in (content["base"] and content["base"].get("certificate"), content):
        if isinstance(part, dict):
            part.pop("sha256", None)
            part["sha256"] = digest(part)
    return json.dumps(content)


def verdict(text: str, folder: Path) -> Verdict:
    file = folder / "certificate.json"
    file.write_text(text)
    return verify(file)


def setting(*path: Any, to: Any) -> Change:
    def change(content: Content) -> None:
        for key in path[:-1]:
            content = content[key]
        content[path[-1]] = to

    return change


@pytest.mark.parametrize("name", MADE)
def test_what_is_true_is_accepted(name: str, tmp_path: Path) -> None:
    result = verdict(original(name), tmp_path)
    family, *_, counts = MADE[name]
    assert result.valid, result.reason
    assert result.claim.startswith(f"exactly {len(counts) - 1} crossing")
    assert f"of Im q = {family.height} for " in result.claim
    assert f" after: {', '.join(map(str, counts))}; case " in result.claim
    for key in ("alpha", "eta_b", "eta_n", "eta_s"):
        assert (f"{key} = {family.case.as_dict()[key]}" in result.claim) == (key != family.parameter)
    masses = ", ".join(family.case.as_dict()["eta_m"])
    places = "0, d, 2d, …" if family.parameter == "distance" else ", ".join(family.case.as_dict()["positions"])
    ratio = "in the ratio" if family.parameter == "level" else "="
    assert result.claim.endswith(f"eta_m {ratio} {masses} at {places}")


def true_zero(family: Family, x: float, t: float) -> tuple[Any, Any]:
    """(x, t) by mpmath: the real and the imaginary part of Δ, both real unknowns, from residue sums at 60 digits."""
    truth = Truth(family.case, 60)
    mp, masses = truth.mp, list(truth.eta_m)

    def parts(x: Any, t: Any) -> list[Any]:
        if family.parameter == "distance":
            truth.x = [k * t for k in range(len(truth.x))]
        elif family.parameter == "level":
            eta = mp.pi * (1 + x * x) * t / (1 - t) / (2 * x * x)
            truth.eta_m = [eta * ratio for ratio in masses]
        else:
            setattr(truth, family.parameter, t)
        value = truth.delta(mp.mpc(x, mp.mpf(family.height.short())))
        return [mp.re(value), mp.im(value)]

    found = mp.findroot(parts, (mp.mpf(x), mp.mpf(t)), tol=mp.mpf(10) ** -80)
    return found[0], found[1]


@pytest.mark.parametrize("name", ["alpha", "distance", "level", "below", "single"])
def test_a_last_digit_that_is_moved_is_still_true_or_refused(name: str) -> None:
    """A crossing is claimed to lie within a unit of its last place: moved by one unit it may still do so."""
    content = json.loads(original(name))
    family, points = MADE[name][0], MADE[name][4]
    for k, (x, t, *_) in enumerate(points):
        truth = dict(zip("xt", true_zero(family, x, t), strict=True))
        for key in "xt":
            place, unit = content["crossings"][k][key], Fraction(2) ** content["crossings"][k][f"{key}_exponent"]
            valid = {}
            for steps in (-2, -1, 0, 1, 2):
                moved = int(place, 16) + steps
                valid[steps] = confirms_crossing(content, content["crossings"][k] | {key: hex(moved)})
                off = abs(truth[key] - moved * Truth(family.case, 60).mp.mpf(unit.numerator) / unit.denominator)
                assert not valid[steps] or off < float(unit), (key, steps)
            assert valid[0]
            assert not valid[-2]
            assert not valid[2]
            assert not (valid[-1] and valid[1])


@pytest.mark.slow
@pytest.mark.parametrize("name", FULL)
def test_whole_ranges_are_accepted(name: str, tmp_path: Path) -> None:
    assert verdict(made(FULL[name]), tmp_path).valid


def shifted(name: str, units: int) -> Change:
    def change(content: Content) -> None:
        one = content["crossings"][0]
        one[name] = hex(int(one[name], 16) + units)

    return change


def without(index: int, counts: list[int]) -> Change:
    def change(content: Content) -> None:
        del content["crossings"][index]
        content["claim"]["counts"] = counts

    return change


def based_at(t: str, **numbers: Any) -> Change:
    def change(content: Content) -> None:
        case = MADE["alpha"][0].case_at(Exact(t))
        values = {k: getattr(case, k) for k in ("alpha", "eta_b", "eta_m", "positions")} | numbers
        content["base"]["certificate"] = spectrum(Case(**values))

    return change


CHANGES: dict[str, tuple[str, Change, str]] = {
    "a crossing left out": ("alpha", without(0, [0]), "there may be another crossing near x = 0.156"),
    "a crossing of a level left out": ("level", without(0, [0]), "there may be another crossing near x = 0.235"),
    "one of two left out": ("distance", without(1, [2, 0]), "there may be another crossing near x = 0.299"),
    "the first of two left out": ("distance", without(0, [0, 2]), "there may be another crossing near x = 0.241"),
    "a crossing twice": (
        "alpha",
        lambda c: c.update(crossings=c["crossings"] * 2, claim={"counts": [0, 2, 4]}),
        "not in order, or not apart",
    ),
    "a crossing of a level twice": (
        "level",
        lambda c: c.update(crossings=c["crossings"] * 2, claim={"counts": [0, 2, 4]}),
        "not in order, or not apart",
    ),
    "out of order": ("distance", lambda c: c["crossings"].reverse(), "not in order"),
    "another direction": ("alpha", setting("crossings", 0, "direction", to=-1), "crossing 0: its direction"),
    "another direction and count": (
        "level",
        lambda c: (c["crossings"][0].update(direction=-1), c.update(claim={"counts": [0, -2]})),
        "crossing 0: its direction",
    ),
    "other counts": ("alpha", setting("claim", "counts", to=[2, 4]), "not those claimed"),
    "other counts of a level": ("level", setting("claim", "counts", to=[2, 4]), "not those claimed"),
    "a count too many": ("alpha", setting("claim", "counts", to=[0, 2, 2]), "not those claimed"),
    "truth values as counts": ("damping", setting("claim", "counts", to=[True]), "not those claimed"),
    "a smaller radius": ("alpha", setting("radius", to=["0x8", 0]), "far field"),
    "a smaller radius of a level": ("level", setting("radius", to=["0x8", 0]), "far field"),
    "a smaller radius for distances": ("distance", setting("radius", to=["0x40", 0]), "far field"),
    "no radius": ("alpha", setting("radius", to=["0x0", 0]), "radius"),
    "x two units higher": ("alpha", shifted("x", 2), "crossing 0: interval Newton"),
    "t two units lower": ("alpha", shifted("t", -2), "crossing 0: interval Newton"),
    "t of a level two units higher": ("level", shifted("t", 2), "crossing 0: interval Newton"),
    "an immense reach": ("alpha", setting("crossings", 0, "reach", to=["0x1", -1]), "crossing 0"),
    "a reach below the last place": (
        "alpha",
        setting("crossings", 0, "reach", to=["0x1", -61]),
        "crossing 0: a reach",
    ),
    "a reach of 0": ("alpha", setting("crossings", 0, "reach", to=["0x0", 0]), "reach is 0"),
    "an invented crossing": (
        "damping",
        lambda c: (
            c["crossings"].append(json.loads(original("alpha"))["crossings"][0] | {"t": hex(2**60 // 19)}),
            c.update(claim={"counts": [2, 4]}),
        ),
        "crossing 0: interval Newton",
    ),
    "a crossing beyond the end": ("alpha", setting("family", "end", to="666/1000"), "crossing 0: it is not inside"),
    "a range the wrong way round": ("alpha", setting("family", "start", to="3/4"), "not below"),
    "a level from the middle": ("level", setting("family", "start", to="1/4"), "runs from 0 to 1"),
    "another parameter": ("alpha", setting("family", "parameter", to="eta_b"), "crossing 0: interval Newton"),
    "an unknown parameter": ("alpha", setting("family", "parameter", to="eta_n"), "parameter is not known"),
    "distances of a pair": ("alpha", setting("family", "parameter", to="distance"), "crossing 0: interval Newton"),
    "distances that differ": (
        "distance",
        lambda c: c["case"].update(eta_m=["70"] * 3, positions=["0", "1", "3"]),
        "do not stand at",
    ),
    "a distance of 0": ("distance", setting("family", "start", to="0"), "start is too small"),
    "distances from another place": ("distance", setting("case", "positions", to=["1", "2"]), "do not stand at"),
    "another height": ("alpha", setting("height", to="-1/1000"), "crossing 0: interval Newton"),
    "a height above the axis": ("alpha", setting("height", to="1/1000"), "above the real axis"),
    "a height of a level": ("level", setting("height", to="-1/1000"), "on the real axis"),
    "no damping": ("alpha", setting("case", "eta_b", to="0"), "there is no damping"),
    "damping from 0": ("damping", setting("family", "start", to="0"), "start is too small"),
    "a buckled beam": ("level", setting("case", "eta_n", to="1"), "buckles"),
    "another damping": ("alpha", setting("case", "eta_b", to="500001/10000000"), "crossing 0: interval Newton"),
    "another mass": ("alpha", setting("case", "eta_m", 0, to="7000001/100000"), "crossing 0: interval Newton"),
    "other proportions": ("level", setting("case", "eta_m", 0, to="1000001/1000000"), "crossing 0: interval Newton"),
    "no base": ("alpha", setting("base", to=None), "missing"),
    "a base of a level": ("level", lambda c: c.update(base=json.loads(original("alpha"))["base"]), "no base"),
    "at rest, but another count": ("at rest", setting("claim", "counts", to=[2, 4]), "not those claimed"),
    "at rest, but not from 0 on": ("at rest", setting("family", "start", to="1/1000"), "missing"),
    "another place of the base": ("alpha", setting("base", "t", to="69/100"), "base: it is of another case"),
    "a base out of the range": ("alpha", setting("base", "t", to="3/5"), "base is not in the range"),
    "a base of another alpha": ("alpha", based_at("0.65"), "base: it is of another case"),
    "a base of another mass": ("alpha", based_at("0.66", eta_m=(70, 71)), "base: it is of another case"),
    "a base of another damping": ("alpha", based_at("0.66", eta_b="0.06"), "base: it is of another case"),
    "a base of another distance": ("alpha", based_at("0.66", positions=(0, "1.6")), "base: it is of another case"),
    "a base with another count": (
        "damping",
        lambda c: c["base"]["certificate"].update(roots=[], identity=[], claim={"count": 0, "unstable": 0}),
        "base: the winding number is 4",
    ),
    "a base that is no certificate": ("alpha", setting("base", "certificate", to=[]), "base: the file holds no"),
    "a base of another kind": (
        "alpha",
        lambda c: c["base"].update(certificate=json.loads(original("level"))),
        "base: it is of another kind",
    ),
    "an unknown key": ("alpha", setting("note", to="x"), "unknown"),
    "an unknown key of a crossing": ("alpha", setting("crossings", 0, "note", to="x"), "unknown"),
    "an unknown key of the family": ("alpha", setting("family", "note", to="x"), "unknown"),
    "an unknown key of the base": ("alpha", setting("base", "note", to="x"), "unknown"),
    "an unknown key of the claim": ("alpha", setting("claim", "note", to="x"), "unknown"),
    "no list of crossings": ("alpha", setting("crossings", to={}), "no list"),
    "a crossing of nothing": ("alpha", setting("crossings", 0, to=None), "missing"),
    "crossings without end": ("alpha", lambda c: c.update(crossings=c["crossings"] * 2000), "too many"),
    "a crossing at negative x": ("alpha", lambda c: shifted("x", -(2**61))(c), "positive"),
    "an immense exponent": ("alpha", setting("crossings", 0, "x_exponent", to=10**9), "exponent"),
    "an exponent as a truth value": ("alpha", setting("crossings", 0, "t_exponent", to=True), "exponent"),
    "an immense mantissa": ("alpha", setting("crossings", 0, "t", to="0x" + "f" * 39_999), "crossing"),
    "a direction as text": ("alpha", setting("crossings", 0, "direction", to="1"), "direction"),
    "a direction of 0": ("alpha", setting("crossings", 0, "direction", to=0), "direction"),
    "a surd as start": ("alpha", setting("family", "start", to="root4(1/3)"), "start is not rational"),
    "an immense end": ("alpha", setting("family", "end", to="9" * 4000), ""),
    "a family as text": ("alpha", setting("family", to="alpha"), "missing"),
    "a claim as text": ("alpha", setting("claim", to="[0, 2]"), "missing"),
    "an immense radius": ("alpha", setting("radius", to=["0x1", 3000]), ""),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_change_is_refused(name: str, tmp_path: Path) -> None:
    kind, change, reason = CHANGES[name]
    result = verdict(changed(kind, change), tmp_path)
    assert not result.valid
    assert reason in result.reason


@pytest.mark.parametrize("where", ["outside", "base"])
def test_the_digests_are_checked(where: str, tmp_path: Path) -> None:
    content = json.loads(original("damping"))
    (content if where == "outside" else content["base"]["certificate"])["sha256"] = "0" * 64
    if where == "base":
        content.pop("sha256")
        content["sha256"] = digest(content)
    assert "the digest does not fit" in verdict(json.dumps(content), tmp_path).reason


def test_a_finer_certificate_is_accepted_too(tmp_path: Path) -> None:
    """300 bits of each number."""

    def change(content: Content) -> None:
        family, x, t = MADE["alpha"][0], *MADE["alpha"][4][0][:2]
        point = approach(family, x, t)
        assert point is not None
        content["crossings"][0] |= on_grid(sharpen(family, isolate(family, *point), 100), 300)

    assert verdict(changed("alpha", change), tmp_path).valid


def test_a_maker_may_ask_for_the_reach() -> None:
    content = json.loads(original("level"))
    one = content["crossings"][0]
    assert confirms_crossing(content, one)
    assert not confirms_crossing(content, one | {"reach": ["0x1", -2]})


# --- the pieces ---------------------------------------------------------------------------------------------------

THREE = {"alpha": "3/5", "eta_b": "1/10", "eta_n": "0", "eta_s": "0"}
MASSES = {1: ["7"], 2: ["7", "9"], 3: ["7", "9", "4"], 5: ["7", "9", "4", "1", "2"]}


def box(parameter: str, masses: int, x: float, t: float, dx: float = 0, dt: float = 0, **changes: str) -> Box:
    case = THREE | {"eta_m": MASSES[masses], "positions": [str(k) for k in range(masses)]} | changes
    start, end = ("0", "1") if parameter == "level" else ("1/100", "2")
    family = {"parameter": parameter, "start": start, "end": end}
    free = free_problem({"case": case, "height": "0", "family": family})
    return Box(free.family(), arb(x), arb(t), arb(0, dx), arb(0, dt))


def split(b: Box) -> Branches | Beside | None:
    return branches(b, seeds_at(b, first_seeds(1.0)))


@pytest.mark.parametrize("masses", MASSES)
@pytest.mark.parametrize("parameter", ["alpha", "eta_b", "distance", "level"])
def test_values_and_slopes_hold_what_points_give(parameter: str, masses: int) -> None:
    if parameter == "distance" and masses == 1:
        with pytest.raises(Refused, match="do not stand at"):
            box(parameter, masses, 0.4, 0.3)
        return
    h = 2.0**-30
    with precision(128):
        wide = box(parameter, masses, 0.4, 0.3, h, h)
        z = split(wide)
        assert isinstance(z, Branches)
        found = value_and_slopes(wide, z)
        assert found is not None
        f, fx, ft = found
        points = {}
        for x, t in ((0.4, 0.3), (0.4 + h / 2, 0.3), (0.4, 0.3 + h / 2)):
            point = box(parameter, masses, x, t)
            at = split(point)
            assert at is not None
            points[x, t] = natural(point, at)
            assert natural(wide, z).contains(points[x, t].mid())
        middle, right, up = points.values()
        assert f.overlaps(middle)
        assert fx.overlaps((right - middle) / (arb(0.4 + h / 2) - arb(0.4)))
        assert ft.overlaps((up - middle) / (arb(0.3 + h / 2) - arb(0.3)))
        assert fx.rad() < 1e-2 * abs(fx)
        assert ft.rad() < 1e-2 * abs(ft)


@pytest.mark.parametrize("masses", MASSES)
def test_values_are_those_of_the_residue_sums(masses: int) -> None:
    with precision(128):
        b = box("alpha", masses, 0.4, 0.3)
        z = split(b)
        assert isinstance(z, Branches)
        delta = delta_off_cut(b.over, b.q)[0]
        assert natural(b, z).overlaps(delta * z.roots.resultant)
        assert abs(delta) > 1e-9
        level = box("level", masses, 0.4, 0.3)
        z = split(level)
        assert isinstance(z, Branches)
        share = (1 + level.q.real**2) * arb(0.3) / (1 - arb(0.3))  # 2ηq²/π
        scale = share / (2 * level.q.real**2 / arb.pi())
        n = level.over
        heavier = type(n)(n.alpha, n.axial, n.eta_b, tuple(eta * scale for eta in n.eta), n.x)
        expected = delta_off_cut(heavier, level.q)[0] * z.roots.resultant * (1 - arb(0.3)) ** len(n.eta)
        assert (natural(level, z) / expected - 1).abs_upper() < 1e-14


@pytest.mark.parametrize("masses", [1, 2, 3])
@pytest.mark.parametrize("size", [2.0**-14, 2.0**-30])
def test_roots_of_one_side_may_meet_within_a_box(masses: int, size: float) -> None:
    """Two upper p-roots meet at one point (x, α), next to which no formula that divides by a − b is of use."""
    places = ["0", "3/2", "5/2"][:masses]
    case = {"eta_b": "1/20", "positions": places, "eta_m": ["70"] * masses}
    x, t = 1.0278021543, 0.1232290602
    with precision(64):
        wide = box("alpha", masses, x, t, size, size, **case)
        z = split(wide)
        assert isinstance(z, Beside)
        value = natural(wide, z)
        assert not value.contains(0)
        for dx, dt in ((0.9, 0.9), (-0.7, 0.9), (0.1, -0.9)):
            point = box("alpha", masses, x + dx * size, t + dt * size, **case)
            assert value.overlaps(value_off_cut(point.over, point.q))


def test_one_root_found_twice_is_no_second_root() -> None:
    with precision(64):
        b = box("alpha", 2, 0.4, 0.3)
        a, b_, c, _ = seeds_at(b, first_seeds(1.0))
        left = branches(b, [a, b_, c, c])  # c is lost with its double: two are left
        assert isinstance(left, Beside) or (isinstance(left, Branches) and left.met)
        assert branches(b, [a, b_, b_, 1e9]) is None
        assert branches(b, [a, a, b_, b_]) is None


def test_a_box_that_may_meet_a_cut_is_refused() -> None:
    with pytest.raises(Refused, match="may meet a cut"):
        box("eta_b", 2, 0.4, 0.3, 0, 0.5)


def test_the_bisection_finds_what_is_there() -> None:
    content = json.loads(original("alpha"))
    with precision(64):
        family = free_problem(content).family()
        assert prove_free(family, (0.0, 1.0, 0.65, 0.66), []) < 1000
        with pytest.raises(Refused, match=r"near x = 0.1562.*, t = 0.6669"):
            prove_free(family, (0.0, 1.0, 0.65, 0.67), [])
    assert (
        outward(Fraction(1, 3), Fraction(2, 3))[0]
        < Fraction(1, 3)
        < Fraction(2, 3)
        <= outward(Fraction(0), Fraction(2, 3))[1]
    )


@pytest.mark.parametrize("z", [0.3 + 0.1j, 1e-9j, 0.0, 2.5 - 0.4j])
def test_the_slope_of_the_entire_function(z: complex) -> None:
    with precision(128):
        h, x = acb(2.0**-40), arb(1.25)
        quotient = (entire(acb(z) + h, x) - entire(acb(z) - h, x)) / (2 * h)
        assert (entire_slope(acb(z), x) - quotient).abs_upper() < 1e-12
        disc = acb(z) + acb(arb(0, 0.01), arb(0, 0.01))
        assert entire_slope(disc, x).contains(entire_slope(acb(z), x).mid())


def test_the_determinant_of_duals() -> None:
    """For five and more rows by the product rule, as by cofactors."""
    with precision(64):
        rows = [[Dual(acb(k * j + 1 + (k == j) * 7), acb(k - j), acb(k * j % 3)) for j in range(5)] for k in range(5)]
        one = det(rows)
        h = arb(2) ** -30
        for slope, name in ((one.x, "x"), (one.t, "t")):
            ends = [det([[e.value + s * h * getattr(e, name) for e in row] for row in rows]) for s in (1, -1)]
            assert ((ends[0] - ends[1]) / (2 * h) - slope).abs_upper() < 1e-3 * (1 + abs(slope).upper())
