"""Enclosures over boxes of q, α and η_b hold the p-roots, R·Δ and the slopes at every point of the box."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest
from oracle import Truth

from mpsolve import Case
from mpsolve.discs import DiscField, Discs, DualField
from mpsolve.dual import Dual
from mpsolve.fields import MP
from mpsolve.model.boxes import RootDiscs, part, root_discs, root_slopes
from mpsolve.model.branch import ALONG_ALPHA, ALONG_DAMPING, ALONG_Q, Motion, Track, track
from mpsolve.model.limits import critical_velocity_ratio, limiting_frequency
from mpsolve.model.scaled import SplitRoots, scaled_characteristic

SLACK = 1e-25  # of the truth itself


@dataclass(frozen=True)
class Boxes:
    """Middles and half-widths of boxes in q, α, η_b for one case's masses and axial force."""

    case: Case
    q: Any
    alpha: Any
    eta_b: Any
    reach: tuple[Any, Any, Any]

    def model(self) -> Track:
        moved = {"alpha": Discs(self.alpha, self.reach[1]), "eta_b": Discs(self.eta_b, self.reach[2])}
        return replace(track(self.case, DiscField()), **moved)

    def found(self) -> tuple[Track, Discs, RootDiscs]:
        model, q = self.model(), Discs(self.q, self.reach[0])
        return model, q, root_discs(model, q)

    def point(self, k: int, towards: Any, digits: int = 45) -> tuple[Truth, Any]:
        """The truth at the point `towards` ∈ [−1, 1]³ of box k, and q there."""
        truth = Truth(self.case, digits)
        q, alpha, eta_b = (
            truth.mp.mpf(float(middle[k])) + truth.mp.mpf(float(np.broadcast_to(r, middle.shape)[k])) * float(u)
            for middle, r, u in zip((self.q, self.alpha, self.eta_b), self.reach, towards, strict=True)
        )
        truth.alpha, truth.eta_b = abs(alpha), abs(eta_b)
        return truth, q


def inside(disc: Discs, k: int, exact: Any) -> bool:
    m, r = complex(disc.m[k]), float(np.broadcast_to(disc.r, disc.m.shape)[k])
    return bool(abs(exact - m) <= r + SLACK * (1 + abs(exact)))


def assert_split(z: SplitRoots, k: int, truth: Truth, q: Any) -> None:
    """The upper p-roots lie in a and b, the lower ones in c and e, one in each."""
    for first, second, roots in zip((z.a, z.c), (z.b, z.e), truth.p_roots(q), strict=True):
        orders = (roots, roots[::-1])
        assert any(inside(first, k, u) and inside(second, k, v) for u, v in orders)


def sampled(rng: Any, count: int, case: Case, reach: float, **given: Any) -> Boxes:
    """Random boxes of half-widths up to `reach` about the values given, or anywhere."""
    q = np.abs(given.get("q", rng.uniform(0, 3, count)))
    alpha = given.get("alpha", rng.uniform(0, 1.4, count))
    eta_b = given.get("eta_b", rng.uniform(0.02, 0.9, count))
    wide = [reach * 10.0 ** rng.uniform(-7, 0, count) for _ in range(3)]
    wide = [np.where(rng.random(count) < 0.3, 0.0, w) for w in wide]
    return Boxes(case, q, alpha, eta_b, (wide[0], np.minimum(wide[1], alpha), np.minimum(wide[2], eta_b / 2)))


def branch_points(case: Case, alphas: Any) -> Any:
    field = MP(80)
    return np.array([float(limiting_frequency(_with(case, alpha), field)) for alpha in alphas])


def _with(case: Case, alpha: float) -> Case:
    return Case(alpha=alpha, eta_b=case.eta_b, eta_n=case.eta_n, eta_s=case.eta_s, eta_m=1)


ONE = Case(alpha=0, eta_b="0.05", eta_m=70)
TWO = Case(alpha=0, eta_b="0.05", eta_m=(70, 30), positions=(0, "1.5"))
FAR = Case(alpha=0, eta_b="0.05", eta_m=(70, 70), positions=(0, 40))
THREE = Case(alpha=0, eta_b="0.05", eta_m=(5, 70, 30), positions=(0, "0.4", 2))
AXIAL = Case(alpha=0, eta_b="0.05", eta_m=(10, 10), positions=(0, 1), eta_n="0.2", eta_s="0.5")


def anywhere(rng: Any, case: Case) -> Boxes:
    return sampled(rng, 60, case, 0.05)


def at_a_branch_point(rng: Any, case: Case) -> Boxes:
    """q near q_lm and little damping: an upper and a lower p-root nearly meet."""
    alphas = rng.uniform(0.05, 0.95, 12).repeat(5) * float(critical_velocity_ratio(case, MP(80)))
    q = branch_points(case, alphas[::5]).repeat(5) + rng.normal(size=60) * 10.0 ** rng.uniform(-6, -1.5, 60)
    eta_b = 10.0 ** rng.uniform(-4, -1, 60)
    return sampled(rng, 60, case, 3e-3, q=q, alpha=alphas, eta_b=eta_b)


def at_a_collision_above(rng: Any, case: Case) -> Boxes:
    """Two p-roots on one side meet near q = 1.0275, α = 0.1225 for η_b = 0.05."""
    q, alpha = 1.0275 + 0.01 * rng.normal(size=60), 0.1225 + 0.01 * rng.normal(size=60)
    return sampled(rng, 60, case, 3e-3, q=q, alpha=np.abs(alpha), eta_b=np.full(60, 0.05))


def at_rest(rng: Any, case: Case) -> Boxes:
    return sampled(rng, 60, case, 0.01, alpha=np.zeros(60))


def near_the_critical_velocity(rng: Any, case: Case) -> Boxes:
    """α near α_C and q near 0."""
    critical = float(critical_velocity_ratio(case, MP(80)))
    alpha = critical + rng.normal(size=60) * 10.0 ** rng.uniform(-6, -1.5, 60)
    q = 10.0 ** rng.uniform(-6, -0.5, 60)
    return sampled(rng, 60, case, 0.01, q=q, alpha=alpha, eta_b=10.0 ** rng.uniform(-3, -1, 60))


def far_out(rng: Any, case: Case) -> Boxes:
    return sampled(rng, 60, case, 0.3, q=10.0 ** rng.uniform(0.5, 3, 60))


places = pytest.mark.parametrize(
    "place",
    [anywhere, at_a_branch_point, at_a_collision_above, at_rest, near_the_critical_velocity, far_out],
    ids=lambda place: place.__name__,
)
several = pytest.mark.parametrize("case", [ONE, TWO, FAR, THREE, AXIAL], ids=["one", "two", "far", "three", "axial"])


@places
@pytest.mark.parametrize("case", [ONE, AXIAL], ids=["plain", "axial"])
def test_p_roots_lie_in_their_discs(place: Callable[[Any, Case], Boxes], case: Case) -> None:
    rng = np.random.default_rng(11)
    boxes = place(rng, case)
    _, _, found = boxes.found()
    assert not np.any(found.apart & ~found.known)
    assert found.known.mean() > 0.5
    for k in rng.choice(np.flatnonzero(found.known), 15):
        for towards in (rng.choice([-1, 0, 1], 3), rng.uniform(-1, 1, 3)):
            assert_split(found.roots, k, *boxes.point(k, towards))


@places
@several
def test_r_times_delta_lies_in_its_disc(place: Callable[[Any, Case], Boxes], case: Case) -> None:
    rng = np.random.default_rng(5)
    boxes = place(rng, case)
    model, q, found = boxes.found()
    with np.errstate(all="ignore"):
        value = scaled_characteristic(model, found.roots, [q * q * 2 / model.field.pi])[0]
    for k in rng.choice(np.flatnonzero(found.known), 6):
        truth, point = boxes.point(k, rng.choice([-1, 0, 1], 3))
        if np.isfinite(value.r[k]):  # else nothing is claimed
            assert inside(value, k, truth.resultant(point) * truth.delta(point))


@places
@pytest.mark.parametrize(
    ("case", "parameter"),
    [
        (ONE, "alpha"),
        (TWO, "alpha"),
        (TWO, "eta_b"),
        (TWO, "distance"),
        (FAR, "alpha"),
        (THREE, "distance"),
        (AXIAL, "eta_b"),
    ],
    ids=["one-alpha", "two-alpha", "two-eta_b", "two-distance", "far-alpha", "three-distance", "axial-eta_b"],
)
def test_slopes_lie_in_their_discs(place: Callable[[Any, Case], Boxes], case: Case, parameter: str) -> None:
    """Of R·Δ along q and along the parameter, by differences of the truth."""
    rng = np.random.default_rng(7)
    boxes = place(rng, case)
    model, q, found = boxes.found()
    keep = np.flatnonzero(found.apart)
    count = len(case.eta_m)
    motions = {"alpha": ALONG_ALPHA, "eta_b": ALONG_DAMPING, "distance": Motion(positions=tuple(range(count)))}
    motion = motions[parameter]
    z = SplitRoots(*(p[keep] for p in (found.roots.a, found.roots.b, found.roots.c, found.roots.e)))
    model, q = part(model, keep), q[keep]
    with np.errstate(all="ignore"):
        rates = root_slopes(model, z, q, (ALONG_Q, motion))
        dual = SplitRoots(*(Dual(p, s) for p, s in zip((z.a, z.b, z.c, z.e), rates, strict=True)))
        steps = motion.positions or (0,) * count
        moving = replace(
            model,
            field=DualField(),
            positions=tuple(Dual(p, [0, step]) for p, step in zip(model.positions, steps, strict=True)),
        )
        along = Dual(q, [1, 0])
        result = scaled_characteristic(moving, dual, [along * along * 2 / model.field.pi])[0]
    for k in rng.choice(len(keep), 2):
        truth, point = boxes.point(keep[k], rng.uniform(-1, 1, 3), 50)
        for slope, speeds in zip(result.slopes, ((1, 0), (0, 1)), strict=True):
            if not np.isfinite(np.broadcast_to(slope.r, slope.m.shape)[k]):
                continue
            exact = truth.mp.diff(changed(truth, point, parameter, *speeds), 0, h=truth.mp.mpf(10) ** -16)
            m, r = complex(slope.m[k]), float(slope.r[k])
            assert abs(exact - m) <= r + 1e-12 * (1 + abs(exact))


def changed(truth: Truth, q: Any, parameter: str, along_q: int, along: int) -> Callable[[Any], Any]:
    """h ↦ R·Δ with q and the parameter moved by h."""
    alpha, eta_b, x = truth.alpha, truth.eta_b, list(truth.x)

    def moved(h: Any) -> Any:
        truth.alpha, truth.eta_b, truth.x = alpha, eta_b, x
        if parameter == "alpha":
            truth.alpha = alpha + along * h
        elif parameter == "eta_b":
            truth.eta_b = eta_b + along * h
        else:
            truth.x = [place + along * k * h for k, place in enumerate(x)]
        return truth.resultant(q + along_q * h) * truth.delta(q + along_q * h)

    return moved


def test_narrow_boxes_give_narrow_discs() -> None:
    boxes = sampled(np.random.default_rng(2), 100, TWO, 1e-9)
    model, q, found = boxes.found()
    assert np.mean(found.apart) > 0.95
    value = scaled_characteristic(model, found.roots, [q * q * 2 / model.field.pi])[0]
    assert np.median(value.r / (1 + np.abs(value.m))) < 1e-6
    assert np.median(found.roots.a.r) < 1e-8


def test_a_pair_that_may_meet_shares_one_disc() -> None:
    """A box about q_lm with η_b below its width, as at the end of a cut: known, not apart, and worth something."""
    alpha = 0.6
    q = branch_points(ONE, [alpha])
    boxes = Boxes(ONE, q, np.array([alpha]), np.array([1e-4]), (np.array([1e-3]), np.zeros(1), np.zeros(1)))
    model, disc, found = boxes.found()
    if found.known[0]:
        assert not found.apart[0]
        assert found.roots.a.m[0] == found.roots.c.m[0]
        value = scaled_characteristic(model, found.roots, [disc * disc * 2 / model.field.pi])[0]
        for u in (-1, 0, 1):
            truth, point = boxes.point(0, (u, 0, 0))
            assert inside(value, 0, truth.resultant(point) * truth.delta(point))


def test_two_seeds_of_one_root_are_not_taken_for_two() -> None:
    """Exactly at a collision of upper p-roots, and all around it, nothing wrong is called known."""
    rng = np.random.default_rng(8)
    centre = Boxes(ONE, np.array([1.0275]), np.array([0.1225]), np.array([0.05]), (np.zeros(1),) * 3)
    truth, _ = centre.point(0, np.zeros(3), 60)
    meeting = collision(truth)
    q, alpha, eta_b = (float(v) for v in meeting)
    offset = 10.0 ** rng.uniform(-17, -3, (3, 40)) * rng.choice([-1, 1], (3, 40))
    reach = tuple(10.0 ** rng.uniform(-18, -4, (3, 40)))
    boxes = Boxes(ONE, q + offset[0], alpha + offset[1], np.full(40, eta_b), reach)
    _, _, found = boxes.found()
    for k in np.flatnonzero(found.known)[:20]:
        for towards in (np.zeros(3), rng.choice([-1, 1], 3)):
            assert_split(found.roots, k, *boxes.point(k, towards, 60))


def collision(truth: Truth) -> tuple[Any, Any, Any]:
    """(q, α, η_b) near (1.0275, 0.1225, 0.05) where D has a double p-root, by D = D_p = 0 with η_b fixed."""
    mp = truth.mp

    def equations(x: Any, y: Any, q: Any, alpha: Any) -> list[Any]:
        truth.alpha = alpha
        p, D = mp.mpc(x, y), truth.quartic(q)
        value = mp.polyval(D, p)
        slope = mp.polyval([4, 0, 2 * D[2], D[3]], p)
        return [value.real, value.imag, slope.real, slope.imag]

    upper, _ = truth.p_roots(mp.mpf("1.0275"))
    start = sum(upper) / 2
    _, _, q, alpha = mp.findroot(equations, (start.real, start.imag, mp.mpf("1.0275"), mp.mpf("0.1225")), tol=1e-40)
    return q, abs(alpha), truth.eta_b  # D(p; −α) = D(−p; α)
